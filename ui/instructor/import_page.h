/// Files of meshes or a volume become the specimen of a new exercise: dropped or chosen, how long one unit is, what each
/// part is made of, how fine. The size in millimetres is shown before anything is made, the specimen in 3D before it is
/// kept. Reading and turning into a volume run in a process of their own, with progress, and can be stopped.
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import.h"
#include "ui/editor/editor_model.h"
#include "ui/modules.h"
#include "ui/widgets/ports.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class Band;
class Busy;
class Card;
class ImportPreview;
class ImportSize;
class MeshForm;
struct ImportedSpecimen;
class VolumeForm;

class ImportPage : public QWidget {
  Q_OBJECT

 public:
  ImportPage(const Ports& ports, std::filesystem::path database, QWidget* parent = nullptr);
  ~ImportPage() override;
  /// What the file picker and a drop do. Meshes join those that are there; anything else replaces them.
  void open_files(const QStringList& paths);
  void open_file(const QString& path) { open_files({path}); }
  /// What a child process would have told of the files; for pictures and tests too.
  void show_look(FileLook look);
  const std::vector<std::filesystem::path>& files() const { return files_; }
  MeshForm* meshes() const { return mesh_form_; }
  VolumeForm* volume() const { return volume_form_; }
  /// What was made, until it is kept or anything that it depends on changes.
  ImportPreview* preview() const { return preview_; }
  bool busy() const { return work_ != nullptr; }

 Q_SIGNALS:
  void back_wanted();
  /// The volume is kept; a new exercise on it is ready to be edited.
  void edit_wanted(const EditorStart& start);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void build_files(QVBoxLayout* body);
  void build_made(QVBoxLayout* body);
  void show_files();
  void show_size();
  void forget_forms();
  void look();
  void run();
  void begin_work(const QString& what);
  void end_work();
  void show_made(ImportedSpecimen made, const std::vector<ImportRemark>& remarks);
  void forget_made();
  void keep();
  void show_failure(const ImportFailure& failure);

  const Ports& ports_;
  std::filesystem::path database_;
  std::vector<std::filesystem::path> files_;
  std::optional<ImageInfo> image_;
  std::shared_ptr<std::stop_source> work_;
  Band* band_;
  Card *files_card_, *parts_card_, *size_card_, *made_card_;
  MeshForm* mesh_form_ = nullptr;
  VolumeForm* volume_form_ = nullptr;
  ImportSize* size_;
  ImportPreview* preview_;
  QLabel *names_, *about_;
  QPushButton *pick_, *clear_, *import_, *keep_;
  Busy* busy_;
};

/// A new exercise on a volume, the volume written beside its draft: a channel in the middle of its upper face.
Result<EditorStart, ImportFailure> exercise_on(const VoxelVolume& volume, const std::string& name,
                                               const std::filesystem::path& database);

}  // namespace cusp::ui
