#include "engine/removal/wear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "engine/contact/solver/plane_search.h"
#include "engine/tool/swept.h"
#include "engine/volume/cell_field.h"

namespace cusp::engine {

namespace {

/// 152 directions: the points of a cube's surface with odd coordinates up to 5, made unit; and what of the ball each
/// stands for: its square of the cube, of which a corner has three quarters, as it is seen from the middle. Only sqrt: the
/// same everywhere.
struct Directions {
  std::array<Vec3, 152> unit;
  std::array<double, 152> share;
  Directions() noexcept {
    std::size_t n = 0;
    for (int z = -5; z <= 5; z += 2)
      for (int y = -5; y <= 5; y += 2)
        for (int x = -5; x <= 5; x += 2) {
          const int most = std::max(std::abs(x), std::max(std::abs(y), std::abs(z)));
          if (most != 5) continue;
          const Vec3 v(x, y, z);
          const double away = std::sqrt(glm::dot(v, v));
          const bool corner = std::abs(x) == most && std::abs(y) == most && std::abs(z) == most;
          share[n] = (corner ? 0.75 : 1.0) / (away * away * away);
          unit[n++] = v / away;
        }
  }
};
const Directions kDirections;

/// Sixteen directions across an axis, evenly about it: cosine and sine of 22.5 degrees and its multiples, by halving; and
/// eight parts of such a step.
struct Round {
  std::array<OnHalf, 16> unit;  // t: cosine, rho: sine
  std::array<OnHalf, 8> part;
  static OnHalf half(OnHalf v) noexcept { return {std::sqrt(0.5 + 0.5 * v.t), std::sqrt(0.5 - 0.5 * v.t)}; }
  static OnHalf turned(OnHalf v, OnHalf by) noexcept {
    return {v.t * by.t - v.rho * by.rho, v.rho * by.t + v.t * by.rho};
  }
  Round() noexcept {
    OnHalf angle = half({0.0, 1.0});  // 45 degrees
    angle = half(angle);
    fill(unit, angle);
    for (int i = 0; i < 3; ++i) angle = half(angle);
    fill(part, angle);
  }
  template <std::size_t kCount>
  static void fill(std::array<OnHalf, kCount>& out, OnHalf step) noexcept {
    out[0] = {1.0, 0.0};
    for (std::size_t i = 1; i < kCount; ++i) out[i] = turned(out[i - 1], step);
  }
};
const Round kRound;
/// Which of 128 turns, the parts of Round, a tick's points have: consecutive ones about a golden section of a turn apart.
inline unsigned turn_of(std::uint64_t tick) noexcept { return static_cast<unsigned>(tick * 79 & 127); }

/// What a point of the front meets.
struct Met {
  double weight = 0.0, time = 0.0;
  bool stops = false;  // tissue that cannot be cut
  /// eighth: of a voxel about the place, whose middle is asked.
  void look(const Volume& volume, const Scene& scene, Vec3 at_mm, double w, unsigned eighth) noexcept {
    const Grid& grid = volume.grid();
    const Vec3 x = (at_mm - grid.origin_mm) * (1.0 / grid.voxel_mm) +
                   Vec3(eighth & 1 ? 0.75 : 0.25, eighth & 2 ? 0.75 : 0.25, eighth & 4 ? 0.75 : 0.25);
    const IVec3 v = cell_of_voxels(x);
    const Specimen& specimen = volume.specimen();
    const int brick = specimen.brick_index(v >> 3), offset = brick_offset(v.x & 7, v.y & 7, v.z & 7);
    // The front itself stands at s = 1/2: a quarter voxel of band either way counts as met.
    constexpr std::uint16_t kMet = 26000;
    if (brick < 0 || volume.cut_in(brick, offset) < kMet || specimen.s_in(brick, offset) < kMet) return;
    const double speed = scene.tissues[index_of(specimen.tissue_in(brick, offset))].speed_mm_s;
    if (!(speed > 0.0)) {
      stops = true;
      return;
    }
    weight += w;
    time += w / speed;
  }
};

/// By the points of a ball that is pushed on, up to the first that stops it.
Met met_by_ball(const Volume& volume, const Scene& scene, const Front& front, std::uint64_t tick) noexcept {
  Met met;
  const Vec3 direction = front.direction;
  auto eighth = static_cast<unsigned>(tick & 7);
  // Turned about the way from tick to tick: what the points miss between them, and what lies unevenly about it, then
  // evens out.
  const unsigned turned = turn_of(tick);
  const OnHalf turn = Round::turned(kRound.unit[turned >> 3], kRound.part[turned & 7]);
  for (std::size_t i = 0; i < kDirections.unit.size() && !met.stops; ++i) {
    const Vec3& u = kDirections.unit[i];
    const double w = glm::dot(u, direction);
    eighth = (eighth + 3) & 7;
    if (w <= 0.0) continue;
    const Vec3 at = u * turn.t + glm::cross(direction, u) * turn.rho + direction * (w * (1.0 - turn.t));
    met.look(volume, scene, front.pose_mm + at * front.bur.radius_mm, w * kDirections.share[i], eighth);
  }
  return met;
}

/// The same of a head given by its rings.
Met met_by_rings(const Volume& volume, const Scene& scene, const Front& front, std::uint64_t tick) noexcept {
  Met met;
  const Vec3 axis = front.axis, first = across(axis), second = glm::cross(axis, first);
  const OnHalf part = kRound.part[turn_of(tick) & 7];
  const Vec3 one = first * part.t + second * part.rho, other = second * part.t - first * part.rho;
  auto eighth = static_cast<unsigned>(tick & 7);
  for (const FrontRing& ring : front.rings)
    for (const OnHalf& turn : kRound.unit) {
      eighth = (eighth + 3) & 7;
      const Vec3 out = one * turn.t + other * turn.rho;
      const double w = ring.area * glm::dot(axis * ring.normal.t + out * ring.normal.rho, front.direction);
      if (w <= 0.0) continue;
      met.look(volume, scene, front.pose_mm + axis * ring.at.t + out * ring.at.rho, w, eighth);
      if (met.stops) return met;
    }
  return met;
}

}  // namespace

HeadPush push_of_head(Vec3 to_device, std::span<const Vec3> walls) noexcept {
  constexpr double kNoPushMm = 1e-9;
  HeadPush out;
  Vec3 left = to_device;
  if (!walls.empty()) {
    Plane plane[3];
    for (std::size_t i = 0; i < walls.size(); ++i) plane[i].n = walls[i];
    left = closest_point(to_device, {plane, walls.size()}, kNoPushMm).y;
    const double whole_mm = std::sqrt(glm::dot(to_device, to_device));
    if (whole_mm > kNoPushMm) out.share = std::sqrt(glm::dot(left, left)) / whole_mm;
  }
  out.gap_mm = std::sqrt(glm::dot(left, left));
  if (out.gap_mm > kNoPushMm) out.direction = left / out.gap_mm;
  return out;
}

std::vector<FrontRing> front_rings(const Profile& head) {
  constexpr int kMostRings = 24;
  std::vector<FrontRing> out;
  double whole = 0.0;
  for (int i = 0; i < head.size(); ++i) {
    const OutlinePiece& p = head.piece(i);
    const double dt = p.to.t - p.from.t, dr = p.to.rho - p.from.rho;
    whole += std::sqrt(dt * dt + dr * dr);
  }
  for (int i = 0; i < head.size(); ++i) {
    const OutlinePiece& p = head.piece(i);
    const double dt = p.to.t - p.from.t, dr = p.to.rho - p.from.rho;
    const double chord = std::sqrt(dt * dt + dr * dr);
    const int parts = std::clamp(static_cast<int>(chord / whole * (kMostRings - head.size())), 1, kMostRings);
    OnHalf last = p.from;
    for (int k = 1; k <= parts; ++k) {
      const auto at_part = [&](double part) {
        OnHalf at{p.from.t + dt * part, p.from.rho + dr * part};
        if (p.radius > 0.0) {
          const double t = at.t - p.centre.t, rho = at.rho - p.centre.rho;
          const double away = std::sqrt(t * t + rho * rho);
          at = {p.centre.t + t * (p.radius / away), p.centre.rho + rho * (p.radius / away)};
        }
        return at;
      };
      const OnHalf next = at_part(static_cast<double>(k) / parts);
      const double t = next.t - last.t, rho = next.rho - last.rho;
      const double length = std::sqrt(t * t + rho * rho);
      FrontRing ring;
      ring.at = at_part((static_cast<double>(k) - 0.5) / parts);
      ring.normal = {-rho / length, t / length};
      ring.area = length * (next.rho + last.rho);
      out.push_back(ring);
      last = next;
    }
  }
  return out;
}

double front_speed(const Volume& volume, const Scene& scene, const Front& front, double fallback_mm_s, std::uint64_t tick) noexcept {
  const Met met = front.bur.head.ball() ? met_by_ball(volume, scene, front, tick) : met_by_rings(volume, scene, front, tick);
  if (met.stops) return 0.0;
  return met.weight > 0.0 ? met.weight / met.time : fallback_mm_s;
}

double slide_depth(const Bur& bur, Vec3 axis, Vec3 direction, Vec3 slide_mm, double advance_mm) noexcept {
  const double slide = std::sqrt(glm::dot(slide_mm, slide_mm));
  const double ratio = advance_mm / slide;
  if (bur.head.ball()) return 0.5 * bur.radius_mm * ratio * ratio;
  if (ratio >= 1.0) return bur.radius_mm;
  const Vec3 turned = direction * std::sqrt(1.0 - ratio * ratio) + slide_mm * (ratio / slide);
  return glm::dot(direction, head_furthest(bur, axis, direction) - head_furthest(bur, axis, turned));
}

}  // namespace cusp::engine
