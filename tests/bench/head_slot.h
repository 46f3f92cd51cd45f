/// A slot in a face that a head has milled sideways with a fixed axis, and the exact proxy of the same head in it with
/// any axis. Away from its ends the slot is a prism, so the problem lies in its cross-section. The head below the face
/// stays inside the milled head's outline, and the slot's two upper edges stay outside the head. Frame: specimen. Unit:
/// mm.
#pragma once

#include <array>
#include <vector>

#include "engine/step/step.h"
#include "tests/bench/half_spaces.h"
#include "tests/bench/head_truth.h"

namespace cusp::bench {

struct HeadSlot {
  Frame frame = oblique_frame();      // z out of the face, which passes through the origin; x along the slot
  Vec3 axis{0.0};                     // of the milling bur
  Vec3 pivot{0.0};                    // in the middle of the milled line
  double from_mm = 0.0, to_mm = 0.0;  // of the pivot along the line, from the middle
  double entry_mm = 0.0;              // length of the shaft along the axis at from_mm

  Vec3 at(double along_mm) const { return pivot + frame.x * along_mm; }
  Vec3 above() const { return at(from_mm) + axis * entry_mm; }
};

/// As deep as 0.55 of the head, 0.8 mm at most; 5 mm long.
HeadSlot slot_of(const Bur& bur, Vec3 axis);
/// Mills shaft and slot in a fresh state. False: the volume has no room.
bool mill(StepState& state, const HeadSlot& slot);

class SlotTruth : public HeadTruth {
 public:
  /// thinner_mm: the head's clearance against cuts.
  SlotTruth(const HeadSlot& slot, const Bur& bur, double thinner_mm);
  double clearance_mm(Vec3 pivot) const override;
  bool is_valid() const override { return fits_; }
  /// Largest angle from the downward direction to a wall's normal, on both sides of the slot, radians.
  double least_steepness() const { return steepness_; }

 private:
  struct Wall {
    Vec3 n{0.0};         // out of the slot
    double level = 0.0;  // the thin head satisfies n . (pivot + furthest point) <= level
    Vec3 furthest{0.0};  // of the head with its present axis
  };
  static constexpr double kFitsMm = 1e-6;  // largest violation of a pose that counts as admissible

  Vec3 across(double angle, double side) const;
  void add_side(double side);
  double kink_of(double normal_angle, double side, double root) const;
  void turn_to(Vec3 axis) override;
  Vec3 place(Vec3 pivot) override;
  Exact move_to(Vec3 device, double precision) override;
  bool below_face(const Wall& wall, Vec3 pivot) const;
  HalfSpace edge_space(Vec3 edge, Vec3 pivot, double& gap) const;
  void constraints(Vec3 pivot);

  HeadSlot slot_;
  HeadCurve head_;
  double thinner_;
  Vec3 axis_{0.0};
  Vec3 proxy_{0.0};
  std::vector<Wall> walls_;
  std::array<Vec3, 2> edges_{};
  double steepness_ = 1e9;
  bool fits_ = true, turned_ = false;
  std::vector<HalfSpace> spaces_;
};

}  // namespace cusp::bench
