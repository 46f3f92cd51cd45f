/// ConvexContact: a body of revolution against convex tissue, exactly. The pivots at which they overlap form a convex
/// set. Every unit normal n of the tissue gives a supporting plane of that set, and depth_mm(n) is the device's depth
/// below it. A proxy is a local minimum of depth_mm over the normals. Frame: specimen. Unit: mm. Thread: any but the
/// haptic one.
#pragma once

#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "tests/bench/frame.h"
#include "tests/bench/head_curve.h"

namespace cusp::bench {

/// face: z <= 0 of the frame; edge: y and z <= 0; corner: x, y and z <= 0; sphere: about the frame's origin.
enum class ConvexKind : std::uint8_t { face, sphere, edge, corner };

struct ConvexTissue {
  ConvexKind kind = ConvexKind::face;
  Frame frame = oblique_frame();
  double radius_mm = 0.0;  // of a sphere

  double distance_mm(Vec3 p) const;  // signed, negative inside
  /// The unit vector of the tissue's normals that is nearest to n, for n close to one of them.
  Vec3 normal_near(Vec3 n) const;
  /// Normals all over the tissue, from which local searches start; of a sphere the one towards `place`.
  std::vector<Vec3> normals(Vec3 place) const;
};

class ConvexContact {
 public:
  ConvexContact(const ConvexTissue& tissue, const HeadCurve& body, Vec3 axis)
      : tissue_(tissue), body_(body), axis_(axis) {}
  void turn_to(Vec3 axis) { axis_ = axis; }

  /// Depth of the body at `pivot` below the tissue's supporting plane with the normal n.
  double depth_mm(Vec3 n, Vec3 pivot) const;
  /// Unit normal from the nearest point of the tissue to the body. Pre: the body at `pivot` is clear of the tissue.
  Vec3 separating(Vec3 pivot) const;
  /// The local minimum of depth_mm over the normals, downhill from n, until a step is below `precision` radians.
  /// Proximal point algorithm: each step projects the device, lifted kProximalMm above n's plane, onto the convex set.
  Vec3 settle(Vec3 n, Vec3 device, double precision) const;
  /// Signed distance from the body at `pivot` to the tissue. near: a normal close to the contact's.
  double clearance_mm(Vec3 pivot, Vec3 near) const;
  /// The pivot on the ray from inside the tissue at which the body is `clearance` away. Pre: clearance > 0.
  Vec3 on_ray(Vec3 from, Vec3 towards, double clearance) const;

 private:
  static constexpr double kProximalMm = 0.1;
  Vec3 from_point(Vec3 point, Vec3 pivot) const;
  Vec3 best_on_arc(Vec3 first, Vec3 second, Vec3 pivot) const;

  ConvexTissue tissue_;
  HeadCurve body_;
  Vec3 axis_;
};

}  // namespace cusp::bench
