/// The little that the program needs of a terminal and of its standard streams.
#pragma once

#include <string>

namespace cusp::ui {

/// Gives a standard stream that is closed at the start its number back: else the first file or connection gets it, and messages go
/// into that. Reading and writing it fail as on a closed stream. Before anything is opened.
void hold_standard_streams() noexcept;

/// One line of stdin, its first kilobyte; when that is a terminal, asked for on stderr and not shown while it is typed.
std::string read_secret(const std::string& prompt);

/// A share done, 0 to 1, in one line on stderr that is written over; nothing where stderr is no terminal.
void show_progress(double share);
/// Empties that line.
void end_progress();

}  // namespace cusp::ui
