/// The little that a verb needs of a terminal.
#pragma once

#include <string>

namespace cusp::ui {

/// One line of stdin, its first kilobyte; when that is a terminal, asked for on stderr and not shown while it is typed.
std::string read_secret(const std::string& prompt);

/// A share done, 0 to 1, in one line on stderr that is written over; nothing where stderr is no terminal.
void show_progress(double share);
/// Empties that line.
void end_progress();

}  // namespace cusp::ui
