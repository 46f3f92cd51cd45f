/// The seam between the driver's decisions and the transport of its bytes: libusb, or the emulated Falcon. A link knows no
/// firmware, frames or forces. One thread uses a link at a time.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <string>

#include "device/falcon/ftdi.h"

namespace cusp::device::falcon {

/// Time since a zero of the link's own; only differences count. steady_clock's in a real link.
using LinkTime = std::chrono::nanoseconds;

/// A request of the driver to its link.
struct LinkAsk {
  enum class Kind : std::uint8_t {
    open,     // find, open and claim: answered by opened, absent, denied or busy
    close,    // give the device back: no answer
    control,  // a vendor request: answered by control_done or failed
    send,     // bytes to the device: answered only on failure
  };
  Kind kind = Kind::close;
  FtdiRequest request{};
  std::array<std::uint8_t, kPayloadBytes> bytes{};
  std::uint8_t size = 0;
  std::span<const std::uint8_t> payload() const noexcept { return std::span(bytes).first(size); }
  /// Pre: at most kPayloadBytes.
  static LinkAsk of_bytes(std::span<const std::uint8_t> sent) noexcept {
    LinkAsk out{.kind = Kind::send};
    std::copy(sent.begin(), sent.end(), out.bytes.begin());
    out.size = static_cast<std::uint8_t>(sent.size());
    return out;
  }
};

/// An event of the link.
struct LinkEvent {
  enum class Kind : std::uint8_t {
    time,  // nothing happened until the requested time
    opened,
    absent,  // no such device
    denied,  // this user may not open the device
    busy,    // another program holds it
    control_done,
    failed,    // a request or a transfer failed; the device is still there
    received,  // `bytes`: one transfer as it came, status bytes included; valid until the link is used again
    gone,      // unplugged
  };
  Kind kind = Kind::time;
  std::span<const std::uint8_t> bytes{};
};

class FalconLink {
 public:
  virtual ~FalconLink() = default;
  virtual LinkTime now() const noexcept = 0;
  /// Begins the ask and returns at once. Closing blocks for some milliseconds on a real link, for half a second if the
  /// device does not return its transfers.
  virtual void start(const LinkAsk& ask) noexcept = 0;
  /// The next event in order, or `time` at `until`. Does not block if `until` is past.
  virtual LinkEvent wait(LinkTime until) noexcept = 0;
  /// The device's serial number, else its USB port ("1-4.2"). Empty before the first open.
  virtual std::string name() const = 0;
  /// Whether its USB port alone identifies the device that was opened first: it has no serial number of its own, and another
  /// Falcon at that port would be taken for it. False before the first open.
  virtual bool known_by_port() const noexcept { return false; }
};

}  // namespace cusp::device::falcon
