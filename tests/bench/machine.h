/// Commit and CPU of a measurement.
#pragma once

#include <string>

namespace cusp::bench {

/// Commit that this program was built from, with a "+" if files were changed since; "unknown" outside a repository.
std::string commit_of_build();
/// "model name" of /proc/cpuinfo; "unknown" where there is none.
std::string cpu_name();

}  // namespace cusp::bench
