/// Haply's Inverse3 through the maker's own service on this computer, as a device of the haptic loop. A thread of its
/// own exchanges messages with the service; the loop reads the newest reading and writes a force. Buttons of a wireless
/// handle: a cuts, b holds the bur while the hand moves, c selects the bur after the one in use [M].
/// [M]: from public clients, never tested on a real device.
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
  std::string device;          // its id; empty: the first that the service lists, and from then on that one
  inverse::SessionSettings session{};
  Vec3 origin_mm{0.0};         // position of the hand in the specimen at opening
  double yaw_rad = 0.0;        // rotation of the device about its vertical axis; x right, y away, z up at 0 [M]
  double scale = 0.5;          // mm in the specimen for a mm of the hand, 0.05 to 1
  double max_force_n = 2.0;    // limit of public clients [M]
  double max_stiffness_n_per_mm = 1.0;  // [M]
  std::uint16_t burs = 1;     // number of burs in the scene
};

/// Plain values for a screen.
struct InverseView {
  inverse::SessionState session{};
  double updates_per_s = 0;    // over the last second
};

class InversePort final : public HapticPort {
 public:
  explicit InversePort(std::unique_ptr<inverse::InverseLink> link, const InverseSettings& settings = {});
  ~InversePort() override;

  /// Blocks until the first position, at most kLongestOpen. not_found "service" if no service listens, not_found "device"
  /// if it has no device, else io with a key of inverse::Trouble.
  Result<void, PortFailure> open() override;
  static constexpr std::chrono::seconds kLongestOpen{3};
  /// Any thread. A running open() fails within some milliseconds, and so does every later one: io "cancelled".
  void cancel() noexcept;
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  /// rotation_axes is 3 if a handle reports its orientation.
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
