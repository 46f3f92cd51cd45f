/// Courses of a head over a tissue: device points 0.3 mm below the offset surface, while the device turns the axis.
/// Frame: specimen. Unit: mm. Thread: any but the haptic one.
#pragma once

#include <memory>
#include <string_view>

#include "engine/step/step.h"
#include "tests/bench/head_slot.h"
#include "tests/bench/head_truth.h"
#include "tests/bench/motions.h"
#include "tests/random.h"

namespace cusp::bench {

using test::Random;

inline constexpr std::array<std::string_view, 5> kHeadShapes = {"face", "sphere", "edge", "corner", "slot"};
inline constexpr std::array<std::string_view, 3> kAxisMotions = {"fixed", "turning", "jitter"};

inline constexpr double kConeDeg = 30.0;      // of the axis about the tissue's z
inline constexpr double kSlotConeDeg = 10.0;  // along the slot, about the milling axis
inline constexpr double kTurnDegS = 60.0;
inline constexpr double kJitterDeg = 0.1;

/// The axis, tick by tick. fixed: a seeded tilt. turning: swings through the rest axis to the cone's rim and back, each
/// time in another seeded direction. jitter: a seeded tilt, each tick up to kJitterDeg off.
class AxisMotion {
 public:
  enum class Span : std::uint8_t { cone, slot };
  /// rest.z: the rest axis. slot: fixed and jitter do not tilt, turning swings towards rest.x and back.
  AxisMotion(std::string_view kind, const Frame& rest, Span span, std::uint64_t seed);
  Vec3 now() const { return axis_; }
  Vec3 next();

 private:
  Vec3 tilted(double angle_deg) const;
  std::string_view kind_;
  Frame rest_;
  Span span_;
  Random random_;
  Vec3 side_{0.0};  // unit, across the rest axis: where the axis tilts to
  Vec3 base_{0.0}, axis_{0.0};
  double angle_deg_ = 0.0, step_deg_ = 0.0;
};

/// The shortest turn from `rest` to `axis`, quantised as a device's sample is. Axis: of the quantised input.
StepInput turned_input(Vec3 device_mm, Vec3 rest, Vec3 axis);
Vec3 axis_of_input(const StepInput& input, Vec3 rest);

/// One run of a bur over a tissue.
class HeadCourse {
 public:
  virtual ~HeadCourse() = default;
  virtual Vec3 rest_axis() const = 0;
  virtual std::shared_ptr<const Specimen> specimen(double voxel_mm) const = 0;
  virtual std::unique_ptr<HeadTruth> truth() const = 0;
  virtual AxisMotion axis_motion(std::string_view kind, std::uint64_t seed) const = 0;
  /// Mills what the course needs. False: the volume has no room.
  virtual bool prepare(StepState&) const { return true; }
  /// Free pivots from outside to the place from which a straight line leads into the first device point.
  virtual std::vector<Vec3> way_in(Vec3 axis) const = 0;
  /// The first device point, then one a tick; per_tick_mm apart but for what the axis turns.
  virtual Vec3 next(Vec3 axis, double per_tick_mm) = 0;
  /// A touching pivot to press at and the outward normal there; slots have none.
  virtual Spot spot(Vec3, Random&) const { return {}; }
};

std::unique_ptr<HeadCourse> make_course(std::string_view shape, const Bur& bur, std::uint64_t seed);

}  // namespace cusp::bench
