/// The seam between what the driver decides and what carries its bytes: libusb, or the emulated Falcon. A link knows
/// nothing of firmware, frames or forces. One thread uses a link at a time.
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

/// What the driver asks of its link.
struct LinkAsk {
  enum class Kind : std::uint8_t {
    open,     // find, open and claim: answered by opened, absent, denied or busy
    close,    // give the device back: no answer
    control,  // a vendor request: answered by control_done or failed
    send,     // bytes to the device: answered only when that fails
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

/// What the link tells.
struct LinkEvent {
  enum class Kind : std::uint8_t {
    time,  // nothing, until the time asked for
    opened,
    absent,  // no such device is there
    denied,  // it is there, and this user may not open it
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
  /// Begins it and returns. Closing takes some milliseconds on a real link (half a second where a device does not give
  /// back what is under way); everything else is at once.
  virtual void start(const LinkAsk& ask) noexcept = 0;
  /// The next event in order, or `time` when `until` has come (at once when it lies in the past and nothing waits).
  virtual LinkEvent wait(LinkTime until) noexcept = 0;
  /// Which device this is: its serial number, else the port that it hangs on ("1-4.2"). Empty before it was opened.
  virtual std::string name() const = 0;
};

}  // namespace cusp::device::falcon
