/// Which tooth or block an exercise is drilled on: a grown one by number, seed and fineness, or a volume file. Where the
/// exercise has a tooth already, number, seed and fineness change it at once; another kind is chosen as a whole.
#pragma once

#include <QWidget>

#include "ui/editor/editor_model.h"
#include "ui/widgets/ports.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace cusp::ui {

class Band;
class NumberBox;
class ToothForm;

class SpecimenForm : public QWidget {
  Q_OBJECT

 public:
  /// A picked file is copied into the model's folder, so that the draft keeps it.
  SpecimenForm(EditorModel& model, const Ports& ports, QWidget* parent = nullptr);

 Q_SIGNALS:
  void done();

 private:
  void follow_model();
  void fit();
  void use();
  bool tooth_stands() const;
  void change_tooth();
  void pick();

  EditorModel& model_;
  const Ports& ports_;
  QComboBox *kind_, *tooth_;
  NumberBox *seed_, *voxel_;
  QWidget *tooth_rows_, *grown_rows_, *file_rows_;
  ToothForm* details_;
  QLabel* file_;
  QPushButton* use_;
  Band* band_;
};

/// "36, lower left", "Practice block", "tooth.nrrd".
QString specimen_name(const SpecimenSource& source);

}  // namespace cusp::ui
