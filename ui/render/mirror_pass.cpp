#include "ui/render/mirror_pass.h"

#include <cmath>
#include <vector>

#include "ui/render/turned_body.h"

namespace cusp::ui {
namespace {

constexpr int kSides = 64;          // sides of the glass and its mount
constexpr float kHandleMm = 60.0f;   // past the picture's edge
constexpr double kHandleTilt = 0.5;  // of the handle out of the glass's plane, away from the glass; radians

/// From the middle of the back round the edge to the glass.
std::vector<BodyRing> mount_rings() {
  constexpr auto r = static_cast<float>(MouthMirror::kRadiusMm);
  return {{-1.9f, 0.0f, -1, 0},       {-1.8f, 0.6f * r, -0.97f, 0.24f}, {-1.2f, 0.93f * r, -0.7f, 0.7f},
          {-0.4f, r + 0.7f, -0.2f, 0.98f}, {0.15f, r + 0.75f, 0.4f, 0.92f},  {0.3f, r + 0.35f, 0.97f, 0.2f},
          {0.0f, r - 0.05f, 0.6f, -0.8f}};
}

std::vector<BodyRing> handle_rings() {
  constexpr float kThin = 0.75f, kThick = 1.6f;
  const auto r = static_cast<float>(MouthMirror::kRadiusMm);
  return {{r - 0.5f, kThin, 0, 1}, {r + 14.0f, kThin, 0, 1}, {r + 17.0f, kThick, -0.25f, 0.97f}, {r + kHandleMm, kThick, 0, 1}};
}

}  // namespace

FrameView reflected(const FrameView& view, const MouthMirror& mirror) {
  const glm::vec3 n(mirror.normal), c(mirror.centre_mm);
  const auto way = [&](glm::vec3 v) { return v - 2.0f * glm::dot(v, n) * n; };
  const glm::mat3 turn(way({1, 0, 0}), way({0, 1, 0}), way({0, 0, 1}));
  glm::mat4 world_from_world(turn);
  world_from_world[3] = glm::vec4(2.0f * glm::dot(c, n) * n, 1.0f);
  FrameView out = view;
  out.clip_from_world = view.clip_from_world * world_from_world;
  out.eye = glm::vec3(world_from_world * glm::vec4(view.eye, 1.0f));
  for (glm::vec3 FrameView::* ray : {&FrameView::key_light, &FrameView::fill_light, &FrameView::back_light, &FrameView::up,
                                     &FrameView::right, &FrameView::to_eye, &FrameView::half_way})
    out.*ray = way(view.*ray);
  return out;
}

glm::vec4 before_glass(const MouthMirror& mirror) {
  return {glm::vec3(mirror.normal), static_cast<float>(-glm::dot(mirror.normal, mirror.centre_mm))};
}

MirrorPass::~MirrorPass() {
  if (glass_array_ != 0) glDeleteVertexArrays(1, &glass_array_);
}

bool MirrorPass::create(std::string& why) {
  if (!glass_.link("glass", why) || !metal_.link("bur", why)) return false;
  std::vector<BodyVertex> bodies;
  add_body(bodies, mount_rings(), kSides);
  mount_ = {0, static_cast<GLsizei>(bodies.size())};
  add_body(bodies, handle_rings(), kSides);
  handle_ = {mount_.count, static_cast<GLsizei>(bodies.size()) - mount_.count};
  glGenVertexArrays(1, &glass_array_);
  bodies_.create();
  bodies_.fill(bodies);
  return true;
}

void MirrorPass::draw_glass(const FrameView& view, const MouthMirror& mirror) {
  const auto right = glm::vec3(mirror.handle), up = glm::vec3(glm::cross(mirror.normal, mirror.handle));
  constexpr auto r = static_cast<float>(MouthMirror::kRadiusMm);
  glass_.use();
  glass_.set("clip_from_world", view.clip_from_world);
  glass_.set("middle", glm::vec3(mirror.centre_mm));
  glass_.set("right", r * right);
  glass_.set("up", r * up);
  glass_.set("sides", kSides);
  glBindVertexArray(glass_array_);
  glDisable(GL_CULL_FACE);
  glDrawArrays(GL_TRIANGLE_FAN, 0, kSides + 2);
  glEnable(GL_CULL_FACE);
}

void MirrorPass::begin_glass(const FrameView& view, const MouthMirror& mirror) {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  draw_glass(view, mirror);
  // What stood there is farther than anything that the glass shows.
  glStencilFunc(GL_EQUAL, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDepthFunc(GL_ALWAYS);
  glDepthRange(1.0, 1.0);
  draw_glass(view, mirror);
  glDepthRange(0.0, 1.0);
  glDepthFunc(GL_LEQUAL);
}

void MirrorPass::end_glass(const FrameView& view, const MouthMirror& mirror) {
  // The glass itself hides what follows behind it.
  glDepthFunc(GL_ALWAYS);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_glass(view, mirror);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_STENCIL_TEST);
}

void MirrorPass::draw_body(Vec3 origin_mm, Vec3 along, Part part) {
  metal_.set("world_from_tool", world_from_body(origin_mm, along));
  bodies_.draw(part.first, part.count);
}

void MirrorPass::draw_mount(const FrameView& view, const MouthMirror& mirror) {
  glDisable(GL_CULL_FACE);
  metal_.use();
  metal_.set("clip_from_world", view.clip_from_world);
  metal_.set("eye", view.eye);
  metal_.set("key_light", view.key_light);
  metal_.set("up", view.up);
  metal_.set("turn", 0.0f);
  metal_.set("radius", 1.0f);
  draw_body(mirror.centre_mm, mirror.normal, mount_);
  const Vec3 along = std::cos(kHandleTilt) * mirror.handle - std::sin(kHandleTilt) * mirror.normal;
  draw_body(mirror.centre_mm, along, handle_);
  glEnable(GL_CULL_FACE);
}

}  // namespace cusp::ui
