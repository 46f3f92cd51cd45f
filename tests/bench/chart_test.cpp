// The pictures: the same rows, the same bytes; what is missing is named; figures that are read are the ones written.
#include "tests/bench/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/bench/names.h"
#include "tests/bench/plot.h"
#include "tests/bench/program.h"
#include "tests/bench/stability.h"

namespace cusp::bench {
namespace {

Row accuracy_row(std::string_view method, std::string_view shape, double radius, double voxel, double rate,
                 double angle) {
  Row row;
  row.method = method;
  row.shape = shape;
  row.motion = "slide";
  row.speed_mm_s = 50.0;
  row.burr_radius_mm = radius;
  row.voxel_mm = voxel;
  row.updates_per_s = rate;
  row.angle_deg_mean = angle;
  row.depth_um_mean = angle * 0.1;
  return row;
}

/// Every method through every case; the penalty falls through the thin wall.
void add_stability(Report& report) {
  const auto row_in = [](std::string_view method, const CaseName& name, bool guard, const Setting& setting) {
    CaseRun what;
    what.key = name.key;
    what.guard = guard;
    what.setting = setting;
    Row row = row_of(what);
    row.method = method;
    row.runs = 10;
    row.passed_through = method == "penalty" && name.key == "thin-wall" ? 10 : 0;
    row.stuck = 0;
    row.force_step_mn = row.force_step_p99_mn = row.zero_ms = 1.0;
    row.energy_mj = row.energy_exact_mj = 0.1;
    return row;
  };
  for (const std::string_view method : kMethodNames)
    for (const bool guard : {true, false}) {
      for (const CaseName& name : kPressCases) {
        Row& row = report.rows.emplace_back(row_in(method, name, guard, usual_setting()));
        row.k_max_n_per_mm = guard ? 2.0 : 0.9;
        row.k_exact_n_per_mm = 1.0;
      }
      for (const CaseName& name : kWayCases) report.rows.push_back(row_in(method, name, guard, {}));
      for (const CaseName& name : kFaultCases) report.rows.push_back(row_in(method, name, guard, {}));
    }
  for (const double friction : {0.0, 0.1})
    for (const double damping : {0.5, 2.0, 5.0})
      for (const std::string_view grip : {"none", "soft", "firm"}) {
        Row& row = report.rows.emplace_back(
            row_in("surface", kPressCases[0], false, Setting{0.1, damping, friction, 0.0, grip}));
        row.k_max_n_per_mm = row.k_exact_n_per_mm = damping;
      }
}

/// Made up, complete, and of second order above a floor of 0.001 degrees.
Evidence made_up() {
  Evidence out;
  out.accuracy = out.rate = out.scale = out.stability = {"0123456789abcdef", "A CPU", {}};
  out.pace = {"0123456789abcdef", "A CPU", {}};
  out.motion = {"0123456789abcdef", "A CPU", {}};
  double rate = 100e3;
  for (const std::string_view method : kMethodNames) {
    rate *= 1.7;
    for (const double radius : {0.25, 0.5})
      for (const double voxel : {0.2, 0.1, 10.0 / 128, 0.04})
        for (const std::string_view shape : {"face", "sphere", "cylinder"}) {
          const double form = shape == "face" ? 0.0 : 0.5 * voxel * voxel;
          out.accuracy.rows.push_back(
              accuracy_row(method, shape, radius, voxel, rate * voxel, std::hypot(form, 0.001)));
        }
    for (const double radius : {0.25, 0.5, 1.15}) {
      Row row = accuracy_row(method, "sphere", radius, 10.0 / 128, rate / radius, kAbsent);
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
        Row row = accuracy_row(method, shape, 0.5, voxel, rate * voxel, kAbsent);
        row.depth_um_mean = kAbsent;
        row.task = "exploration";
        row.ratio_to_occupancy = 1.0;
        out.rate.rows.push_back(row);
      }
    for (const std::int64_t edge : {128, 256, 1024}) {
      Row row = accuracy_row(method, "block", 0.5, 10.0 / 128, rate, kAbsent);
      row.depth_um_mean = kAbsent;
      row.task = "exploration";
      row.variant = "whole-top";
      row.volume_voxels = edge * edge * edge;
      row.memory_mb = static_cast<double>(edge * edge) * 1e-4;
      row.cost_to_smallest = 1.0 + 1e-5 * static_cast<double>(edge);
      out.scale.rows.push_back(row);
    }
  }
  add_stability(out.stability);
  for (const std::string method : {"surface", "occupancy"})
    for (const std::string task : {"displacement", "exploration", "perforation"})
      for (int i = 1; i <= kSamplesATask; ++i) {
        out.pace.samples.push_back({method, task, i * kSampleS, 1e5 + 1e3 * i});
        const double t = i * kSampleS + (task == "exploration" ? 0.4 : task == "perforation" ? 0.8 : 0.0);
        out.motion.samples.push_back({method, task, t, {t, -t, 1.0}, {0.125, 0.0, 0.5 * t}});
      }
  return out;
}

TEST(Chart, draws_the_same_bytes_from_the_same_rows) {
  const auto a = draw_all(made_up());
  const auto b = draw_all(made_up());
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->size(), 16u);
  EXPECT_EQ(*a, *b);
}

TEST(Chart, draws_the_same_from_the_tables_that_it_wrote) {
  const auto first = draw_all(made_up());
  ASSERT_TRUE(first);
  const auto folder = std::filesystem::path(testing::TempDir()) / "cusp_chart_tables";
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : *first) std::ofstream(folder / name, std::ios::binary) << text;
  const auto read = read_evidence({folder.string()});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->accuracy.rows.size(), made_up().accuracy.rows.size());
  const auto again = draw_all(*read);
  ASSERT_TRUE(again);
  for (const auto& [name, text] : *first) EXPECT_TRUE(again->at(name) == text) << name;
  std::filesystem::remove_all(folder);
}

TEST(Chart, marks_what_failed_and_how_stiff_a_wall_may_be) {
  const auto map = stability_map(made_up().stability);
  ASSERT_TRUE(map);
  EXPECT_NE(map->find(">0.9</text>"), std::string::npos);
  EXPECT_NE(map->find(">2</text>"), std::string::npos);
  // Without the penalty's fall, one cell less is tinted; two guards.
  Report whole = made_up().stability;
  for (Row& row : whole.rows) row.passed_through = 0;
  const auto tinted = [](const std::string& text) {
    std::size_t n = 0;
    for (std::size_t at = text.find("#FBE3D2"); at != std::string::npos; at = text.find("#FBE3D2", at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(tinted(*map), 2u);
  EXPECT_EQ(tinted(*stability_map(whole)), 0u);
}

/// Rows of --full: every place in two cells, one of them settled by five sets, and one that has no exact proxy to compare with.
Report full_stability() {
  Report out{"fedcba9876543210", "A CPU", {}};
  for (const CaseName& place : kPressCases)
    for (const double exact : {0.5, 2.0, 0.0}) {
      Row& row = out.rows.emplace_back();
      row.method = "surface";
      row.case_name = place.key;
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

TEST(Chart, draws_every_cell_of_a_full_sweep_where_there_was_one) {
  Evidence evidence = made_up();
  EXPECT_EQ(draw_all(evidence)->count("stability-cells.svg"), 0u);
  evidence.stability_full = full_stability();
  const auto drawn = draw_all(evidence);
  ASSERT_TRUE(drawn);
  const std::string& picture = drawn->at("stability-cells.svg");
  EXPECT_NE(picture.find("12 cells"), std::string::npos);
  EXPECT_NE(picture.find("Beyond 15 %: 0."), std::string::npos);
  EXPECT_NE(picture.find("6 cells by the medians"), std::string::npos);
  EXPECT_NE(picture.find("by their first set 6 would be beyond"), std::string::npos);
  // Its rows are of no account to the map, which is of the usual device.
  EXPECT_EQ(drawn->at("stability-map.svg"), draw_all(made_up())->at("stability-map.svg"));
  evidence.stability_full.rows.front().k_max_n_per_mm = 0.6;
  EXPECT_NE(stiffness_by_cell(evidence.stability_full)->find("Beyond 15 %: 1."), std::string::npos);
  std::erase_if(evidence.stability_full.rows, [](const Row& r) { return r.case_name == "pit"; });
  EXPECT_NE(stiffness_by_cell(evidence.stability_full).error().where.find("pit"), std::string::npos);
}

TEST(Chart, keeps_the_tables_of_a_full_sweep_apart_and_finds_them_again) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "cusp_chart_full";
  std::filesystem::create_directories(folder);
  Evidence evidence = made_up();
  evidence.stability_full = full_stability();
  const auto drawn = draw_all(evidence);
  ASSERT_TRUE(drawn);
  for (const auto& [name, text] : *drawn) std::ofstream(folder / name, std::ios::binary) << text;
  const auto read = read_evidence({folder.string()});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->stability_full.rows.size(), full_stability().rows.size());
  EXPECT_EQ(read->stability.rows.size(), evidence.stability.rows.size());
  EXPECT_EQ(*draw_all(*read), *drawn);
  std::filesystem::remove_all(folder);
}

TEST(Chart, names_commit_and_machine_in_every_file) {
  const auto files = draw_all(made_up());
  ASSERT_TRUE(files);
  for (const auto& [name, text] : *files) {
    EXPECT_NE(text.find("A CPU"), std::string::npos) << name;
    EXPECT_NE(text.find("0123456789"), std::string::npos) << name;
  }
}

TEST(Chart, shows_every_voxel_size_that_was_measured) {
  const Evidence e = made_up();
  const auto picture = speed_against_accuracy(e.accuracy, e.rate, 0.5);
  ASSERT_TRUE(picture);
  for (const char* size : {">0.2</text>", ">0.1</text>", ">0.078</text>", ">0.04</text>"})
    EXPECT_NE(picture->find(size), std::string::npos) << size;
  EXPECT_EQ(speed_against_accuracy(e.accuracy, e.rate, 0.25)->find(">0.078</text>"), std::string::npos);
}

TEST(Chart, says_what_is_missing_instead_of_drawing_without_it) {
  const auto failure_without = [](auto&& remove) {
    Evidence evidence = made_up();
    remove(evidence);
    const auto drawn = draw_all(evidence);
    EXPECT_FALSE(drawn);
    if (drawn) return std::string();
    EXPECT_EQ(drawn.error().code, ChartError::missing_rows);
    return drawn.error().where;
  };
  const auto drop = [](Report& report, auto&& which) { std::erase_if(report.rows, which); };
  EXPECT_NE(failure_without([&](Evidence& e) { e.accuracy.rows.clear(); }).find("accuracy"), std::string::npos);
  EXPECT_NE(failure_without([&](Evidence& e) {
              drop(e.accuracy, [](const Row& r) { return r.shape == "cylinder"; });
            }).find("cylinder"),
            std::string::npos);
  EXPECT_NE(failure_without([&](Evidence& e) {
              drop(e.rate, [](const Row& r) { return r.method == "surface"; });
            }).find("rate"),
            std::string::npos);
  EXPECT_NE(failure_without([&](Evidence& e) { e.scale.rows.clear(); }).find("scale"), std::string::npos);
  EXPECT_NE(failure_without([&](Evidence& e) {
              drop(e.stability, [](const Row& r) { return r.method == "ray" && r.case_name == "islands"; });
            }).find("islands"),
            std::string::npos);
  EXPECT_NE(failure_without([&](Evidence& e) {
              drop(e.stability, [](const Row& r) { return r.grip == "firm"; });
            }).find("firm"),
            std::string::npos);
  EXPECT_NE(failure_without([](Evidence& e) {
              std::erase_if(e.pace.samples, [](const PaceSample& s) { return s.task == "perforation"; });
            }).find("perforation"),
            std::string::npos);
  EXPECT_NE(failure_without([](Evidence& e) { e.motion.samples.clear(); }).find("motion"), std::string::npos);
}

TEST(Chart, writes_its_table_between_the_marks_of_a_readme_and_nothing_else) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "cusp_chart_readme";
  std::filesystem::create_directories(folder);
  const auto files = draw_all(made_up());
  ASSERT_TRUE(files);
  for (const auto& [name, text] : *files) std::ofstream(folder / name, std::ios::binary) << text;
  const auto readme = folder / "README.md";
  const std::string before = "before\n" + std::string(kTableBegin);
  const std::string between = std::string(kTableEnd) + "between\n" + std::string(kStabilityBegin);
  const std::string after = std::string(kStabilityEnd) + "after\n";
  std::ofstream(readme) << before << "old\n" << between << "old too\n" << after;
  const std::vector<std::string> args = {"chart",         "--from",   folder.string(), "--out",
                                         folder.string(), "--readme", readme.string()};
  ASSERT_EQ(run_program(args), kDone);
  std::ifstream file(readme);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(text, before + files->at("methods.md") + between + files->at("stability.md") + after);
  std::ofstream(readme) << "no marks\n";
  EXPECT_EQ(run_program(args), kFailed);
  std::filesystem::remove_all(folder);
}

TEST(Chart, the_committed_results_are_what_their_tables_draw) {
  const auto folder = std::filesystem::path(CUSP_SOURCE_DIR) / "tests/bench/results";
  const auto read = read_evidence({folder.string()});
  ASSERT_TRUE(read);
  const auto drawn = draw_all(*read);
  ASSERT_TRUE(drawn) << drawn.error().where;
  const auto text_of = [](const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(file)), {});
  };
  for (const auto& [name, text] : *drawn) EXPECT_TRUE(text_of(folder / name) == text) << name;
  for (const char* table : {"methods.md", "stability.md"})
    EXPECT_NE(text_of(std::filesystem::path(CUSP_SOURCE_DIR) / "README.md").find(drawn->at(table)), std::string::npos)
        << table;
}

TEST(Chart, refuses_what_is_no_report) {
  const auto path = std::filesystem::path(testing::TempDir()) / "cusp_no_report.csv";
  EXPECT_EQ(read_evidence({path.string()}).error().code, ChartError::cannot_read);
  std::ofstream(path) << "not,a,table\n1,2,3,4\n";
  EXPECT_EQ(read_evidence({path.string()}).error().code, ChartError::cannot_read);
  EXPECT_EQ(run_program({"chart", "--from", path.string(), "--out", testing::TempDir()}), kFailed);
  EXPECT_EQ(run_program({"chart"}), kUsage);  // without --out
  std::filesystem::remove(path);
}

TEST(Chart, rows_of_one_report_go_to_their_kinds) {
  const Evidence all = made_up();
  Report one = all.accuracy;
  one.rows.insert(one.rows.end(), all.rate.rows.begin(), all.rate.rows.end());
  one.rows.insert(one.rows.end(), all.scale.rows.begin(), all.scale.rows.end());
  one.rows.insert(one.rows.end(), all.stability.rows.begin(), all.stability.rows.end());
  const auto path = std::filesystem::path(testing::TempDir()) / "cusp_one_report.json";
  std::ofstream(path) << to_json(one);
  const auto read = read_evidence({path.string()});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->accuracy.rows.size(), all.accuracy.rows.size());
  EXPECT_EQ(read->rate.rows.size(), all.rate.rows.size());
  EXPECT_EQ(read->scale.rows.size(), all.scale.rows.size());
  EXPECT_EQ(read->stability.rows.size(), all.stability.rows.size());
  std::filesystem::remove(path);
}

TEST(Chart, tables_over_time_refuse_broken_lines) {
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

TEST(Chart, fits_the_order_of_a_power) {
  // error = 3 h^2, exactly.
  EXPECT_NEAR(fitted_order({{0.2, 0.12}, {0.1, 0.03}, {0.05, 0.0075}}), 2.0, 1e-12);
  EXPECT_NEAR(fitted_order({{0.2, 0.2}, {0.1, 0.1}}), 1.0, 1e-12);
}

TEST(Chart, fits_second_order_above_the_face_s_error) {
  const auto picture = error_against_voxel(made_up().accuracy);
  ASSERT_TRUE(picture);
  EXPECT_NE(picture->find("order 2.0"), std::string::npos);
}

TEST(Svg, writes_letters_that_no_reader_takes_for_marks) {
  Svg svg(100.0, 50.0, "a < b", "c & d");
  svg.text({1.0, 2.0}, "\"<&>\"");
  const std::string text = svg.str();
  EXPECT_NE(text.find("<title>a &lt; b</title>"), std::string::npos);
  EXPECT_NE(text.find(">&quot;&lt;&amp;&gt;&quot;</text>"), std::string::npos);
}

TEST(Svg, writes_numbers_to_a_hundredth_without_needless_digits) {
  EXPECT_EQ(pixels(12.0), "12");
  EXPECT_EQ(pixels(12.345), "12.35");
  EXPECT_EQ(pixels(12.30), "12.3");
  EXPECT_EQ(pixels(-0.001), "0");
}

TEST(Plot, letters_numbers_as_people_read_them) {
  EXPECT_EQ(short_number(62e3), "62 k");
  EXPECT_EQ(short_number(1.5e6), "1.5 M");
  EXPECT_EQ(short_number(671234.0), "671 k");
  EXPECT_EQ(short_number(0.25), "0.25");
  EXPECT_EQ(short_number(0.0), "0");
}

TEST(Plot, decades_hold_every_value) {
  const Axis axis = decades("", {0.002, 37.0});
  EXPECT_DOUBLE_EQ(axis.low, 0.001);
  EXPECT_DOUBLE_EQ(axis.high, 100.0);
  EXPECT_DOUBLE_EQ(axis.place(0.001), 0.0);
  EXPECT_DOUBLE_EQ(axis.place(100.0), 1.0);
  EXPECT_NEAR(axis.place(0.1), 0.4, 1e-12);
}

}  // namespace
}  // namespace cusp::bench
