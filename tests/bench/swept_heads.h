/// SweptHeads is what a head that is no ball leaves of a block: the tissue below a flat face and outside every pose that
/// the head has swept, each with its own axis. proxy_from() gives the head's exact proxy there. Distances come from
/// HeadCurve, not from the engine. Frame: specimen. Unit: mm. Thread: any but the haptic one; it allocates.
#pragma once

#include <optional>
#include <vector>

#include "engine/tool/bur.h"
#include "tests/bench/frame.h"
#include "tests/bench/head_curve.h"

namespace cusp::bench {

/// The pivot's straight way from a to b.
struct HeadSweep {
  Vec3 a{0.0}, b{0.0}, axis{0.0};
};

/// Places on a head's skin, from the pivot, at most kSkinMm apart; its rims among them.
inline constexpr double kSkinMm = 0.04;
std::vector<Vec3> skin_of(const Bur& bur, Vec3 axis);

class SweptHeads {
 public:
  /// face.z points out of the block. Pre: sweeps is not empty.
  SweptHeads(const Bur& bur, std::vector<HeadSweep> sweeps, const Frame& face);

  /// Depth of a place in the tissue, negative outside, and the direction that leads deeper. Exact in the tissue; in the
  /// void as far as one pose reaches, and beyond kFarMm any value.
  static constexpr double kFarMm = 0.12;
  double depth_mm(Vec3 place, Vec3& inwards) const;
  /// Largest depth of the skin.
  double deepest_mm(Vec3 pivot, Vec3 axis) const;

  /// The pivot nearest to `device`, downhill from `from`, at which no skin is deeper than thinner_mm. nullopt if the search
  /// ends, after 0.1 mm at most, on a pose that is not admissible.
  std::optional<Vec3> proxy_from(Vec3 from, Vec3 axis, Vec3 device, double thinner_mm) const;

 private:
  /// Of a tree: every pose of its sweeps is the head at `centre` with the first sweep's axis, moved by radius at most.
  struct Node {
    Vec3 centre{0.0};
    double radius = 0.0;
    std::int32_t first = 0, count = 0;  // sweeps; of a leaf alone
    std::int32_t left = -1, right = -1;
  };
  std::int32_t build(std::int32_t first, std::int32_t count);
  double head_mm(Vec3 place, Vec3 pivot, Vec3 axis, Vec3& outwards) const;
  double passing_mm(Vec3 place, const HeadSweep& sweep, double enough, Vec3& outwards) const;
  void nearest(std::int32_t node, Vec3 place, double& least, Vec3& outwards) const;

  Bur bur_;
  HeadCurve curve_;
  std::vector<HeadSweep> sweeps_;
  Frame face_;
  Vec3 axis_{0.0};  // of the first sweep
  std::vector<Node> nodes_;
};

}  // namespace cusp::bench
