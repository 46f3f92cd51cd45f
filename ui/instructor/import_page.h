/// Makes a new exercise on meshes or on a volume from files: drop or choice, tissues, unit, voxel size, then a 3D preview. Shows the
/// size in millimetres before the import. A child process reads and converts the files, with progress and cancelling. Thread: GUI.
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
class ImportDrop;
class ImportPreview;
class ImportSize;
class MeshForm;
class SizePicture;
struct ImportedSpecimen;
class VolumeForm;

class ImportPage : public QWidget {
  Q_OBJECT

 public:
  ImportPage(const Ports& ports, std::filesystem::path database, QWidget* parent = nullptr);
  ~ImportPage() override;
  /// Opens files as the picker and a drop do. Meshes join the open ones; any other file replaces them. Until they are read, and if they
  /// cannot be, the page keeps what it had.
  void open_files(const QStringList& paths);
  /// Shows the answer of a child process about the files; public for pictures and tests.
  void show_look(FileLook look);
  const std::vector<std::filesystem::path>& files() const { return files_; }
  MeshForm* meshes() const { return mesh_form_; }
  VolumeForm* volume() const { return volume_form_; }
  /// The imported specimen, until it is kept or a setting of the import changes.
  ImportPreview* preview() const { return preview_; }
  bool busy() const { return work_ != nullptr; }
  /// Files were read, and what was chosen for them stands nowhere else.
  bool begun() const { return mesh_form_ != nullptr || volume_form_ != nullptr; }

 Q_SIGNALS:
  void back_wanted();
  /// The volume is stored; `start` is a new exercise on it.
  void edit_wanted(const EditorStart& start);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// Asks first if something is begun.
  void leave();
  void pick_files();
  void build_files(QVBoxLayout* body);
  void build_made(QVBoxLayout* body);
  void show_files();
  void show_size();
  void forget_forms();
  void take_back_files();
  void look();
  void run();
  void begin_work(const QString& what);
  void end_work();
  void end_look();
  void show_made(ImportedSpecimen made, const std::vector<ImportRemark>& remarks);
  void forget_made();
  void keep();
  void show_failure(const ImportFailure& failure);
  /// The same of several files.
  void show_apart(const ImportFailure& failure);

  const Ports& ports_;
  std::filesystem::path database_;
  std::vector<std::filesystem::path> files_;
  std::optional<std::vector<std::filesystem::path>> files_before_;  // those of the forms, while others are read
  bool joins_ = false;  // the files that are read join those of the form
  std::optional<ImageInfo> image_;
  std::shared_ptr<std::stop_source> work_;
  Band* band_;
  ImportDrop* drop_card_;  // while there is no file
  Card *files_card_, *parts_card_, *size_card_, *made_card_;
  MeshForm* mesh_form_ = nullptr;
  VolumeForm* volume_form_ = nullptr;
  ImportSize* size_;
  SizePicture* size_picture_;
  ImportPreview* preview_;
  QLabel *names_, *about_;
  QPushButton *first_pick_, *pick_, *clear_, *import_, *keep_;
  Busy* busy_;
};

/// A new exercise on a volume: a channel in the middle of its upper face, with bands that fit its size. Writes the volume beside the
/// draft.
Result<EditorStart, ImportFailure> exercise_on(const VoxelVolume& volume, const std::string& name,
                                               const std::filesystem::path& database);

}  // namespace cusp::ui
