/// CarvedBlock is a half space minus capsules, exactly. Its faces are the plane and the inner sides of the capsules.
/// Its edges are traced to points 5 um apart; a parabola through three of them errs by 2 nm. All edges are convex,
/// because each face bounds a convex void. Frame: specimen. Unit: mm.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"
#include "tests/bench/frame.h"
#include "tests/bench/half_spaces.h"

namespace cusp::bench {

struct Capsule {
  Vec3 a{0.0}, b{0.0};
  double radius_mm = 0.0;
};

class CarvedBlock {
 public:
  /// Tissue: normal . p <= level. Pre: no two capsules coincide along a stretch. A ball of radius_mm meets the plane.
  /// A ball thinner by thinner_mm meets the cut faces and all edges.
  CarvedBlock(Vec3 normal, double level, std::vector<Capsule> capsules, double radius_mm, double thinner_mm);

  /// Distance from the ball's surface to the tissue, negative inside.
  double clearance_mm(Vec3 centre) const;
  /// True if the nearest feature is an edge.
  bool edge_nearest(Vec3 centre) const;

  /// The local minimum of |c - q| over admissible centres, downhill from the admissible centre `from`, to precision_mm.
  /// Each Newton step solves over half spaces with their curvature and moves by at most 4 um.
  Vec3 settle(Vec3 from, Vec3 q, double precision_mm);

  const std::vector<Capsule>& capsules() const { return capsules_; }

 private:
  struct EdgePoint {
    Vec3 at{0.0};
    int before = -1, after = -1;  // along the edge; -1 at its end
  };
  struct Nearest {
    double clearance = 0.0;
    bool edge = false;
  };
  Nearest nearest(Vec3 centre) const;
  double void_depth(int face, Vec3 p, Vec3* gradient) const;  // plane -1; positive in the void
  bool remains(Vec3 p, int face_a, int face_b) const;      // no other face has removed this point
  bool project_onto(int face_a, int face_b, Vec3& p) const;       // Newton to both faces
  void trace_pair(int face_a, int face_b);
  void trace(int face_a, int face_b, Vec3 seed);
  enum class Curve : std::uint8_t { open, closed };
  void store_edge(const std::vector<Vec3>& points, Curve curve);
  Vec3 refined(int edge_point, Vec3 centre) const;
  void gather(Vec3 y);
  /// turning: the half space's normal turns about a point that stays; fixed: neighbouring points give the curvature.
  enum class Normal : std::uint8_t { fixed, turning };
  struct Contact {
    Vec3 at{0.0};
    double radius = 0.0;
    Normal normal = Normal::fixed;
  };
  bool add_point(const Contact& contact, Vec3 y, std::vector<HalfSpace>& out) const;
  void add_face(int face, Vec3 y, std::vector<HalfSpace>& out) const;
  void add_fitting_capsule(int face, Vec3 y, std::vector<HalfSpace>& out) const;
  void add_edge(int point, Vec3 y, std::vector<HalfSpace>& out) const;
  void constraints(Vec3 y, std::vector<HalfSpace>& out) const;

  Vec3 normal_;
  double level_;
  std::vector<Capsule> capsules_;
  std::vector<Frame> frames_;  // of the capsules: z along them
  double radius_, cut_radius_;
  std::vector<EdgePoint> edges_;
  std::vector<int> near_;  // edge points about near_centre_
  Vec3 near_centre_{1e9};
  std::vector<HalfSpace> spaces_;
  Mat3 bend_{0.0};  // of the active constraints of the last pose
};

}  // namespace cusp::bench
