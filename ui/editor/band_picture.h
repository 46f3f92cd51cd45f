/// The bands of one criterion as a picture: full points, flanks and none over a scale in the criterion's unit. An edge is dragged
/// by the mouse or moved by keys; measured values stand as marks above. band_scale.h has the geometry. Thread: GUI.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <vector>

#include "ui/editor/band_scale.h"
#include "ui/editor/try_outs.h"

namespace cusp::ui {

class BandKnob;

/// A measured value and how well it is known, one-sided.
struct BandMark {
  TriedBy by = TriedBy::author;
  double value = 0, uncertainty = 0;
};
/// Its sign: a disc, a diamond, a triangle or a square, by who cut.
void paint_band_mark(QPainter& painter, QPointF middle, TriedBy by);

class BandPicture : public QWidget {
  Q_OBJECT

 public:
  struct Criterion {
    QString name, unit;
    BandRange possible;
  };
  /// `take` changes the exercise and returns false if it cannot; `end` ends the step of undo.
  BandPicture(Criterion criterion, std::function<bool(const Bands&)> take, std::function<void()> end, QWidget* parent = nullptr);

  void show_bands(const Bands& bands);
  void set_marks(std::vector<BandMark> marks);
  const BandScale& scale() const { return scale_; }
  BandPlot plot() const;
  BandKnob* knob(std::size_t edge) const { return knobs_[edge]; }
  /// Moves an edge as far as its neighbours let it go. `step` snaps.
  void move_edge(std::size_t edge, double wanted, double step);
  void end_gesture() { end_(); }
  double step() const { return step_; }
  QString value_text(double value) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void fit_scale();
  void place_knobs();
  std::optional<std::size_t> edge_under(QPointF at) const;
  void paint_shares(QPainter& p, const BandPlot& at) const;
  void paint_figures(QPainter& p, const BandPlot& at) const;
  void paint_marks(QPainter& p, const BandPlot& at) const;

  Criterion criterion_;
  double step_;
  std::function<bool(const Bands&)> take_;
  std::function<void()> end_;
  std::vector<BandMark> marks_;
  BandScale scale_;
  std::array<BandKnob*, kBandEdges.size()> knobs_{};
  std::optional<std::size_t> dragged_;
  double grip_px_ = 0;  // from the edge to where the mouse took it
};

/// The handle of one edge: a slider for keys and screen readers. BandPicture takes the mouse.
class BandKnob : public QWidget {
  Q_OBJECT

 public:
  BandKnob(BandPicture& picture, std::size_t edge);
  void follow();
  BandPicture& picture() const { return picture_; }
  std::size_t edge() const { return edge_; }
  double value() const { return picture_.scale().bands().*kBandEdges[edge_]; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  BandPicture& picture_;
  std::size_t edge_;
};

/// "Half from" of an edge.
QString band_edge_name(std::size_t edge);

}  // namespace cusp::ui
