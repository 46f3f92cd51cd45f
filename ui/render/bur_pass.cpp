#include "ui/render/bur_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cusp::ui {
namespace {

constexpr int kAround = 28;

/// The outline's parts as rings; where two meet at an edge, both with their own normals.
void add_head(const Profile& head, std::vector<BodyRing>& out) {
  constexpr int kArc = 10;
  const auto add = [&out](OnHalf at, OnHalf normal) {
    // The end towards the neck has no blades.
    out.push_back({static_cast<float>(at.t), static_cast<float>(at.rho), static_cast<float>(normal.t),
                   static_cast<float>(normal.rho), normal.t > 0.9 ? 0.0f : 1.0f});
  };
  for (int i = 0; i < head.size(); ++i) {
    const OutlinePiece& p = head.piece(i);
    if (p.radius == 0.0) {
      const double length = std::hypot(p.to.t - p.from.t, p.to.rho - p.from.rho);
      const OnHalf normal{-(p.to.rho - p.from.rho) / length, (p.to.t - p.from.t) / length};
      add(p.from, normal);
      add(p.to, normal);
      continue;
    }
    const double from = std::atan2(p.from.rho - p.centre.rho, p.from.t - p.centre.t);
    const double to = std::atan2(p.to.rho - p.centre.rho, p.to.t - p.centre.t);
    for (int k = 0; k <= kArc; ++k) {
      const double angle = from + (to - from) * k / kArc;
      const OnHalf normal{std::cos(angle), std::sin(angle)};
      add({p.centre.t + p.radius * normal.t, p.centre.rho + p.radius * normal.rho}, normal);
    }
  }
}

std::vector<BodyRing> profile(const Bur& bur) {
  std::vector<BodyRing> out;
  const auto r = static_cast<float>(bur.radius_mm);
  const auto neck = static_cast<float>(std::min(bur.neck_radius_mm, bur.radius_mm));
  const auto neck_end = static_cast<float>(bur.neck_length_mm);
  const auto shank = static_cast<float>(bur.shank_radius_mm);
  const float meet = std::sqrt(std::max(r * r - neck * neck, 0.0f));  // where the neck leaves the ball
  float head_end = meet;
  if (!bur.head.ball()) {
    head_end = static_cast<float>(bur.head.high());
    add_head(bur.head, out);
  }
  constexpr int kBall = 14;
  const float last = std::acos(std::clamp(-meet / r, -1.0f, 1.0f));
  for (int i = 0; bur.head.ball() && i <= kBall; ++i) {
    const float a = last * static_cast<float>(i) / kBall;  // from the tip
    out.push_back({-r * std::cos(a), r * std::sin(a), -std::cos(a), std::sin(a), 1.0f});
  }
  out.push_back({head_end, neck, 0, 1, 0});
  // The neck widens to the shank over its last part, as turned steel does.
  const float shoulder = std::max(head_end, neck_end - 1.6f * std::max(shank - neck, 0.0f));
  const float length = std::hypot(neck_end - shoulder, shank - neck);
  const float nz = length > 0 ? -(shank - neck) / length : 0.0f, nr = length > 0 ? (neck_end - shoulder) / length : 1.0f;
  out.push_back({shoulder, neck, 0, 1, 0});
  out.push_back({shoulder, neck, nz, nr, 0});
  out.push_back({neck_end, shank, nz, nr, 0});
  out.push_back({neck_end, shank, 0, 1, 0});
  // Closed at its end, which the mouth mirror and a view without the handpiece show.
  const float end = neck_end + static_cast<float>(bur.shank_length_mm);
  for (const auto& [radius, along, across] : {std::array{shank, 0.0f, 1.0f}, {shank, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}) out.push_back({end, radius, along, across, 0});
  return out;
}

/// How solid neck and shank are drawn: seen along the axis they would hide the blades and what these cut.
float shank_share(const FrameView& view, const BurPose& pose) {
  constexpr float kFadesFrom = 0.88f, kFadedFrom = 0.96f, kFadedShare = 0.25f;  // cosines of 28 and 16 degrees
  const float along = glm::dot(view.to_eye, glm::vec3(pose.axis));
  return glm::mix(1.0f, kFadedShare, glm::smoothstep(kFadesFrom, kFadedFrom, along));
}

}  // namespace

std::vector<BodyVertex> bur_mesh(const Bur& bur) {
  std::vector<BodyVertex> out;
  add_body(out, profile(bur), kAround);
  return out;
}

bool BurPass::create(std::string& why) {
  if (!program_.link("bur", why)) return false;
  body_.create();
  return true;
}

void BurPass::use(const FrameView& view, const BurPose& pose, float share) {
  if (!made_ || !(*made_ == pose.bur)) {
    const std::vector<BodyVertex> mesh = bur_mesh(pose.bur);
    body_.fill(mesh);
    made_ = pose.bur;
    count_ = static_cast<GLsizei>(mesh.size());
    // The mesh begins at the tip: after its blades come neck and shank.
    const auto last = std::find_if(mesh.rbegin(), mesh.rend(), [](const BodyVertex& v) { return v.cutting > 0.5f; });
    blades_ = static_cast<GLsizei>((mesh.rend() - last + 2) / 3 * 3);
  }
  program_.use();
  program_.set("share", share);
  program_.set("clip_from_world", view.clip_from_world);
  program_.set("world_from_tool", world_from_body(pose.pivot_mm, pose.axis));
  program_.set("eye", view.eye);
  program_.set("key_light", view.key_light);
  program_.set("up", view.up);
  program_.set("turn", pose.turning ? -1.0f : 0.0f);
  program_.set("radius", static_cast<float>(std::max(pose.bur.radius_mm, 0.01)));
}

void BurPass::draw(const FrameView& view, const BurPose& pose) {
  const bool whole = shank_share(view, pose) >= 1.0f;
  use(view, pose, 1.0f);
  body_.draw(0, whole ? count_ : blades_);
}

void BurPass::draw_faded_shank(const FrameView& view, const BurPose& pose) {
  const float share = shank_share(view, pose);
  if (share >= 1.0f) return;
  use(view, pose, share);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  body_.draw(blades_, count_ - blades_);
  glDisable(GL_BLEND);
}

}  // namespace cusp::ui
