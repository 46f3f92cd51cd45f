#include "ui/render/handpiece_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace cusp::ui {
namespace {

constexpr int kHandpieceSides = 32;
// Of a common contra-angle: head 10 mm across and 13 mm high, neck at 100 degrees to the bur [M].
constexpr float kJointMm = 7.5f;      // of the neck's axis above the shank's begin
constexpr float kNeckTilt = 0.17f;    // of the neck away from the tooth, radians
constexpr float kNeckEndMm = 75.0f;   // beyond the picture's edge
// Of the picture, from the bur's tip, in millimetres at the tip: clear up to the first, as solid as it becomes from the second on.
constexpr float kClearMm = 4.0f, kSolidMm = 9.0f;
constexpr float kMostShare = 0.85f;

struct Corner {
  float z, radius;
};

/// Cones between corners, each with its own normal: turned metal with edges.
std::vector<BodyRing> rings_of(std::span<const Corner> corners) {
  std::vector<BodyRing> out;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const float dz = corners[i + 1].z - corners[i].z, dr = corners[i + 1].radius - corners[i].radius;
    const float length = std::hypot(dz, dr);
    out.push_back({corners[i].z, corners[i].radius, -dr / length, dz / length});
    out.push_back({corners[i + 1].z, corners[i + 1].radius, -dr / length, dz / length});
  }
  return out;
}

std::vector<BodyRing> head_rings() {
  constexpr std::array<Corner, 8> kHead = {{{0.8f, 0.0f}, {0.8f, 1.6f}, {0.8f, 3.0f}, {1.6f, 3.6f}, {2.8f, 4.7f}, {11.2f, 4.9f}, {12.4f, 4.2f}, {12.4f, 3.4f}}};
  std::vector<BodyRing> out = rings_of(kHead);
  // The push button, round at its edge.
  constexpr int kArc = 6;
  for (int i = 0; i <= kArc; ++i) {
    const float a = 1.5708f * static_cast<float>(i) / kArc;
    out.push_back({12.4f + 1.2f * std::sin(a), 2.2f + 1.2f * std::cos(a), std::sin(a), std::cos(a)});
  }
  out.push_back({13.6f, 0.0f, 1, 0});
  return out;
}

std::vector<BodyRing> neck_rings() {
  constexpr std::array<Corner, 6> kNeck = {{{2.0f, 3.1f}, {9.0f, 3.0f}, {20.0f, 4.1f}, {21.0f, 4.7f}, {34.0f, 5.6f}, {kNeckEndMm, 6.6f}}};
  return rings_of(kNeck);
}

}  // namespace

Vec3 neck_side(const FrameView& view, Vec3 axis, HandSide hand) {
  const auto across = [axis](Vec3 way) { return way - glm::dot(way, axis) * axis; };
  const double sideways = hand == HandSide::right ? 0.9 : -0.9;
  Vec3 side = across(sideways * Vec3(view.right) + 0.45 * Vec3(view.to_eye));
  if (glm::length(side) < 0.3) side = across(Vec3(view.up));  // the bur lies along that way
  return glm::normalize(side);
}

std::vector<BodyVertex> handpiece_mesh() {
  std::vector<BodyVertex> out;
  add_body(out, head_rings(), kHandpieceSides);
  const std::size_t head = out.size();
  add_body(out, neck_rings(), kHandpieceSides);
  const float c = std::cos(kNeckTilt), s = std::sin(kNeckTilt);
  const glm::mat3 turn(Vec3f(s, 0, -c), Vec3f(0, 1, 0), Vec3f(c, 0, s));  // columns: where x, y and z of the neck go
  for (BodyVertex& v : std::span(out).subspan(head)) {
    v.position_mm = turn * v.position_mm + Vec3f(0, 0, kJointMm);
    v.normal = turn * v.normal;
  }
  return out;
}

bool HandpiecePass::create(std::string& why) {
  if (!program_.link("handpiece", why)) return false;
  body_.create();
  body_.fill(handpiece_mesh());
  return true;
}

void HandpiecePass::draw(const FrameView& view, const BurPose& pose, HandSide hand) {
  const glm::vec4 tip = view.clip_from_world * glm::vec4(glm::vec3(pose.pivot_mm), 1.0f);
  if (tip.w <= 0) return;
  const float px_per_mm = 0.5f * std::min(view.view_px.x, view.view_px.y) / view.lamp.w;
  program_.use();
  program_.set("clip_from_world", view.clip_from_world);
  program_.set("world_from_tool", world_from_frame(pose.pivot_mm + pose.bur.neck_length_mm * pose.axis, neck_side(view, pose.axis, hand), pose.axis));
  program_.set("eye", view.eye);
  program_.set("key_light", view.key_light);
  program_.set("up", view.up);
  program_.set("work_px", 0.5f * (glm::vec2(tip) / tip.w + 1.0f) * view.view_px);
  const float clear = px_per_mm * kClearMm, solid = px_per_mm * kSolidMm;
  program_.set("fade", glm::vec2(clear * clear, 1.0f / (solid * solid - clear * clear)));
  program_.set("most_share", kMostShare);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  // The head comes first: where it hides the neck's begin, the depth test leaves the neck out.
  body_.draw();
  glDisable(GL_BLEND);
}

}  // namespace cusp::ui
