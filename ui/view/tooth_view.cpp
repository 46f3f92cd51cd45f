#include "ui/view/tooth_view.h"

#include <QGuiApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/view/frame_stats.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

// What a frame may upload: a bur changes some 40 patches of 5 kB; a whole molar comes over a few frames.
constexpr std::size_t kUploadBytes = 1u << 20;
constexpr double kTurnPerPx = 0.008;  // radians; half a turn across a view 400 px wide
constexpr double kZoomPerNotch = 1.15;

QSurfaceFormat wanted_format() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(0);       // multisampling halves the rate under software OpenGL
  format.setSwapInterval(0);  // a frame is asked for, never waited for
  return format;
}

/// False on platforms whose windows have no OpenGL, and where a context cannot be made.
bool windows_have_opengl() {
  static const bool able = [] {
    const QString platform = QGuiApplication::platformName();
    if (platform == u"offscreen" || platform == u"minimal" || platform == u"vnc") return false;
    QOpenGLContext context;
    context.setFormat(wanted_format());
    return context.create();
  }();
  return able;
}

Colour colour_of(const QColor& c) {
  return {static_cast<float>(c.redF()), static_cast<float>(c.greenF()), static_cast<float>(c.blueF()), 1.0f};
}

}  // namespace

class ToothView::Surface : public QOpenGLWidget {
 public:
  explicit Surface(ToothView* view) : QOpenGLWidget(view), view_(*view) {
    setFormat(wanted_format());
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] { view_.frame_ended(); });
  }
  ~Surface() override {
    makeCurrent();
    picture_.reset();
    doneCurrent();
  }

  bool scenery_changed = true, lines_changed = true, section_changed = true, all_changed = true;

 protected:
  void initializeGL() override {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
      makeCurrent();
      picture_.reset();
      doneCurrent();
    });
    picture_ = ToothPicture::create();
    scenery_changed = lines_changed = section_changed = all_changed = true;
  }

  void paintGL() override {
    if (!picture_) return;
    view_.draw_start_ = std::chrono::steady_clock::now();
    view_.drawn_ = true;
    view_.asked_.store(false);
    if (view_.bur_source_) view_.scene_.bur = view_.bur_source_();
    if (all_changed) {
      picture_->clear();
      for (const auto& [brick, patch] : view_.store_.patches()) picture_->put(patch);
    }
    if (view_.feed_) {
      FedPatches fed = view_.feed_->take(all_changed ? ~std::size_t{0} : kUploadBytes);
      for (BakedPatch& patch : fed.patches) {
        picture_->put(patch);
        view_.store_.put(std::move(patch));
      }
      view_.changes_.insert(view_.changes_.end(), fed.changes.begin(), fed.changes.end());
      if (fed.more) QMetaObject::invokeMethod(this, [this] { update(); }, Qt::QueuedConnection);
    }
    all_changed = false;
    if (std::exchange(scenery_changed, false)) picture_->set_scenery(view_.scenery_.get());
    if (std::exchange(lines_changed, false)) picture_->set_lines(view_.lines_);
    if (std::exchange(section_changed, false) && view_.section_) picture_->set_section(*view_.section_);
    const qreal ratio = devicePixelRatioF();
    view_.scene_.line_scale = static_cast<float>(ratio);
    picture_->draw(view_.scene_, static_cast<int>(std::lround(width() * ratio)),
                   static_cast<int>(std::lround(height() * ratio)));
  }

 private:
  ToothView& view_;
  std::unique_ptr<ToothPicture> picture_;
};

ToothView::ToothView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(240, 200);
  setAttribute(Qt::WA_OpaquePaintEvent);
  if (windows_have_opengl()) {
    surface_ = new Surface(this);
  } else {
    auto* lay = new QVBoxLayout(this);
    auto* note = make_label(tr("The tooth is drawn where the screen has OpenGL."), TextRole::body, Weight::regular, "text2");
    note->setAlignment(Qt::AlignCenter);
    note->setWordWrap(true);
    lay->addWidget(note);
    setAttribute(Qt::WA_OpaquePaintEvent, false);
  }
  setAccessibleName(tr("Tooth"));
  read_theme();
}

ToothView::~ToothView() {
  delete surface_;
  surface_ = nullptr;
}

void ToothView::repaint_soon() {
  if (surface_ != nullptr) surface_->update();
}

void ToothView::read_theme() {
  scene_.background_middle = colour_of(tokens().view_middle);
  scene_.background_edge = colour_of(tokens().view_edge);
  repaint_soon();
}

void ToothView::show_volume(const Volume& volume, const FeedSettings& settings) {
  feed_.reset();
  store_.clear();
  PatchFeed feed(settings);
  feed.build_all(volume);
  for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) store_.put(std::move(patch));
  if (!framed_) {
    if (const std::optional<Box> box = store_.bounds()) {
      scene_.camera = Camera::about(0.5 * (box->low + box->high), 0.5 * glm::length(box->high - box->low));
      framed_ = true;
    }
  }
  if (surface_ != nullptr) surface_->all_changed = true;
  repaint_soon();
}

void ToothView::set_feed(std::shared_ptr<PatchFeed> feed) {
  feed_ = std::move(feed);
  store_.clear();
  if (surface_ != nullptr) {
    surface_->all_changed = true;
  } else if (feed_) {
    for (BakedPatch& patch : feed_->take(~std::size_t{0}).patches) store_.put(std::move(patch));
  }
  repaint_soon();
}

void ToothView::feed_changed() {
  if (asked_.exchange(true)) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (surface_ != nullptr) {
          surface_->update();
        } else {
          asked_.store(false);
          if (feed_)
            for (BakedPatch& patch : feed_->take(~std::size_t{0}).patches) store_.put(std::move(patch));
        }
      },
      Qt::QueuedConnection);
}

void ToothView::frame_ended() {
  if (!drawn_) return;
  drawn_ = false;
  const auto now = std::chrono::steady_clock::now();
  if (stats_ != nullptr) {
    const std::chrono::duration<double, std::milli> took = now - draw_start_;
    stats_->frame(now, changes_, took.count());
  }
  changes_.clear();
}

void ToothView::set_scenery(std::shared_ptr<const SceneryLook> scenery) {
  if (scenery == scenery_) return;
  scenery_ = std::move(scenery);
  if (surface_ != nullptr) surface_->scenery_changed = true;
  repaint_soon();
}

void ToothView::set_lines(std::vector<OverlayLine> lines) {
  lines_ = std::move(lines);
  if (surface_ != nullptr) surface_->lines_changed = true;
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
  if (!bur_source_ || std::chrono::steady_clock::now() - draw_start_ < pause) return;
  if (moved_visibly(bur_source_())) repaint_soon();
}

void ToothView::set_cutaway(std::optional<SectionImage> image) {
  scene_.cutaway = image ? std::optional(image->plane) : std::nullopt;
  section_ = std::move(image);
  if (surface_ != nullptr) surface_->section_changed = true;
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
  if (surface_ != nullptr) {
    surface_->setGeometry(rect());
    surface_->lower();
  }
  QWidget::resizeEvent(event);
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
