#include "ui/editor/landmark_snap.h"

#include <algorithm>

#include "scenarios/teeth/landmarks.h"

namespace cusp::ui {
namespace {

double from_above_mm(Vec3 a, Vec3 b) { return glm::length(glm::dvec2(a) - glm::dvec2(b)); }

bool is_place(MarkKind kind) {
  return kind == MarkKind::cusp_tip || kind == MarkKind::pit || kind == MarkKind::contact || kind == MarkKind::contour;
}

bool is_line(MarkKind kind) { return kind == MarkKind::fissure || kind == MarkKind::marginal_ridge; }

/// Of the way from a to b, seen from above.
Vec3 nearest_on(Vec3 a, Vec3 b, Vec3 at) {
  const glm::dvec2 way(b - a);
  const double length2 = glm::dot(way, way);
  if (length2 == 0.0) return a;
  return a + std::clamp(glm::dot(glm::dvec2(at - a), way) / length2, 0.0, 1.0) * (b - a);
}

Vec3 nearest_of(const Landmark& mark, Vec3 at) {
  Vec3 best = mark.points_mm.front();
  for (std::size_t i = 1; i < mark.points_mm.size(); ++i) {
    const Vec3 next = nearest_on(mark.points_mm[i - 1], mark.points_mm[i], at);
    if (from_above_mm(next, at) < from_above_mm(best, at)) best = next;
  }
  return best;
}

}  // namespace

std::vector<Landmark> marks_of(const scenarios::ToothLandmarks& grown) {
  std::vector<Landmark> out;
  const auto add = [&](MarkKind kind, std::string name, std::vector<Vec3> points) {
    if (!points.empty()) out.push_back({kind, std::move(name), std::move(points), MarkState::set});
  };
  for (const auto& tip : grown.cusp_tips) add(MarkKind::cusp_tip, tip.name, {tip.at_mm});
  for (const auto& pit : grown.pits) add(MarkKind::pit, pit.name, {pit.at_mm});
  for (const auto& line : grown.fissures) add(MarkKind::fissure, line.name, line.points_mm);
  for (const auto& line : grown.marginal_ridges) add(MarkKind::marginal_ridge, line.name, line.points_mm);
  add(MarkKind::contact, "mesial", {grown.mesial_contact});
  add(MarkKind::contact, "distal", {grown.distal_contact});
  return out;
}

std::optional<SnapPlace> nearest_place(std::span<const Landmark> marks, Vec3 at_mm, double reach_mm) {
  for (const auto kind_fits : {is_place, is_line}) {
    std::optional<SnapPlace> best;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (!kind_fits(marks[i].kind) || marks[i].points_mm.empty()) continue;
      const Vec3 there = nearest_of(marks[i], at_mm);
      const double far = from_above_mm(there, at_mm);
      if (far <= (best ? best->far_mm : reach_mm)) best = SnapPlace{i, there, far};
    }
    if (best) return best;
  }
  return std::nullopt;
}

}  // namespace cusp::ui
