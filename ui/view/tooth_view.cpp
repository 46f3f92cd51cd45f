#include "ui/view/tooth_view.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/render/opengl_allowed.h"
#include "ui/view/frame_stats.h"
#include "ui/view/view_painter.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kTurnPerPx = 0.008;  // radians; half a turn across a view 400 px wide
constexpr double kZoomPerNotch = 1.15;
// For a frame of a picture in motion. The window's own copy and hand-over take the rest of 40 ms, 25 frames a second.
constexpr double kBudgetMs = 24.0;
// After a frame that showed a change of mesh, camera or mirror: without another one for so long the picture is at rest. On a
// busy machine changes come further apart, and a large picture between two of them would delay the second.
constexpr double kRestMs = 150.0, kRestFrames = 3.0;

Colour colour_of(const QColor& c) {
  return {static_cast<float>(c.redF()), static_cast<float>(c.greenF()), static_cast<float>(c.blueF()), 1.0f};
}

}  // namespace

ToothView::ToothView(QWidget* parent) : ToothView(parent, ViewPainter::create) {}

ToothView::ToothView(QWidget* parent, const MakePainter& make_painter) : QWidget(parent), scale_(kBudgetMs) {
  setMinimumSize(240, 200);
  setAttribute(Qt::WA_OpaquePaintEvent);
  // A view that is gone takes no frame: the painter, a member, ends with it.
  painter_ = make_painter([this](FinishedFrame frame) {
    auto shared = std::make_shared<FinishedFrame>(std::move(frame));
    QMetaObject::invokeMethod(this, [this, shared] { take(std::move(*shared)); }, Qt::QueuedConnection);
  });
  if (!painter_) show_placeholder(opengl_allowed() ? tr("The tooth is drawn where the screen has OpenGL.") : pictures_off());
  setAccessibleName(tr("Tooth"));
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, &ToothView::sharpen);
  read_theme();
}

ToothView::~ToothView() { painter_.reset(); }

QString ToothView::pictures_off() { return tr("3D pictures are off: this station can grade, replay and administer."); }

void ToothView::show_placeholder(const QString& text) {
  auto* lay = new QVBoxLayout(this);
  auto* note = make_label(text, TextRole::body, Weight::regular, "text2");
  note->setAlignment(Qt::AlignCenter);
  note->setWordWrap(true);
  lay->addWidget(note);
  setAttribute(Qt::WA_OpaquePaintEvent, false);
}

void ToothView::repaint_soon() {
  if (!painter_ || std::exchange(wanted_, true) || drawing_) return;
  QMetaObject::invokeMethod(this, &ToothView::order_frame, Qt::QueuedConnection);
}

QSize ToothView::full_size_px() const { return (devicePixelRatioF() * QSizeF(size())).toSize().expandedTo({1, 1}); }

/// Where a graphics card draws, no picture counts as in motion.
void ToothView::note_motion() {
  const bool mesh = asked_.exchange(false);
  const bool moved = ordered_camera_ != scene_.camera || ordered_mirror_ != scene_.mirror;
  ordered_camera_ = scene_.camera;
  ordered_mirror_ = scene_.mirror;
  shows_motion_ = in_software_ && (mesh || moved);
  if (!shows_motion_) return;
  in_motion_ = true;
  rest_.stop();
}

void ToothView::sharpen() {
  in_motion_ = false;
  if (drawing_ || image_.size() != full_size_px()) repaint_soon();
}

void ToothView::order_frame() {
  if (!wanted_ || drawing_ || !painter_ || !isVisible()) return;
  wanted_ = false;
  drawing_ = true;
  note_motion();
  ordered_at_ = std::chrono::steady_clock::now();
  if (bur_source_) scene_.bur = bur_source_();
  const double share = in_motion_ ? scale_.share() : 1.0;
  scene_.line_scale = static_cast<float>(share * devicePixelRatioF());
  FrameOrder order;
  order.scene = scene_;
  order.size_px = (share * QSizeF(full_size_px())).toSize().expandedTo({1, 1});
  order.mesh = mesh_;
  order.feed = feed_;
  if (std::exchange(changed_.mesh, false))
    for (const auto& [brick, patch] : store_.patches()) order.patches.push_back(patch);
  if (std::exchange(changed_.scenery, false)) order.scenery = scenery_;
  if (std::exchange(changed_.lines, false)) order.lines = lines_;
  if (std::exchange(changed_.marks, false)) order.marks = marks_;
  if (std::exchange(changed_.section, false)) order.section = section_;
  order.spare = std::exchange(spare_, QImage());
  painter_->draw(std::move(order));
}

void ToothView::take(FinishedFrame frame) {
  keep_fed(frame);
  if (frame.image.isNull() && !frame.lost) return give_up(frame.why);
  if (frame.lost) {
    changed_ = {};
    wanted_ = true;
    drawing_ = false;
    return order_frame();
  }
  spare_ = std::exchange(image_, std::move(frame.image));
  draw_ms_ = frame.draw_ms;
  in_software_ = frame.in_software;
  if (in_motion_) scale_.drawn(frame.draw_ms);
  fresh_ = true;
  update();
  if (frame.more) wanted_ = true;
  note_shown(frame.mesh);
}

void ToothView::keep_fed(FinishedFrame& frame) {
  if (frame.mesh != mesh_) return;
  for (BakedPatch& patch : frame.fed) store_.put(std::move(patch));
  changes_.insert(changes_.end(), frame.changes.begin(), frame.changes.end());
}

void ToothView::give_up(const QString& why) {
  painter_.reset();
  forbid_opengl();  // no other picture can be drawn either, and the pages show why
  show_placeholder(tr("The tooth could not be drawn: %1").arg(why));
  take_feed();
  note_shown(mesh_);
  Q_EMIT drawing_failed();
}

void ToothView::note_shown(int mesh) {
  if (awaited_ != mesh) return;
  awaited_.reset();
  Q_EMIT feed_shown();
}

void ToothView::paintEvent(QPaintEvent*) {
  if (!painter_) return;
  QPainter painter(this);
  if (image_.isNull()) {
    painter.fillRect(rect(), tokens().view_middle);
  } else {
    // Smaller while it is in motion, and of another size until a frame of the new size is there.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != full_size_px());
    painter.drawImage(rect(), image_);
  }
  // Behind this event the window's pixels are handed over.
  if (std::exchange(fresh_, false)) QMetaObject::invokeMethod(this, &ToothView::frame_ended, Qt::QueuedConnection);
}

void ToothView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  wanted_ = true;
  order_frame();
}

void ToothView::read_theme() {
  scene_.background_middle = colour_of(tokens().view_middle);
  scene_.background_edge = colour_of(tokens().view_edge);
  repaint_soon();
}

void ToothView::show_volume(const Volume& volume, const FeedSettings& settings) { show_mesh(PatchFeed::build_mesh(volume, settings)); }

void ToothView::show_mesh(WholeMesh mesh) {
  feed_.reset();
  store_.clear();
  for (BakedPatch& patch : mesh.patches) store_.put(std::move(patch));
  if (!framed_) {
    if (const std::optional<Box> box = store_.bounds()) {
      scene_.camera = Camera::about(0.5 * (box->low + box->high), 0.5 * glm::length(box->high - box->low));
      framed_ = true;
    }
  }
  ++mesh_;
  changed_.mesh = true;
  repaint_soon();
}

void ToothView::set_feed(std::shared_ptr<PatchFeed> feed) {
  feed_ = std::move(feed);
  store_.clear();
  ++mesh_;
  changed_.mesh = true;
  awaited_ = mesh_;
  if (!painter_) {
    take_feed();
    note_shown(mesh_);
  }
  repaint_soon();
}

void ToothView::take_feed() {
  asked_.store(false);
  if (!feed_) return;
  for (BakedPatch& patch : feed_->take(~std::size_t{0}).patches) store_.put(std::move(patch));
}

void ToothView::feed_changed() {
  if (asked_.exchange(true)) return;
  QMetaObject::invokeMethod(
      this, [this] { painter_ ? repaint_soon() : take_feed(); }, Qt::QueuedConnection);
}

void ToothView::frame_ended() {
  if (stats_ != nullptr) stats_->frame(std::chrono::steady_clock::now(), changes_, draw_ms_);
  changes_.clear();
  // Not before: two frames in work at once would keep the mirror's thread from the processor.
  drawing_ = false;
  if (shows_motion_) rest_.start(static_cast<int>(std::max(kRestMs, kRestFrames * draw_ms_)));
  order_frame();
}

void ToothView::set_scenery(std::shared_ptr<const SceneryLook> scenery) {
  if (scenery == scenery_) return;
  scenery_ = std::move(scenery);
  changed_.scenery = true;
  repaint_soon();
}

void ToothView::set_lines(std::vector<OverlayLine> lines) {
  lines_ = std::move(lines);
  changed_.lines = true;
  repaint_soon();
}

void ToothView::set_marks(SurfaceMarks marks) {
  if (marks.empty() && marks_.empty()) return;
  marks_ = std::move(marks);
  changed_.marks = true;
  repaint_soon();
}

void ToothView::set_colouring(Colouring colouring) {
  scene_.colouring = colouring;
  repaint_soon();
}

void ToothView::set_target_shown(bool on) {
  scene_.show_target = on;
  repaint_soon();
}

void ToothView::set_handpiece_shown(bool on) {
  if (on == scene_.show_handpiece) return;
  scene_.show_handpiece = on;
  repaint_soon();
}

void ToothView::set_hand(HandSide hand) {
  if (hand == scene_.hand) return;
  scene_.hand = hand;
  repaint_soon();
}

bool ToothView::moved_visibly(const std::optional<BurPose>& bur) const {
  const auto& now = scene_.bur;
  if (bur.has_value() != now.has_value()) return true;
  if (!bur) return false;
  // A bur that moves by less than a fifth of a pixel is where it was.
  return !(bur->bur == now->bur) || bur->turning != now->turning || bur->axis != now->axis ||
         glm::length(bur->pivot_mm - now->pivot_mm) * scene_.camera.px_per_mm(std::min(width(), height())) > 0.2;
}

void ToothView::set_bur(const std::optional<BurPose>& bur) {
  if (!moved_visibly(bur)) return;
  scene_.bur = bur;
  repaint_soon();
}

void ToothView::follow_bur(std::chrono::milliseconds pause) {
  if (!bur_source_ || std::chrono::steady_clock::now() - ordered_at_ < pause) return;
  if (moved_visibly(bur_source_())) repaint_soon();
}

void ToothView::set_mirror(const std::optional<MouthMirror>& mirror) {
  if (mirror == scene_.mirror) return;
  scene_.mirror = mirror;
  repaint_soon();
}

void ToothView::set_cutaway(std::optional<SectionImage> image) {
  scene_.cutaway = image ? std::optional(image->plane) : std::nullopt;
  section_ = std::move(image);
  changed_.section = true;
  repaint_soon();
}

void ToothView::set_camera(const Camera& camera) {
  if (framed_ && camera == scene_.camera) return;
  framed_ = true;
  scene_.camera = camera;
  repaint_soon();
  Q_EMIT camera_changed();
}

void ToothView::look_at(Vec3 place_mm) {
  Camera camera = scene_.camera;
  const Vec3 out = place_mm - camera.centre_mm();
  const double flat = std::hypot(out.x, out.y);
  // From above unless the place lies well down the side; the side it lies on comes forward.
  const double pitch = std::clamp(std::atan2(out.z + 2.0, flat), 0.35, 1.35);
  camera.set_angles(flat > 0.3 ? std::atan2(-out.x, out.y) : camera.yaw(), pitch);
  camera.set_centre(place_mm);
  set_camera(camera);
}

std::optional<PickedPoint> ToothView::pick(QPointF at) const { return store_.pick(ray(at)); }

Ray ToothView::ray(QPointF at) const {
  return scene_.camera.ray({at.x(), at.y()}, {std::max(width(), 1), std::max(height(), 1)});
}

std::optional<QPointF> ToothView::project(Vec3 mm) const {
  const auto p = scene_.camera.project(mm, {std::max(width(), 1), std::max(height(), 1)});
  if (!p) return std::nullopt;
  return QPointF(p->x, p->y);
}

void ToothView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  repaint_soon();
}

void ToothView::mousePressEvent(QMouseEvent* event) {
  last_ = event->position();
  if (event->button() == Qt::LeftButton && !left_turns_) Q_EMIT pressed(last_, event->modifiers());
}

void ToothView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_;
  last_ = event->position();
  const Qt::MouseButtons turning = left_turns_ ? Qt::LeftButton | Qt::RightButton : Qt::MouseButtons(Qt::RightButton);
  if (event->buttons() & turning) {
    Camera camera = scene_.camera;
    if (event->modifiers() & Qt::ShiftModifier) {
      camera.pan({by.x(), by.y()}, std::min(width(), height()));
    } else {
      camera.orbit(-by.x() * kTurnPerPx, by.y() * kTurnPerPx);
    }
    set_camera(camera);
  } else if (event->buttons() & Qt::MiddleButton) {
    Camera camera = scene_.camera;
    camera.pan({by.x(), by.y()}, std::min(width(), height()));
    set_camera(camera);
  }
  if (!left_turns_) Q_EMIT moved(last_, event->buttons(), event->modifiers());
}

void ToothView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !left_turns_) Q_EMIT released(event->position());
}

void ToothView::wheelEvent(QWheelEvent* event) {
  const int delta = event->angleDelta().y();
  if (delta == 0) return;
  if (wheel_taken_ && !(event->modifiers() & Qt::ControlModifier)) {
    Q_EMIT wheel_turned(delta);
    return;
  }
  Camera camera = scene_.camera;
  camera.zoom(std::pow(kZoomPerNotch, delta / 120.0));
  set_camera(camera);
}

void ToothView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) read_theme();
  QWidget::changeEvent(event);
}

}  // namespace cusp::ui
