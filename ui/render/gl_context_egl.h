/// An OpenGL 3.3 core context without a window or display server, and a framebuffer to draw into.
/// Thread: current on the thread that made it, until destroyed there. A thread on which a window's context is current
/// cannot have one: libglvnd lets a thread use one window system at a time (eglMakeCurrent fails with 0x3002).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cusp::ui {

class EglContext {
 public:
  /// nullptr when there is none; `why` names the call that failed and its code.
  static std::unique_ptr<EglContext> create(int width_px, int height_px, std::string* why = nullptr);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  /// What is in the framebuffer: top row first, R, G, B, A.
  std::vector<std::uint8_t> read_rgba() const;
  /// The first error since the last asking, as "OpenGL 0x0505"; empty without one.
  std::string failed_call() const;

 private:
  EglContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  unsigned framebuffer_ = 0, colour_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace cusp::ui
