/// The verb `chart`: measures (or reads what was measured), and writes the tables and pictures of tests/bench/results.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/figures.h"
#include "tests/bench/options.h"

namespace cusp::bench {

/// All that the pictures are drawn from.
struct Evidence {
  Report accuracy, rate, scale, stability, removal;
  Report stability_full, removal_full;  // of --full, which takes long: drawn where they are, never measured by chart
  PaceReport pace;
  MotionReport motion;
};

/// Runs every verb that makes rows.
Evidence measure_all(const Options& options);
/// Reads reports of --json, and the tables that chart writes; a folder stands for its tables. Rows find their kind by
/// what they hold, so that one file may bring several.
Result<Evidence, ChartFailure> read_evidence(const std::vector<std::string>& from);

/// [name]: text of every file. The same evidence, the same bytes.
Result<std::map<std::string, std::string>, ChartFailure> draw_all(const Evidence& evidence);

/// Lines of a README between which the table of methods stands; a README has to have both places.
inline constexpr std::string_view kTableBegin = "<!-- methods: written by cusp-bench chart -->\n";
inline constexpr std::string_view kTableEnd = "<!-- /methods -->\n";
/// And the one of what breaks.
inline constexpr std::string_view kStabilityBegin = "<!-- stability: written by cusp-bench chart -->\n";
inline constexpr std::string_view kStabilityEnd = "<!-- /stability -->\n";
/// And the one of what the cut keeps.
inline constexpr std::string_view kRemovalBegin = "<!-- removal: written by cusp-bench chart -->\n";
inline constexpr std::string_view kRemovalEnd = "<!-- /removal -->\n";

/// Records pace and motion where nothing that was read holds them. What --full once left in --out is drawn again.
int run_chart(const Options& options);

}  // namespace cusp::bench
