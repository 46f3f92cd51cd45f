/// The specimen of an exercise: a grown tooth by number, seed and voxel size, or a volume file with its landmarks. If the exercise has a
/// grown tooth, each change is an edit at once; another kind is taken as a whole. Thread: GUI.
#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

#include "ui/editor/editor_model.h"
#include "ui/widgets/ports.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class Band;
class LandmarksForm;
class NumberBox;
class ToothForm;

/// Why no exercise can hold a volume of these voxels; empty if one can.
QString fineness_refusal(double voxel_mm);

class SpecimenForm : public QWidget {
  Q_OBJECT

 public:
  /// Copies the picked file into the model's folder: the draft keeps it.
  SpecimenForm(EditorModel& model, const Ports& ports, QWidget* parent = nullptr);

 Q_SIGNALS:
  void done();

 private:
  /// The rows of a grown tooth, of any grown specimen and of a file; fit() shows those of the kind.
  void make_rows(QVBoxLayout& column);
  void follow_model();
  void fit();
  void use();
  bool tooth_stands() const;
  bool file_stands() const;
  void change_tooth();
  void pick();
  void copy_beside(const std::filesystem::path& from);
  /// A file may be a better scan of the same tooth, or another tooth: the author chooses whether the landmarks go over to it.
  void put_on(const SpecimenSource& source, const std::vector<Tissue>& tissues, const SpecimenLandmarks& kept);
  void take(const SpecimenSource& source, const std::vector<ScenarioTissue>& tissues);

  EditorModel& model_;
  const Ports& ports_;
  QComboBox *kind_, *tooth_;
  NumberBox *seed_, *voxel_;
  QWidget *tooth_rows_, *grown_rows_, *file_rows_;
  ToothForm* details_;
  LandmarksForm* landmarks_;
  QLabel* file_;
  QPushButton* use_;
  Band* band_;
};

/// "36, lower left", "Practice block", "tooth.nrrd".
QString specimen_name(const SpecimenSource& source);
/// For breakable(): a file's name often has no blank. A line of the left panel holds about 20 characters.
inline constexpr int kWholeInPanel = 12;
/// The permanent teeth by FDI number, which is their data.
void add_teeth(QComboBox& box);

}  // namespace cusp::ui
