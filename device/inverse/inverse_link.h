/// The seam between the Inverse3's driver and its service: a WebSocket, or a test's own link. One thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace cusp::device::inverse {

using LinkTime = std::chrono::steady_clock::time_point;

/// Loopback alone: the service is a program of this computer.
struct ServiceAddress {
  std::uint16_t port = 10001;  // of the maker's service, version 3
  friend bool operator==(const ServiceAddress&, const ServiceAddress&) = default;
};

struct LinkEvent {
  enum class Kind : std::uint8_t {
    time,     // nothing happened until the requested time
    opened,
    refused,  // no service listens there, or it is no WebSocket
    message,  // `text` until the next call
    closed,   // the other side is gone
  };
  Kind kind = Kind::time;
  std::string_view text{};
};

class InverseLink {
 public:
  virtual ~InverseLink() = default;
  virtual LinkTime now() const noexcept = 0;
  /// Begins to open; wait() reports `opened` or `refused`.
  virtual void open() = 0;
  /// Queues one message; drops it if the link is not open.
  virtual void send(std::string text) = 0;
  /// The next event, or `time` at `until`.
  virtual LinkEvent wait(LinkTime until) = 0;
  virtual void close() noexcept = 0;
};

}  // namespace cusp::device::inverse
