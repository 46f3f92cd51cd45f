/// A framebuffer with depth and stencil, to draw into and to read, with or without multisampling. Thread: the one that holds the current OpenGL 3.3
/// core context; needs it current from create() to destruction.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cusp::ui {

struct FramebufferSize {
  int width_px = 0, height_px = 0;
  friend bool operator==(const FramebufferSize&, const FramebufferSize&) = default;
};

/// True where the current context's renderer is a rasteriser in software, not a graphics card.
bool draws_in_software();

enum class Multisampling : std::uint8_t { off, four };
/// Four samples where a graphics card draws; off in software, where they cost two to four frames.
Multisampling usual_multisampling();

/// `wanted`, or the largest size of its shape that the current context draws into: an old graphics card ends at 4096 or 8192 pixels a side.
FramebufferSize drawable(FramebufferSize wanted);

enum class PixelOrder : std::uint8_t { rgba, bgra };  // of the bytes of a pixel

class Framebuffer {
 public:
  /// Bound for drawing and reading. nullptr where OpenGL refuses it; `why` gives the status.
  static std::unique_ptr<Framebuffer> create(FramebufferSize size, Multisampling multisampling, std::string* why = nullptr);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  FramebufferSize size() const noexcept { return size_; }
  void bind() const;
  /// Top row first, four bytes a pixel. Waits for the drawing. Pre: pixels.size() == 4 * width * height.
  void read(PixelOrder order, std::span<std::uint8_t> pixels);

 private:
  struct Buffers {
    unsigned framebuffer = 0, colour = 0, depth = 0;
  };
  Framebuffer() = default;
  static void attach(Buffers& to, FramebufferSize size, int samples);

  FramebufferSize size_;
  Buffers drawn_, resolved_;  // resolved_: of a multisampled one, else empty
  std::vector<std::uint8_t> bottom_up_;
};

}  // namespace cusp::ui
