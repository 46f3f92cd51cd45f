/// The bur: cutting head, neck and shank as one body of revolution. Thread: the one that holds the context.
#pragma once

#include <optional>
#include <vector>

#include "ui/render/body_buffer.h"
#include "ui/render/gl_program.h"
#include "ui/render/tooth_picture.h"

namespace cusp::ui {

/// Triangles of a bur, pivot at the origin, z towards the shank, closed at both ends.
std::vector<BodyVertex> bur_mesh(const Bur& bur);

class BurPass {
 public:
  bool create(std::string& why);
  /// Neck and shank only where they are not seen along the axis.
  void draw(const FrameView& view, const BurPose& pose);
  /// The rest, half transparent, over tooth and target.
  void draw_faded_shank(const FrameView& view, const BurPose& pose);

 private:
  void use(const FrameView& view, const BurPose& pose, float share);

  GlProgram program_;
  BodyBuffer body_;
  std::optional<Bur> made_;
  GLsizei blades_ = 0, count_ = 0;  // vertices of the blades, and of all
};

}  // namespace cusp::ui
