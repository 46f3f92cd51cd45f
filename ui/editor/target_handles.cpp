#include "ui/editor/target_handles.h"

#include <algorithm>
#include <cmath>

#include "ui/editor/editor_model.h"

namespace cusp::ui {
namespace {

double at_least(double mm) { return std::max(on_handle_step(mm), kLeastHandleMm); }

bool same_place(Vec3 a, Vec3 b) { return std::abs(a.x - b.x) < 1e-6 && std::abs(a.y - b.y) < 1e-6; }

/// Middle and unit normal of the longest segment of the first path, which carries the handle of the width.
struct Stretch {
  Vec3 middle{0.0};
  Vec3 across{0.0, 1.0, 0.0};
};
Stretch widest_seen(const Outline& t) {
  const auto& path = t.paths.front();
  Stretch out{path.front(), {0, 1, 0}};
  double longest = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 along(path[i + 1].x - path[i].x, path[i + 1].y - path[i].y, 0);
    const double length = glm::length(along);
    if (length <= longest) continue;
    longest = length;
    out.middle = (path[i] + path[i + 1]) / 2.0;
    out.across = Vec3(-along.y, along.x, 0) / length;
  }
  return out;
}

}  // namespace

double on_handle_step(double mm) { return tidy(std::round(mm / kHandleStepMm) * kHandleStepMm); }
Vec3 on_handle_step(Vec3 mm) { return {on_handle_step(mm.x), on_handle_step(mm.y), on_handle_step(mm.z)}; }

double tidy(double mm) { return std::round(mm * 1e4) / 1e4; }
Vec3 tidy(Vec3 mm) { return {tidy(mm.x), tidy(mm.y), tidy(mm.z)}; }

std::vector<TargetHandle> handles_of(const Outline& t) {
  std::vector<TargetHandle> out;
  if (t.paths.empty() || t.paths.front().empty()) return out;
  for (std::size_t i = 0; i < t.paths.size(); ++i) {
    for (std::size_t k = 0; k < t.paths[i].size(); ++k) {
      const Vec3 p = t.paths[i][k];
      const bool there = std::ranges::any_of(out, [&](const TargetHandle& h) { return same_place(h.at_mm, p); });
      if (!there) out.push_back({TargetHandle::Kind::point, i, k, {p.x, p.y, t.top_mm}});
    }
  }
  Vec3 anchor = t.paths.front()[t.paths.front().size() / 2];
  if (t.shape == "box") {
    anchor = t.paths.front().front();
    out.push_back({TargetHandle::Kind::size_x, 0, 0, {anchor.x + t.box_size_mm.x / 2, anchor.y, t.top_mm}});
    out.push_back({TargetHandle::Kind::size_y, 0, 0, {anchor.x, anchor.y + t.box_size_mm.y / 2, t.top_mm}});
  } else {
    const Stretch s = widest_seen(t);
    const Vec3 edge = s.middle + s.across * (t.width_mm / 2);
    out.push_back({TargetHandle::Kind::width, 0, 0, {edge.x, edge.y, t.top_mm}});
    if (t.shape == "channel") anchor = s.middle;
  }
  out.push_back({TargetHandle::Kind::depth, 0, 0, {anchor.x, anchor.y, t.top_mm - t.depth_mm}});
  return out;
}

Outline moved(const Outline& target, const TargetHandle& handle, Vec3 to) {
  Outline t = target;
  switch (handle.kind) {
    case TargetHandle::Kind::point: {
      const Vec3 from = target.paths[handle.path][handle.point];
      for (auto& path : t.paths) {
        for (Vec3& p : path) {
          if (same_place(p, from)) p = Vec3(on_handle_step(to.x), on_handle_step(to.y), p.z);
        }
      }
      break;
    }
    case TargetHandle::Kind::width: {
      const Stretch s = widest_seen(t);
      const double half = std::abs((to.x - s.middle.x) * s.across.x + (to.y - s.middle.y) * s.across.y);
      t.width_mm = at_least(2 * half);
      break;
    }
    case TargetHandle::Kind::size_x:
      t.box_size_mm.x = at_least(2 * std::abs(to.x - t.paths[0][0].x));
      break;
    case TargetHandle::Kind::size_y:
      t.box_size_mm.y = at_least(2 * std::abs(to.y - t.paths[0][0].y));
      break;
    case TargetHandle::Kind::depth:
      t.depth_mm = at_least(t.top_mm - to.z);
      settle_on_floor(t);
      break;
    default: break;
  }
  return t;
}

}  // namespace cusp::ui
