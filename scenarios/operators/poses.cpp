#include "scenarios/operators/poses.h"

#include <algorithm>
#include <cmath>

#include "engine/tool/swept.h"

namespace cusp::scenarios {

namespace {

constexpr double kTurn = 6.283185307179586;
constexpr int kAround = 32;             // places of a ring; at radius 0.5 mm a chord lies 0.0024 mm inside
constexpr int kCoarse = 8;              // of those that are asked first
constexpr double kRingStep = kTurn / 32;  // between the rings of an arc
constexpr double kFlankStepMm = 0.5;    // between the rings of a straight flank
constexpr double kTiltedStepMm = 0.15;  // the same of a tilted bur's flank and neck: an edge between two rings stands 0.04 mm into it at 45 degrees
constexpr double kShankStepMm = 0.3;
constexpr int kUndersideSteps = 64;     // of a tilted head's height, in search of a place within it
constexpr double kSurelyOutMm = 0.05;   // of one place: the others are not asked

/// Solid fraction between voxel centres, as a distance in voxels: below 0 in tissue.
double air_voxels(const Specimen& specimen, Vec3 p) noexcept {
  const Grid& grid = specimen.grid();
  const Vec3 at = (p - grid.origin_mm) / grid.voxel_mm;
  const IVec3 low(glm::floor(at));
  const Vec3 f = at - Vec3(low);
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    const IVec3 step(c & 1, c >> 1 & 1, c >> 2);
    const Vec3 w(step.x ? f.x : 1.0 - f.x, step.y ? f.y : 1.0 - f.y, step.z ? f.z : 1.0 - f.z);
    sum += w.x * w.y * w.z * distance_from_solid(specimen.s(low + step));
  }
  return sum;
}

}  // namespace

Poses::Poses(const TargetShape& shape, const Specimen& specimen, const Bur& bur, Vec3 moved_mm, double wider_mm, double clear_mm, Top top,
             Vec3 axis)
    : shape_(&shape), specimen_(&specimen), moved_(moved_mm), axis_(axis), lowest_(0.0, 0.0, -bur.radius_mm), wider_(wider_mm), clear_(clear_mm),
      radius_(bur.radius_mm), spread_(bur.radius_mm), reach_(head_reach(bur)), top_(top), bur_(bur) {
  // A filled voxel is a whole band within one edge.
  if (specimen.reading() == Reading::banded) air_mm_ = specimen.grid().voxel_mm;
  else if (!upright()) air_mm_ = 0.5 / kBandVoxels * specimen.grid().voxel_mm;
  if (bur.head.ball()) sample_ball();
  else sample_head(bur.head);
  if (!upright()) {
    tilt(bur);
    return;
  }
  // Neck and shank: rings a millimetre apart.
  const double head_end = bur.head.ball() ? bur.radius_mm : bur.head.high();
  for (double t = head_end; t < bur.neck_length_mm; t += 1.0) add_ring(t, bur.neck_radius_mm, kCoarse, fine_);
  add_ring(bur.neck_length_mm, bur.shank_radius_mm, 2 * kCoarse, coarse_);
}

/// A neck and a shank that lean stand out beside the head: rings lie close along both.
void Poses::tilt(const Bur& bur) {
  const double head_end = bur.head.ball() ? bur.radius_mm : bur.head.high(), shank_end = bur.neck_length_mm + bur.shank_length_mm;
  for (double t = head_end; t < bur.neck_length_mm; t += kTiltedStepMm) add_ring(t, bur.neck_radius_mm, kCoarse, fine_);
  for (double t = bur.neck_length_mm; t < shank_end; t += kShankStepMm) add_ring(t, bur.shank_radius_mm, 2 * kCoarse, fine_);
  add_ring(bur.neck_length_mm, bur.shank_radius_mm, 2 * kCoarse, coarse_);
  lowest_ = head_furthest(bur, axis_, Vec3(0.0, 0.0, -1.0));
  if (narrows_) *narrows_ += std::sqrt(1.0 - axis_.z * axis_.z) / axis_.z;
  const Vec3 x = across(axis_), y = glm::cross(axis_, x);
  for (std::vector<Ring>* rings : {&coarse_, &fine_})
    for (Ring& ring : *rings)
      for (Vec3& place : ring.places) {
        const bool of_head = place.z <= head_end;
        place = place.x * x + place.y * y + place.z * axis_;
        if (of_head) spread_ = std::max(spread_, std::hypot(place.x, place.y));
      }
}

void Poses::add_ring(double t, double rho, int count, std::vector<Ring>& to) const {
  Ring& ring = to.emplace_back();
  if (rho < 1e-6) count = 1;
  for (int i = 0; i < count; ++i) {
    const double angle = kTurn * i / count;
    ring.places.push_back({rho * std::cos(angle), rho * std::sin(angle), t});
  }
  ring.apart_mm = std::max(1e-6, kTurn * rho / count);
}

void Poses::sample_ball() {
  for (double angle = -0.25 * kTurn; angle < 0.25 * kTurn + 0.5 * kRingStep; angle += kRingStep)
    add_ring(radius_ * std::sin(angle), radius_ * std::cos(angle), kAround, fine_);
  add_ring(0.0, radius_, kCoarse, coarse_);
  add_ring(-radius_, 0.0, 1, coarse_);
}

void Poses::sample_head(const Profile& head) {
  lowest_.z = head.low();
  OnHalf widest;
  const double flank_step = upright() ? kFlankStepMm : kTiltedStepMm;
  for (int i = 0; i < head.size(); ++i) {
    const OutlinePiece& piece = head.piece(i);
    const double dt = piece.to.t - piece.from.t, drho = piece.to.rho - piece.from.rho;
    const double length = std::sqrt(dt * dt + drho * drho);
    const bool straight = piece.radius == 0.0;
    if (straight && dt > radius_) narrows_ = std::fabs(drho) / dt;
    const int rings = std::max(1, static_cast<int>(std::ceil(straight ? length / flank_step : length / (piece.radius * kRingStep))));
    for (int k = 0; k <= rings; ++k) {
      const double share = static_cast<double>(k) / rings;
      OnHalf at{piece.from.t + share * dt, piece.from.rho + share * drho};
      if (!straight) {
        const double t = at.t - piece.centre.t, rho = at.rho - piece.centre.rho;
        const double out = piece.radius / std::max(1e-9, std::sqrt(t * t + rho * rho));
        at = {piece.centre.t + out * t, piece.centre.rho + out * rho};
      }
      add_ring(at.t, at.rho, kAround, fine_);
      if (at.rho > widest.rho) widest = at;
    }
  }
  add_ring(widest.t, widest.rho, kCoarse, coarse_);
  add_ring(head.low(), 0.0, 1, coarse_);
}

double Poses::ridge_mm(double apart_mm) const noexcept {
  return narrows_ ? *narrows_ * apart_mm : apart_mm * apart_mm / (8.0 * radius_);
}

double Poses::underside_upright(double from_axis) const noexcept {
  const Profile& head = bur_.head;
  if (from_axis > radius_) return 1e9;
  if (head.ball()) return -std::sqrt(radius_ * radius_ - from_axis * from_axis);
  // Upwards to where the place lies within the head.
  OnHalf gradient;
  double low = head.low(), high = head.high();
  for (double t = head.low(); t <= head.high(); t += 0.05 * radius_)
    if (head.distance({t, from_axis}, gradient) <= 0.0) {
      high = t;
      break;
    }
  for (int pass = 0; pass < 20; ++pass) {
    const double middle = 0.5 * (low + high);
    (head.distance({middle, from_axis}, gradient) <= 0.0 ? high : low) = middle;
  }
  return high;
}

double Poses::underside_mm(Vec2 way, double away_mm) const noexcept {
  if (upright()) return underside_upright(away_mm);
  const double length = glm::length(way);
  const Vec2 at = length > 0.0 ? (away_mm / length) * way : Vec2(0.0);
  const auto within = [&](double z) { return head_distance(bur_, axis_, {at.x, at.y, z}) <= 0.0; };
  const double step = (head_furthest(bur_, axis_, Vec3(0.0, 0.0, 1.0)).z - lowest_.z) / kUndersideSteps;
  double high = lowest_.z;
  for (int i = 0; !within(high); ++i) {
    if (i == kUndersideSteps) return 1e9;
    high += step;
  }
  double low = high - step;
  for (int pass = 0; pass < 20; ++pass) {
    const double middle = 0.5 * (low + high);
    (within(middle) ? high : low) = middle;
  }
  return high;
}

double Poses::place_out(Vec3 p) const noexcept {
  const double target = target_mm(p);
  if (target <= 0.0 || air_mm_ == 0.0) return target;
  return std::min(target, clear_ - air_mm_ * air_voxels(*specimen_, p));
}

double Poses::beside_mm(Vec3 pivot) const noexcept {
  return std::min(target_mm(pivot), target_mm(pivot + lowest_));
}

double Poses::blocked_mm(Vec3 pivot) const noexcept {
  // Of a distance that is exact this is all; of a bound it may be far too much.
  const double whole = target_mm(pivot) + reach_;
  if (whole <= 0.0) return whole;
  double most = -1e9;
  for (const std::vector<Ring>* rings : {&coarse_, &fine_})
    for (const Ring& ring : *rings)
      for (std::size_t i = 0; i < ring.places.size();) {
        const double out = place_out(pivot + ring.places[i]);
        most = std::max(most, out);
        if (most > kSurelyOutMm) return most;
        // Within that of a place inside nothing stands out.
        i += 1 + static_cast<std::size_t>(std::max(0.0, -out) / ring.apart_mm);
      }
  return most;
}

double Poses::out_mm(Vec3 pivot) const noexcept {
  const double beside = beside_mm(pivot);
  return beside > kSurelyOutMm ? beside : std::max(beside, blocked_mm(pivot));
}

}  // namespace cusp::scenarios
