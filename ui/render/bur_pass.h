/// The bur: cutting head, neck and shank as one body of revolution. Thread: the one that holds the context.
#pragma once

#include <optional>
#include <vector>

#include "ui/render/gl_program.h"
#include "ui/render/tooth_picture.h"
#include "ui/render/turned_body.h"

namespace cusp::ui {

/// Triangles of a bur, pivot at the origin, z towards the shank, whose far end is open.
std::vector<BodyVertex> bur_mesh(const Bur& bur);

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
