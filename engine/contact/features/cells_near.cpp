#include "engine/contact/features/cells_near.h"

#include <algorithm>
#include <cmath>

namespace cusp::engine {

namespace {

/// Voxels that a point or an edge may stand outside its cell: a tenth, a quarter the specimen's own.
constexpr float kOutside = 0.3f;
/// Cosine of the steepest cylinders separated slice by slice.
constexpr float kUpright = 0.5f;

/// Bits of the cells along an axis that come within low..high.
unsigned cells_along(float low, float high) noexcept {
  const float first = low - 1.0f - kOutside, last = high + kOutside;
  if (last < 0.0f || first > 7.0f) return 0;
  int from = first > 0.0f ? static_cast<int>(first) : 0;
  if (static_cast<float>(from) < first) ++from;
  const int to = last < 7.0f ? static_cast<int>(last) : 7;
  return from > to ? 0u : (2u << to) - (1u << from);
}

std::uint64_t cells_within(float low_x, float high_x, float low_y, float high_y) noexcept {
  // Bit y of the rows becomes the lowest bit of byte y, which the row's cells then fill.
  const std::uint64_t rows = cells_along(low_y, high_y);
  const std::uint64_t seven = (rows & 0x7fu) * 0x0002040810204081ull & 0x0101010101010101ull;
  return (seven | rows >> 7 << 56) * cells_along(low_x, high_x);
}

/// Of one cylinder about shape's axis, from..to along it.
void add_cylinder(const TwoCylinders& shape, float from, float to, float radius, unsigned slices, CellsNear& out) noexcept {
  const Vec3f axis = shape.axis;
  const float up = axis.z, beside = radius * std::sqrt(up < 1.0f && up > -1.0f ? 1.0f - up * up : 0.0f);
  for (int z = 0; z < 8; ++z) {
    if ((slices >> z & 1) == 0) continue;
    // Of the axis' places those that are level with the slice, give or take the radius.
    const float below = (z - kOutside - shape.at.z - beside) / up, above = (z + 1.0f + kOutside - shape.at.z + beside) / up;
    const float t0 = std::max(std::min(below, above), from), t1 = std::min(std::max(below, above), to);
    if (t0 > t1) continue;
    const Vec3f a = shape.at + axis * t0, b = shape.at + axis * t1;
    const Vec3f low = glm::min(a, b) - radius, high = glm::max(a, b) + radius;
    out.slice[z] |= cells_within(low.x, high.x, low.y, high.y);
  }
}

}  // namespace

CellsNear CellsNear::all() noexcept {
  CellsNear out;
  for (std::uint64_t& slice : out.slice) slice = ~std::uint64_t{0};
  return out;
}

CellsNear CellsNear::ball(Vec3f centre, float reach, unsigned slices) noexcept {
  CellsNear out;
  for (int z = 0; z < 8; ++z) {
    const float low = z - kOutside - centre.z, high = z + 1.0f + kOutside - centre.z;
    const float off = low > 0.0f ? low : high < 0.0f ? high : 0.0f;
    const float level = reach * reach - off * off;
    out.slice[z] = 0;
    if (level < 0.0f || (slices >> z & 1) == 0) continue;
    for (int y = 0; y < 8; ++y) {
      const float below = y - kOutside - centre.y, above = y + 1.0f + kOutside - centre.y;
      const float beside = below > 0.0f ? below : above < 0.0f ? above : 0.0f;
      const float left = level - beside * beside;
      if (left < 0.0f) continue;
      const float half = std::sqrt(left);
      out.slice[z] |= static_cast<std::uint64_t>(cells_along(centre.x - half, centre.x + half)) << (8 * y);
    }
  }
  return out;
}

CellsNear CellsNear::cylinders(const TwoCylinders& shape, unsigned slices) noexcept {
  if (shape.axis.z < kUpright && shape.axis.z > -kUpright) return all();
  CellsNear out{};
  const float narrow = std::sqrt(shape.narrow2), wide = std::sqrt(shape.wide2);
  const bool wide_all_along = shape.wide_from <= shape.from;
  if (!wide_all_along) add_cylinder(shape, shape.from, shape.to, narrow, slices, out);
  add_cylinder(shape, wide_all_along ? shape.from : shape.wide_from, shape.to, wide, slices, out);
  return out;
}

CellsNear CellsNear::operator|(const CellsNear& other) const noexcept {
  CellsNear out = *this;
  for (int z = 0; z < 8; ++z) out.slice[z] |= other.slice[z];
  return out;
}

CellsNear CellsNear::without(const std::uint64_t (&others)[8]) const noexcept {
  CellsNear out = *this;
  for (int z = 0; z < 8; ++z) out.slice[z] &= ~others[z];
  return out;
}

}  // namespace cusp::engine
