/// The tooth: shaded by three lights and the light baked into its vertices, coloured by tissue or by deviation.
/// Thread: the one that holds the context.
#pragma once

#include <optional>

#include "ui/render/gl_program.h"
#include "ui/render/mesh_buffers.h"
#include "ui/render/tooth_picture.h"

namespace cusp::ui {

class ToothPass {
 public:
  bool create(std::string& why) {
    return by_tissue_.link("tooth", why) && by_deviation_.link("tooth", why, "BY_DEVIATION");
  }
  /// `clip_plane`: kept where its product with (place, 1) is not below 0; zeros keep all.
  MeshBuffers::Drawn draw(MeshBuffers& mesh, const FrameView& view, const Scene3d& scene, glm::vec4 clip_plane);

 private:
  GlProgram by_tissue_, by_deviation_;  // two programs: a branch costs software OpenGL both of its sides
};

}  // namespace cusp::ui
