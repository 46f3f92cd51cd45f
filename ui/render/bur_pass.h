/// The bur: cutting head, neck and shank as one body of revolution. Thread: the one that holds the context.
#pragma once

#include <optional>
#include <vector>

#include "ui/render/gl_program.h"
#include "ui/render/tooth_picture.h"

namespace cusp::ui {

struct BurVertex {
  Vec3f position_mm;  // tool's frame: pivot at the origin, z towards the shank
  Vec3f normal;
  float cutting;      // 1 on the head
};

/// Triangles of a bur, counter-clockwise seen from outside; the shank's far end is open.
std::vector<BurVertex> bur_mesh(const Bur& bur);

class BurPass {
 public:
  ~BurPass();
  bool create(std::string& why);
  void draw(const FrameView& view, const BurPose& pose);

 private:
  GlProgram program_;
  GLuint array_ = 0, vertices_ = 0;
  GLsizei count_ = 0;
  std::optional<Bur> made_;
};

}  // namespace cusp::ui
