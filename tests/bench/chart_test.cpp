// Tables: equal rows give equal bytes, and reading restores what was written.
#include "tests/bench/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/bench/names.h"
#include "tests/bench/program.h"
#include "tests/bench/stability.h"
#include "tests/bench/verdict.h"
#include "tests/source_dir.h"

namespace cusp::bench {
namespace {

struct MadeUp {
  double radius_mm, voxel_mm, updates_per_s, angle_deg;
};
Row accuracy_row(std::string_view method, std::string_view shape, const MadeUp& made) {
  Row row;
  row.method = method;
  row.shape = shape;
  row.motion = "slide";
  row.speed_mm_s = 50.0;
  row.bur_radius_mm = made.radius_mm;
  row.voxel_mm = made.voxel_mm;
  row.updates_per_s = made.updates_per_s;
  row.angle_deg_mean = made.angle_deg;
  row.depth_um_mean = made.angle_deg * 0.1;
  return row;
}

/// Every method through every case; the penalty falls through the thin wall.
void add_stability(Report& report) {
  const auto row_in = [](std::string_view method, std::string_view name, GuardUse guard, const Setting& setting) {
    CaseRun what;
    what.key = name;
    what.guard = guard;
    what.setting = setting;
    Row row = row_of(what);
    row.method = method;
    row.runs = 10;
    row.passed_through = method == "penalty" && name == "thin-wall" ? 10 : 0;
    row.stuck = 0;
    row.force_step_mn = row.force_step_p99_mn = row.zero_ms = 1.0;
    row.energy_mj = row.energy_exact_mj = 0.1;
    return row;
  };
  for (const std::string_view method : kMethodNames)
    for (const GuardUse guard : {GuardUse::on, GuardUse::off}) {
      for (std::string_view name : kPressCases) {
        Row& row = report.rows.emplace_back(row_in(method, name, guard, usual_setting()));
        row.k_max_n_per_mm = guard == GuardUse::on ? 2.0 : 0.9;
        row.k_exact_n_per_mm = 1.0;
      }
      for (std::string_view name : kMotionCases) report.rows.push_back(row_in(method, name, guard, {}));
      for (std::string_view name : kFaultCases) report.rows.push_back(row_in(method, name, guard, {}));
    }
  for (const double friction : {0.0, 0.1})
    for (const double damping : {0.5, 2.0, 5.0})
      for (const std::string_view grip : {"none", "soft", "firm"}) {
        Row& row = report.rows.emplace_back(
            row_in("surface", kPressCases[0], GuardUse::off, Setting{0.1, damping, friction, 0.0, grip}));
        row.k_max_n_per_mm = row.k_exact_n_per_mm = damping;
      }
}

void add_samples(Evidence& out) {
  for (const std::string method : {"surface", "occupancy"})
    for (const std::string task : {"displacement", "exploration", "perforation"})
      for (int i = 1; i <= kSamplesATask; ++i) {
        out.pace.samples.push_back({method, task, i * kSampleS, 1e5 + 1e3 * i});
        const double t = i * kSampleS + (task == "exploration" ? 0.4 : task == "perforation" ? 0.8 : 0.0);
        out.motion.samples.push_back({method, task, t, {t, -t, 1.0}, {0.125, 0.0, 0.5 * t}});
      }
}

/// Made up, complete, and of second order above a floor of 0.001 degrees.
Evidence made_up() {
  Evidence out;
  out.accuracy = out.cavity = out.rate = out.scale = out.stability = {{"0123456789abcdef", 9, "A CPU"}, {}};
  out.pace = {{"0123456789abcdef", 9, "A CPU"}, {}};
  out.motion = {{"0123456789abcdef", 9, "A CPU"}, {}};
  double rate = 100e3;
  for (const std::string_view method : kMethodNames) {
    rate *= 1.7;
    for (const double radius : {0.25, 0.5})
      for (const double voxel : {0.2, 0.1, 10.0 / 128, 0.04})
        for (const std::string_view shape : {"face", "sphere", "cylinder"}) {
          const double form = shape == "face" ? 0.0 : 0.5 * voxel * voxel;
          out.accuracy.rows.push_back(
              accuracy_row(method, shape, {radius, voxel, rate * voxel, std::hypot(form, 0.001)}));
        }
    for (const double radius : {0.25, 0.5, 1.15}) {
      Row row = accuracy_row(method, "sphere", {radius, 10.0 / 128, rate / radius, kAbsent});
      row.depth_um_mean = kAbsent;
      row.task = "exploration";
      row.ratio_to_occupancy = 1.0;
      out.rate.rows.push_back(row);
      row.shape = "face";
      out.rate.rows.push_back(row);
      row.task = "perforation";
      row.motion = "";
      row.speed_mm_s = 1.0;
      out.rate.rows.push_back(row);
    }
    for (const double voxel : {0.2, 0.1, 0.04})
      for (const std::string_view shape : {"face", "sphere"}) {
        Row row = accuracy_row(method, shape, {0.5, voxel, rate * voxel, kAbsent});
        row.depth_um_mean = kAbsent;
        row.task = "exploration";
        row.ratio_to_occupancy = 1.0;
        out.rate.rows.push_back(row);
      }
    for (const std::int64_t edge : {128, 256, 1024}) {
      Row row = accuracy_row(method, "block", {0.5, 10.0 / 128, rate, kAbsent});
      row.depth_um_mean = kAbsent;
      row.task = "exploration";
      row.variant = "whole-top";
      row.volume_voxels = edge * edge * edge;
      row.memory_mb = static_cast<double>(edge * edge) * 1e-4;
      row.cost_to_smallest = 1.0 + 1e-5 * static_cast<double>(edge);
      out.scale.rows.push_back(row);
    }
  }
  for (const std::string_view task : {"", "mill"}) {
    Row& row = out.cavity.rows.emplace_back(accuracy_row("surface", "cavity", {0.4, 10.0 / 128, 1e4, 5.8}));
    row.task = task;
    row.minutes = 2.0;
  }
  add_stability(out.stability);
  add_samples(out);
  return out;
}

void write_tables(const std::filesystem::path& folder, const Evidence& evidence) {
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : tables_of(evidence)) std::ofstream(folder / name, std::ios::binary) << text;
}

TEST(Chart, WritesTheSameBytesFromTheTablesThatItWrote) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "cusp_chart_tables";
  const auto first = tables_of(made_up());
  EXPECT_EQ(first.size(), 7u);
  write_tables(folder, made_up());
  const auto read = read_evidence({folder.string()});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->accuracy.rows.size(), made_up().accuracy.rows.size());
  EXPECT_EQ(tables_of(*read), first);
  std::filesystem::remove_all(folder);
}

TEST(Chart, NamesInEachStabilityRowWhatBroke) {
  Options options;
  options.methods = {"surface", "penalty"};
  options.cases = {"start-inside", "jump"};
  options.guards = {"off"};
  options.budget_s = 0.01;
  const std::vector<Row> rows = stability_rows(options);
  ASSERT_FALSE(rows.empty());
  bool any = false;
  for (const Row& row : rows) {
    EXPECT_EQ(row.failures, names_of(failures_of(row))) << row.case_name;
    any = any || !row.failures.empty();
  }
  EXPECT_TRUE(any) << "without a guard a jump leaves its force on";
}

TEST(Chart, TheCommittedStabilityRowsNameWhatTheirFiguresBreak) {
  const auto folder = test::source_dir() / "tests/bench/results";
  const auto read = read_evidence({folder.string()});
  ASSERT_TRUE(read);
  ASSERT_FALSE(read->stability.rows.empty());
  for (const Report* report : {&read->stability, &read->stability_full})
    for (const Row& row : report->rows) EXPECT_EQ(row.failures, names_of(failures_of(row))) << row.method << ' ' << row.case_name;
}

/// Rows of --full: every place in two cells, one of them settled by five sets, and one that has no exact proxy to compare with.
Report full_stability() {
  Report out{{"fedcba9876543210", 9, "A CPU"}, {}};
  for (std::string_view place : kPressCases)
    for (const double exact : {0.5, 2.0, 0.0}) {
      Row& row = out.rows.emplace_back();
      row.method = "surface";
      row.case_name = place;
      row.guard = "off";
      row.sweep = kFullSweep;
      row.k_exact_n_per_mm = exact;
      row.k_max_n_per_mm = 1.05 * exact;
      row.k_sets = exact == 2.0 ? 5 : 1;
      if (row.k_sets > 1) {
        row.k_first_n_per_mm = 2.5;
        row.k_exact_first_n_per_mm = 2.0;
      }
    }
  return out;
}

/// As `rate --task mill --full` writes it.
Report full_mill() {
  Report out{{"0123456789abcdef", 9, "A CPU"}, {}};
  for (const std::string_view axis : {"fixed", "jitter"}) {
    Row& row = out.rows.emplace_back();
    row.sweep = kFullSweep;
    row.method = "surface";
    row.shape = "cavity";
    row.task = "mill";
    row.bur = "pear 330";
    row.axis = axis;
    row.work_us_max = 250.0;
    row.deferred_percent = 0.5;
  }
  return out;
}

TEST(Chart, KeepsTheTablesOfAFullSweepApartAndFindsThemAgain) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "cusp_chart_full";
  Evidence evidence = made_up();
  evidence.stability_full = full_stability();
  evidence.mill_full = full_mill();
  write_tables(folder, evidence);
  const auto read = read_evidence({folder.string()});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->stability_full.rows.size(), full_stability().rows.size());
  EXPECT_EQ(read->stability.rows.size(), evidence.stability.rows.size());
  EXPECT_EQ(read->mill_full.rows.size(), evidence.mill_full.rows.size());
  EXPECT_EQ(read->cavity.rows.size(), evidence.cavity.rows.size());
  EXPECT_EQ(tables_of(*read), tables_of(evidence));
  std::filesystem::remove_all(folder);
}

TEST(Chart, NamesCommitAndMachineInEveryFile) {
  for (const auto& [name, text] : tables_of(made_up())) {
    EXPECT_NE(text.find("A CPU"), std::string::npos) << name;
    EXPECT_NE(text.find("0123456789"), std::string::npos) << name;
  }
}

TEST(Chart, RefusesAFileThatIsNoReport) {
  const auto path = std::filesystem::path(testing::TempDir()) / "cusp_no_report.csv";
  EXPECT_EQ(read_evidence({path.string()}).error().code, ChartError::cannot_read);
  std::ofstream(path) << "not,a,table\n1,2,3,4\n";
  EXPECT_EQ(read_evidence({path.string()}).error().code, ChartError::cannot_read);
  EXPECT_EQ(run_program({"chart", "--from", path.string(), "--out", testing::TempDir()}), kFailed);
  EXPECT_EQ(run_program({"chart"}), kUsage);  // without --out
  std::filesystem::remove(path);
}

TEST(Chart, SortsTheRowsOfOneReportByKind) {
  const Evidence all = made_up();
  Report one = all.accuracy;
  one.rows.insert(one.rows.end(), all.cavity.rows.begin(), all.cavity.rows.end());
  one.rows.insert(one.rows.end(), all.rate.rows.begin(), all.rate.rows.end());
  one.rows.insert(one.rows.end(), all.scale.rows.begin(), all.scale.rows.end());
  one.rows.insert(one.rows.end(), all.stability.rows.begin(), all.stability.rows.end());
  const auto path = std::filesystem::path(testing::TempDir()) / "cusp_one_report.json";
  std::ofstream(path) << to_json(one);
  const auto read = read_evidence({path.string()});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->accuracy.rows.size(), all.accuracy.rows.size());
  EXPECT_EQ(read->cavity.rows.size(), all.cavity.rows.size());
  EXPECT_EQ(read->rate.rows.size(), all.rate.rows.size());
  EXPECT_EQ(read->scale.rows.size(), all.scale.rows.size());
  EXPECT_EQ(read->stability.rows.size(), all.stability.rows.size());
  std::filesystem::remove(path);
}

TEST(Chart, RefusesBrokenLinesInTablesOverTime) {
  const PaceReport pace = made_up().pace;
  const std::string text = to_csv(pace);
  ASSERT_TRUE(pace_from_csv(text));
  EXPECT_EQ(pace_from_csv(text)->samples.size(), pace.samples.size());
  EXPECT_FALSE(pace_from_csv(text + "surface,exploration,0.1\n"));
  EXPECT_FALSE(pace_from_csv(text + "surface,exploration,0.1,nan\n"));
  EXPECT_FALSE(pace_from_csv(text + "surface,exploration,0.1,12x\n"));
  EXPECT_FALSE(pace_from_csv(to_csv(made_up().motion)));
  EXPECT_FALSE(motion_from_csv(text));
}

}  // namespace
}  // namespace cusp::bench
