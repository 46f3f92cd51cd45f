/// Parses a HID device's report descriptor. Pure: no I/O, no clock. Any bytes may be given: damaged ones are refused with a
/// code and the position, and nothing is read past the end.
/// Source: USB Device Class Definition for HID 1.11, section 6.2.2.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/result.h"

namespace cusp::device::hid {

/// Pages and usages that Cusp reads.
namespace usage {
inline constexpr std::uint16_t kDesktopPage = 0x01, kSimulationPage = 0x02, kKeyPage = 0x07, kButtonPage = 0x09;
inline constexpr std::uint16_t kMouse = 0x02, kJoystick = 0x04, kGamePad = 0x05, kKeyboard = 0x06, kMultiAxis = 0x08;
}  // namespace usage

/// One value of an input report, or the slots in which a keyboard lists its pressed keys.
struct InputField {
  std::uint8_t report = 0;             // its report's number; 0 if the device uses none
  std::uint32_t bit = 0;               // from the report's first payload bit
  std::uint8_t bits = 0;               // 1 to 32
  std::uint16_t count = 1;             // slots of `bits` each; above 1 for lists alone
  bool list = false;                   // slots hold usages (pressed keys), not a value of one usage
  bool relative = false;
  std::int32_t least = 0, most = 0;    // logical range
  std::uint16_t page = 0, usage = 0;   // of lists: the usage that `least` stands for
  friend bool operator==(const InputField&, const InputField&) = default;
};

struct ReportDescriptor {
  std::vector<InputField> inputs;      // without padding
  std::uint16_t page = 0, usage = 0;   // of the first application collection: the device's own kind
  bool numbered = false;               // each report begins with its number
  std::array<std::uint16_t, 256> bytes{};  // of each input report, without its number; 0: none of that number
};

enum class DescriptorError : std::uint8_t {
  cut_off,        // an item extends past the end
  nesting,        // collections or pushes too deep, or closed more often than opened
  size,           // a field of no or over 32 bits, a report of over 4 KiB, more than 1,024 fields
  report_number,  // 0, or above 255
};
struct DescriptorFailure {
  DescriptorError code;
  std::size_t at = 0;  // byte of the descriptor
};

Result<ReportDescriptor, DescriptorFailure> parse_report_descriptor(std::span<const std::uint8_t> bytes);

/// A field's value in a report (payload alone, without the number), sign extended where its range has negative values;
/// slot `slot` of a list. nullopt if the report is too short or the value lies outside the field's range.
std::optional<std::int32_t> value_in(const InputField& field, std::span<const std::uint8_t> payload,
                                     std::uint16_t slot = 0) noexcept;

}  // namespace cusp::device::hid
