/// The little that a verb needs of a terminal.
#pragma once

#include <string>

namespace cusp {

/// One line of stdin; when that is a terminal, asked for on stderr and not shown while it is typed.
std::string read_secret(const std::string& prompt);

}  // namespace cusp
