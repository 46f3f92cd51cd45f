/// Gradient proxy: a god-object on the implicit surface s = 1/2 (Salisbury and Tarr 1997), what users of the usual
/// libraries get. The field is plain trilinear, its normal a central difference over a voxel. The bur's ball is an
/// offset: its foot is x = y - r n(x), iterated from the last one; of another head the foot is its place furthest against
/// n(x). One tangent plane at a time: the deepest of the foot
/// that is followed and of what a coarse scan of the bur's skin finds (the ball's best direction, made a foot; neck
/// and shank by their points), scanned again after every half voxel of way. Each pass puts the proxy on the device
/// point's projection onto that plane, at most a voxel from where it was, so that no wall of two voxels is jumped. Its
/// limits: where two walls hold the bur it knows one of them, so corners and grooves are entered by the depth to which
/// the device point is pushed, first into one wall, then into the other; a foot on an edge sharper than a third of the
/// bur, or in a hole as wide as it, is not found by the iteration. In a hollow that leaves the bur less room than it
/// is pushed deep the projections swing; they are damped by halves. Thread: haptic; wait-free; memory at construction.
#pragma once

#include <vector>

#include "engine/contact/methods/banded_contact.h"
#include "engine/contact/methods/point_shell.h"
#include "engine/contact/methods/tissue_box.h"
#include "engine/contact/methods/trilinear_field.h"
#include "engine/scene/scene.h"

namespace cusp::engine {

class GradientProxy {
 public:
  GradientProxy(const Scene& scene, const Volume& volume);

  /// kept: from the pivot to the point of the bur that was followed last; zero: none. Part of the step's state.
  BandedContact solve(const Volume& volume, const Scene& scene, std::size_t bur, Vec3 from, Vec3 device,
                      Vec3& kept) noexcept;
  bool fits(const Volume& volume, std::size_t bur, Vec3 pose) noexcept;

  /// In the bur's own hole the proxy shivers by up to some 20 um: the cut pose follows none of it (a cut pose that did
  /// drilled 6 to 45 % too fast), but is dragged when the proxy is further off than half a voxel.
  static constexpr bool kFollowsSideways = false;
  static double tie_mm(double /*radius_mm*/, double voxel_mm) noexcept { return 0.5 * voxel_mm; }

 private:
  struct Foot {
    bool known = false;
    bool shank = false;
    Vec3 offset{0.0};     // from the pivot
    Vec3 n{0.0};          // out of the tissue
    double gap_mm = 0.0;  // between bur and tissue; negative: overlap
  };
  struct Scan {
    Vec3 offset{0.0};
    double gap_mm = 0.0;
  };
  Scan scan(const TrilinearField& field, std::size_t bur, Vec3 y) const noexcept;
  Foot foot(const TrilinearField& field, const Bur& bur, Vec3 y, Vec3 offset) const noexcept;

  std::vector<PointShell> shells_;  // one for each bur of the scene
  Vec3 axis_;
  TissueBox box_;
};

}  // namespace cusp::engine
