/// Where the mouse's hand is while the bur lags behind it: a ring as wide as the bur's head, and a line to the bur. A mask shapes it;
/// it lets the mouse through. Thread: GUI.
#pragma once

#include <QLineF>
#include <QWidget>
#include <optional>

#include "engine/base/vec.h"
#include "ui/modules.h"

namespace cusp::ui {

class ToothView;

class HandGhost : public QWidget {
  Q_OBJECT

 public:
  /// Least way of the hand from the bur that is shown; nearer, ring and bur would cover each other [M].
  static constexpr double kLagMm = 0.3;

  /// `view` fills the parent.
  HandGhost(const ToothView& view, QWidget* parent);
  struct Bur {
    Vec3 at_mm{0.0};
    double radius_mm = 0;
  };
  /// `hand_mm`: at the bur's depth; nullopt: the hand does not drill.
  void follow(const std::optional<Vec3>& hand_mm, const Bur& bur);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const ToothView& view_;
  QRectF ring_;
  QLineF line_;  // from the ring to the bur; both relative to this widget
};

}  // namespace cusp::ui
