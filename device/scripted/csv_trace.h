/// A motion as CSV: `elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal[,bur]`. The units are the step's own integers (0.1 µm,
/// 1/32767, µs): a played trace is exact to the bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/haptic_port.h"

namespace cusp::device {

struct TraceRow {
  std::uint32_t elapsed_us = 1000;  // since the row before
  std::int32_t x = 0, y = 0, z = 0;
  std::int16_t qx = 0, qy = 0, qz = 0, qw = 32767;
  /// Bit 0: cut; bit 1: coolant; bit 13: the guard is re-armed; bit 14: the device was gone; bit 15: it was late.
  /// Bits 14 and 15: the position was no number. A row with bit 14 repeats the last position, whatever its columns hold.
  /// In virtual time the row after a fault re-arms without bit 13, too.
  std::uint16_t buttons = 0;
  std::uint16_t pedal = 0;
  std::uint16_t bur = 0;
  friend bool operator==(const TraceRow&, const TraceRow&) = default;
};

enum class TraceError : std::uint8_t {
  empty,           // no row at all
  bad_header,      // the first line has text, but not the columns' names
  wrong_columns,   // neither 10 nor 11, or not as many as the first row
  not_a_number,    // not a plain integer
  out_of_range,    // does not fit its column
  not_a_rotation,  // the quaternion's length is not 1 within 2 %
};

/// Stable key of a code ("not_a_number").
std::string_view key_of(TraceError code) noexcept;

/// `where` is "line:column", both from 1 (column of the table, not of the text).
using TraceFailure = Failure<TraceError>;

/// A header line is optional; lines may end in CR LF; an empty last line is no row.
[[nodiscard]] Result<std::vector<TraceRow>, TraceFailure> parse_trace(std::string_view text);

/// The row as a device reports it.
Sample sample_of(const TraceRow& row) noexcept;

}  // namespace cusp::device
