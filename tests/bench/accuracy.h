/// The verb `accuracy`: every method on every shape and motion against the exact proxy.
#pragma once

#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"

namespace cusp::bench {

/// Default set: every method at 10/128 mm with burs of 0.25 and 0.5 mm on every shape and motion; voxels of 0.2, 0.1
/// and 0.04 mm and burs of 1.15 and 3 mm on face and sphere, the voxels on the cylinder too.
std::vector<Row> accuracy_rows(const Options& options);

/// Prints or writes accuracy_rows and returns an exit code of program.h.
int run_accuracy(const Options& options);

}  // namespace cusp::bench
