/// The exact proxy of a ball bur on one shape: the local minimum of the distance to the device point over admissible
/// centres, reached by moving the device point straight from its last place, in closed form. Specimen frame, mm.
#pragma once

#include "engine/base/vec.h"

namespace cusp::bench {

struct Exact {
  Vec3 pose_mm{0.0};
  bool contact = false;   // the proxy is not at the device point
  bool vanished = false;  // in this tick the minimum that held the proxy ceased to be, and it went to another
};

class Truth {
 public:
  static constexpr int kSubSteps = 64;  // of the device's move in a tick

  virtual ~Truth() = default;

  /// Signed clearance of the bur's ball: distance from its surface to the tissue, negative inside. Cuts are met with
  /// the surface proxy's own clearance (SurfaceContact::kClearanceMm) where the shape has any.
  virtual double clearance_mm(Vec3 centre) const = 0;

  /// Device point and proxy at an admissible centre.
  virtual void start(Vec3 centre) {
    device_ = centre;
    exact_ = {place(centre), false, false};
  }
  /// The device point has moved straight from where it was.
  virtual Exact follow(Vec3 device) {
    Exact out;
    const Vec3 from = device_;
    for (int k = 1; k <= kSubSteps; ++k) {
      const Exact now = move_to(from + (device - from) * (static_cast<double>(k) / kSubSteps));
      out.pose_mm = now.pose_mm;
      out.contact = now.contact;
      out.vanished = out.vanished || now.vanished;
    }
    device_ = device;
    exact_ = out;
    return out;
  }
  const Exact& exact() const { return exact_; }

 protected:
  /// Forgets the past: the nearest admissible centre, which is where the proxy stands from now on.
  virtual Vec3 place(Vec3 centre) = 0;
  void keep(const Exact& exact) { exact_ = exact; }
  /// One sub-step.
  virtual Exact move_to(Vec3 device) = 0;

 private:
  Vec3 device_{0.0};
  Exact exact_;
};

}  // namespace cusp::bench
