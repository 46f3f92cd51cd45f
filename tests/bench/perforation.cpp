#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/rate.h"
#include "tests/engine/step/cut_along.h"

namespace cusp::bench {

namespace {

constexpr double kPerforationFullForceN = 0.25;  // at 1 N/mm full wear begins at 0.25 mm of spring
constexpr double kDrillLeadMm = 0.3;       // of the device point ahead of the bur: full wear
constexpr double kCoverMm = 0.3;      // of tissue over the ball at the start, more than the band
constexpr double kLeadStepMm = 0.05;  // a tick, during the approach
constexpr int kSettleTicks = 100;

std::shared_ptr<const Scene> drilling_scene(Method method, const Shape& face, double voxel_mm) {
  auto scene = scene_of(face, method, voxel_mm);
  scene->full_force_n = kPerforationFullForceN;
  for (TissueFeel& feel : scene->tissues) feel = {1.0, kAdvanceMmS};
  return scene;
}

}  // namespace

Perforation::Perforation(Method method, const Shape& face, double voxel_mm, std::uint64_t seed)
    : state_(drilling_scene(method, face, voxel_mm)) {
  Random random(seed);
  const Spot spot = face.spot(random);
  const double r = face.bur_radius_mm();
  inwards_ = -spot.normal;
  start_ = spot.centre + inwards_ * (2.0 * r + kCoverMm);
  // cut_along opens the approach at once; the bur enters, begins to cut and settles.
  test::cut_along(state_, 0, spot.centre - inwards_ * (2.0 * r), start_);
  lead(state_, step, face.home(), kLeadStepMm);
  lead(state_, step, spot.centre - inwards_ * (2.0 * r), kLeadStepMm);
  lead(state_, step, start_ + inwards_ * kDrillLeadMm, kLeadStepMm);
  for (int k = 0; k < kSettleTicks; ++k) step(state_, next());
  tick_ = 0;
  start_ += inwards_ * (kAdvanceMmS * 1e-3 * kSettleTicks);
}

StepInput Perforation::next() {
  ++tick_;
  return input_at(start_ + inwards_ * (kDrillLeadMm + kAdvanceMmS * 1e-3 * tick_), Button::down);
}

}  // namespace cusp::bench
