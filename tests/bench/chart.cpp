#include "tests/bench/chart.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/bench/accuracy.h"
#include "tests/bench/cavity.h"
#include "tests/bench/heads.h"
#include "tests/bench/pin.h"
#include "tests/bench/program.h"
#include "tests/bench/rate.h"
#include "tests/bench/removal.h"
#include "tests/bench/scale.h"
#include "tests/bench/stability.h"

namespace cusp::bench {

namespace {

namespace fs = std::filesystem;

constexpr const char* kStabilityFull = "stability-full.csv";
constexpr const char* kRemovalFull = "removal-full.csv";
constexpr const char* kMillFull = "mill-full.csv";

/// Rows of one report go to their kinds, each with the report's source.
void sort_in(Evidence& to, const Report& report) {
  for (const Row& row : report.rows) {
    const bool full = row.sweep == kFullSweep;
    Report& kind = !row.measure.empty()     ? full ? to.removal_full : to.removal
                   : !row.case_name.empty() ? full ? to.stability_full : to.stability
                   : full                   ? to.mill_full
                   : !row.axis.empty()      ? to.heads
                   : row.shape == "cavity"  ? to.cavity
                   : row.volume_voxels >= 0 ? to.scale
                   : !row.task.empty()      ? to.rate
                                            : to.accuracy;
    kind.source = report.source;
    kind.rows.push_back(row);
  }
}

Result<void, ChartFailure> read_file(const fs::path& path, Evidence& to) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return fail(ChartError::cannot_read, path.string());
  if (path.extension() == ".json") {
    const auto report = from_json(text.str());
    if (!report) return fail(ChartError::cannot_read, path.string(), report.error().where);
    sort_in(to, *report);
    return {};
  }
  // A table is known by its names.
  if (auto pace = pace_from_csv(text.str())) {
    to.pace = std::move(*pace);
  } else if (auto motion = motion_from_csv(text.str())) {
    to.motion = std::move(*motion);
  } else if (const auto report = from_csv(text.str()); report && !report->rows.empty()) {
    sort_in(to, *report);
  } else {
    return fail(ChartError::cannot_read, path.string());
  }
  return {};
}

int failed(const ChartFailure& failure) {
  std::cerr << "cusp-bench: "
            << (failure.code == ChartError::cannot_read ? "cannot read " : "cannot write ")
            << failure.where << (failure.detail.empty() ? "" : ": " + failure.detail) << '\n';
  return kFailed;
}

}  // namespace

Evidence measure_all(const Options& options) {
  Evidence out;
  const Report here = empty_report();
  out.accuracy = out.cavity = out.rate = out.scale = out.stability = out.removal = out.heads = here;
  for (const auto rows_of : {accuracy_rows, cavity_rows, rate_rows, scale_rows, stability_rows, removal_rows, heads_rows})
    sort_in(out, {here.source, rows_of(options)});
  return out;
}

Result<Evidence, ChartFailure> read_evidence(const std::vector<std::string>& from) {
  std::vector<fs::path> files;
  for (const std::string& name : from) {
    std::error_code none;
    if (!fs::is_directory(name, none)) {
      files.emplace_back(name);
      continue;
    }
    for (const char* table : {"accuracy.csv", "cavity.csv", "rate.csv", "scale.csv", "stability.csv", "removal.csv", "heads.csv", "pace.csv", "motion.csv", kStabilityFull, kRemovalFull, kMillFull})
      if (fs::exists(fs::path(name) / table, none)) files.push_back(fs::path(name) / table);
  }
  Evidence out;
  for (const fs::path& file : files)
    if (const auto read = read_file(file, out); !read) return std::unexpected(read.error());
  return out;
}

std::map<std::string, std::string> tables_of(const Evidence& evidence) {
  std::map<std::string, std::string> out;
  for (const auto& [name, report] : {std::pair<const char*, const Report*>{"accuracy.csv", &evidence.accuracy},
                                     {"cavity.csv", &evidence.cavity},
                                     {"rate.csv", &evidence.rate},
                                     {"scale.csv", &evidence.scale},
                                     {"stability.csv", &evidence.stability},
                                     {"removal.csv", &evidence.removal},
                                     {"heads.csv", &evidence.heads},
                                     {kStabilityFull, &evidence.stability_full},
                                     {kRemovalFull, &evidence.removal_full},
                                     {kMillFull, &evidence.mill_full}})
    if (!report->rows.empty()) out[name] = to_csv(*report);
  if (!evidence.pace.samples.empty()) out["pace.csv"] = to_csv(evidence.pace);
  if (!evidence.motion.samples.empty()) out["motion.csv"] = to_csv(evidence.motion);
  return out;
}

int run_chart(const Options& options) {
  Evidence evidence;
  if (!options.from.empty()) {
    auto read = read_evidence(options.from);
    if (!read) return failed(read.error());
    evidence = std::move(*read);
  }
  const bool measures = options.from.empty() || evidence.pace.samples.empty();
  if (measures && !pin_to_core()) std::cerr << "cusp-bench: this thread could not be kept on one core\n";
  if (options.from.empty()) evidence = measure_all(options);
  // No report of --json holds these two, and they take seconds.
  if (evidence.pace.samples.empty()) evidence.pace = record_pace();
  if (evidence.motion.samples.empty()) evidence.motion = record_motion();
  std::error_code none;
  fs::create_directories(options.out, none);
  for (const auto& [name, text] : tables_of(evidence)) {
    const fs::path path = fs::path(options.out) / name;
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) return failed({ChartError::cannot_write, path.string(), ""});
  }
  if (!options.json.empty()) {
    Report all{evidence.rate.source, evidence.accuracy.rows};
    for (const Report* more : {&evidence.cavity, &evidence.rate, &evidence.scale, &evidence.stability, &evidence.removal, &evidence.heads, &evidence.stability_full,
                               &evidence.removal_full, &evidence.mill_full})
      all.rows.insert(all.rows.end(), more->rows.begin(), more->rows.end());
    if (const auto written = print_json(all, options.json); !written)
      return failed({ChartError::cannot_write, written.error().where, ""});
  }
  return kDone;
}

}  // namespace cusp::bench
