#include "ui/render/tooth_picture.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "ui/render/bur_pass.h"
#include "ui/render/gl_program.h"
#include "ui/render/handpiece_pass.h"
#include "ui/render/mark_pass.h"
#include "ui/render/mesh_buffers.h"
#include "ui/render/mirror_pass.h"
#include "ui/render/overlay_pass.h"
#include "ui/render/tooth_pass.h"

namespace cusp::ui {
namespace {

// Everything lies within it of the camera's centre: a tooth is 25 mm long, a bur with its shank 20.
constexpr double kReachMm = 60.0;

/// Background, and the lid of a cutaway: one quad each, too small for files of their own.
class FlatPasses {
 public:
  ~FlatPasses() {
    if (array_ != 0) glDeleteVertexArrays(1, &array_);
    if (texture_ != 0) glDeleteTextures(1, &texture_);
  }
  bool create(std::string& why) {
    if (!background_.link("background", why) || !lid_.link("section", why)) return false;
    glGenVertexArrays(1, &array_);
    glGenTextures(1, &texture_);
    return true;
  }
  void background(const Scene3d& scene) {
    background_.use();
    background_.set("middle", glm::vec3(scene.background_middle.r, scene.background_middle.g, scene.background_middle.b));
    background_.set("edge", glm::vec3(scene.background_edge.r, scene.background_edge.g, scene.background_edge.b));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  void set_section(const SectionImage& image) {
    plane_ = image.plane;
    size_mm_ = image.mm_per_px * glm::dvec2(image.width, image.height);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  void lid(const FrameView& view) {
    if (size_mm_.x <= 0) return;
    lid_.use();
    lid_.set("clip_from_world", view.clip_from_world);
    const Vec3 right = size_mm_.x * plane_.right, up = size_mm_.y * plane_.up;
    lid_.set("corner", glm::vec3(plane_.centre_mm - 0.5 * right + 0.5 * up));
    lid_.set("right", glm::vec3(right));
    lid_.set("up", glm::vec3(up));
    lid_.set("picture", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }

 private:
  GlProgram background_, lid_;
  GLuint array_ = 0, texture_ = 0;
  SectionPlane plane_;
  glm::dvec2 size_mm_{0.0};
};

/// What the passes share. `scenery`: its box, which the view has to reach.
FrameView view_of(const Scene3d& scene, const Box& scenery, int width_px, int height_px) {
  const Camera& camera = scene.camera;
  const double aspect = static_cast<double>(width_px) / std::max(height_px, 1);
  FrameView view;
  const Vec3 furthest = glm::max(glm::abs(scenery.low - camera.centre_mm()), glm::abs(scenery.high - camera.centre_mm()));
  const bool bare = scenery == Box{};
  view.clip_from_world = glm::mat4(camera.clip_from_world(aspect, bare ? kReachMm : std::max(kReachMm, glm::length(furthest))));
  view.eye = glm::vec3(camera.eye_mm());
  // The lamp moves with the eye, as a dentist's does: upper left before, a weaker one at the right, one behind.
  const Vec3 back = -camera.forward();
  const auto towards = [&](double right, double up, double near) {
    return glm::vec3(glm::normalize(right * camera.right() + up * camera.up() + near * back));
  };
  view.key_light = towards(-0.45, 0.55, 0.70);
  view.fill_light = towards(0.85, 0.30, 0.42);
  view.back_light = towards(0.25, 0.80, -0.50);
  view.right = glm::vec3(camera.right());
  view.to_eye = glm::vec3(back);
  view.half_way = glm::normalize(view.key_light + glm::vec3(back));
  // Half the picture's shorter side, at the distance of its middle.
  view.lamp = glm::vec4(glm::vec3(camera.centre_mm()), static_cast<float>(0.5 * 1000.0 / camera.px_per_mm(1000.0)));
  view.up = glm::vec3(camera.up());
  view.view_px = glm::vec2(width_px, height_px);
  view.line_scale = scene.line_scale;
  return view;
}

}  // namespace

struct ToothPicture::Inner {
  MeshBuffers mesh, scenery;
  Box scenery_bounds;
  ToothPass tooth;
  MarkPass marks;
  OverlayPass overlay, mark_lines;
  BurPass bur;
  HandpiecePass handpiece;
  MirrorPass mirror;
  FlatPasses flat;

  DrawStats draw_solids(const FrameView& view, const Scene3d& scene, glm::vec4 clip);
  DrawStats draw_mirror(const FrameView& view, const Scene3d& scene);
};

ToothPicture::ToothPicture() = default;
ToothPicture::~ToothPicture() = default;

std::unique_ptr<ToothPicture> ToothPicture::create(std::string* why) {
  std::string reason;
  if (epoxy_gl_version() < 33) {
    reason = "OpenGL " + std::to_string(epoxy_gl_version() / 10) + "." + std::to_string(epoxy_gl_version() % 10);
  } else {
    std::unique_ptr<ToothPicture> out(new ToothPicture);
    out->inner_ = std::make_unique<Inner>();
    Inner& in = *out->inner_;
    if (in.tooth.create(reason) && in.marks.create(reason) && in.overlay.create(reason) && in.mark_lines.create(reason) && in.bur.create(reason) && in.handpiece.create(reason) && in.mirror.create(reason) &&
        in.flat.create(reason))
      return out;
  }
  if (why != nullptr) *why = reason;
  return nullptr;
}

void ToothPicture::put(const BakedPatch& patch) { inner_->mesh.put(patch); }
void ToothPicture::clear() { inner_->mesh.clear(); }
void ToothPicture::set_scenery(const SceneryLook* scenery) {
  inner_->scenery.clear();
  inner_->scenery_bounds = {};
  if (scenery == nullptr) return;
  inner_->scenery_bounds = scenery->bounds();
  for (const BakedPatch& patch : scenery->patches()) inner_->scenery.put(patch);
}
void ToothPicture::set_lines(const std::vector<OverlayLine>& lines) { inner_->overlay.set(lines); }
void ToothPicture::set_marks(const SurfaceMarks& marks) {
  inner_->marks.set(marks.triangles);
  inner_->mark_lines.set(marks.lines);
}
void ToothPicture::set_section(const SectionImage& image) { inner_->flat.set_section(image); }

DrawStats ToothPicture::Inner::draw_solids(const FrameView& view, const Scene3d& scene, glm::vec4 clip) {
  const bool clipped = clip != glm::vec4(0.0f);
  if (clipped) glEnable(GL_CLIP_DISTANCE0);
  const MeshBuffers::Drawn specimen = tooth.draw(mesh, view, scene, clip);
  const MeshBuffers::Drawn about = tooth.draw(scenery, view, scene, clip);  // last: much of it lies behind
  if (clipped) glDisable(GL_CLIP_DISTANCE0);
  return {specimen.triangles + about.triangles, specimen.bricks + about.bricks};
}

DrawStats ToothPicture::Inner::draw_mirror(const FrameView& view, const Scene3d& scene) {
  const MouthMirror& held = *scene.mirror;
  DrawStats out;
  if (shows_glass(held, Vec3(view.eye))) {
    mirror.begin_glass(view, held);
    const FrameView behind = reflected(view, held);
    glFrontFace(GL_CW);
    out = draw_solids(behind, scene, before_glass(held));
    if (scene.bur) bur.draw(behind, *scene.bur);
    if (scene.show_target) overlay.draw(behind);
    glFrontFace(GL_CCW);
    mirror.end_glass(view, held);
  }
  mirror.draw_mount(view, held);
  return out;
}

DrawStats ToothPicture::draw(const Scene3d& scene, int width_px, int height_px) {
  Inner& in = *inner_;
  const FrameView view = view_of(scene, in.scenery_bounds, width_px, height_px);
  glViewport(0, 0, width_px, height_px);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_STENCIL_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  in.flat.background(scene);

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glm::vec4 clip(0.0f);
  if (scene.cutaway) {
    const Vec3 n = -scene.cutaway->normal();
    clip = glm::vec4(glm::vec3(n), static_cast<float>(-glm::dot(n, scene.cutaway->centre_mm)));
  }
  DrawStats drawn = in.draw_solids(view, scene, clip);
  if (scene.cutaway) {
    in.flat.lid(view);
    glEnable(GL_CULL_FACE);
  }
  if (!scene.cutaway) {
    in.marks.draw(view);
    in.mark_lines.draw(view);
  }
  if (scene.bur) in.bur.draw(view, *scene.bur);
  if (scene.show_target && !scene.cutaway) in.overlay.draw(view);
  if (scene.bur) in.bur.draw_faded_shank(view, *scene.bur);
  if (scene.mirror && !scene.cutaway) {
    const DrawStats mirrored = in.draw_mirror(view, scene);
    drawn.triangles += mirrored.triangles;
    drawn.bricks += mirrored.bricks;
  }
  if (scene.bur && scene.show_handpiece && !scene.cutaway && !scene.mirror) in.handpiece.draw(view, *scene.bur, scene.hand);
  glBindVertexArray(0);
  glUseProgram(0);
  return drawn;
}

}  // namespace cusp::ui
