/// A haptic device between two samples of the loop: a mass with damping and Coulomb friction, alike in all directions.
/// A grip holds it, and the motors' force moves it. Linear parts are integrated exactly, friction in slices of 50 us
/// with stiction: a load below the friction does not creep. Units: millimetres, newtons, seconds; N mm is mJ. Same
/// numbers for the same calls on one build. No heap after the constructor. Thread: any, one at a time.
#pragma once

#include <array>
#include <cstdint>

#include "engine/base/vec.h"
#include "engine/lab/grip.h"

namespace cusp::engine::lab {

inline constexpr int kSliceUs = 50;        // the laboratory's grain of time
inline constexpr int kSlicesPerTick = 20;  // 1 kHz
inline constexpr double kTickS = 0.001;

/// The caller sweeps figures that no device's source gives [M].
struct DeviceSettings {
  double mass_kg = 0.1;            // that the hand moves with the grip of the device, (0, 10]
  double damping_ns_per_m = 2.0;   // viscous, >= 0
  double friction_n = 0.0;         // Coulomb, of the whole vector, >= 0
  double encoder_step_mm = 0.05;   // 0: exact
  double force_quantum_n = 0.002;  // of each axis; 0: exact
  double limit_n = 8.9;            // most force of the motors, of the whole vector
  Vec3 weight_n{0.0};              // of the grip, where nothing compensates it
};

/// What no source gives of a device: the caller sweeps it [M].
struct MovingMass {
  double mass_kg = 0.1;           // (0, 10]
  double damping_ns_per_m = 2.0;  // viscous, >= 0
  double friction_n = 0.0;        // Coulomb, >= 0
};

/// Novint Falcon, at the middle of its workspace (0.125 m), in the worst direction: encoder 0.049 mm, force
/// quantum 16.2 N / 4095, limit 6.1 N. All are computed from the published mechanism and constants.
DeviceSettings falcon(const MovingMass& moving) noexcept;

class Plant {
 public:
  Plant(const DeviceSettings& device, const Grip& grip, Vec3 start_mm);

  Vec3 position_mm() const noexcept { return x_; }
  Vec3 velocity_mm_s() const noexcept { return v_; }
  double kinetic_mj() const noexcept;
  /// True while friction holds it.
  bool sticks() const noexcept { return sticks_; }
  double mass_kg() const noexcept { return mass_kg_; }  // with the hand's

  /// The hand's intended place and its velocity until the next call. Without a grip it has no effect.
  void intend(Vec3 at_mm, Vec3 velocity_mm_s) noexcept;
  Vec3 intended_mm() const noexcept { return intended_; }
  /// A constant push besides: of a finger, a weight.
  void push(Vec3 force_n) noexcept { push_ = force_n; }
  /// Moves at this velocity, whatever the forces, until release().
  void drive(Vec3 velocity_mm_s) noexcept;
  void release() noexcept { driven_ = false; }
  bool driven() const noexcept { return driven_; }
  /// Blocks motion along two directions (unit, at right angles to each other). A zero vector blocks nothing.
  void rail(Vec3 first, Vec3 second) noexcept;
  void place(Vec3 at_mm, Vec3 velocity_mm_s) noexcept;

  /// Advances by slices of kSliceUs under a constant force of the motors. 0 < slices <= kSlicesPerTick.
  void advance(Vec3 force_n, int slices) noexcept;
  /// Work that friction took since the start, mJ.
  double friction_mj() const noexcept { return friction_mj_; }

 private:
  /// x, v after a time, from x, v, a force and the rate at which it grows.
  struct Flow {
    double xx = 0, xv = 0, xf = 0, xg = 0, vx = 0, vv = 0, vf = 0, vg = 0;
  };
  void flow(const Flow& by, Vec3 force_n, Vec3 rate, double seconds) noexcept;
  void slice(Vec3 force_n, Vec3 rate) noexcept;
  Vec3 allowed(Vec3 v) const noexcept { return v - rail_a_ * glm::dot(v, rail_a_) - rail_b_ * glm::dot(v, rail_b_); }

  std::array<Flow, kSlicesPerTick + 1> flows_{};  // by slices
  double mass_kg_, grip_n_per_mm_, grip_ns_per_mm_, friction_n_;
  Vec3 weight_;
  Vec3 x_{0.0}, v_{0.0}, intended_{0.0}, intended_v_{0.0}, push_{0.0}, rail_a_{0.0}, rail_b_{0.0};
  bool driven_ = false, sticks_ = false;
  double friction_mj_ = 0.0;
};

}  // namespace cusp::engine::lab
