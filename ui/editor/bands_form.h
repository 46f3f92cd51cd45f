/// The bands of one criterion: the picture that is dragged, what was measured by whom, and the six numbers. Thread: GUI.
#pragma once

#include <QFrame>
#include <array>

#include "ui/editor/band_picture.h"
#include "ui/editor/editor_model.h"

class QLabel;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class BandsForm : public QFrame {
  Q_OBJECT

 public:
  /// `index`: of the criterion, which stays the same as long as this form stands.
  BandsForm(EditorModel& model, std::size_t index, QWidget* parent = nullptr);
  BandPicture& picture() { return *picture_; }
  void follow_model();

 private:
  void show_marks();
  const Criterion& criterion() const { return model_.scenario().rubric.criteria[index_]; }

  EditorModel& model_;
  std::size_t index_;
  BandPicture* picture_;
  QVBoxLayout* marks_;
  std::array<NumberBox*, kBandEdges.size()> numbers_{};
};

}  // namespace cusp::ui
