#include "scenarios/teeth/arch.h"

#include <algorithm>
#include <cmath>

#include "scenarios/teeth/noise.h"
#include "scenarios/teeth/shared_shape.h"
#include "scenarios/teeth/tables.h"

namespace cusp::scenarios {
namespace {

/// How far the arch turns at a contact, degrees, from the midline backwards: I1|I1, I1|I2, ... M2|M3. Chosen so that
/// the widths of the arch are those of the literature (README) [M].
constexpr double kUpperTurns[8] = {10, 14, 24, 26, 9, 6, 6, 8};
constexpr double kLowerTurns[8] = {10, 12, 26, 24, 6, 3, 5, 6};

double turn_at(int fdi, Proximal side) noexcept {
  const double* turns = fdi < 30 ? kUpperTurns : kLowerTurns;
  const int number = fdi % 10;
  return glm::radians(turns[side == Proximal::mesial ? number - 1 : number]);
}

std::optional<double> reach(const ToothBody& body, Vec3 from, Vec3 way, double most_mm) noexcept {
  const ToothPlace& place = body.place();
  Vec3 v = place.turned_back(way);
  if (place.mirrored) v.x = -v.x;
  return body.shape().march(place.to_tooth(from), v, most_mm);
}

}  // namespace

int neighbour_fdi(int fdi, Proximal side) noexcept {
  const int quadrant = fdi / 10, number = fdi % 10;
  if (side == Proximal::distal) return number == 8 ? 0 : fdi + 1;
  if (number > 1) return fdi - 1;
  constexpr int kOther[5] = {0, 2, 1, 4, 3};
  return 10 * kOther[quadrant] + 1;
}

std::uint64_t seed_in_mouth(std::uint64_t seed, int fdi) noexcept {
  return seed == 0 ? 0 : seed * 64 + static_cast<std::uint64_t>(fdi);
}

Gap gap_between(const ToothBody& a, const ToothBody& b, Vec3 way, Vec3 about) {
  const Vec3 across{-way.y, way.x, 0.0};
  constexpr double kFar = 6.0;
  Gap best{1e9, about};
  const auto look = [&](double w, double z) {
    const Vec3 middle = about + w * across + Vec3(0, 0, z);
    const auto to_a = reach(a, middle + kFar * way, -way, 2 * kFar);
    const auto to_b = reach(b, middle - kFar * way, way, 2 * kFar);
    if (!to_a || !to_b) return;
    const double at_a = kFar - *to_a, at_b = *to_b - kFar;
    if (at_b - at_a < best.mm) best = {at_b - at_a, middle + 0.5 * (at_a + at_b) * way};
  };
  for (double z = -2.0; z <= 2.01; z += 0.4) {
    for (double w = -2.4; w <= 2.41; w += 0.4) look(w, z);
  }
  for (double step = 0.2; step > 0.02; step *= 0.5) {
    const double w = glm::dot(best.at_mm - about, across), z = best.at_mm.z - about.z;
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) look(w + i * step, z + j * step);
    }
  }
  return best;
}

std::shared_ptr<const ToothShape> shape_in_mouth(int fdi, std::uint64_t mouth_seed, double voxel_mm) {
  return shared_shape(*table_for(fdi)->table, seed_in_mouth(mouth_seed, fdi), voxel_mm);
}

Standing stand_beside(const Standing& before, Proximal side, std::shared_ptr<const ToothShape> shape) {
  const bool mesial = side == Proximal::mesial;
  Standing out;
  out.fdi = neighbour_fdi(before.fdi, side);
  out.shape = std::move(shape);
  const bool midline = mesial && before.fdi % 10 == 1;
  out.place.mirrored = before.place.mirrored != midline;

  // Mesially the arch bends towards lingual: in a tooth's own frame x turns to -y, in a mirrored one the other way.
  const double turn = turn_at(before.fdi, side) * (mesial != before.place.mirrored ? -1.0 : 1.0);
  const double c = std::cos(turn), s = std::sin(turn);
  out.place.cos = before.place.cos * c - before.place.sin * s;
  out.place.sin = before.place.sin * c + before.place.cos * s;

  const ToothBody here(*before.shape, before.place, ToothMaterial::natural);
  const Vec3 from = mesial ? here.mesial_contact() : here.distal_contact();
  const auto contact_of_new = [&] {
    const ToothBody there(*out.shape, out.place, ToothMaterial::natural);
    return mesial && !midline ? there.distal_contact() : there.mesial_contact();
  };
  out.place.move_mm += from - contact_of_new();

  // Along the middle of the two teeth's rows, pushed together until they touch.
  const bool along_x = mesial != before.place.mirrored;
  const double half = std::cos(0.5 * turn), across = std::sin(0.5 * turn);
  Vec3 way = before.place.turned({along_x ? 1.0 : -1.0, 0.0, 0.0});
  way = {half * way.x - across * way.y, across * way.x + half * way.y, 0.0};
  for (int round = 0; round < 3; ++round) {
    const ToothBody there(*out.shape, out.place, ToothMaterial::natural);
    const Gap gap = gap_between(here, there, way, from);
    out.contact_mm = gap.at_mm;
    out.gap_mm = gap.mm;
    if (round == 2 || gap.mm > 1e8) break;
    out.place.move_mm += (kContactGapMm - gap.mm) * way;
  }
  return out;
}

}  // namespace cusp::scenarios
