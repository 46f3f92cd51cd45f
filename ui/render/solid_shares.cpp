#include "ui/render/solid_shares.h"

#include <algorithm>
#include <cmath>

namespace cusp::ui {

namespace {

/// Cells of this many voxels meet at whole numbers of the result.
Vec3f in_cells(Vec3f voxel, int edge) { return (voxel + 0.5f) / static_cast<float>(edge); }
int edge_of(SolidShares::Cell cell) { return 4 << static_cast<int>(cell); }
IVec3 floor_of(Vec3f p) { return IVec3(glm::floor(p)); }

}  // namespace

void SolidShares::Level::resize(IVec3 cells) {
  size = cells + 2 * kEdge;
  cell.assign(index({0, 0, size.z}), 0);
}

SolidShares::SolidShares(const Volume& volume) {
  const IVec3 bricks = volume.specimen().brick_count();
  levels_[0].resize(2 * bricks);
  levels_[1].resize(bricks);
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (!volume.specimen().uniform(b) || volume.has_cut(b) || volume.specimen().s_in(b, 0) != 0) update(volume, b);
  }
}

void SolidShares::update(const Volume& volume, int brick) {
  const Specimen& specimen = volume.specimen();
  const std::uint16_t* cut = volume.cut_of(brick);
  const IVec3 at = specimen.brick_at(brick);
  std::array<std::uint32_t, 8> sums{};
  if (specimen.uniform(brick) && cut == nullptr) {
    sums.fill(64u * specimen.s_in(brick, 0));
  } else {
    for (int o = 0; o < kBrickVoxels; ++o) {
      std::uint16_t s = specimen.s_in(brick, o);
      if (cut != nullptr) s = std::min(s, cut[o]);
      sums[static_cast<std::size_t>((o >> 2 & 1) | (o >> 5 & 1) << 1 | (o >> 8 & 1) << 2)] += s;
    }
  }
  std::uint32_t all = 0;
  for (int i = 0; i < 8; ++i) {
    const std::uint32_t sum = sums[static_cast<std::size_t>(i)];
    levels_[0].set(2 * at + IVec3(i & 1, i >> 1 & 1, i >> 2), sum >> 14);  // of 64 values of 16 bits
    all += sum >> 3;
  }
  levels_[1].set(at, all >> 14);
}

float SolidShares::at(Cell cell, Vec3f voxel) const noexcept {
  const Level& of = level(cell);
  const Vec3f p = in_cells(voxel, edge_of(cell)) - 0.5f + static_cast<float>(Level::kEdge);
  const IVec3 low = glm::clamp(floor_of(p), IVec3(0), of.size - 2);
  const Vec3f f = glm::clamp(p - Vec3f(low), 0.0f, 1.0f);
  const std::uint8_t* c = &of.cell[of.index(low)];
  const int up = of.size.x, far = of.size.x * of.size.y;
  const auto row = [&](int i) { return static_cast<float>(c[i]) + f.x * static_cast<float>(c[i + 1] - c[i]); };
  const float a = row(0) + f.y * (row(up) - row(0)), b = row(far) + f.y * (row(far + up) - row(far));
  return (a + f.z * (b - a)) * (1.0f / 255.0f);
}

float SolidShares::smooth_at(Cell cell, Vec3f voxel) const noexcept {
  const Level& of = level(cell);
  const Vec3f p = in_cells(voxel, edge_of(cell)) + static_cast<float>(Level::kEdge);
  const IVec3 middle = glm::clamp(floor_of(p), IVec3(1), of.size - 2);
  const Vec3f t = glm::clamp(p - Vec3f(middle), 0.0f, 1.0f);
  const Vec3f weight[3] = {0.5f * (1.0f - t) * (1.0f - t), 0.5f + t * (1.0f - t), 0.5f * t * t};  // a quadratic spline's
  float sum = 0.0f;
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y) {
      const std::uint8_t* c = &of.cell[of.index(middle + IVec3(-1, y - 1, z - 1))];
      sum += weight[z].z * weight[y].y * (weight[0].x * c[0] + weight[1].x * c[1] + weight[2].x * c[2]);
    }
  return sum * (1.0f / 255.0f);
}

namespace {

struct Tap {
  float mm;
  SolidShares::Cell cell;
  float stops;  // share of the cone's light that a wholly solid cell there stops
};
// A fossa is a millimetre wide, a cavity 1 to 2.
constexpr std::array<Tap, 3> kAlong = {{{0.40f, SolidShares::Cell::four, 0.8f},
                                        {0.90f, SolidShares::Cell::four, 0.7f},
                                        {1.80f, SolidShares::Cell::eight, 0.6f}}};
constexpr std::array<Tap, 3> kAslant = {{{0.45f, SolidShares::Cell::four, 0.8f},
                                         {0.95f, SolidShares::Cell::four, 0.8f},
                                         {1.80f, SolidShares::Cell::eight, 0.6f}}};
constexpr float kSolidFrom = 0.10f;       // what the plane itself lends to a cell above it
constexpr float kAslantCos = 0.60f, kAslantSin = 0.80f;
constexpr float kShareAlong = 0.32f, kShareAslant = 0.17f;  // of the half sphere's light; 0.32 + 4 * 0.17 = 1

template <std::size_t N>
float open_along(const SolidShares& shares, const std::array<Tap, N>& taps, Vec3f from, Vec3f along, float voxel_mm) {
  float open = 1.0f;
  for (const Tap& tap : taps) {
    const float solid = shares.at(tap.cell, from + (tap.mm / voxel_mm) * along);
    open *= 1.0f - tap.stops * std::clamp((solid - kSolidFrom) * 1.35f, 0.0f, 1.0f);
  }
  return open;
}

}  // namespace

float ambient_at(const SolidShares& shares, Vec3f voxel, Vec3f normal, float voxel_mm) noexcept {
  // A frame that turns without a jump as the normal turns, but for straight down: cones that jumped would draw an edge.
  const float k = -1.0f / std::max(1.0f + normal.z, 1e-3f);
  const Vec3f t = glm::normalize(Vec3f(1.0f + k * normal.x * normal.x, k * normal.x * normal.y, -normal.x));
  const Vec3f b = glm::cross(normal, t);
  float light = kShareAlong * open_along(shares, kAlong, voxel, normal, voxel_mm);
  for (const Vec3f& d : {t, -t, b, -b})
    light += kShareAslant * open_along(shares, kAslant, voxel, kAslantCos * normal + kAslantSin * d, voxel_mm);
  return light;
}

}  // namespace cusp::ui
