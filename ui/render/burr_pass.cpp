#include "ui/render/burr_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace cusp {
namespace {

constexpr int kAround = 28;

struct Ring {
  float z, radius;
  float nz, nr;  // normal
  float cutting;
};

/// The outline's pieces as rings; where two meet at an edge, both with their own normals.
void add_head(const Profile& head, std::vector<Ring>& out) {
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

std::vector<Ring> profile(const Burr& burr) {
  std::vector<Ring> out;
  const auto r = static_cast<float>(burr.radius_mm);
  const auto neck = static_cast<float>(std::min(burr.neck_radius_mm, burr.radius_mm));
  const auto neck_end = static_cast<float>(burr.neck_length_mm);
  const auto shank = static_cast<float>(burr.shank_radius_mm);
  const float meet = std::sqrt(std::max(r * r - neck * neck, 0.0f));  // where the neck leaves the ball
  float head_end = meet;
  if (!burr.head.ball()) {
    head_end = static_cast<float>(burr.head.high());
    add_head(burr.head, out);
  }
  constexpr int kBall = 14;
  const float last = std::acos(std::clamp(-meet / r, -1.0f, 1.0f));
  for (int i = 0; burr.head.ball() && i <= kBall; ++i) {
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
  out.push_back({neck_end + static_cast<float>(burr.shank_length_mm), shank, 0, 1, 0});
  return out;
}

}  // namespace

std::vector<BurrVertex> burr_mesh(const Burr& burr) {
  const std::vector<Ring> rings = profile(burr);
  std::vector<BurrVertex> out;
  const auto at = [&](const Ring& ring, int i) {
    const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i % kAround) / kAround;
    const float c = std::cos(a), s = std::sin(a);
    return BurrVertex{{ring.radius * c, ring.radius * s, ring.z}, {ring.nr * c, ring.nr * s, ring.nz}, ring.cutting};
  };
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    for (int i = 0; i < kAround; ++i) {
      const BurrVertex a = at(rings[k], i), b = at(rings[k], i + 1), c = at(rings[k + 1], i + 1), d = at(rings[k + 1], i);
      if (rings[k].radius > 0) out.insert(out.end(), {a, b, c});
      out.insert(out.end(), {a, c, d});
    }
  }
  return out;
}

BurrPass::~BurrPass() {
  if (array_ != 0) glDeleteVertexArrays(1, &array_);
  if (vertices_ != 0) glDeleteBuffers(1, &vertices_);
}

bool BurrPass::create(std::string& why) {
  if (!program_.link("burr", why)) return false;
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(BurrVertex), at(offsetof(BurrVertex, position_mm)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(BurrVertex), at(offsetof(BurrVertex, normal)));
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(BurrVertex), at(offsetof(BurrVertex, cutting)));
  return true;
}

void BurrPass::draw(const FrameView& view, const BurrPose& pose) {
  glBindVertexArray(array_);
  if (!made_ || !(*made_ == pose.burr)) {
    const std::vector<BurrVertex> mesh = burr_mesh(pose.burr);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(BurrVertex)), mesh.data(),
                 GL_STATIC_DRAW);
    count_ = static_cast<GLsizei>(mesh.size());
    made_ = pose.burr;
  }
  const Vec3 z = glm::normalize(pose.axis);
  const Vec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), z));
  const Vec3 y = glm::cross(z, x);
  program_.use();
  program_.set("clip_from_world", view.clip_from_world);
  program_.set("world_from_tool", glm::mat4(glm::vec4(glm::vec3(x), 0), glm::vec4(glm::vec3(y), 0),
                                            glm::vec4(glm::vec3(z), 0), glm::vec4(glm::vec3(pose.pivot_mm), 1)));
  program_.set("eye", view.eye);
  program_.set("key_light", view.key_light);
  program_.set("up", view.up);
  program_.set("turn", pose.turning ? -1.0f : 0.0f);
  program_.set("radius", static_cast<float>(std::max(pose.burr.radius_mm, 0.01)));
  glDrawArrays(GL_TRIANGLES, 0, count_);
}

}  // namespace cusp
