#include "ui/render/patch_store.h"

#include <algorithm>
#include <cmath>

namespace cusp::ui {
namespace {

/// Distance at which a ray enters a box, or nothing.
bool meets(const Ray& ray, Vec3f low, Vec3f high, double before) {
  double first = 0, last = before;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(ray.along[i]) < 1e-12) {
      if (ray.from_mm[i] < low[i] || ray.from_mm[i] > high[i]) return false;
      continue;
    }
    double a = (low[i] - ray.from_mm[i]) / ray.along[i], b = (high[i] - ray.from_mm[i]) / ray.along[i];
    if (a > b) std::swap(a, b);
    first = std::max(first, a);
    last = std::min(last, b);
    if (first > last) return false;
  }
  return true;
}

Vec3 position(const PackedVertex& v) { return {v.position_mm[0], v.position_mm[1], v.position_mm[2]}; }

}  // namespace

void PatchStore::put(BakedPatch patch) {
  if (patch.indices.empty()) {
    patches_.erase(patch.brick);
  } else {
    const int brick = patch.brick;
    patches_.insert_or_assign(brick, std::move(patch));
  }
}

std::optional<PickedPoint> PatchStore::pick(const Ray& ray) const {
  std::optional<PickedPoint> best;
  double nearest = 1e9;
  for (const auto& [brick, patch] : patches_) {
    if (!meets(ray, patch.low_mm, patch.high_mm, nearest)) continue;
    for (std::size_t i = 0; i + 2 < patch.indices.size(); i += 3) {
      const PackedVertex& va = patch.vertices[patch.indices[i]];
      const PackedVertex& vb = patch.vertices[patch.indices[i + 1]];
      const PackedVertex& vc = patch.vertices[patch.indices[i + 2]];
      const Vec3 a = position(va), ab = position(vb) - a, ac = position(vc) - a;
      const Vec3 p = glm::cross(ray.along, ac);
      const double det = glm::dot(ab, p);
      if (det < 1e-15) continue;  // seen from behind, or edge on
      const Vec3 s = ray.from_mm - a;
      const double u = glm::dot(s, p) / det;
      if (u < -1e-9 || u > 1 + 1e-9) continue;
      const Vec3 q = glm::cross(s, ab);
      const double v = glm::dot(ray.along, q) / det;
      if (v < -1e-9 || u + v > 1 + 1e-9) continue;
      const double t = glm::dot(ac, q) / det;
      if (t <= 0 || t >= nearest) continue;
      nearest = t;
      const double w = 1 - u - v;
      Vec3 n(0.0);
      for (int k = 0; k < 3; ++k) n[k] = w * va.normal[k] + u * vb.normal[k] + v * vc.normal[k];
      const double length = glm::length(n);
      PickedPoint& hit = best.emplace();
      hit.at_mm = ray.from_mm + t * ray.along;
      hit.normal = length > 0 ? n / length : Vec3(0, 0, 1);
      hit.distance_mm = t;
      hit.tissue = static_cast<Tissue>(w >= u && w >= v ? va.tissue : u >= v ? vb.tissue : vc.tissue);
      hit.value = static_cast<float>(w * va.value + u * vb.value + v * vc.value);
    }
  }
  return best;
}

bool PatchStore::shows(Vec3 place_mm, Vec3 eye_mm) const {
  const double far = glm::length(place_mm - eye_mm);
  if (!(far > 0)) return true;
  const auto hit = pick({eye_mm, (place_mm - eye_mm) / far});
  return !hit || hit->distance_mm >= far - kSurfaceMm;
}

std::optional<Box> PatchStore::bounds() const {
  std::optional<Box> out;
  for (const auto& [brick, patch] : patches_) {
    if (!out) out = Box{Vec3(patch.low_mm), Vec3(patch.high_mm)};
    out->low = glm::min(out->low, Vec3(patch.low_mm));
    out->high = glm::max(out->high, Vec3(patch.high_mm));
  }
  return out;
}

std::size_t PatchStore::triangles() const noexcept {
  std::size_t out = 0;
  for (const auto& [brick, patch] : patches_) out += patch.indices.size() / 3;
  return out;
}

}  // namespace cusp::ui
