#include "tests/bench/rows.h"

#include <array>
#include <charconv>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <type_traits>

#include "engine/scene/scene.h"
#include "tests/bench/machine.h"
#include "tests/bench/program.h"

namespace cusp::bench {

namespace {

using Json = nlohmann::ordered_json;

bool present(double v) { return !std::isnan(v); }
bool present(std::int64_t v) { return v >= 0; }
bool present(const std::string& v) { return !v.empty(); }
bool present(bool) { return true; }

/// Six digits keep the files short and exceed every uncertainty.
double rounded(double v) {
  if (v == 0.0 || !std::isfinite(v)) return v;
  std::ostringstream text;
  text << std::setprecision(6) << v;
  return std::strtod(text.str().c_str(), nullptr);
}

std::string csv_text(double v) {
  std::ostringstream out;
  out << std::setprecision(6) << v;
  return out.str();
}
std::string csv_text(std::int64_t v) { return std::to_string(v); }
std::string csv_text(const std::string& v) { return v; }
std::string csv_text(bool v) { return v ? "true" : "false"; }

bool from_text(const std::string& text, double& v) {
  char* end = nullptr;
  v = std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size();
}
bool from_text(const std::string& text, std::int64_t& v) {
  char* end = nullptr;
  v = std::strtoll(text.c_str(), &end, 10);
  return end == text.c_str() + text.size();
}
bool from_text(const std::string& text, std::string& v) {
  v = text;
  return true;
}
bool from_text(const std::string& text, bool& v) {
  v = text == "true";
  return v || text == "false";
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> out;
  std::size_t at = 0;
  for (;;) {
    const std::size_t comma = line.find(',', at);
    out.push_back(line.substr(at, comma == std::string::npos ? comma : comma - at));
    if (comma == std::string::npos) return out;
    at = comma + 1;
  }
}

}  // namespace

Source this_source() { return {commit_of_build(), engine::kEngineVersion, cpu_name()}; }

std::string source_line(const Source& source) {
  return "# commit " + source.commit + ", engine " + std::to_string(source.engine_version) + ", machine " + source.machine + '\n';
}

std::optional<Source> source_from_line(const std::string& line) {
  constexpr std::string_view kCommit = "# commit ", kEngine = ", engine ", kMachine = ", machine ";
  const std::size_t engine = line.find(kEngine), machine = line.find(kMachine);
  if (!line.starts_with(kCommit) || engine == std::string::npos || machine == std::string::npos || machine < engine) return std::nullopt;
  Source out;
  out.commit = line.substr(kCommit.size(), engine - kCommit.size());
  const std::size_t at = engine + kEngine.size();
  const auto [end, error] = std::from_chars(line.data() + at, line.data() + machine, out.engine_version);
  if (error != std::errc{} || end != line.data() + machine) return std::nullopt;
  out.machine = line.substr(machine + kMachine.size());
  return out;
}

Report empty_report() { return {this_source(), {}}; }

std::string to_json(const Report& report) {
  Json rows = Json::array();
  for (const Row& row : report.rows) {
    Json one = Json::object();
    for_each_field(row, [&one](const char* name, const auto& value) {
      if (!present(value)) return;
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
        one[name] = rounded(value);
      } else {
        one[name] = value;
      }
    });
    rows.push_back(std::move(one));
  }
  const Json whole = {{"commit", report.source.commit}, {"engine", report.source.engine_version}, {"machine", report.source.machine}, {"rows", std::move(rows)}};
  return whole.dump(1) + '\n';
}

Result<Report, RowsFailure> from_json(const std::string& text) {
  const Json whole = Json::parse(text, nullptr, false);
  if (!whole.is_object() || !whole.contains("rows") || !whole["rows"].is_array())
    return fail(RowsError::not_json, "rows");
  Report out;
  try {
    out.source = {whole.value("commit", "unknown"), whole.value("engine", 0), whole.value("machine", "unknown")};
    for (const Json& one : whole["rows"]) {
      Row row;
      for_each_field(row, [&one](const char* name, auto& value) {
        if (one.contains(name)) one.at(name).get_to(value);
      });
      out.rows.push_back(std::move(row));
    }
  } catch (const nlohmann::json::exception& e) {
    return fail(RowsError::wrong_type, "rows", e.what());
  }
  return out;
}

Result<void, RowsFailure> print_json(const Report& report, const std::string& path) {
  if (path == "-") {
    std::cout << to_json(report);
    return {};
  }
  std::ofstream file(path);
  file << to_json(report);
  file.close();
  if (!file) return fail(RowsError::cannot_open, path);
  return {};
}

Result<Report, RowsFailure> read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) return fail(RowsError::cannot_open, path);
  std::ostringstream text;
  text << file.rdbuf();
  return from_json(text.str());
}

std::string to_csv(const Report& report) {
  std::string out = source_line(report.source);
  std::vector<bool> held;
  for (const Row& row : report.rows) {
    std::size_t i = 0;
    for_each_field(row, [&](const char*, const auto& value) {
      if (i == held.size()) held.push_back(false);
      held[i] = held[i] || present(value);
      ++i;
    });
  }
  const auto line = [&](const Row& row, auto&& cell) {
    std::size_t i = 0;
    bool first = true;
    for_each_field(row, [&](const char* name, const auto& value) {
      if (!held.empty() && !held[i++]) return;
      if (!first) out += ',';
      cell(name, value);
      first = false;
    });
    out += '\n';
  };
  line(Row{}, [&out](const char* name, const auto&) { out += name; });
  for (const Row& row : report.rows)
    line(row, [&out](const char*, const auto& value) {
      if (present(value)) out += csv_text(value);
    });
  return out;
}

Result<Report, RowsFailure> from_csv(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  Report out;
  std::vector<std::string> names;
  while (std::getline(in, line)) {
    if (line.starts_with("# commit ")) {
      const auto source = source_from_line(line);
      if (!source) return fail(RowsError::wrong_type, "first line");
      out.source = *source;
      continue;
    }
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> cells = split(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    if (cells.size() != names.size()) return fail(RowsError::wrong_type, line);
    Row row;
    bool good = true;
    for_each_field(row, [&](const char* name, auto& value) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name && !cells[i].empty()) good = from_text(cells[i], value) && good;
    });
    if (!good) return fail(RowsError::wrong_type, line);
    out.rows.push_back(std::move(row));
  }
  return out;
}

void print_table(const std::vector<Row>& rows, std::ostream& out) {
  const auto number = [&out](double v, int width, int digits) {
    if (std::isnan(v)) {
      out << std::setw(width) << '-';
    } else {
      out << std::setw(width) << std::fixed << std::setprecision(digits) << v;
    }
  };
  out << std::left << std::setw(16) << "method" << std::setw(17) << "shape" << std::setw(7) << "motion" << std::right
      << std::setw(6) << "mm/s" << std::setw(6) << "r" << std::setw(7) << "voxel" << std::setw(8) << "samples"
      << std::setw(9) << "deg" << std::setw(9) << "max" << std::setw(10) << "um" << std::setw(10) << "max"
      << std::setw(9) << "pose um" << std::setw(9) << "max" << std::setw(9) << "step mN" << std::setw(7) << "follow"
      << std::setw(7) << "infeas" << std::setw(10) << "kHz" << std::setw(9) << "p99.9 us" << '\n';
  for (const Row& row : rows) {
    const std::string shape = row.variant.empty() ? row.shape : row.shape + ' ' + row.variant;
    out << std::left << std::setw(16) << row.method << std::setw(17) << shape << std::setw(7)
        << (row.task.empty() ? row.motion : row.task) << std::right;
    number(row.speed_mm_s, 6, 0);
    number(row.bur_radius_mm, 6, 2);
    number(row.voxel_mm, 7, 3);
    number(row.samples < 0 ? kAbsent : static_cast<double>(row.samples), 8, 0);
    number(row.angle_deg_mean, 9, 4);
    number(row.angle_deg_max, 9, 3);
    number(row.depth_um_mean, 10, 4);
    number(row.depth_um_max, 10, 3);
    number(row.pose_um_mean, 9, 2);
    number(row.pose_um_max, 9, 1);
    number(row.force_step_excess_mn_p99, 9, 2);
    number(row.follow_ticks, 7, 1);
    number(row.infeasible_ticks < 0 ? kAbsent : static_cast<double>(row.infeasible_ticks), 7, 0);
    number(row.updates_per_s * 1e-3, 10, 1);
    number(row.tick_us_p999, 9, 1);
    out << (row.unresolved ? "  unresolved\n" : "\n");
  }
}

int write_report(const Report& report, const std::string& json, void (*print)(const std::vector<Row>&)) {
  if (json.empty()) {
    print(report.rows);
    return kDone;
  }
  if (const auto written = print_json(report, json); !written) {
    std::cerr << "cusp-bench: cannot write " << written.error().where << '\n';
    return kFailed;
  }
  return kDone;
}

}  // namespace cusp::bench
