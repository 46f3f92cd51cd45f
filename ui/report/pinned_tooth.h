/// The report's tooth: the 3D view with a pin on one place and a card that says what was measured there. The card is an
/// opaque child: no translucency under software OpenGL.
#pragma once

#include <QLineF>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/render/scenery_look.h"
#include "ui/report/place_view.h"

class QLabel;

namespace cusp::ui {

class PinLeader;
class ToothView;

/// The card stands at the foot of the view, clear of the cavity; a line joins it to the ring.
/// A place that the tooth, or what stands about it, hides has no ring and no line, and its card says so.
class PinnedTooth : public QWidget {
  Q_OBJECT

 public:
  PinnedTooth(std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent = nullptr);
  void show_difference(bool on);
  void pin(const std::optional<Vec3>& place_mm, const QString& what, const QString& more);
  void turn_back();
  /// The ring stands on the pinned place; false without a place, and while it is hidden.
  bool ring_shown() const;
  /// From the ring to the card; none without a ring.
  std::optional<QLineF> leader() const;
  ToothView* view() const { return view_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place_pin();
  Meshes meshes() const;
  void set_scenery(std::shared_ptr<const SceneryLook> scenery);
  std::shared_ptr<const Volume> volume_;
  PatchStore beside_;  // what stands about the tooth
  ToothView* view_;
  PinLeader* leader_;
  QWidget* ring_;
  QLabel* card_;
  std::optional<Vec3> place_;
  bool inside_ = false;  // no view shows the place
  QString text_;         // of the card, rich
};

/// Colours of the difference map with their figures.
class DeviationLegend : public QWidget {
  Q_OBJECT

 public:
  explicit DeviationLegend(QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace cusp::ui
