/// The laboratory's loop: a plant sampled and held at 1 kHz, a transport, and a controller that maps readings to
/// forces. The controller is anything callable as Vec3(const Reading&), in newtons. Deterministic; no clock, no heap
/// after the constructor. Thread: any, one at a time.
#pragma once

#include <cstdint>

#include "engine/base/vec.h"
#include "engine/lab/device_model.h"
#include "engine/lab/transport.h"

namespace cusp::engine::lab {

/// The host's input: the encoders' reading in the step's unit, and the time since the reading before.
struct Reading {
  std::int32_t x = 0, y = 0, z = 0;  // 0.1 um
  std::uint32_t elapsed_us = 1000;

  Vec3 position_mm() const noexcept { return Vec3(x, y, z) / 1e4; }
};

/// One millisecond of the loop, from one sample of the device to the next.
struct LoopTick {
  std::int64_t tick = 0;          // 1 after the first
  Vec3 from_mm{0.0}, to_mm{0.0};  // true place of the device at its beginning and end
  Vec3 velocity_mm_s{0.0};        // true, at its end
  Vec3 held_n{0.0};               // force of the motors at its end: limited and quantised
  Vec3 mean_n{0.0};               // held, over its time
  Vec3 wanted_n{0.0};             // the controller's last answer
  double energy_mj = 0.0;         // held force times true motion; positive: to the hand
  int answers = 0;                // of the controller in this millisecond: 0 after a loss
  bool held_any = false;          // a force was held at some time in it
  bool over_limit = false;        // the controller wanted more than the limit, or no number
};

class ClosedLoop {
 public:
  /// encoder_phase: where the encoders' first step begins, in steps, each axis [0, 1).
  ClosedLoop(const DeviceSettings& device, const TransportSettings& transport, const Grip& grip, Vec3 start_mm,
             Vec3 encoder_phase = Vec3(0.0));

  Plant& plant() noexcept { return plant_; }
  const Plant& plant() const noexcept { return plant_; }
  const LoopTick& last() const noexcept { return out_; }
  Vec3 held_n() const noexcept { return held_; }

  /// The host reads nothing for so long; then it reads the newest reading alone. [0, 1000] ms.
  void stall_ms(double ms) noexcept;
  /// Until plug_in() no reading and no force arrives; the motors hold nothing.
  void unplug() noexcept;
  void plug_in() noexcept { unplugged_ = false; }

  /// One millisecond.
  template <class Controller>
  LoopTick tick(Controller&& controller) {
    begin();
    for (std::int64_t end = now_ + kSlicesPerTick; now_ < end;) {
      Reading reading;
      while (receive(reading)) answer(controller(static_cast<const Reading&>(reading)));
      run(end);
    }
    finish();
    return out_;
  }

 private:
  struct Sampled {
    std::int32_t x, y, z;
  };
  void begin() noexcept;                // samples the encoders
  bool receive(Reading& out) noexcept;  // the newest reading that has arrived; false: none
  void answer(Vec3 wanted) noexcept;
  void run(std::int64_t end) noexcept;  // to the next event, at most to end
  void finish() noexcept;
  std::int64_t one_way() noexcept;  // slices that a packet takes
  std::int32_t read(int axis) const noexcept;

  DeviceSettings device_;
  TransportSettings transport_;
  Plant plant_;
  Vec3 phase_;
  Dice dice_;
  Wire<Sampled> up_;
  Wire<Vec3> down_;
  Vec3 held_{0.0};
  std::int64_t now_ = 0, stalled_until_ = 0, received_ = -1;
  bool unplugged_ = false;
  LoopTick out_;
};

}  // namespace cusp::engine::lab
