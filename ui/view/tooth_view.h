/// The tooth in a window: draws a ToothPicture, turns with the right mouse button, zooms and picks. Report, editor and
/// drilling use it alike; what the left button means is theirs. Where the platform has no OpenGL (offscreen) a plain
/// placeholder stands instead and everything else answers as before. Thread: GUI; a ViewPainter draws.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "ui/render/patch_feed.h"
#include "ui/render/tooth_picture.h"
#include "ui/view/picture_scale.h"

namespace cusp::ui {

class FrameStats;
class ViewPainter;
struct FinishedFrame;

class ToothView : public QWidget {
  Q_OBJECT

 public:
  explicit ToothView(QWidget* parent = nullptr);
  /// Makes what draws; nullptr: a placeholder stands.
  using MakePainter = std::function<std::unique_ptr<ViewPainter>(std::function<void(FinishedFrame)> drawn)>;
  ToothView(QWidget* parent, const MakePainter& make_painter);
  /// Why nothing can be drilled after forbid_opengl(), and what can be done.
  static QString pictures_off();
  ~ToothView() override;

  /// Builds the whole mesh of a volume as it stands, here and now (about 0.4 s for a molar), and looks at it when
  /// nothing was shown before.
  void show_volume(const Volume& volume, const FeedSettings& settings = {});
  /// The same with a mesh that another thread has built.
  void show_mesh(WholeMesh mesh);
  /// Patches come from this feed from now on, a bounded number of bytes a frame after the first. Call feed_changed() when it has news.
  void set_feed(std::shared_ptr<PatchFeed> feed);
  /// Any thread: asks for a frame. Several askings before it make one.
  void feed_changed();

  /// What stands about the tooth, to be looked at; null: nothing.
  void set_scenery(std::shared_ptr<const SceneryLook> scenery);
  void set_lines(std::vector<OverlayLine> lines);
  /// What a measure is about, painted over the tooth; empty: nothing.
  void set_marks(SurfaceMarks marks);
  void set_colouring(Colouring colouring);
  void set_target_shown(bool on);
  /// Above the bur; off unless it is called.
  void set_handpiece_shown(bool on);
  void set_hand(HandSide hand);
  void set_bur(const std::optional<BurPose>& bur);
  /// Asked at the start of every frame, so that the bur is drawn where it is then; replaces set_bur.
  void set_bur_source(std::function<std::optional<BurPose>()> source) { bur_source_ = std::move(source); }
  /// Asks for a frame when the bur has moved and none came within `pause`, so that a bur alone never doubles the
  /// frames that the mesh asks for.
  void follow_bur(std::chrono::milliseconds pause);
  /// The mouth mirror; nullopt: none.
  void set_mirror(const std::optional<MouthMirror>& mirror);
  /// Takes away what lies before the image's plane and closes it with the image; nullopt: whole tooth.
  void set_cutaway(std::optional<SectionImage> image);

  const Camera& camera() const { return scene_.camera; }
  void set_camera(const Camera& camera);
  /// Turns so that the place faces the viewer, and brings it to the middle.
  void look_at(Vec3 place_mm);
  /// The left button turns too (where a click means nothing else).
  void set_left_turns(bool on) { left_turns_ = on; }
  /// True: the wheel is the receiver's, and only Ctrl+wheel zooms.
  void set_wheel_taken(bool on) { wheel_taken_ = on; }

  /// What lies under a widget position.
  std::optional<PickedPoint> pick(QPointF at) const;
  /// The ray under a widget position.
  Ray ray(QPointF at) const;
  /// Where a place is drawn; nullopt behind the eye. It may be hidden by the tooth.
  std::optional<QPointF> project(Vec3 mm) const;
  const PatchStore& store() const { return store_; }
  const Scene3d& scene() const { return scene_; }

  /// Frames are counted there; may be nullptr.
  void set_stats(FrameStats* stats) { stats_ = stats; }

 Q_SIGNALS:
  void camera_changed();
  /// The tooth of the newest set_feed() stands in a frame and can be picked; once each.
  void feed_shown();
  /// No frame can be drawn any more: forbid_opengl() was called.
  void drawing_failed();
  /// Left button and movement, widget positions; only while left_turns is off.
  void pressed(QPointF at, Qt::KeyboardModifiers modifiers);
  void moved(QPointF at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers);
  void released(QPointF at);
  /// Wheel steps (120 = one notch). Without Ctrl the receiver may take it by wheel_taken; else it zooms.
  void wheel_turned(int delta);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// What the next frame shows otherwise than the last one.
  struct Changed {
    bool scenery = true, lines = true, marks = true, section = true, mesh = true;
  };
  void repaint_soon();
  void order_frame();
  void note_motion();
  void sharpen();
  QSize full_size_px() const;
  void take(FinishedFrame frame);
  void keep_fed(FinishedFrame& frame);
  void give_up(const QString& why);
  void take_feed();
  void note_shown(int mesh);
  void show_placeholder(const QString& text);
  bool moved_visibly(const std::optional<BurPose>& bur) const;
  void read_theme();
  void frame_ended();

  std::unique_ptr<ViewPainter> painter_;  // null: a placeholder stands
  QImage image_, spare_;                  // the newest frame; one to draw into
  Scene3d scene_;
  PatchStore store_;
  std::shared_ptr<PatchFeed> feed_;
  std::shared_ptr<const SceneryLook> scenery_;
  std::vector<OverlayLine> lines_;
  SurfaceMarks marks_;
  std::optional<SectionImage> section_;
  Changed changed_;
  FrameStats* stats_ = nullptr;
  std::function<std::optional<BurPose>()> bur_source_;
  TickTimes changes_;  // shown by the newest frame, not yet on the screen
  double draw_ms_ = 0;
  std::chrono::steady_clock::time_point ordered_at_;
  PictureScale scale_;                       // of pictures in motion
  QTimer rest_;                              // from the newest change on the screen to the picture's rest
  Camera ordered_camera_;                    // of the newest order, as its mirror
  std::optional<MouthMirror> ordered_mirror_;
  QPointF last_;
  int mesh_ = 0;  // rises with each volume and feed
  std::optional<int> awaited_;  // mesh_ of a feed that no frame has shown
  bool left_turns_ = false, wheel_taken_ = false;
  bool framed_ = false;   // the camera was set or found
  bool wanted_ = false;   // a frame is wanted
  bool drawing_ = false;  // the painter has an order, or its frame is not yet on the screen
  bool fresh_ = false;    // the newest frame is not yet on the screen
  bool in_software_ = false;   // no graphics card draws
  bool in_motion_ = false;     // drawn at scale_.share()
  bool shows_motion_ = false;  // the newest order has a change
  std::atomic<bool> asked_{false};
};

}  // namespace cusp::ui
