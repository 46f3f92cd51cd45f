/// The Falcon's USB bridge, an FTDI FT232R: its vendor requests as values, and the two status bytes that lead every
/// packet from it. Pure. Source: facts 1.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cusp::device::falcon {

inline constexpr std::uint16_t kVendor = 0x0403, kProduct = 0xCB48;
inline constexpr std::uint8_t kInEndpoint = 0x81, kOutEndpoint = 0x02;
inline constexpr std::size_t kPacketBytes = 64;
inline constexpr std::size_t kStatusBytes = 2;
inline constexpr std::size_t kPayloadBytes = kPacketBytes - kStatusBytes;
/// Larger than any expected count: a transfer that is too small for a packet loses it.
inline constexpr std::size_t kReadBytes = 512;

/// bmRequestType 0x40, wIndex 0, wLength 0.
struct FtdiRequest {
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  friend bool operator==(const FtdiRequest&, const FtdiRequest&) = default;
};

namespace ftdi {
// Sources disagree on which of the two purges empties which buffer: send both.
inline constexpr FtdiRequest kPurge1{0x00, 1}, kPurge2{0x00, 2};
inline constexpr FtdiRequest kDtrLow{0x01, 0x0100}, kDtrHigh{0x01, 0x0101}, kRtsLow{0x01, 0x0200},
    kRtsHigh{0x01, 0x0202};
inline constexpr FtdiRequest kNoFlowControl{0x02, 0};
// 3,000,000 baud over 312.5, 21 and 2.
inline constexpr FtdiRequest kBaudHello{0x03, 0x4138}, kBaudUpload{0x03, 0x0015}, kBaudRun{0x03, 0x0002};
inline constexpr FtdiRequest k8N1{0x04, 0x0008};
inline constexpr FtdiRequest kEventOnFrameEnd{0x06, 0x013E};
inline constexpr FtdiRequest kLatency16ms{0x09, 16}, kLatency1ms{0x09, 1};
}  // namespace ftdi

/// Line errors that the bridge reported besides the payload.
struct LineErrors {
  std::uint32_t overrun = 0, parity = 0, framing = 0, broken = 0, short_packets = 0;
  /// Errors that corrupt bytes.
  std::uint32_t spoilt() const noexcept { return overrun + parity + framing + broken; }
};

/// Calls `take(payload)` for each 64-byte packet with a payload, without its two status bytes, and counts the line's
/// errors. Every 64-byte packet of a transfer begins with status bytes.
template <class Take>
void strip_status(std::span<const std::uint8_t> transfer, LineErrors& errors, Take&& take) noexcept {
  while (!transfer.empty()) {
    const std::size_t size = transfer.size() < kPacketBytes ? transfer.size() : kPacketBytes;
    const auto packet = transfer.first(size);
    transfer = transfer.subspan(size);
    if (size < kStatusBytes) {
      ++errors.short_packets;
      continue;
    }
    const std::uint8_t line = packet[1];
    errors.overrun += (line >> 1) & 1;
    errors.parity += (line >> 2) & 1;
    errors.framing += (line >> 3) & 1;
    errors.broken += (line >> 4) & 1;
    if (size > kStatusBytes) take(packet.subspan(kStatusBytes));
  }
}

/// Bits a second of a divisor request (low 14 bits whole, bits 15:14 a code for the fraction); 0 when it has none.
double baud_of(std::uint16_t divisor) noexcept;

}  // namespace cusp::device::falcon
