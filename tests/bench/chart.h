/// The verb `chart`: measures (or reads what was measured), and writes the tables of tests/bench/results. charts/draw.py
/// draws them.
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

/// All that charts and tables are drawn from.
struct Evidence {
  Report accuracy, rate, scale, stability, removal;
  Report stability_full, removal_full;  // of --full, which takes long: kept where they are, never measured by chart
  PaceReport pace;
  MotionReport motion;
};

/// Runs every verb that makes rows.
Evidence measure_all(const Options& options);
/// Reads reports of --json, and the tables that chart writes; a folder stands for its tables. Rows find their kind by
/// what they hold, so that one file may bring several.
Result<Evidence, ChartFailure> read_evidence(const std::vector<std::string>& from);

/// [name]: text of every CSV file that has rows. The same evidence, the same bytes.
std::map<std::string, std::string> tables_of(const Evidence& evidence);

/// Records pace and motion where nothing that was read holds them.
int run_chart(const Options& options);

}  // namespace cusp::bench
