/// The exact proxy of a ball bur in a cavity that a wider or narrower ball has milled: constraints from the surface that the
/// recorded path has left, solved in sub-steps. Frame: specimen. Unit: mm. Thread: any but the haptic one.
#pragma once

#include <memory>
#include <vector>

#include "tests/bench/half_spaces.h"
#include "tests/bench/swept_surface.h"
#include "tests/bench/truth.h"

namespace cusp::bench {

class CavityTruth : public Truth {
 public:
  /// thinner_mm: the bur's clearance against cuts, which the method has by design.
  CavityTruth(std::shared_ptr<const SweptSurface> surface, double bur_radius_mm, double thinner_mm);

  double clearance_mm(Vec3 centre) const override;
  void start(Vec3 centre) override;
  Exact follow(Vec3 device) override;

 protected:
  Vec3 place(Vec3 centre) override { return y_ = centre; }
  Exact move_to(Vec3 device) override { return move_to(device, kFineMm); }

 private:
  static constexpr double kFineMm = 1e-8, kCoarseMm = 2e-4;  // at the end of a tick, and in its sub-steps
  Exact move_to(Vec3 device, double precision_mm);
  /// The local minimum of |c - q| over admissible centres, downhill from y_. Each Newton step moves by at most kTrustMm.
  Vec3 settle(Vec3 q, double precision_mm);
  /// Features that a ball within kNearMm of touch about the centre reaches.
  struct Near {
    Vec3 centre{1e9};
    std::vector<int> sweeps, surfels, edges;
  };
  void gather(Vec3 centre, Near& near) const;
  void constraints(Vec3 y);
  void add_wall(int sweep, Vec3 y);
  enum class Normal : std::uint8_t { fixed, turning };
  bool add_point(Vec3 at, double radius_mm, Vec3 y, Normal normal);
  void add_fitting_walls(Vec3 y);
  void add_edge(int point, Vec3 y);

  std::shared_ptr<const SweptSurface> surface_;
  double radius_;   // thinner
  bool fits_;       // as wide as the sweeps: a wall touches all round
  Vec3 y_{0.0}, device_{0.0};
  Near near_;
  std::vector<HalfSpace> spaces_;
  std::vector<int> walls_;  // of add_fitting_walls
  Mat3 bend_{0.0};  // of the active constraints of the last pose
};

}  // namespace cusp::bench
