/// udev rule for the Falcon, and the command that installs it (Linux).
#pragma once

#include <string>
#include <string_view>

namespace cusp::device::falcon {

/// The rule, as in 51-cusp.rules. The file must sort before 73-seat-late.rules.
std::string_view udev_rule() noexcept;
std::string_view udev_rule_path() noexcept;
/// A shell command that writes the rule and applies it to connected devices; sudo asks for the password.
std::string udev_install_command();

}  // namespace cusp::device::falcon
