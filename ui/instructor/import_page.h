/// A file of meshes or a volume becomes the specimen of a new exercise: how long one unit is, what each mesh is made of,
/// how fine. The size in millimetres is shown before anything is reckoned. Reading and turning into a volume run in a
/// process of their own, with progress, and can be stopped.
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/import.h"
#include "ui/app/ports.h"
#include "ui/editor/editor_model.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace cusp {

class Band;
class Busy;
class Card;

class ImportPage : public QWidget {
  Q_OBJECT

 public:
  ImportPage(const Ports& ports, std::filesystem::path database, QWidget* parent = nullptr);
  ~ImportPage() override;
  /// What the file picker does; for a file given on other ways.
  void open_file(const QString& path);

 Q_SIGNALS:
  void back_wanted();
  /// The volume is kept; a new exercise on it is ready to be edited.
  void edit_wanted(const cusp::EditorStart& start);

 private:
  struct Mesh {
    MeshInfo info;
    QComboBox* tissue;
  };
  void show_meshes(std::vector<MeshInfo> meshes);
  void show_size();
  void run();
  void begin_work(const QString& what);
  void end_work();
  void keep(const VoxelVolume& volume);
  void tell_failure(const ImportFailure& failure);
  std::vector<std::pair<std::string, Tissue>> chosen() const;

  const Ports& ports_;
  std::filesystem::path database_, file_;
  std::vector<Mesh> meshes_;
  std::shared_ptr<std::stop_source> work_;
  Band* band_;
  Card* card_;
  QGridLayout* grid_;
  QLabel *name_, *size_;
  QDoubleSpinBox *unit_, *voxel_;
  QComboBox* up_;
  QPushButton *pick_, *import_;
  Busy* busy_;
};

/// A new exercise on a volume, the volume written beside its draft: a channel in the middle of its upper face.
Result<EditorStart, ImportFailure> exercise_on(const VoxelVolume& volume, const std::string& name,
                                               const std::filesystem::path& database);

}  // namespace cusp
