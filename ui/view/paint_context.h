/// The OpenGL 3.3 core context in which a ViewPainter draws. Thread: the painter's, but for construction and destruction.
#pragma once

namespace cusp::ui {

class PaintContext {
 public:
  PaintContext() = default;
  virtual ~PaintContext() = default;
  PaintContext(const PaintContext&) = delete;
  PaintContext& operator=(const PaintContext&) = delete;

  /// Makes one and makes it current. False: there is none. Pre: none stands.
  virtual bool make() = 0;
  /// Whether the graphics card has lost it, with all that was uploaded. Pre: make() gave one.
  virtual bool lost() = 0;
  virtual void end() = 0;
};

}  // namespace cusp::ui
