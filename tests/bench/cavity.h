/// The verb `cavity`: a ball of 0.4 mm mills a cavity of 4.8 x 1.9 x 1.8 mm in layers, as a trembling hand does, and balls
/// explore it. Each tick is compared with the exact proxy in the recorded path's union. Its depth is reached after 54 s.
/// Motions: slide and press explore with the button up. cutting compares ticks of the milling itself: the exact proxy stands
/// in the union of all sweeps, this tick's included, at the minimum downhill from the newest swept pose.
/// The task `mill` times the cutting ticks of every method on the same device points (mill.h).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tests/bench/lanes.h"
#include "tests/bench/motions.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/swept_surface.h"
#include "tests/random.h"

namespace cusp::bench {

using test::Random;

inline constexpr double kMillRadiusMm = 0.4, kMillSpeedMmS = 5.0;
inline constexpr double kCavityVoxelMm = 10.0 / 128;

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
  /// sweeps() and the truths expect kMillRadiusMm; mill.h times other balls.
  Cavity(Method method, const MillHand& hand, double mill_radius_mm = kMillRadiusMm);
  /// Mills on until `minutes` have passed in all. each(seconds): thread CPU time of every tick.
  template <class Each>
  void mill_until(double minutes, Each&& each) {
    while (static_cast<double>(ticks_) < minutes * 60e3) each(mill_tick());
  }
  double mill_tick();
  /// Back to where the milling stopped, from wherever a bur has explored.
  void resume();

  StepState& state() { return state_; }
  /// What the bur has swept so far.
  const std::vector<Sweep>& sweeps() const { return sweeps_; }
  /// Place of an exploring bur in the scene: 0.25, 0.4 or 0.5 mm. Throws std::invalid_argument for another radius.
  static std::uint16_t bur_of(double radius_mm);

 private:
  void record();
  StepState state_;
  MillMotion motion_;
  Vec3 device_{0.0};  // of the last tick of milling
  std::int64_t ticks_ = 0;
  std::vector<Sweep> sweeps_;
};

/// A block whose flat face is the plane z = 0 of oblique_frame(). Its burs: the exploring ones, then the mill.
std::shared_ptr<Scene> cavity_scene(Method method, double mill_radius_mm = kMillRadiusMm);

/// lead() with a bur of the scene.
void lead_bur(StepState& state, std::uint16_t bur, Vec3 to_mm, double per_tick_mm);
/// Out of the cavity with the bur at hand, over its middle and down into it with another: free all the way.
void enter_cavity(StepState& state, std::uint16_t bur);

/// The surface below the mouth that the sweeps have left.
std::shared_ptr<const SweptSurface> cavity_surface(const std::vector<Sweep>& sweeps);
/// The same within reach_mm of a place.
std::shared_ptr<const SweptSurface> cavity_surface_about(const std::vector<Sweep>& sweeps, Vec3 place, double reach_mm);

/// Device points of a slide over floor and walls, kDepthMm below the offset surface of a box without tremor; one a tick.
std::vector<Vec3> exploring_points(double radius_mm, double speed_mm_s, std::uint64_t seed, int ticks);

std::vector<Row> cavity_rows(const Options& options);
int run_cavity(const Options& options);

}  // namespace cusp::bench
