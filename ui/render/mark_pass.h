/// Patches of the surface that a measure is about, striped over the tooth. Hidden where the tooth is before them.
/// Thread: the one that holds the context.
#pragma once

#include <array>
#include <vector>

#include "ui/render/gl_program.h"

namespace cusp::ui {

class MarkPass {
 public:
  ~MarkPass();
  bool create(std::string& why);
  /// Corners in millimetres, specimen frame.
  void set(const std::vector<std::array<Vec3f, 3>>& triangles);
  void draw(const FrameView& view);

 private:
  GlProgram program_;
  GLuint array_ = 0, vertices_ = 0;
  GLsizei count_ = 0;
};

}  // namespace cusp::ui
