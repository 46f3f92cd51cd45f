/// What a bur's head has swept, by brute force over its way from the exact profile: truth for what carving leaves. It
/// shares the profile with the carving and nothing else. Lengths in mm; for benches and tests, not for the haptic thread.
#pragma once

#include <vector>

#include "engine/tool/bur.h"
#include "tests/bench/frame.h"
#include "tests/modules.h"

namespace cusp::bench {

/// The pivot goes straight from place to place, the axis stays.
class SweptBur {
 public:
  /// Pre: two places at least, axis unit.
  SweptBur(const Bur& bur, Vec3 axis, std::vector<Vec3> places);

  /// Signed distance to what was swept; inside it is the least of the distances to the heads, which is no deeper than the
  /// true one. Exact to 0.01 um where the places are under 0.02 mm apart, else to kGoldenMm. Beyond far_mm, either way, it
  /// may be any value beyond.
  double distance_mm(Vec3 place, Vec3& gradient, double far_mm = 1e300) const;
  static constexpr double kGoldenMm = 1e-8;

  /// Volume of what was swept behind a face (z < 0 of the frame), by cubes down to leaf_mm that the surface's tangent
  /// plane cuts, and once more with half of that, extrapolated. Error with 0.04 mm: 2e-5, 1e-4 for an inverted cone
  /// (swept_bur_test.cpp).
  double volume_mm3(const Frame& face, double leaf_mm = 0.04) const;

 private:
  struct Least {
    double distance, at;  // at: along the way
    Vec3 gradient;
  };
  double head(double at, Vec3 place, Vec3& gradient) const;
  /// Places between two indices, with the distances at both.
  struct Span {
    std::size_t from, to;
    double low, high;
  };
  void search(const Span& span, Vec3 place, double far, Least& least) const;
  void golden(std::size_t segment, Vec3 place, Least& least) const;
  struct Near {
    double distance = 0.0;
    Vec3 gradient{0.0};
  };
  double cube_mm3(const Frame& face, Vec3 middle, double half, double leaf_mm) const;
  double columns_mm3(const Frame& face, Vec3 middle, double half) const;
  double split_mm3(const Frame& face, Vec3 middle, double half, Vec3 gradient, double leaf_mm, int edge_levels) const;

  Bur bur_;
  Vec3 axis_;
  std::vector<Vec3> places_;
  bool undercuts_ = false;      // a rim that is less than a right angle leaves the walls: within them no distance is near
  std::vector<double> along_;  // length of the way up to each place
};

/// Closed forms, of a bur upright on a face: what it has taken when its tip is `deep` behind the face, led down along its
/// axis and then sideways by `aside_mm` (0, or its radius at least). Discs and strips exactly, their sum over the depth by
/// Gauss's rule on each piece of the outline, to 1e-9 of it. Pre: deep no more than the head's length.
double upright_mm3(const Bur& bur, double deep_mm, double aside_mm);

/// Share of the unit cube about the origin that lies where n·x < level; closed form.
double share_behind(Vec3 n, double level);

}  // namespace cusp::bench
