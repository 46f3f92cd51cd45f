/// The verb `cavity`: a ball of 0.4 mm mills a cavity of 4.8 x 1.9 x 1.8 mm in layers, as a trembling hand does, and balls
/// explore it. Each tick is compared with the exact proxy in the recorded path's union.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tests/bench/lanes.h"
#include "tests/bench/motions.h"
#include "tests/bench/options.h"
#include "tests/bench/random.h"
#include "tests/bench/rows.h"
#include "tests/bench/swept_surface.h"

namespace cusp::bench {

inline constexpr double kMillRadiusMm = 0.4, kMillSpeedMmS = 5.0;

/// The hand and the sensor of a cavity.
struct MillHand {
  double tremor_mm = 0.05;   // rms of the vector, 8 to 12 Hz
  double encoder_mm = 0.0;   // step of the device's reading; 0: 0.1 um
  std::uint64_t seed = 1;
};

/// Device points that mill the cavity: layers from the mouth to the floor, then rows over the floor and rounds along the
/// walls without end. Frame: specimen.
class MillMotion {
 public:
  explicit MillMotion(const MillHand& hand);
  /// The next tick's, of 1 ms.
  Vec3 next();

 private:
  void plan_pass();
  void plan_rows(double z_mm, int lane_axis, double shift_mm);
  void plan_round(double z_mm);
  Vec3 trembling(Vec3 at) const;

  MillHand hand_;
  Random random_;
  struct Wave {
    double hz = 0.0, phase = 0.0;
  };
  static constexpr int kWaves = 3;
  Wave wave_[3][kWaves];
  std::vector<Vec3> corners_;  // of the pass at hand, in the frame's own axes
  std::size_t corner_ = 0;
  double along_mm_ = 0.0;
  int pass_ = 0;
  std::int64_t tick_ = 0;
};

/// A cavity being milled by one method.
class Cavity {
 public:
  Cavity(Method method, const MillHand& hand);
  /// Mills on until `minutes` have passed in all. each(seconds): thread CPU time of every tick.
  template <class Each>
  void mill_until(double minutes, Each&& each) {
    while (static_cast<double>(ticks_) < minutes * 60e3) each(mill_tick());
  }
  double mill_tick();

  StepState& state() { return state_; }
  /// What the bur has swept so far.
  const std::vector<Sweep>& sweeps() const { return sweeps_; }
  /// Exploring burs of the scene: 0.25, 0.4 and 0.5 mm; its index is their place.
  static std::uint16_t bur_of(double radius_mm);

 private:
  void record();
  StepState state_;
  MillMotion motion_;
  std::int64_t ticks_ = 0;
  bool recording_ = false;
  std::vector<Sweep> sweeps_;
};

/// A block whose flat face is the plane z = 0 of oblique_frame().
std::shared_ptr<Scene> cavity_scene(Method method);

/// The surface below the mouth that the sweeps have left.
std::shared_ptr<const SweptSurface> cavity_surface(const std::vector<Sweep>& sweeps);

/// Device points of a slide over floor and walls, kDepthMm below the offset surface of a box without tremor; one a tick.
std::vector<Vec3> exploring_points(double radius_mm, double speed_mm_s, std::uint64_t seed, int ticks);

std::vector<Row> cavity_rows(const Options& options);
int run_cavity(const Options& options);

}  // namespace cusp::bench
