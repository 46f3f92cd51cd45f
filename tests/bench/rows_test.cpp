// Files of rows, and exit codes of the program.
#include "tests/bench/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/scene.h"
#include "tests/bench/machine.h"
#include "tests/bench/program.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {
namespace {

Report some() {
  Report report{{"0123456789abcdef", 9, "A CPU (R) @ 2 GHz"}, {}};
  Row row;
  row.method = "surface";
  row.shape = "channel";
  row.variant = "oblique";
  row.motion = "slide";
  row.speed_mm_s = 50.0;
  row.bur_radius_mm = 0.25;
  row.voxel_mm = 0.078125;
  row.seed = 1;
  row.samples = 1234;
  row.skipped = 0;
  row.angle_deg_mean = 0.00213;
  row.infeasible_ticks = 0;
  row.unresolved = true;
  report.rows = {row, Row{}};
  return report;
}

void expect_equal(const Report& a, const Report& b) {
  EXPECT_EQ(a.source, b.source);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    std::vector<std::string> left, right;
    const auto text = [](std::vector<std::string>& out) {
      return [&out](const char*, const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
          out.push_back(value);
        } else {
          out.push_back(std::to_string(value));
        }
      };
    };
    for_each_field(a.rows[i], text(left));
    for_each_field(b.rows[i], text(right));
    EXPECT_EQ(left, right);
  }
}

TEST(Rows, NameTheCommitThatTheProgramWasBuiltFrom) {
  const std::string commit = commit_of_build();
  const std::size_t hex = std::min(commit.find_first_not_of("0123456789abcdef"), commit.size());
  EXPECT_TRUE(commit == "unknown" || (hex == 40 && commit.substr(hex).find_first_not_of('+') == std::string::npos)) << commit;
  EXPECT_EQ(this_source().commit, commit);
}

TEST(Rows, NameCommitEngineVersionAndMachine) {
  const Source source{"0123456789abcdef", 9, "A CPU, machine 2"};
  EXPECT_EQ(source_line(source), "# commit 0123456789abcdef, engine 9, machine A CPU, machine 2\n");
  EXPECT_EQ(source_from_line("# commit 0123456789abcdef, engine 9, machine A CPU, machine 2"), source);
  for (const char* other : {"", "method,shape", "# commit 0123, machine A CPU", "# commit 0123, engine , machine A CPU",
                            "# commit 0123, engine 9a, machine A CPU", "# commit 0123, machine A CPU, engine 9"}) {
    EXPECT_EQ(source_from_line(other), std::nullopt) << other;
  }
  EXPECT_EQ(this_source().engine_version, engine::kEngineVersion);
}

TEST(Rows, ComeBackFromJsonAndFromCsv) {
  const auto json = from_json(to_json(some()));
  ASSERT_TRUE(json);
  expect_equal(some(), *json);
  const auto csv = from_csv(to_csv(some()));
  ASSERT_TRUE(csv);
  expect_equal(some(), *csv);
}

TEST(Rows, LeaveOutAbsentFieldsAndKeepAZero) {
  const std::string text = to_json(some());
  EXPECT_NE(text.find("\"infeasible_ticks\": 0"), std::string::npos);
  EXPECT_EQ(text.find("pose_um_mean"), std::string::npos);
  EXPECT_EQ(text.find("null"), std::string::npos);
}

TEST(Rows, AreRefusedIfTheyAreNoJsonOrHaveWrongTypes) {
  EXPECT_EQ(from_json("{").error().code, RowsError::not_json);
  EXPECT_EQ(from_json("[]").error().code, RowsError::not_json);
  EXPECT_EQ(from_json(R"({"rows": [{"samples": "many"}]})").error().code, RowsError::wrong_type);
  EXPECT_EQ(read_json("/nowhere/rows.json").error().code, RowsError::cannot_open);
  EXPECT_EQ(from_csv("method,samples\nsurface\n").error().code, RowsError::wrong_type);
  EXPECT_EQ(from_csv("method,samples\nsurface,many\n").error().code, RowsError::wrong_type);
}

TEST(TickTimes, GivePercentilesByTheNearestRank) {
  TickTimes times;
  for (int i = 1; i <= 1000; ++i) times.add_ns(i * 1000);
  Row row;
  times.fill(row);
  EXPECT_DOUBLE_EQ(row.tick_us_p50, 500.0);
  EXPECT_DOUBLE_EQ(row.tick_us_p999, 999.0);
  EXPECT_DOUBLE_EQ(row.tick_us_max, 1000.0);
  EXPECT_NEAR(row.updates_per_s, 1000.0 / 0.5005, 1e-3);  // 1 + 2 + … + 1000 us
}

TEST(Program, AnswersWrongUsageWith2AndHelpWith0) {
  EXPECT_EQ(run_program({}), kUsage);
  EXPECT_EQ(run_program({"polish"}), kUsage);
  EXPECT_EQ(run_program({"accuracy", "--method", "best"}), kUsage);
  EXPECT_EQ(run_program({"accuracy", "--shape", "cube"}), kUsage);
  EXPECT_EQ(run_program({"accuracy", "--voxel-mm", "-1"}), kUsage);
  EXPECT_EQ(run_program({"accuracy", "--budget-s", "soon"}), kUsage);
  EXPECT_EQ(run_program({"--help"}), kDone);
  EXPECT_EQ(run_program({"accuracy", "--help"}), kDone);
}

TEST(Program, FailsWith1IfItsFileCannotBeWritten) {
  EXPECT_EQ(run_program({"accuracy", "--shape", "face", "--method", "surface", "--motion", "press", "--voxel-mm", "0.2",
                         "--bur-radius-mm", "0.5", "--budget-s", "0.001", "--json", "/nowhere/rows.json"}),
            kFailed);
}

}  // namespace
}  // namespace cusp::bench
