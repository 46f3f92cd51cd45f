#include "ui/render/place_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace cusp::ui {
namespace {

constexpr int kTurns = 16;  // views about the tooth's axis
constexpr std::array<double, 6> kPitches = {1.45, 1.2, 0.95, 0.7, 0.45, 0.15};  // radians above the horizon
constexpr double kFromAbove = 1.0;   // weight of a view from above, against the cosine of the surface's slant
constexpr double kAsUsual = 0.3;     // weight of the usual turn about the axis, likewise
constexpr double kOnPlaceMm = 0.5;   // a ray that ends farther from the place has missed its surface
constexpr double kAboutMm = 0.5;     // surface about the place that is to be shown: what the report's ring surrounds
constexpr double kEnoughShown = 0.35;  // of that surface, slant included; tests/ui/render/evidence_view_test.cpp measures it
constexpr double kSpotMm = 0.02;     // a ray that ends this near a spot has met it: rounding of packed vertices
constexpr std::size_t kMostSpots = 24;

/// A place of the surface, which faces `normal`.
struct Spot {
  Vec3 at_mm, normal;
  double area_mm2;
};

/// Triangles within kAboutMm of the place: some kMostSpots of them, of every size.
std::vector<Spot> spots_about(const PatchStore& tooth, Vec3 place_mm) {
  std::vector<Spot> out;
  for (const auto& [brick, patch] : tooth.patches()) {
    if (glm::length(glm::clamp(place_mm, Vec3(patch.low_mm), Vec3(patch.high_mm)) - place_mm) > kAboutMm) continue;
    const auto at = [&patch](std::size_t index) {
      const float* p = patch.vertices[patch.indices[index]].position_mm;
      return Vec3(p[0], p[1], p[2]);
    };
    for (std::size_t i = 0; i + 2 < patch.indices.size(); i += 3) {
      const Vec3 a = at(i), cross = glm::cross(at(i + 1) - a, at(i + 2) - a), middle = (a + at(i + 1) + at(i + 2)) / 3.0;
      const double length = glm::length(cross);
      if (length > 0.0 && glm::length(middle - place_mm) < kAboutMm) out.push_back({middle, cross / length, 0.5 * length});
    }
  }
  std::ranges::sort(out, std::greater(), &Spot::area_mm2);
  std::vector<Spot> spread;
  const std::size_t step = std::max<std::size_t>(1, out.size() / kMostSpots);
  for (std::size_t i = 0; i < out.size(); i += step) spread.push_back(out[i]);
  return spread;
}

/// Of the spots' area what a camera shows, slant included.
double shown_share(const Camera& camera, const Meshes& meshes, const std::vector<Spot>& spots) {
  double shown = 0.0, all = 0.0;
  for (const Spot& spot : spots) {
    all += spot.area_mm2;
    const Vec3 way = spot.at_mm - camera.eye_mm();
    const double far = glm::length(way), facing = -glm::dot(spot.normal, way) / far;
    if (facing <= 0.0) continue;
    const bool seen = std::ranges::all_of(meshes, [&](const PatchStore* mesh) {
      const auto hit = mesh->pick({camera.eye_mm(), way / far});
      return !hit || hit->distance_mm > far - kSpotMm;
    });
    if (seen) shown += facing * spot.area_mm2;
  }
  return all > 0.0 ? shown / all : 1.0;
}

/// A view that sees the place, and how much it suits.
struct Seen {
  Camera camera;
  double worth;
};

/// The best first.
std::vector<Seen> views_of(const Camera& above, const Meshes& meshes, Vec3 place_mm) {
  std::vector<Seen> out;
  for (const double pitch : kPitches)
    for (int turn = 0; turn < kTurns; ++turn) {
      Camera view = above;
      view.set_angles(above.yaw() + 2 * std::numbers::pi * turn / kTurns, pitch);
      if (!seen_from(view, meshes, place_mm)) continue;
      const Vec3 to_eye = -view.forward();
      const auto hit = meshes.front()->pick({view.eye_mm(), view.forward()});
      const bool on_place = hit && glm::length(hit->at_mm - place_mm) < kOnPlaceMm;
      out.push_back({view, (on_place ? glm::dot(hit->normal, to_eye) : 0.0) + kFromAbove * to_eye.z +
                               kAsUsual * std::cos(view.yaw() - above.yaw())});
    }
  std::ranges::stable_sort(out, std::greater(), &Seen::worth);
  return out;
}

}  // namespace

Camera keep_in_picture(const Camera& view, const Meshes& meshes, Vec3 place_mm, glm::dvec2 picture_px, double margin_px) {
  constexpr int kPasses = 3;  // what is nearer than the middle moves further than the middle does
  Camera out = view;
  for (int pass = 0; pass < kPasses; ++pass) {
    glm::dvec2 low(1e9), high(-1e9);
    for (const auto& [brick, patch] : meshes.front()->patches())
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p(corner & 1 ? patch.high_mm[0] : patch.low_mm[0], corner & 2 ? patch.high_mm[1] : patch.low_mm[1],
                     corner & 4 ? patch.high_mm[2] : patch.low_mm[2]);
        const auto px = out.project(p, picture_px);
        if (!px) return view;
        low = glm::min(low, *px);
        high = glm::max(high, *px);
      }
    glm::dvec2 by(0.0);
    for (int axis = 0; axis < 2; ++axis) {
      const double least = margin_px - low[axis], most = picture_px[axis] - margin_px - high[axis];
      if (least <= most) by[axis] = std::clamp(0.0, least, most);
    }
    if (by == glm::dvec2(0.0)) break;
    out.pan(by, std::min(picture_px.x, picture_px.y));
  }
  return seen_from(out, meshes, place_mm) ? out : view;
}

bool seen_from(const Camera& camera, const Meshes& meshes, Vec3 place_mm) {
  return std::ranges::all_of(meshes, [&](const PatchStore* mesh) { return mesh->shows(place_mm, camera.eye_mm()); });
}

Camera look_at_place(const Camera& now, const Meshes& meshes, Vec3 place_mm) {
  Camera above = now;
  above.set_centre(place_mm);
  above.set_preset(PresetView::occlusal);
  const std::vector<Seen> views = views_of(above, meshes, place_mm);
  const std::vector<Spot> spots = spots_about(*meshes.front(), place_mm);
  const Camera* best = nullptr;
  double most = -1.0;
  for (const Seen& view : views) {
    const double share = shown_share(view.camera, meshes, spots);
    if (share <= most) continue;
    most = share;
    best = &view.camera;
    if (share >= kEnoughShown) break;
  }
  return best != nullptr ? *best : above;
}

}  // namespace cusp::ui
