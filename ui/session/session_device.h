/// What a station drills with: its choice, and the port that is made of it for one attempt.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "device/falcon/emulated_falcon_port.h"
#include "device/falcon/profile.h"
#include "device/inverse/inverse_port.h"
#include "device/pointer/pointer_hand.h"
#include "engine/base/haptic_port.h"
#include "ui/modules.h"

namespace cusp::ui {

/// A file that the user named: the maker's licence does not allow Cusp to ship one.
struct FirmwareChoice {
  std::filesystem::path file;  // empty: none was named
  std::string sha256;          // as it was when it was named; another file is refused
  friend bool operator==(const FirmwareChoice&, const FirmwareChoice&) = default;
};

struct DeviceChoice {
  std::string kind = "pointer";  // DeviceKind::key
  std::string name;              // which of several Falcons; empty: the first
  FirmwareChoice firmware;
  FalconProfile profile;         // of that Falcon
  InverseSettings inverse{};     // of the Inverse3; place and burs are the attempt's
};

/// A port for one attempt, and what a screen may look at meanwhile. Its parts live as long as the port.
struct SessionDevice {
  std::unique_ptr<HapticPort> port;
  std::shared_ptr<PointerHand> hand;         // mouse and keys lead it: the pointer, or the emulated Falcon
  FalconPort* falcon = nullptr;              // a real one: to look at while its open() waits for homing
  InversePort* inverse = nullptr;        // to call off while its open() waits; to look at
  EmulatedFalconPort* emulated = nullptr;
  /// Live values of the Falcon, real or emulated; nullptr for others. One thread.
  const FalconView* view() const noexcept;
};

/// Makes the port; nothing is opened yet. The middle of the device's travel lies at `start_mm`, its buttons go through
/// `burs` instruments. A Falcon's open() ends when it is homed. `hand`: leads the emulated Falcon instead of the mouse.
/// Fails with bad_file "needs_file" for a kind that plays a file; not_found for an unknown kind; io where libusb does not
/// start. A firmware file that cannot be used fails the port's open(), and only if firmware must be loaded.
Result<SessionDevice, PortFailure> make_session_device(const DeviceChoice& choice, Vec3 start_mm, std::size_t burs,
                                               EmulatedHand hand = {});

/// Reads the file that was named. Fails with bad_file: "changed" where it is not the one that was named, else its
/// ImageError's key.
Result<falcon::FirmwareImage, PortFailure> read_firmware(const FirmwareChoice& choice);

}  // namespace cusp::ui
