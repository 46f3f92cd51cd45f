#include "engine/contact/methods/gradient_proxy.h"

#include <algorithm>

#include "engine/tool/swept.h"

namespace cusp::engine {

namespace {

constexpr double kBallVoxels = 2.0,
                 kHolderVoxels = 3.0;  // spacing of the scan: it finds a direction, the foot is exact
constexpr int kPasses = 24;            // of one tick
constexpr double kSettledMm = 1e-5;    // a pass that moves less is the last
constexpr double kRescanVoxels = 0.5;  // of way
constexpr double kNearVoxels = 1.5;    // a gap beyond it needs no foot yet: a step is at most a voxel
constexpr int kFootPasses = 6;
constexpr double kFootSettled = 1e-6;  // of the normal
constexpr double kOverlapMm = 0.001;
constexpr double kOnHeadMm = 1e-6;  // of the head's skin

}  // namespace

GradientProxy::GradientProxy(const Scene& scene, const Volume& volume) : axis_(scene.tool_axis), box_(volume) {
  const double voxel = volume.grid().voxel_mm;
  for (const Bur& bur : scene.burs) {
    // At least three by three points a side, so that the best of them leads to the foot.
    const double spacing = std::min(kBallVoxels * voxel, 0.45 * bur.radius_mm);
    shells_.push_back(shell_of(bur, scene.tool_axis, spacing, kHolderVoxels * voxel));
  }
}

GradientProxy::Scan GradientProxy::scan(const TrilinearField& field, std::size_t bur, Vec3 y) const noexcept {
  Scan out;
  out.gap_mm = field.band_mm();
  const auto take = [&](const auto& point, Vec3 place) {
    const double d = field.at(place);
    if (d < out.gap_mm) out = {point.offset_mm, d};
  };
  shells_[bur].for_points_in(box_, y, take, take);
  return out;
}

GradientProxy::Foot GradientProxy::foot(const TrilinearField& field, const Bur& bur, Vec3 y,
                                        Vec3 offset) const noexcept {
  Foot out;
  out.offset = offset;
  const double radius_mm = bur.radius_mm;
  const bool ball = bur.head.ball();
  // No point of neck and shank lies inside the head.
  out.shank = ball ? glm::dot(offset, offset) > radius_mm * radius_mm * (1.0 + 1e-9)
                   : head_distance(bur, axis_, offset) > kOnHeadMm;
  if (out.shank) {
    out.known = field.normal(y + offset, out.n);
    out.gap_mm = field.at(y + offset);
    return out;
  }
  Vec3 n = offset / -radius_mm;
  if (!ball) {
    head_distance(bur, axis_, offset, n);
    n = -n;
  }
  // The head's place that a plane of this normal touches; of a flat end or flank the one nearest to the foot so far.
  const auto against = [&](Vec3 normal) {
    return ball ? normal * -radius_mm : head_support(bur, axis_, -normal, out.offset);
  };
  Vec3 before(0.0);
  for (int pass = 0; pass < kFootPasses; ++pass) {
    Vec3 m;
    if (!field.normal(ball ? y - n * radius_mm : y + against(n), m)) break;
    out.known = true;
    Vec3 change = m - n;
    // On a feature sharper than the bur the iteration swings: then half the way.
    if (glm::dot(change, before) < 0.0) change *= 0.5;
    before = change;
    // Half the way to the other side of a thin ridge is no direction at all.
    const Vec3 turned = n + change;
    const double length = length_of(turned);
    if (length < 1e-9) break;
    n = turned / length;
    if (glm::dot(change, change) < kFootSettled * kFootSettled) break;
  }
  out.n = n;
  out.offset = against(n);
  out.gap_mm = field.at(y + out.offset);
  return out;
}

bool GradientProxy::fits(const Volume& volume, std::size_t bur, Vec3 pose) noexcept {
  return scan(TrilinearField(volume), bur, pose).gap_mm >= 0.0;
}

BandedContact GradientProxy::solve(const Volume& volume, const Scene& scene, std::size_t bur, Vec3 from, Vec3 device,
                                   Vec3& kept) noexcept {
  BandedContact out;
  const TrilinearField field(volume);
  const double voxel = volume.grid().voxel_mm;
  const Bur& shape = scene.burs[bur];
  Vec3 y = from;
  Foot held;
  bool touching = false, clipped = false;
  double clear = 0.0;
  double since_scan = voxel;  // at once
  Vec3 before(0.0);
  double bound = voxel;
  for (int pass = 0; pass < kPasses; ++pass) {
    Foot found;
    if (glm::dot(kept, kept) > 0.0) found = foot(field, shape, y, kept);
    if (since_scan >= kRescanVoxels * voxel) {
      since_scan = 0.0;
      const Scan seen = scan(field, bur, y);
      clear = seen.gap_mm;
      if (clear < kNearVoxels * voxel) {
        const Foot other = foot(field, shape, y, seen.offset);
        if (other.known && (!found.known || other.gap_mm < found.gap_mm - 1e-6)) found = other;
      } else {
        found = Foot{};
      }
    }
    Vec3 goal = device;
    touching = false;
    if (found.known) {
      const double towards = glm::dot(found.n, device - y);
      touching = towards < -found.gap_mm;
      if (touching) goal = device - found.n * (towards + found.gap_mm);
    }
    held = found;
    kept = found.known ? found.offset : Vec3(0.0);
    const Vec3 way = goal - y;
    const double length = length_of(way);
    // Projections that swing (a hollow narrower than the push is deep) are damped: half the last way, and so on.
    if (touching && glm::dot(way, before) < 0.0) bound = 0.5 * std::min(bound, length_of(before));
    const double most = clear > kNearVoxels * voxel ? 0.9 * clear : bound;
    clipped = length > most;
    before = clipped ? way * (most / length) : way;
    y = clipped ? y + way * (most / length) : goal;
    since_scan += clipped ? most : length;
    if (length < kSettledMm || most < kSettledMm) break;
    if (!clipped && !touching && since_scan < kRescanVoxels * voxel) break;
  }
  out.pose_mm = y;
  out.deferred = clipped && bound == voxel;
  out.touching = touching && length_of(device - y) > 1e-6;
  if (!out.touching) return out;
  out.infeasible = held.gap_mm < -kOverlapMm;
  out.shank = held.shank;
  out.shank_normal = held.n;
  out.tissue = field.tissue(y + held.offset - held.n * (0.5 * voxel));
  if (out.tissue == Tissue::empty) out.tissue = field.tissue(y + held.offset);
  out.stiffness_n_per_mm = scene.tissues[index_of(out.tissue)].stiffness_n_per_mm;
  return out;
}

}  // namespace cusp::engine
