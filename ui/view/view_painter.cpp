#include "ui/view/view_painter.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QThread>
#include <chrono>
#include <span>
#include <thread>
#include <utility>

#include "ui/render/framebuffer.h"
#include "ui/render/opengl_allowed.h"
#include "ui/render/reset_watch.h"
#include "ui/view/low_priority.h"

namespace cusp::ui {
namespace {

// What a frame may upload: a bur changes some 40 patches of 5 kB; the first frame of a mesh takes all.
constexpr std::size_t kUploadBytes = 1u << 20;
// After a reset a card may refuse contexts for a while; a card that loses one after the other draws nothing.
constexpr int kTriesAfterLoss = 10, kMostLosses = 3;
constexpr std::chrono::milliseconds kPauseAfterLoss{100};

QSurfaceFormat wanted_format(PaintContext::Resets resets) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setOption(QSurfaceFormat::ResetNotification, resets == PaintContext::Resets::reported);
  return format;
}

/// Of Qt's platform, on a surface that no screen shows.
class PlatformContext : public PaintContext {
 public:
  PlatformContext() {
    surface_.setFormat(wanted_format(Resets::reported));
    surface_.create();
  }
  bool valid() const { return surface_.isValid(); }

  bool make(Resets resets) override {
    context_ = std::make_unique<QOpenGLContext>();
    context_->setFormat(wanted_format(resets));
    if (!context_->create() || !context_->makeCurrent(&surface_)) return false;
    watch_.emplace();
    return true;
  }
  bool lost() override { return !context_->isValid() || watch_->lost(); }
  void end() override {
    if (!context_) return;
    watch_.reset();
    context_->doneCurrent();
    context_.reset();
  }

 private:
  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  std::optional<ResetWatch> watch_;
};

}  // namespace

/// Picture and framebuffer, kept from frame to frame. Thread: the painter's.
class ViewPainter::Canvas {
 public:
  /// Image and failure of the frame are left to paint().
  FinishedFrame draw(FrameOrder& order) {
    FinishedFrame out;
    out.mesh = order.mesh;
    std::string why;
    if (!picture_) {
      picture_ = ToothPicture::create(&why);
      in_software_ = draws_in_software();
    }
    const FramebufferSize wanted{order.size_px.width(), order.size_px.height()};
    if (picture_ && (!framebuffer_ || wanted_ != wanted)) {
      framebuffer_.reset();
      framebuffer_ = Framebuffer::create(drawable(wanted), usual_multisampling(), &why);
      wanted_ = wanted;
    }
    if (!picture_ || !framebuffer_) {
      out.why = QString::fromStdString(why);
      return out;
    }
    put(order, out);
    framebuffer_->bind();
    const FramebufferSize size = framebuffer_->size();
    order.scene.line_scale *= static_cast<float>(size.width_px) / static_cast<float>(wanted.width_px);
    picture_->draw(order.scene, size.width_px, size.height_px);
    out.in_software = in_software_;
    out.image = std::move(order.spare);
    const QSize size_px(size.width_px, size.height_px);
    if (out.image.size() != size_px) out.image = QImage(size_px, QImage::Format_RGB32);
    framebuffer_->read(PixelOrder::bgra, {out.image.bits(), static_cast<std::size_t>(out.image.sizeInBytes())});
    return out;
  }

 private:
  void put(FrameOrder& order, FinishedFrame& out) {
    const bool fresh = std::exchange(mesh_, order.mesh) != order.mesh;
    if (fresh) picture_->clear();
    for (const BakedPatch& patch : order.patches) picture_->put(patch);
    if (order.feed) {
      FedPatches fed = order.feed->take(fresh ? ~std::size_t{0} : kUploadBytes);
      for (const BakedPatch& patch : fed.patches) picture_->put(patch);
      out.fed = std::move(fed.patches);
      out.changes = std::move(fed.changes);
      out.more = fed.more;
    }
    if (order.scenery) picture_->set_scenery(order.scenery->get());
    if (order.lines) picture_->set_lines(*order.lines);
    if (order.marks) picture_->set_marks(*order.marks);
    if (order.section) picture_->set_section(*order.section);
  }

  std::unique_ptr<ToothPicture> picture_;
  std::unique_ptr<Framebuffer> framebuffer_;
  FramebufferSize wanted_;  // of framebuffer_, but for OpenGL's limits
  int mesh_ = -1;
  bool in_software_ = false;
};

ViewPainter::ViewPainter(Drawn drawn, std::unique_ptr<PaintContext> context) : drawn_(std::move(drawn)), context_(std::move(context)) {
  thread_.reset(QThread::create([this] { run(); }));
  thread_->setObjectName(QStringLiteral("tooth view"));
  thread_->start();
}

std::unique_ptr<ViewPainter> ViewPainter::create(Drawn drawn) {
  const QString platform = QGuiApplication::platformName();
  if (!opengl_allowed() || platform == u"offscreen" || platform == u"minimal" || platform == u"vnc") return nullptr;
  auto context = std::make_unique<PlatformContext>();
  if (!context->valid()) return nullptr;
  return std::make_unique<ViewPainter>(std::move(drawn), std::move(context));
}

ViewPainter::~ViewPainter() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_one();
  thread_->wait();
}

void ViewPainter::draw(FrameOrder order) {
  {
    const std::lock_guard lock(mutex_);
    order_ = std::move(order);
  }
  wake_.notify_one();
}

std::optional<FrameOrder> ViewPainter::next_order() {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return over_ || order_; });
  return over_ ? std::nullopt : std::exchange(order_, std::nullopt);
}

bool ViewPainter::make_context() {
  for (int i = 0; i < (losses_ == 0 ? 1 : kTriesAfterLoss); ++i) {
    if (i > 0) std::this_thread::sleep_for(kPauseAfterLoss);
    for (const auto resets : {PaintContext::Resets::reported, PaintContext::Resets::unreported}) {
      if (context_->make(resets)) return true;
      context_->end();
    }
  }
  return false;
}

FinishedFrame ViewPainter::draw_in(std::optional<Canvas>& canvas, FrameOrder& order) {
  FinishedFrame frame;
  frame.mesh = order.mesh;
  if (!canvas && !make_context()) {
    frame.why = QStringLiteral("OpenGL 3.3");
    return frame;
  }
  if (!canvas) canvas.emplace();
  frame = canvas->draw(order);
  if (!context_->lost()) {
    losses_ = 0;
    return frame;
  }
  canvas.reset();
  context_->end();
  frame.image = QImage();
  frame.lost = ++losses_ < kMostLosses;
  frame.why = QStringLiteral("OpenGL 3.3");
  return frame;
}

void ViewPainter::run() {
  using Clock = std::chrono::steady_clock;
  // Before the context: software OpenGL starts its own threads with it, and they inherit the priority.
  lower_own_priority();
  {
    std::optional<Canvas> canvas;  // stands while a context does
    while (std::optional<FrameOrder> order = next_order()) {
      const Clock::time_point start = Clock::now();
      FinishedFrame frame = draw_in(canvas, *order);
      frame.draw_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      drawn_(std::move(frame));
    }
  }
  context_->end();
}

}  // namespace cusp::ui
