#include "tests/bench/chart.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/bench/accuracy.h"
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

/// Rows of one report go to their kinds, each with the report's commit and machine.
void sort_in(Evidence& to, const Report& report) {
  for (const Row& row : report.rows) {
    const bool full = row.sweep == kFullSweep;
    Report& kind = !row.measure.empty()     ? full ? to.removal_full : to.removal
                   : !row.case_name.empty() ? full ? to.stability_full : to.stability
                   : row.volume_voxels >= 0 ? to.scale
                   : !row.task.empty()      ? to.rate
                                            : to.accuracy;
    kind.commit = report.commit;
    kind.machine = report.machine;
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

/// Puts a table between the two lines that mark its place in a README.
Result<void, ChartFailure> place_table(const fs::path& path, std::string_view begin_line, std::string_view end_line,
                                       const std::string& table) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  std::string whole = text.str();
  const std::size_t begin = whole.find(begin_line);
  const std::size_t end = whole.find(end_line);
  if (!file || begin == std::string::npos || end == std::string::npos || end < begin)
    return fail(ChartError::cannot_read, path.string(), "no place for the table");
  const std::size_t from = begin + begin_line.size();
  whole.replace(from, end - from, table);
  std::ofstream out(path, std::ios::binary);
  out << whole;
  out.close();
  if (!out) return fail(ChartError::cannot_write, path.string());
  return {};
}

int failed(const ChartFailure& failure) {
  std::cerr << "cusp-bench: "
            << (failure.code == ChartError::missing_rows  ? "nothing to draw from: "
                : failure.code == ChartError::cannot_read ? "cannot read "
                                                          : "cannot write ")
            << failure.where << (failure.detail.empty() ? "" : ": " + failure.detail) << '\n';
  return kFailed;
}

}  // namespace

Evidence measure_all(const Options& options) {
  Evidence out;
  const Report here = empty_report();
  out.accuracy = out.rate = out.scale = out.stability = out.removal = here;
  out.accuracy.rows = accuracy_rows(options);
  out.rate.rows = rate_rows(options);
  out.scale.rows = scale_rows(options);
  out.stability.rows = stability_rows(options);
  out.removal.rows = removal_rows(options);
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
    for (const char* table : {"accuracy.csv", "rate.csv", "scale.csv", "stability.csv", "removal.csv", "pace.csv", "motion.csv", kStabilityFull, kRemovalFull})
      if (fs::exists(fs::path(name) / table, none)) files.push_back(fs::path(name) / table);
  }
  Evidence out;
  for (const fs::path& file : files)
    if (const auto read = read_file(file, out); !read) return std::unexpected(read.error());
  return out;
}

Result<std::map<std::string, std::string>, ChartFailure> draw_all(const Evidence& evidence) {
  std::map<std::string, std::string> out = {
      {"accuracy.csv", to_csv(evidence.accuracy)}, {"rate.csv", to_csv(evidence.rate)},
      {"scale.csv", to_csv(evidence.scale)},       {"stability.csv", to_csv(evidence.stability)},
      {"pace.csv", to_csv(evidence.pace)},         {"motion.csv", to_csv(evidence.motion)}};
  // Drawn from what the tables hold, not from more figures than they do: then they give the same pictures later.
  const auto accuracy = from_csv(out["accuracy.csv"]);
  const auto rate = from_csv(out["rate.csv"]);
  const auto scale = from_csv(out["scale.csv"]);
  const auto stability = from_csv(out["stability.csv"]);
  const auto pace = pace_from_csv(out["pace.csv"]);
  const auto motion = motion_from_csv(out["motion.csv"]);
  for (const auto* read : {&accuracy, &rate, &scale, &stability})
    if (!*read) return fail(ChartError::cannot_read, "a row", read->error().where);
  if (!pace) return fail(ChartError::cannot_read, "pace", pace.error().where);
  if (!motion) return fail(ChartError::cannot_read, "motion", motion.error().where);
  const std::pair<const char*, Picture> pictures[] = {
      {"speed-accuracy-r025.svg", speed_against_accuracy(*accuracy, *rate, 0.25)},
      {"speed-accuracy-r050.svg", speed_against_accuracy(*accuracy, *rate, 0.5)},
      {"rates-by-task.svg", rates_by_task(*pace)},
      {"displacement-force.svg", displacement_and_force(*motion)},
      {"error-voxel.svg", error_against_voxel(*accuracy)},
      {"cost-size.svg", cost_against_size(*rate, *scale)},
      {"methods.md", method_table(*accuracy, *rate)},
      {"stability-map.svg", stability_map(*stability)},
      {"stability-damping.svg", stiffness_against_damping(*stability)},
      {"stability.md", stability_table(*stability)},
  };
  for (const auto& [name, picture] : pictures) {
    if (!picture) return std::unexpected(picture.error());
    out[name] = *picture;
  }
  if (!evidence.stability_full.rows.empty()) {
    out[kStabilityFull] = to_csv(evidence.stability_full);
    const auto full = from_csv(out[kStabilityFull]);
    if (!full) return fail(ChartError::cannot_read, "a row", full.error().where);
    const auto picture = stiffness_by_cell(*full);
    if (!picture) return std::unexpected(picture.error());
    out["stability-cells.svg"] = *picture;
  }
  // Tables of before there was such a report have none of it.
  if (evidence.removal.rows.empty()) return out;
  out["removal.csv"] = to_csv(evidence.removal);
  const auto removal = from_csv(out["removal.csv"]);
  if (!removal) return fail(ChartError::cannot_read, "a row", removal.error().where);
  Report full;
  if (!evidence.removal_full.rows.empty()) {
    out[kRemovalFull] = to_csv(evidence.removal_full);
    auto read = from_csv(out[kRemovalFull]);
    if (!read) return fail(ChartError::cannot_read, "a row", read.error().where);
    full = std::move(*read);
  }
  for (const auto& [name, picture] : {std::pair<const char*, Picture>{"drilling-depth.svg", depth_over_time(*removal)},
                                      {"drilling-speed-error.svg", speed_error(*removal)},
                                      {"removal.md", removal_table_with(*removal, full)}}) {
    if (!picture) return std::unexpected(picture.error());
    out[name] = *picture;
  }
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
  for (const auto& [name, report] : {std::pair{kStabilityFull, &Evidence::stability_full}, {kRemovalFull, &Evidence::removal_full}}) {
    std::error_code none;
    const fs::path before = fs::path(options.out) / name;
    if (!(evidence.*report).rows.empty() || !fs::exists(before, none)) continue;
    if (const auto read = read_file(before, evidence); !read) return failed(read.error());
  }
  // No report of --json holds these two, and they take seconds.
  if (evidence.pace.samples.empty()) evidence.pace = record_pace();
  if (evidence.motion.samples.empty()) evidence.motion = record_motion();
  const auto files = draw_all(evidence);
  if (!files) return failed(files.error());
  std::error_code none;
  fs::create_directories(options.out, none);
  for (const auto& [name, text] : *files) {
    const fs::path path = fs::path(options.out) / name;
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) return failed({ChartError::cannot_write, path.string(), ""});
  }
  if (!options.json.empty()) {
    Report all{evidence.rate.commit, evidence.rate.machine, evidence.accuracy.rows};
    for (const Report* more : {&evidence.rate, &evidence.scale, &evidence.stability, &evidence.removal, &evidence.stability_full,
                               &evidence.removal_full})
      all.rows.insert(all.rows.end(), more->rows.begin(), more->rows.end());
    if (const auto written = print_json(all, options.json); !written)
      return failed({ChartError::cannot_write, written.error().where, ""});
  }
  if (options.readme.empty()) return kDone;
  for (const auto& placed : {place_table(options.readme, kTableBegin, kTableEnd, files->at("methods.md")),
                             place_table(options.readme, kStabilityBegin, kStabilityEnd, files->at("stability.md"))})
    if (!placed) return failed(placed.error());
  if (const auto removal = files->find("removal.md"); removal != files->end())
    if (const auto placed = place_table(options.readme, kRemovalBegin, kRemovalEnd, removal->second); !placed)
      return failed(placed.error());
  return kDone;
}

}  // namespace cusp::bench
