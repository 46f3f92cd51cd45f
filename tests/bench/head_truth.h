/// HeadTruth is the exact proxy of a bur's head whose axis the device turns: in each sub-step the local minimum of the
/// distance to the device point over admissible pivots, followed from the last one. Device and axis move evenly within
/// a tick. Frame: specimen. Unit: mm. Thread: any but the haptic one.
#pragma once

#include "engine/tool/bur.h"
#include "tests/bench/convex_contact.h"
#include "tests/bench/truth.h"

namespace cusp::bench {

class HeadTruth {
 public:
  virtual ~HeadTruth() = default;
  /// Sets device point and proxy. Pre: the head is clear of tissue.
  void start(Vec3 pivot, Vec3 axis);
  Exact follow(Vec3 device, Vec3 axis);
  /// Signed distance from the head at `pivot` with the last axis to the tissue.
  virtual double clearance_mm(Vec3 pivot) const = 0;
  /// False if neck or shank at the proxy come within kShankMm of tissue, for the truth knows the head alone; or if the
  /// head with its axis fits nowhere near the proxy.
  virtual bool is_valid() const = 0;
  static constexpr double kShankMm = 0.01;

 protected:
  static constexpr int kTurnSubSteps = 8;
  static constexpr double kCoarse = 1e-6, kFine = 1e-11;  // radians or mm: of a sub-step, and of a tick's end
  virtual void turn_to(Vec3 axis) = 0;
  virtual Vec3 place(Vec3 pivot) = 0;
  virtual Exact move_to(Vec3 device, double precision) = 0;
  const Exact& exact() const { return exact_; }

 private:
  Vec3 device_{0.0}, axis_{0.0};
  Exact exact_;
};

/// On a convex tissue.
class ConvexTruth : public HeadTruth {
 public:
  ConvexTruth(const ConvexTissue& tissue, const Bur& bur);
  double clearance_mm(Vec3 pivot) const override { return head_.clearance_mm(pivot, normal_); }
  bool is_valid() const override;

 private:
  void turn_to(Vec3 axis) override;
  Vec3 place(Vec3 pivot) override;
  Exact move_to(Vec3 device, double precision) override;
  bool is_clear(const ConvexContact& part) const;

  ConvexContact head_, neck_, shank_;
  Vec3 normal_{0.0};  // of the proxy's contact
};

}  // namespace cusp::bench
