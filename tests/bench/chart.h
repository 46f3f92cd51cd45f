/// The verb `chart`: measures or reads rows and writes the tables of tests/bench/results for charts/draw.py.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/tasks.h"

namespace cusp::bench {

enum class ChartError : std::uint8_t { cannot_read, cannot_write };
using ChartFailure = Failure<ChartError>;

/// The rows behind all charts and tables.
struct Evidence {
  Report accuracy, cavity, rate, scale, stability, removal, heads;
  Report stability_full, removal_full, mill_full;  // of --full; chart reads and never measures them
  PaceReport pace;
  MotionReport motion;
};

/// Runs every verb that makes rows.
Evidence measure_all(const Options& options);
/// Reads reports of --json and tables of chart; a folder stands for its tables. The fields of a row decide its kind, so
/// one file may hold several kinds.
Result<Evidence, ChartFailure> read_evidence(const std::vector<std::string>& from);

/// [name]: text of every CSV file that has rows. The same evidence, the same bytes.
std::map<std::string, std::string> tables_of(const Evidence& evidence);

/// Records pace and motion unless --from holds them.
int run_chart(const Options& options);

}  // namespace cusp::bench
