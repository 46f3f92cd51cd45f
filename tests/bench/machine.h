/// Commit and CPU of a measurement.
#pragma once

#include <string>

namespace cusp::bench {

/// Commit of the working tree this program was built from, read from its .git; "unknown" outside a repository.
std::string commit_of_tree();
/// "model name" of /proc/cpuinfo; "unknown" where there is none.
std::string cpu_name();

}  // namespace cusp::bench
