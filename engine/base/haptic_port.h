/// Interface between the haptic loop and any device: real, emulated, scripted or a mouse. Neither includes the other.
/// Frame: specimen, right-handed, x mesial, y buccal, z up. Units: millimetres, newtons, N/mm unless a name differs.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace cusp {

/// What a device can do. The session's header stores it, so that a replay uses the same limits.
struct DeviceLimits {
  std::string name;                  // "Mouse and keys", "Novint Falcon"; stored with the grade
  std::string device_class;          // "pointer", "falcon", "inverse3", "scripted"; statistics never mix classes
  int position_axes = 3;             // number of axes that it senses
  int rotation_axes = 0;             // number of axes of orientation that it senses
  double max_force_n = 8.9;          // largest force vector that the guard may ask for
  double max_stiffness_n_per_mm = 3.0;  // declared or calibrated; engine/step/stiffness_rule.h lowers the scene's to it
  bool has_own_clock = false;        // true: wait() returns when the device delivers, not at the deadline
  /// Closed loop: the force moves a mass behind the device point. A stiffness can then be too high.
  /// False if the hand gives force and not depth (a mouse), or nobody holds the device (a script).
  bool closed_loop = true;
  std::optional<double> damping_ns_per_m;  // N s/m, viscous, of the device alone; none until calibrated
  std::optional<double> delay_ms;    // round trip from the hand's motion to the answering force; none until calibrated
  std::optional<double> encoder_mm;  // smallest step of a reading; none if unknown
  std::optional<double> softest_grip_ns_per_m;  // N s/m, of the softest grip; none: the laboratory's value
};

/// One reading of the device. A port reports `late` if the device has delivered nothing since the last sample. The loop
/// detects a frozen device by that status alone, because a resting hand repeats its position.
struct Sample {
  enum class Status : std::uint8_t { fresh, late, gone };
  Status status = Status::gone;
  Vec3 position_mm{0.0};
  Quat orientation{1.0, 0.0, 0.0, 0.0};
  std::uint16_t buttons = 0;  // bit 0: cut; bit 1: coolant; bit 13: re-arm the guard
  std::uint16_t pedal = 0;    // 0 released to 65535 fully down
  std::uint16_t bur = 0;      // requested bur: index into the scene's burs
};

/// Result of a tick for the device: the force, and the proxy for devices whose hand gives force and not depth.
struct Feedback {
  Vec3 force_n{0.0};                  // after the guard
  Vec3 proxy_mm{0.0};                 // pivot of the bur that does not penetrate
  double stiffness_n_per_mm = 1.0;    // of the touched tissue; of the softest tissue without contact
  Vec3 normal{0.0, 0.0, 1.0};         // unit direction of the contact force; the last one without contact
  bool in_contact = false;
  bool faulted = false;               // the guard has latched; force is zero until re-armed
  std::uint16_t bur = 0;              // last wanted: index into the scene's burs; a device's buttons count from it
};

/// bad_file: a script or a firmware image; io: every other failure, with the device's key in Failure::detail.
enum class PortError : std::uint8_t { not_found, no_permission, busy, bad_file, io };
using PortFailure = Failure<PortError>;

class HapticPort {
 public:
  virtual ~HapticPort() = default;
  /// Blocks until the device delivers, or fails. Not on the haptic thread. After success one thread calls wait(), write().
  virtual Result<void, PortFailure> open() = 0;
  /// Newest complete sample; `late` repeats the last one, `gone`: the device is lost. Returns by `deadline`; a port
  /// without a clock of its own sleeps until then. Thread: haptic. No allocation. Pre: open() succeeded.
  virtual Sample wait(std::chrono::steady_clock::time_point deadline) noexcept = 0;
  /// After a `gone` sample: true if no sample follows it. Virtual time then ends. False: a script continues after a loss.
  /// Thread: of wait().
  virtual bool over() const noexcept { return true; }
  /// Passes on the force of this tick. Thread: haptic. Never waits; no allocation.
  virtual void write(const Feedback& feedback) noexcept = 0;
  virtual DeviceLimits limits() const = 0;
  /// Sets the force to zero, then releases the device. Any thread, after the loop has stopped.
  virtual void close() noexcept = 0;
};

}  // namespace cusp
