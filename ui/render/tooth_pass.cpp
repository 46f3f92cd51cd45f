#include "ui/render/tooth_pass.h"

#include <array>

namespace cusp::ui {
namespace {

constexpr float kStripePx = 10.0f;  // of the hatching, from stripe to stripe across the view

}  // namespace

MeshBuffers::Drawn ToothPass::draw(MeshBuffers& mesh, const FrameView& view, const Scene3d& scene,
                                   glm::vec4 clip_plane) {
  const bool deviation = scene.colouring == Colouring::deviation;
  GlProgram& program = deviation ? by_deviation_ : by_tissue_;
  program.use();
  program.set("clip_from_world", view.clip_from_world);
  program.set("eye", view.eye);
  program.set("key_light", view.key_light);
  program.set("fill_light", view.fill_light);
  program.set("up", view.up);
  program.set("clip_plane", clip_plane);
  program.set("show_target", scene.show_target ? 1 : 0);
  program.set("target_colour", linear(kTargetLine));
  program.set("over_colour", glm::vec3(kOverCut.r, kOverCut.g, kOverCut.b));
  program.set("stripes_a_px", 1.0f / (kStripePx * view.line_scale));
  program.set("to_eye", view.to_eye);
  program.set("back_light", view.back_light);
  program.set("right", view.right);
  program.set("half_way", glm::vec3(glm::dot(view.half_way, view.right), glm::dot(view.half_way, view.up), glm::dot(view.half_way, view.to_eye)));
  std::array<glm::vec3, 5> map;
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = linear(kDifference[i]);
  program.set_array("map_colour", map.data(), static_cast<int>(map.size()));
  glm::vec4 bur(0.0f);
  glm::vec3 axis(0.0f, 0.0f, 1.0f);
  if (scene.bur) {
    bur = glm::vec4(glm::vec3(scene.bur->pivot_mm), static_cast<float>(scene.bur->bur.radius_mm));
    axis = glm::vec3(scene.bur->axis);
  }
  program.set("lamp", view.lamp);
  program.set("bur", bur);
  program.set("bur_axis", axis);
  return mesh.draw(view.clip_from_world, view.eye, clip_plane);
}

}  // namespace cusp::ui
