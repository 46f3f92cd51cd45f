/// The burr: cutting head, neck and shank as one body of revolution. Thread: the one that holds the context.
#pragma once

#include <optional>
#include <vector>

#include "ui/render/gl_program.h"
#include "ui/render/tooth_picture.h"

namespace cusp {

struct BurrVertex {
  Vec3f position_mm;  // tool's frame: pivot at the origin, z towards the shank
  Vec3f normal;
  float cutting;      // 1 on the head
};

/// Triangles of a burr, counter-clockwise seen from outside; the shank's far end is open.
std::vector<BurrVertex> burr_mesh(const Burr& burr);

class BurrPass {
 public:
  ~BurrPass();
  bool create(std::string& why);
  void draw(const FrameView& view, const BurrPose& pose);

 private:
  GlProgram program_;
  GLuint array_ = 0, vertices_ = 0;
  GLsizei count_ = 0;
  std::optional<Burr> made_;
};

}  // namespace cusp
