/// What a user who may not open a Falcon lacks: the rule, and the one line that installs it (Linux).
#pragma once

#include <string>
#include <string_view>

namespace cusp::device::falcon {

/// The rule's one line, as in 51-cusp.rules. It has to sort before 73-seat-late.rules.
std::string_view udev_rule() noexcept;
std::string_view udev_rule_path() noexcept;
/// A shell command that writes the rule and applies it to what is plugged in already; asks for the password by sudo.
std::string udev_install_command();

}  // namespace cusp::device::falcon
