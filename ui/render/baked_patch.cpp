#include "ui/render/baked_patch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cusp::ui {
namespace {

/// Directions over the half sphere about +z, weighted as a matt surface receives light: two rings and the pole.
std::array<Vec3, 11> ambient_directions() {
  std::array<Vec3, 11> out{};
  out[0] = {0, 0, 1};
  const auto ring = [&out](std::size_t first, std::size_t count, double elevation, double turn) {
    for (std::size_t i = 0; i < count; ++i) {
      const double a = (static_cast<double>(i) + turn) * 2 * 3.14159265358979 / static_cast<double>(count);
      out[first + i] = {std::cos(elevation) * std::cos(a), std::cos(elevation) * std::sin(a), std::sin(elevation)};
    }
  };
  ring(1, 4, 1.0, 0.5);
  ring(5, 6, 0.5, 0.0);
  return out;
}

// Samples along a ray, mm: a fissure is some tenths wide, a cavity 1 to 2 mm.
constexpr std::array<double, 6> kAmbientSteps = {0.14, 0.28, 0.48, 0.78, 1.2, 1.7};
constexpr double kAmbientReach = 2.4;  // what is further away takes no light

/// How much more solid the near neighbourhood is than its middle: above 0 in a groove, below 0 on a ridge, 0 on any
/// plane. A filled volume has no such thing: its voxels' own steps would be all there is to see.
double concavity(const Volume& volume, IVec3 middle) noexcept {
  if (volume.specimen().reading() == Reading::filled) return 0.0;
  int sum = 0;
  for (int i = 0; i < 8; ++i) sum += volume.s(middle + IVec3(i & 1, i >> 1 & 1, i >> 2) * 2 - 1);
  for (int axis = 0; axis < 3; ++axis) {
    IVec3 d(0);
    d[axis] = 2;
    sum += volume.s(middle + d) + volume.s(middle - d);
  }
  return (sum / 14.0 - volume.s(middle)) / 65535.0;
}

}  // namespace

float ambient_at(const Volume& volume, Vec3 at_mm, Vec3 normal) noexcept {
  static const std::array<Vec3, 11> directions = ambient_directions();
  const Grid& grid = volume.grid();
  const Vec3 side = std::abs(normal.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
  const Vec3 t = glm::normalize(glm::cross(side, normal));
  const Vec3 b = glm::cross(normal, t);
  const double inverse = 1.0 / grid.voxel_mm;
  // Off the surface by a voxel, so that a flat face does not shade itself.
  const Vec3 from = (at_mm + grid.voxel_mm * normal - grid.origin_mm) * inverse + 0.5;
  double light = 0, weight = 0;
  for (const Vec3& d : directions) {
    const Vec3 along = (d.x * t + d.y * b + d.z * normal) * inverse;
    double blocked = 0;
    for (const double step : kAmbientSteps) {
      const Vec3 p = from + step * along;
      const IVec3 v(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
                    static_cast<int>(std::floor(p.z)));
      const double s = volume.s(v) / 65535.0;
      const double solid = std::clamp((s - 0.42) * 5.0, 0.0, 1.0);
      blocked = std::max(blocked, solid * (1.0 - step / kAmbientReach));
      if (blocked > 0.93) break;
    }
    light += d.z * (1.0 - blocked);
    weight += d.z;
  }
  // Narrow grooves, which the rays step over.
  const Vec3 near = (at_mm - grid.origin_mm) * inverse + 0.5;
  const double groove = concavity(volume, {static_cast<int>(std::floor(near.x)), static_cast<int>(std::floor(near.y)),
                                           static_cast<int>(std::floor(near.z))});
  const double shade = groove > 0 ? std::max(1.0 - 5.0 * groove, 0.2) : std::min(1.0 - 1.0 * groove, 1.1);
  return static_cast<float>(std::clamp(light / weight * shade, 0.0, 1.0));
}

namespace {
/// True where a triangle of the seam comes within a voxel or so of a fine brick.
bool needed(const Volume& volume, const Patch& patch, std::size_t triangle, const std::function<bool(int)>& is_fine) {
  constexpr float kReach = 1.3f;  // voxels
  Vec3f middle(0.0f);
  for (std::size_t k = 0; k < 3; ++k) middle += patch.vertices[patch.indices[triangle + k]].position_mm;
  const Grid& grid = volume.grid();
  const Vec3f at = (middle / 3.0f - Vec3f(grid.origin_mm)) / static_cast<float>(grid.voxel_mm);
  int before = patch.brick;
  for (int i = 0; i < 8; ++i) {
    const Vec3f p = at + kReach * Vec3f(i & 1 ? 1 : -1, i >> 1 & 1 ? 1 : -1, i >> 2 ? 1 : -1);
    const int brick = volume.specimen().brick_index(
        {static_cast<int>(std::floor(p.x / 8)), static_cast<int>(std::floor(p.y / 8)), static_cast<int>(std::floor(p.z / 8))});
    if (brick < 0 || brick == before) continue;
    before = brick;
    if (brick != patch.brick && is_fine(brick)) return true;
  }
  return false;
}
}  // namespace

BakedPatch bake_patch(const Volume& volume, const Patch& patch, const std::function<bool(int brick)>& is_fine,
                      const DeviationAt& deviation) {
  BakedPatch out;
  out.brick = patch.brick;
  out.level = patch.level;
  out.indices.assign(patch.indices.begin(), patch.indices.begin() + static_cast<std::ptrdiff_t>(patch.own));
  for (std::size_t t = patch.own; is_fine && t < patch.indices.size(); t += 3) {
    if (needed(volume, patch, t, is_fine))
      out.indices.insert(out.indices.end(), patch.indices.begin() + static_cast<std::ptrdiff_t>(t),
                         patch.indices.begin() + static_cast<std::ptrdiff_t>(t + 3));
  }
  if (out.indices.empty()) return out;

  // Vertices that only the seam uses come last.
  std::size_t vertices = 0;
  for (const std::uint16_t i : out.indices) vertices = std::max<std::size_t>(vertices, i + 1u);
  out.vertices.reserve(vertices);
  out.low_mm = out.high_mm = patch.vertices[0].position_mm;
  Vec3f sum(0.0f);
  for (std::size_t i = 0; i < vertices; ++i) {
    const PatchVertex& v = patch.vertices[i];
    PackedVertex p{};
    for (int k = 0; k < 3; ++k) {
      p.position_mm[k] = v.position_mm[k];
      p.normal[k] = static_cast<std::int16_t>(std::lround(std::clamp(v.normal[k], -1.0f, 1.0f) * 32767.0f));
    }
    p.tissue = static_cast<std::uint8_t>(v.tissue);
    p.cut = v.cut ? 255 : 0;
    const Vec3 at(v.position_mm);
    p.ambient = static_cast<std::uint8_t>(std::lround(255.0f * ambient_at(volume, at, Vec3(v.normal))));
    if (deviation) {
      const Deviation d = deviation(at, v.cut);
      p.value = d.mm;
      p.beyond = d.beyond ? 255 : 0;
    }
    out.vertices.push_back(p);
    out.low_mm = glm::min(out.low_mm, v.position_mm);
    out.high_mm = glm::max(out.high_mm, v.position_mm);
    sum += v.normal;
  }
  const float length = glm::length(sum);
  if (length > 1e-6f) {
    out.cone_axis = sum / length;
    out.cone_cos = 1.0f;
    for (std::size_t i = 0; i < vertices; ++i)
      out.cone_cos = std::min(out.cone_cos, glm::dot(out.cone_axis, patch.vertices[i].normal));
  }
  return out;
}

}  // namespace cusp::ui
