/// The OpenGL 3.3 core context in which a ViewPainter draws. Thread: the painter's, but for construction and destruction.
#pragma once

#include <cstdint>

namespace cusp::ui {

class PaintContext {
 public:
  /// Whether the driver is asked to report a reset of the card. A driver may refuse a context that does.
  enum class Resets : std::uint8_t { reported, unreported };
  PaintContext() = default;
  virtual ~PaintContext() = default;
  PaintContext(const PaintContext&) = delete;
  PaintContext& operator=(const PaintContext&) = delete;

  /// Makes one and makes it current. False: there is none. Pre: none stands.
  virtual bool make(Resets resets) = 0;
  /// Whether the graphics card has lost it, with all that was uploaded. Pre: make() gave one.
  virtual bool lost() = 0;
  virtual void end() = 0;
};

}  // namespace cusp::ui
