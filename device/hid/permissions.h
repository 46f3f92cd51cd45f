/// udev rules for pedals and SpaceMice, and the command that installs them (Linux).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cusp::device::hid {

/// The lines of 52-cusp-hid.rules. The file must sort before 73-seat-late.rules.
std::string_view udev_rules() noexcept;
std::string_view udev_rules_path() noexcept;
/// Whether those lines name a device; for others an administrator adds udev_rule_for().
bool is_ruled(std::uint16_t vendor, std::uint16_t product) noexcept;
/// A line for any other device.
std::string udev_rule_for(std::uint16_t vendor, std::uint16_t product);
/// A shell command that writes the rules (and, for a device that they do not name, a line for it) and applies them to
/// connected devices; sudo asks for the password.
std::string udev_install_command(std::uint16_t vendor, std::uint16_t product);

}  // namespace cusp::device::hid
