#include "scenarios/templates/outline_paths.h"

#include <algorithm>

namespace cusp::scenarios {

namespace {

bool named(std::string_view name, std::string_view pattern) {
  if (!pattern.ends_with('*')) return name == pattern;
  pattern.remove_suffix(1);
  return name.starts_with(pattern);
}

double off_line(Vec3 p, Vec3 a, Vec3 b) noexcept {
  const Vec3 ab = b - a;
  const double square = glm::dot(ab, ab);
  const double t = square > 0.0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * ab);
}

/// Douglas and Peucker's way: the furthest point off stays.
void straighten(const std::vector<Vec3>& line, std::size_t first, std::size_t last, std::vector<Vec3>& out) {
  std::size_t worst = first;
  double most = kStraightMm;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off = off_line(line[i], line[first], line[last]);
    if (off <= most) continue;
    most = off;
    worst = i;
  }
  if (worst == first) {
    out.push_back(line[last]);
    return;
  }
  straighten(line, first, worst, out);
  straighten(line, worst, last, out);
}

}  // namespace

std::vector<std::vector<Vec3>> fissure_paths(const ToothLandmarks& landmarks, const FissurePaths& wanted) {
  std::vector<std::vector<Vec3>> out;
  for (const SurfaceLine& fissure : landmarks.fissures) {
    if (std::ranges::none_of(wanted.names, [&](const std::string& name) { return named(fissure.name, name); })) continue;
    std::vector<Vec3> stretch;
    const auto end_stretch = [&] {
      if (stretch.size() > 1) {
        out.push_back({stretch.front()});
        straighten(stretch, 0, stretch.size() - 1, out.back());
      }
      stretch.clear();
    };
    double gone = 0.0;
    for (std::size_t i = 0; i < fissure.points_mm.size(); ++i) {
      const Vec3 p(fissure.points_mm[i].x, fissure.points_mm[i].y, 0.0);
      if (i > 0) gone += glm::length(p - Vec3(fissure.points_mm[i - 1].x, fissure.points_mm[i - 1].y, 0.0));
      if (gone > wanted.longest_mm) break;
      if (p.x > wanted.most_x || p.x < wanted.least_x) end_stretch();
      else stretch.push_back(p);
    }
    end_stretch();
  }
  return out;
}

}  // namespace cusp::scenarios
