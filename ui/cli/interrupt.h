/// Ctrl+C as a question: a verb that takes long asks it between two steps.
#pragma once

namespace cusp::ui {

/// From now on Ctrl+C and SIGTERM no longer end the program. Any thread; once a program is enough.
void catch_interrupt() noexcept;

/// True from the first of them after catch_interrupt(). Any thread.
bool interrupted() noexcept;

}  // namespace cusp::ui
