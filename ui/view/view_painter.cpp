#include "ui/view/view_painter.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QThread>
#include <chrono>
#include <span>
#include <utility>

#include "ui/render/framebuffer.h"
#include "ui/render/opengl_allowed.h"
#include "ui/view/low_priority.h"

namespace cusp::ui {
namespace {

// What a frame may upload: a bur changes some 40 patches of 5 kB; the first frame of a mesh takes all.
constexpr std::size_t kUploadBytes = 1u << 20;

QSurfaceFormat wanted_format() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

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
    const FramebufferSize size{order.size_px.width(), order.size_px.height()};
    if (picture_ && (!framebuffer_ || framebuffer_->size() != size)) {
      framebuffer_.reset();
      framebuffer_ = Framebuffer::create(size, usual_multisampling(), &why);
    }
    if (!picture_ || !framebuffer_) {
      out.why = QString::fromStdString(why);
      return out;
    }
    put(order, out);
    framebuffer_->bind();
    picture_->draw(order.scene, size.width_px, size.height_px);
    out.in_software = in_software_;
    out.image = std::move(order.spare);
    if (out.image.size() != order.size_px) out.image = QImage(order.size_px, QImage::Format_RGB32);
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
  int mesh_ = -1;
  bool in_software_ = false;
};

ViewPainter::ViewPainter(Drawn drawn) : drawn_(std::move(drawn)) {}

std::unique_ptr<ViewPainter> ViewPainter::create(Drawn drawn) {
  const QString platform = QGuiApplication::platformName();
  if (!opengl_allowed() || platform == u"offscreen" || platform == u"minimal" || platform == u"vnc") return nullptr;
  std::unique_ptr<ViewPainter> out(new ViewPainter(std::move(drawn)));
  out->surface_ = std::make_unique<QOffscreenSurface>();
  out->surface_->setFormat(wanted_format());
  out->surface_->create();
  if (!out->surface_->isValid()) return nullptr;
  out->thread_.reset(QThread::create([painter = out.get()] { painter->run(); }));
  out->thread_->setObjectName(QStringLiteral("tooth view"));
  out->thread_->start();
  return out;
}

ViewPainter::~ViewPainter() {
  if (!thread_) return;
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

void ViewPainter::run() {
  using Clock = std::chrono::steady_clock;
  // Before the context: software OpenGL starts its own threads with it, and they inherit the priority.
  lower_own_priority();
  context_ = std::make_unique<QOpenGLContext>();
  context_->setFormat(wanted_format());
  const bool able = context_->create() && context_->makeCurrent(surface_.get());
  {
    Canvas canvas;
    while (std::optional<FrameOrder> order = next_order()) {
      const Clock::time_point start = Clock::now();
      FinishedFrame frame;
      if (able) {
        frame = canvas.draw(*order);
      } else {
        frame.why = QStringLiteral("OpenGL 3.3");
      }
      frame.draw_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      drawn_(std::move(frame));
    }
  }
  context_->doneCurrent();
  context_.reset();
}

}  // namespace cusp::ui
