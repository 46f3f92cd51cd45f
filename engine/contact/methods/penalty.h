/// Penalty: a shell of points on the bur against the voxels' distance field, no proxy (McNeely, Puterbaugh and Troy
/// 1999, "Voxmap PointShell"; Barbic and James 2008, whose distance field and inward point normals it has). Every point
/// that lies in tissue pushes back along its own normal, by its depth. Made comparable to K times a depth: the sum of
/// the pushes, each with its share of the sphere, is measured against what a plane pressed to a depth gives (a ball: in
/// closed form; another head: by its own shell against the plane across the sum; the band's clamp included), and the force is K times the depth at which a plane would give the same
/// sum, along the sum. So a plane gives K d, whatever the bur and the shell; other shapes give what the sum makes of
/// them, of a ball: two walls at a right angle 2^(1/4) d instead of 2^(1/2) d, a hole as wide as the bur sqrt(2 r d / 3). Neck
/// and shank push by their deepest point along the mean of theirs. K is the mean over the points, weighted by their
/// push. The reported pose is device point + F / K. It remembers nothing: beyond the band or a thin wall's middle the
/// bur falls through, as with every penalty. Thread: haptic; wait-free; memory at construction.
#pragma once

#include <vector>

#include "engine/contact/methods/banded_contact.h"
#include "engine/contact/methods/point_shell.h"
#include "engine/contact/methods/tissue_box.h"
#include "engine/scene/scene.h"

namespace cusp::engine {

class Penalty {
 public:
  Penalty(const Scene& scene, const Volume& volume);

  BandedContact solve(const Volume& volume, const Scene& scene, std::size_t bur, Vec3 from, Vec3 device,
                      Vec3& kept) noexcept;
  /// A penalty starts anywhere: it has no proxy that could be on the wrong side.
  bool fits(const Volume&, std::size_t, Vec3) noexcept { return true; }

  /// The cut pose follows the reported pose sideways alone: pressed harder, a sum of pushes says another pose although
  /// the bur has not moved.
  static constexpr bool kFollowsSideways = true;
  /// The most by which the reported pose is off in the bur's own hole, sqrt(2 r d / 3) - d, is r / 6; half a voxel
  /// more.
  static double tie_mm(double radius_mm, double voxel_mm) noexcept { return radius_mm / 6.0 + 0.5 * voxel_mm; }

 private:
  struct Shell {
    PointShell points;
    double radius_mm = 0.0;
    double deepest_mm = 0.0;  // the plane's response rises up to here
    double most = 0.0;        // and is this there
  };
  double response(const Shell& shell, double depth_mm) const noexcept;
  double response(const Shell& shell, Vec3 normal, double lowest_mm, double depth_mm) const noexcept;
  double depth_of(const Shell& shell, double sum_mm) const noexcept;
  double depth_of(const Shell& shell, Vec3 normal, double sum_mm) const noexcept;

  std::vector<Shell> shells_;  // one for each bur of the scene
  TissueBox box_;
  double band_mm_;
};

}  // namespace cusp::engine
