/// Ctrl+C as a question: a verb that takes long asks it between two steps.
#pragma once

#include <cstddef>

namespace cusp::ui {

/// From now on Ctrl+C, SIGTERM and the closing of the terminal no longer end the program. Any thread; once a program is enough.
void catch_interrupt() noexcept;

/// True from the first of them after catch_interrupt(). Any thread.
bool interrupted() noexcept;

/// A WorkWatch (storage/base/watch.h) that ends the work then.
inline bool goes_on_until_interrupt(std::size_t, std::size_t) noexcept { return !interrupted(); }

}  // namespace cusp::ui
