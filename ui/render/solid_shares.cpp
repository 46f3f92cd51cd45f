#include "ui/render/solid_shares.h"

#include <algorithm>
#include <cmath>

namespace cusp::ui {

SolidShares::SolidShares(const Volume& volume) : bricks_(volume.specimen().brick_count()) {
  const auto bricks = static_cast<std::size_t>(bricks_.x) * static_cast<std::size_t>(bricks_.y) * static_cast<std::size_t>(bricks_.z);
  place_.assign(bricks, -1);
  four_.assign(bricks, {});
  eight_.assign(bricks, 0);
  for (int b = 0; b < static_cast<int>(bricks); ++b) {
    if (!volume.specimen().uniform(b) || volume.has_cut(b) || volume.specimen().s_in(b, 0) != 0) update(volume, b);
  }
}

void SolidShares::update(const Volume& volume, int brick) {
  const auto at = static_cast<std::size_t>(brick);
  const Specimen& specimen = volume.specimen();
  const std::uint16_t* cut = volume.cut_of(brick);
  if (specimen.uniform(brick) && cut == nullptr) {
    eight_[at] = specimen.s_in(brick, 0) != 0 ? 255 : 0;
    four_[at].fill(eight_[at]);
    place_[at] = -1;
    return;
  }
  if (place_[at] < 0) {
    place_[at] = static_cast<std::int32_t>(two_.size());
    two_.emplace_back();
  }
  std::array<std::uint32_t, 64> sums{};
  for (int o = 0; o < kBrickVoxels; ++o) {
    std::uint16_t s = specimen.s_in(brick, o);
    if (cut != nullptr) s = std::min(s, cut[o]);
    sums[static_cast<std::size_t>((o >> 1 & 3) | (o >> 4 & 3) << 2 | (o >> 7 & 3) << 4)] += s;
  }
  std::array<std::uint32_t, 8> of_four{};
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    two_[static_cast<std::size_t>(place_[at])][i] = static_cast<std::uint8_t>(sums[i] >> 11);  // of 8 values of 16 bits
    of_four[(i >> 1 & 1) | (i >> 3 & 1) << 1 | (i >> 5 & 1) << 2] += sums[i] >> 3;
  }
  for (std::size_t i = 0; i < 8; ++i) {
    four_[at][i] = static_cast<std::uint8_t>(of_four[i] >> 11);
    all += of_four[i] >> 3;
  }
  eight_[at] = static_cast<std::uint8_t>(all >> 11);
}

int SolidShares::brick_index(IVec3 b) const noexcept {
  if (b.x < 0 || b.y < 0 || b.z < 0 || b.x >= bricks_.x || b.y >= bricks_.y || b.z >= bricks_.z) return -1;
  return b.x + bricks_.x * (b.y + bricks_.y * b.z);
}

float SolidShares::of_two(IVec3 c) const noexcept {
  const int b = brick_index({c.x >> 2, c.y >> 2, c.z >> 2});
  if (b < 0) return 0.0f;
  const std::int32_t place = place_[static_cast<std::size_t>(b)];
  if (place < 0) return eight_[static_cast<std::size_t>(b)];
  return two_[static_cast<std::size_t>(place)][static_cast<std::size_t>((c.x & 3) | (c.y & 3) << 2 | (c.z & 3) << 4)];
}

float SolidShares::of_four(IVec3 c) const noexcept {
  const int b = brick_index({c.x >> 1, c.y >> 1, c.z >> 1});
  if (b < 0) return 0.0f;
  return four_[static_cast<std::size_t>(b)][static_cast<std::size_t>((c.x & 1) | (c.y & 1) << 1 | (c.z & 1) << 2)];
}

float SolidShares::of_eight(IVec3 c) const noexcept {
  const int b = brick_index(c);
  return b < 0 ? 0.0f : eight_[static_cast<std::size_t>(b)];
}

float SolidShares::at(Cell cell, Vec3f voxel) const noexcept {
  const float size = static_cast<float>(2 << static_cast<int>(cell));
  const Vec3f p = (voxel + 0.5f) / size - 0.5f;
  const IVec3 low(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z)));
  const Vec3f f = p - Vec3f(low);
  const auto mean = [&](const auto& of) {
    const auto row = [&](int y, int z) {
      const float a = of(low + IVec3(0, y, z)), b = of(low + IVec3(1, y, z));
      return a + f.x * (b - a);
    };
    const float near = row(0, 0) + f.y * (row(1, 0) - row(0, 0)), far = row(0, 1) + f.y * (row(1, 1) - row(0, 1));
    return (near + f.z * (far - near)) / 255.0f;
  };
  if (cell == Cell::two) return mean([this](IVec3 c) { return of_two(c); });
  if (cell == Cell::four) return mean([this](IVec3 c) { return of_four(c); });
  return mean([this](IVec3 c) { return of_eight(c); });
}

float SolidShares::mean_about(Vec3f voxel) const noexcept {
  const Vec3f p = (voxel + 0.5f) / 8.0f;
  const IVec3 middle(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z)));
  float weight[3][3];  // a quadratic spline's
  for (int axis = 0; axis < 3; ++axis) {
    const float t = p[axis] - static_cast<float>(middle[axis]);
    weight[axis][0] = 0.5f * (1.0f - t) * (1.0f - t);
    weight[axis][1] = 0.5f + t * (1.0f - t);
    weight[axis][2] = 0.5f * t * t;
  }
  float sum = 0.0f;
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        sum += weight[0][x] * weight[1][y] * weight[2][z] * of_eight(middle + IVec3(x, y, z) - 1);
  return sum / 255.0f;
}

namespace {

struct Tap {
  float mm;
  SolidShares::Cell cell;
  float stops;  // share of the cone's light that a wholly solid cell there stops
};
// A fissure is some tenths wide, a cavity 1 to 2 mm.
constexpr std::array<Tap, 4> kAlong = {{{0.25f, SolidShares::Cell::two, 0.8f},
                                        {0.55f, SolidShares::Cell::four, 0.8f},
                                        {1.05f, SolidShares::Cell::four, 0.7f},
                                        {1.80f, SolidShares::Cell::eight, 0.6f}}};
constexpr std::array<Tap, 3> kAslant = {{{0.35f, SolidShares::Cell::two, 0.9f},
                                         {0.80f, SolidShares::Cell::four, 0.9f},
                                         {1.60f, SolidShares::Cell::eight, 0.7f}}};
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
