/// The tooth of the report: the 3D view, a ring on one place, and a card with its measure. Ring and card are masked or opaque
/// children. Thread: GUI.
#pragma once

#include <QLineF>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/render/scenery_look.h"
#include "ui/render/tooth_picture.h"
#include "ui/render/place_view.h"
#include "ui/render/surface_marks.h"

class QLabel;

namespace cusp::ui {

class PatchSource;
class Compass;
class PinLeader;
class ToothView;

/// The card stands at the foot of the view, beside the cavity, and a line joins it to the ring. If the tooth or its scenery hides
/// the place, ring and line are hidden and the card gives the cause.
class PinnedTooth : public QWidget {
  Q_OBJECT

 public:
  PinnedTooth(std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent = nullptr);
  void set_colouring(Colouring colouring);
  /// `metric`: its patch is painted once it is computed, in the background; empty: none.
  void pin(const std::optional<Vec3>& place_mm, const QString& what, const QString& more, const std::string& metric = {});
  /// Of a pinned place: hidden, it turns the tooth all the same.
  enum class Pin { shown, hidden };
  void show_pin(Pin pin);
  /// A section goes through the tooth and through each pinned place: nothing hides the place, and the view does not turn to it.
  void set_cut_open(bool open);
  const std::optional<Vec3>& place_mm() const { return place_; }
  /// What stands over the view's head, from its top: the card keeps below.
  void set_head(int height_px);
  void turn_back();
  /// False without a place, and while something hides it.
  bool ring_shown() const;
  /// Line from ring to card; nullopt without a ring.
  std::optional<QLineF> leader() const;
  ToothView* view() const { return view_; }
  /// The mesh of a tooth takes a second or more: it is built in the background, and a place that is pinned meanwhile is shown then.
  bool tooth_shown() const { return tooth_shown_; }
  /// Neighbours and gums; null: none, or not yet.
  std::shared_ptr<const SceneryLook> scenery() const { return scenery_; }
  /// Of the pinned measure, as far as it has a patch; empty until it is computed.
  const SurfaceMarks& marks() const { return marks_; }

 Q_SIGNALS:
  void scenery_came();
  /// The mesh stands, and the view shows the whole of it or a pinned place.
  void tooth_came();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build_mesh(const Scenario& scenario);
  /// Of the pinned place; `shown_` follows.
  void compute_patch(const std::string& metric);
  /// Where the ring stands and the camera looks. Pre: a place is pinned.
  Vec3 pinned() const;
  void face_place();
  void place_pin();
  void place_compass();
  /// After Busy::kDelayMs, until the mesh stands.
  void show_waiting();
  Meshes meshes() const;
  void set_scenery(std::shared_ptr<const SceneryLook> scenery);
  std::shared_ptr<const Volume> volume_;
  std::shared_ptr<const SceneryLook> scenery_;
  PatchStore beside_;  // of the scenery
  ToothView* view_;
  Compass* compass_;
  PinLeader* leader_;
  QWidget* ring_;
  QLabel* card_;
  QLabel* waiting_;  // null once the mesh stands
  std::shared_ptr<const PatchSource> patches_;
  SurfaceMarks marks_;
  std::string metric_;  // whose patch is wanted
  std::optional<Vec3> place_;
  std::optional<Vec3> shown_;  // the surface over a place within the tooth, once it is known
  Pin pin_ = Pin::shown;
  bool tooth_shown_ = false;
  bool inside_ = false;  // no view shows the place
  bool cut_open_ = false;
  int head_px_ = 0;
  QString text_;         // of the card, rich text
};

/// Legend of the difference map.
class DeviationLegend : public QWidget {
  Q_OBJECT

 public:
  explicit DeviationLegend(QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace cusp::ui
