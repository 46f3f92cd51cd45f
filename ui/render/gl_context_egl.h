/// An OpenGL 3.3 core context without a window or display server, and a framebuffer to draw into.
/// Thread: current on the thread that made it, until destroyed there. A thread on which a window's context is current
/// cannot have one: libglvnd lets a thread use one window system at a time (eglMakeCurrent fails with 0x3002).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ui/render/framebuffer.h"

namespace cusp::ui {

class EglContext {
 public:
  /// nullptr when there is none; `why` names the call that failed and its code.
  static std::unique_ptr<EglContext> create(int width_px, int height_px, std::string* why = nullptr);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  int width() const noexcept { return framebuffer_->size().width_px; }
  int height() const noexcept { return framebuffer_->size().height_px; }
  /// What is in the framebuffer: top row first, R, G, B, A.
  std::vector<std::uint8_t> read_rgba() const;
  /// The first error since the last asking, as "OpenGL 0x0505"; empty without one.
  std::string failed_call() const;

 private:
  EglContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::unique_ptr<Framebuffer> framebuffer_;
};

}  // namespace cusp::ui
