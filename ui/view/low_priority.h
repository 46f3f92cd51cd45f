/// Lets other threads of this process go first. Thread: any; holds for the calling thread and those that it starts.
#pragma once

namespace cusp::ui {

/// Without effect where the system refuses it.
void lower_own_priority() noexcept;

}  // namespace cusp::ui
