/// Lines at the surface, of constant width in pixels, each on its casing. Hidden where the tooth is before them.
/// Thread: the one that holds the context.
#pragma once

#include <vector>

#include "ui/render/gl_program.h"
#include "ui/render/overlay_line.h"

namespace cusp::ui {

class OverlayPass {
 public:
  ~OverlayPass();
  bool create(std::string& why);
  void set(const std::vector<OverlayLine>& lines);
  void draw(const FrameView& view);

 private:
  struct Range {
    LineStyle style;
    GLint first = 0;
    GLsizei count = 0;
  };
  GlProgram program_;
  GLuint array_ = 0, vertices_ = 0;
  std::vector<Range> ranges_;
};

}  // namespace cusp::ui
