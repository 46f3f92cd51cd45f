/// Names this process so that a later one can tell whether it still runs, also when its number was given again.
#pragma once

#include <string>

namespace cusp {

/// "boot id:process:start time".
std::string this_process();
/// False when that process has ended, the machine was started anew, or the text is none of ours.
bool process_runs(const std::string& process);

}  // namespace cusp
