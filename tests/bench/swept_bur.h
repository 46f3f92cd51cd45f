/// The volume swept by a bur's head, by brute force over its path from the exact profile: the truth for carving, with
/// which it shares only the profile. Unit: mm. Thread: any but the haptic one.
#pragma once

#include <vector>

#include "engine/tool/bur.h"
#include "tests/bench/frame.h"
#include "tests/modules.h"

namespace cusp::bench {

/// The pivot moves straight from place to place with a fixed axis.
class SweptBur {
 public:
  /// Pre: two places at least, axis unit.
  SweptBur(const Bur& bur, Vec3 axis, std::vector<Vec3> places);

  /// Signed distance to the swept volume; inside, the least distance to the heads, which is no deeper than the true one.
  /// Exact to 0.01 um for places under 0.02 mm apart, else to kGoldenMm. Beyond +-far_mm any value beyond it may return.
  double distance_mm(Vec3 place, Vec3& gradient, double far_mm = 1e300) const;
  static constexpr double kGoldenMm = 1e-8;

  /// Swept volume behind a face (z < 0 of the frame): cubes down to leaf_mm cut by the tangent plane, extrapolated from
  /// leaf_mm and half of it. Relative error at 0.04 mm: 2e-5, 1e-4 for an inverted cone (swept_bur_test.cpp).
  double volume_mm3(const Frame& face, double leaf_mm = 0.04) const;

 private:
  struct Least {
    double distance, at;  // at: length along the path
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
  bool undercuts_ = false;      // an acute rim leaves walls, inside which distances are too large
  std::vector<double> along_;  // path length at each place
};

/// Closed form of the volume that an upright bur removes: down along its axis to deep_mm, then sideways by aside_mm (0, or
/// at least its radius). Discs and strips are exact; Gauss's rule on each part of the outline sums them to 1e-9.
/// Pre: deep_mm at most the length of the head.
double upright_mm3(const Bur& bur, double deep_mm, double aside_mm);

/// Share of the unit cube about the origin that lies where n·x < level; closed form.
double share_behind(Vec3 n, double level);

}  // namespace cusp::bench
