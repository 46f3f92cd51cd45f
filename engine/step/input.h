/// One tick's input: integers, exactly what the recorder stores, so that a replay is the same bit for bit.
#pragma once

#include <cstdint>

#include "engine/base/haptic_port.h"
#include "engine/base/vec.h"

namespace cusp::engine {

struct StepInput {
  std::int32_t x = 0, y = 0, z = 0;                 // device point, 0.1 µm, specimen frame
  std::int16_t qx = 0, qy = 0, qz = 0, qw = 32767;  // orientation, 1/32767
  std::uint16_t buttons = 0;                        // bit 0: cut, bit 1: coolant; the others below
  std::uint16_t pedal = 0;                          // 0 to 65535
  std::uint16_t bur = 0;                            // wanted: index into Scene::burs; StepOutput::bur has the one in use
  std::uint16_t fragment = 0;                       // half of a severed fragment's name, 0: none; FragmentRemoval::receive()
  std::uint32_t elapsed_us = 1000;                  // since the input before

  Vec3 position_mm() const noexcept { return Vec3(x, y, z) / 1e4; }
  bool cutting() const noexcept { return (buttons & kCut) != 0; }

  static constexpr std::uint16_t kCut = 1, kCoolant = 2, kRearm = 1u << 13, kGone = 1u << 14, kLate = 1u << 15;
  static constexpr std::uint16_t kNotFinite = kGone | kLate;  // both: the position was no number, or beyond 100 m
  friend bool operator==(const StepInput&, const StepInput&) = default;
};
static_assert(sizeof(StepInput) == 32);

/// Quantises a device's sample. If the position is not finite or beyond 100 m, or the orientation is none, the last
/// input is repeated with kNotFinite set.
StepInput quantise(const Sample& sample, std::uint32_t elapsed_us, const StepInput& last) noexcept;

}  // namespace cusp::engine
