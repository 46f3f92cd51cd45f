/// Head and neck of a contra-angle handpiece above the bur, from the side of the hand that holds it, clear about the bur's tip. Thread: the one that
/// holds the context.
#pragma once

#include <vector>

#include "ui/render/body_buffer.h"
#include "ui/render/gl_program.h"
#include "ui/render/tooth_picture.h"

namespace cusp::ui {

/// The side of a bur's axis at which the neck leaves the head: at right angles to the axis, towards that hand of a viewer who
/// looks with this view. `axis`: unit. Returns a unit vector.
Vec3 neck_side(const FrameView& view, Vec3 axis, HandSide hand);

/// Triangles of the head, which encloses the z axis, and after them of the neck, which leaves it towards x. z: 0 where the bur's
/// shank begins. Millimetres.
std::vector<BodyVertex> handpiece_mesh();

class HandpiecePass {
 public:
  bool create(std::string& why);
  /// Blends over what is drawn: after everything else of the frame.
  void draw(const FrameView& view, const BurPose& pose, HandSide hand);

 private:
  GlProgram program_;
  BodyBuffer body_;
};

}  // namespace cusp::ui
