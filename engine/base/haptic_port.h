/// The seam between the haptic loop and any device: real, emulated, scripted or a mouse. Neither side knows the other.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace cusp {

/// What a device can do; stands in the session's header, so that a replay has it.
struct DeviceLimits {
  std::string name;                  // "Mouse and keys", "Novint Falcon", as stored with the grade
  std::string device_class;          // "pointer", "falcon", "inverse3", "scripted": never mixed in statistics
  int position_axes = 3;             // axes it senses
  int rotation_axes = 0;             // axes of orientation it senses
  double max_force_n = 8.9;          // most force the guard may ask of it, per vector
  double max_stiffness_n_per_mm = 3.0;  // the device's own most, declared or calibrated; engine/step/stiffness_rule.h
  bool has_own_clock = false;        // true: wait() returns when the device delivers, not at the deadline
  // The closed loop: with a mass behind the device point that the force moves, a stiffness may be too much.
  bool closed_loop = true;           // false: the hand gives force and not depth (a mouse), or nobody holds it (a script)
  std::optional<double> damping_ns_per_m;  // viscous, of the device alone; unknown until calibrated
  std::optional<double> delay_ms;    // from the hand's motion to the force that answers it, there and back; likewise
  std::optional<double> encoder_mm;  // step of the reading
  std::optional<double> softest_grip_ns_per_m;  // damping of the softest grip that holds it; unknown: the laboratory's
};

/// One reading of the device, already in the specimen frame. A port says `late` whenever the device has delivered nothing
/// since the sample before, whether or not the position is the same: a device that froze shows by that alone.
struct Sample {
  enum class Status : std::uint8_t { fresh, late, gone };
  Status status = Status::gone;
  Vec3 position_mm{0.0};
  Quat orientation{1.0, 0.0, 0.0, 0.0};
  std::uint16_t buttons = 0;  // bit 0: cut
  std::uint16_t pedal = 0;    // 0 released to 65535 fully down
  std::uint16_t bur = 0;     // index of the scene's bur asked for
};

/// What the step answers: the force for the hand, and where the proxy stands, for devices whose hand gives force
/// and not depth (a mouse).
struct Feedback {
  Vec3 force_n{0.0};                  // after the guard
  Vec3 proxy_mm{0.0};                 // pivot of the bur that does not penetrate
  double stiffness_n_per_mm = 1.0;    // of what is touched, or of the softest tissue when nothing is
  Vec3 normal{0.0, 0.0, 1.0};         // direction of the contact force; last one when nothing is touched
  bool in_contact = false;
  bool faulted = false;               // the guard has latched; force is zero until re-armed
};

enum class PortError : std::uint8_t { not_found, no_permission, busy, bad_file, io };
using PortFailure = Failure<PortError>;

class HapticPort {
 public:
  virtual ~HapticPort() = default;
  /// Not on the haptic thread. After success, wait() and write() may be called from one thread.
  virtual Result<void, PortFailure> open() = 0;
  /// Haptic thread. The newest complete sample; `late` repeats the last one, `gone` means the device is lost.
  /// Returns by `deadline`; a port without a clock of its own sleeps until then.
  virtual Sample wait(std::chrono::steady_clock::time_point deadline) noexcept = 0;
  /// Haptic thread. Hands over the force of this tick; never waits.
  virtual void write(const Feedback& feedback) noexcept = 0;
  virtual DeviceLimits limits() const = 0;
  /// Force to zero, then release. Any thread, after the loop has stopped.
  virtual void close() noexcept = 0;
};

}  // namespace cusp
