#include "ui/render/baked_patch.h"

#include <algorithm>
#include <cmath>

namespace cusp::ui {
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

namespace {

std::uint8_t byte_of(float share) { return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f))); }

/// Box and cone of the patch's vertices.
void bound(BakedPatch& out) {
  out.low_mm = Vec3f(1e9f);
  out.high_mm = Vec3f(-1e9f);
  Vec3f sum(0.0f);
  const auto normal = [](const PackedVertex& v) { return Vec3f(v.normal[0], v.normal[1], v.normal[2]) / 32767.0f; };
  for (const PackedVertex& v : out.vertices) {
    const Vec3f p(v.position_mm[0], v.position_mm[1], v.position_mm[2]);
    out.low_mm = glm::min(out.low_mm, p);
    out.high_mm = glm::max(out.high_mm, p);
    sum += normal(v);
  }
  const float length = glm::length(sum);
  if (length <= 1e-6f) return;
  out.cone_axis = sum / length;
  out.cone_cos = 1.0f;
  for (const PackedVertex& v : out.vertices) out.cone_cos = std::min(out.cone_cos, glm::dot(out.cone_axis, normal(v)));
}

}  // namespace

void put_look(const VertexLook& look, PackedVertex& out) noexcept {
  const auto unit = [](float v) { return static_cast<std::int16_t>(std::lround(std::clamp(v, -1.0f, 1.0f) * 32767.0f)); };
  for (int k = 0; k < 3; ++k) {
    out.position_mm[k] = look.position_mm[k];
    out.normal[k] = unit(look.normal[k]);
    out.colour[k] = byte_of(std::sqrt(std::max(look.colour[k], 0.0f)));
  }
  out.normal[3] = unit(look.thin);
  out.enamel = byte_of(look.enamel);
  out.cut = byte_of(look.cut);
}

BakedPatch bake_patch(const Volume& volume, const PatchSurroundings& around, const Patch& patch,
                      const std::function<bool(int brick)>& is_fine, const DeviationAt& deviation) {
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
  const LookWindow window(volume.specimen(), patch.brick, patch.level);
  const Grid& grid = volume.grid();
  for (std::size_t i = 0; i < vertices; ++i) {
    const PatchVertex& v = patch.vertices[i];
    PackedVertex p{};
    const Vec3 at(v.position_mm);
    const Vec3f voxel((at - grid.origin_mm) / grid.voxel_mm);
    VertexLook look = window.look(v, {around.depth.mm_at(voxel), 0.5f - around.shares.smooth_at(SolidShares::Cell::eight, voxel)});
    const Vec3f drawn((Vec3(look.position_mm) - grid.origin_mm) / grid.voxel_mm);
    const float groove = glm::smoothstep(0.06f, 0.24f, around.shares.smooth_at(SolidShares::Cell::four, drawn) - 0.5f);
    stain(look, groove);
    put_look(look, p);
    p.tissue = static_cast<std::uint8_t>(v.tissue);
    p.ambient = byte_of((1.0f - 0.4f * groove * (1.0f - look.cut)) * ambient_at(around.shares, drawn, look.normal, static_cast<float>(grid.voxel_mm)));
    if (deviation) {
      const Deviation d = deviation(at, v.cut ? SurfaceKind::cut : SurfaceKind::original);
      p.value = d.mm;
      p.beyond = d.beyond ? 255 : 0;
    }
    out.vertices.push_back(p);
  }
  bound(out);
  return out;
}

}  // namespace cusp::ui
