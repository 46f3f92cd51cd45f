/// The program cusp-bench: parses the command line and runs a verb.
#pragma once

#include <string>
#include <vector>

namespace cusp::bench {

/// Exit codes: 0 done, 1 failed with one clear line on stderr, 2 wrong usage.
inline constexpr int kDone = 0, kFailed = 1, kUsage = 2;

/// args without the program's name.
int run_program(std::vector<std::string> args);

}  // namespace cusp::bench
