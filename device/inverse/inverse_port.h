/// Haply's Inverse3 through the maker's own service on this computer, as a device of the haptic loop. A thread of its
/// own talks to the service; the loop takes the newest reading and leaves a force. Of a wireless handle's buttons a
/// cuts, b holds the bur while the hand moves, c takes the next bur [M]. What was learnt from public clients and never
/// tried on a real device is marked [M].
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "device/inverse/inverse_link.h"
#include "device/inverse/inverse_session.h"
#include "engine/base/haptic_port.h"

namespace cusp::device {

struct InverseSettings {
  inverse::ServiceAddress service{};
  std::string device;          // its id; empty: the first that the service tells
  inverse::SessionSettings session{};
  Vec3 origin_mm{0.0};         // place in the specimen where the hand is when the device is opened
  double yaw_rad = 0.0;        // by which the device is turned about its upright; x right, y away, z up at 0 [M]
  double scale = 0.5;          // mm in the specimen for a mm of the hand, 0.05 to 1
  double max_force_n = 2.0;    // what public clients let through [M]
  double max_stiffness_n_per_mm = 1.0;  // [M]
  std::uint16_t burs = 1;     // how many the scene has
};

/// What a screen may want to know; plain values.
struct InverseView {
  inverse::SessionState session{};
  double updates_per_s = 0;    // over the last second
};

class InversePort final : public HapticPort {
 public:
  explicit InversePort(std::unique_ptr<inverse::InverseLink> link, const InverseSettings& settings = {});
  ~InversePort() override;

  /// Until the service tells a first place: not_found "service" when nobody listens, not_found "device" when it has
  /// none, io with a key of inverse::Trouble otherwise. At most kLongestOpen.
  Result<void, PortFailure> open() override;
  static constexpr std::chrono::seconds kLongestOpen{3};
  /// Any thread: an open() under way fails within some milliseconds, and so does every later one: io "cancelled".
  void cancel() noexcept;
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  /// rotation_axes is 3 where a handle tells its orientation.
  DeviceLimits limits() const override;
  void close() noexcept override;

  /// Any thread.
  InverseView view() const;

 private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

/// Over WebSocket to the service on this computer.
std::unique_ptr<InversePort> make_inverse_port(const InverseSettings& settings);

}  // namespace cusp::device
