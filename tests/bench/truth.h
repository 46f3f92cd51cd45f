/// The exact proxy of a ball bur on one shape: the local minimum of the distance to the device point over admissible
/// centres, reached by moving the device point straight from its last place, in closed form. Specimen frame, mm.
#pragma once

#include "engine/base/vec.h"

namespace cusp::bench {

struct Exact {
  Vec3 pose_mm{0.0};
  bool contact = false;   // the proxy differs from the device point
  bool vanished = false;  // in this tick the proxy's minimum vanished and it moved to another
};

class Truth {
 public:
  static constexpr int kSubSteps = 64;  // of the device's move in a tick

  virtual ~Truth() = default;

  /// Distance from the surface of the ball to the tissue, negative inside. Cut shapes include the surface proxy's own
  /// clearance, SurfaceContact::kClearanceMm, so that the method is compared and not its clearance.
  virtual double clearance_mm(Vec3 centre) const = 0;

  /// Sets device point and proxy. Pre: centre is admissible.
  virtual void start(Vec3 centre) {
    device_ = centre;
    exact_ = {place(centre), false, false};
  }
  /// Moves the device point straight to `device`, in kSubSteps.
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
  /// Sets the proxy to the nearest admissible centre, without memory.
  virtual Vec3 place(Vec3 centre) = 0;
  void keep(const Exact& exact) { exact_ = exact; }
  /// One sub-step.
  virtual Exact move_to(Vec3 device) = 0;

 private:
  Vec3 device_{0.0};
  Exact exact_;
};

/// Of a shape that gives clearance_mm(centre) and proxy(device) in closed form, without memory.
template <class S>
class OneSheet : public Truth {
 public:
  explicit OneSheet(const S& shape) : shape_(shape) {}
  double clearance_mm(Vec3 centre) const override { return shape_.clearance_mm(centre); }

 protected:
  Vec3 place(Vec3 centre) override { return shape_.proxy(centre); }
  Exact move_to(Vec3 device) override {
    const Vec3 pose = shape_.proxy(device);
    return {pose, pose != device, false};
  }

 private:
  const S& shape_;
};

}  // namespace cusp::bench
