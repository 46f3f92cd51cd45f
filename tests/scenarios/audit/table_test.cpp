// The audited library, scenarios/audit/library.md, against the exercises as they are set.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

using Cells = std::vector<std::string>;

/// "| a | b |" is {"a", "b"}.
Cells cells_of(const std::string& line) {
  Cells out;
  for (std::size_t at = 2; at < line.size();) {
    const auto end = std::min(line.find(" |", at), line.size());
    out.push_back(line.substr(at, end - at));
    at = end + 3;
  }
  return out;
}

struct Table {
  std::map<std::string, Cells> audited;  // by key: voxels, scores, cost, twice, half, result of the audit
  std::map<std::string, Cells> changed;  // by key: from, to, which is, half of the former, change, half of the new, cost
  int engines = 0;
};

Table read() {
  Table out;
  std::ifstream in(source_dir() / "scenarios/audit/library.md");
  bool second = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("Engine version ")) out.engines = 1 + static_cast<int>(std::ranges::count(line.substr(0, line.find(';')), ','));
    second = second || line.starts_with("## What was changed");
    if (!line.starts_with("| ")) continue;
    Cells cells = cells_of(line);
    const std::string key = cells.front();
    if (key == "exercise") continue;
    cells.erase(cells.begin());
    EXPECT_TRUE((second ? out.changed : out.audited).emplace(key, std::move(cells)).second) << key << " stands there twice";
  }
  return out;
}

/// "+1.6 ± 2.7 (8 attempts)": as far from nothing as it may be. Text: infinite.
double most_of(const std::string& change) {
  if (change.find("parts") != change.npos || change.find("lost") != change.npos) return INFINITY;
  const double score = std::abs(std::atof(change.c_str()));
  const auto error = change.find("± ");
  return error == change.npos ? score : score + std::atof(change.c_str() + error + std::string_view("± ").size());
}

double tolerance_of(const Cells& row) { return std::atof(row[0].c_str() + row[0].find("within ") + 7); }

TEST(AuditTable, HasEveryExerciseWithTheVoxelsThatItIsSetTo) {
  const Table table = read();
  EXPECT_EQ(table.engines, 1) << "measured on one engine";
  EXPECT_EQ(table.audited.size(), builtin_scenarios().size());
  for (const std::string_view name : builtin_scenarios()) {
    const std::string key(name);
    const auto row = table.audited.find(key);
    ASSERT_NE(row, table.audited.end()) << key;
    ASSERT_EQ(row->second.size(), 6u) << key;
    const auto scenario = load_builtin(key);
    ASSERT_TRUE(scenario) << key;
    // 0.078 stands for the paper's 10 / 128 mm.
    EXPECT_NEAR(std::atof(row->second[0].c_str()), scenario->specimen.voxel_mm, 0.0005) << key;
    ASSERT_NE(row->second[0].find("within "), std::string::npos) << key;
    EXPECT_NEAR(tolerance_of(row->second), scenario->tolerance_points, 1e-9) << key;
    EXPECT_EQ(std::ranges::count(row->second[1], ','), 2) << key << ": three operators";
    if (row->second[2].starts_with("by cuts alone")) {
      EXPECT_NE(row->second[2].find("engine version "), std::string::npos) << key;
    }
  }
}

TEST(AuditTable, HalfTheVoxelsChangeNoScoreByMoreThanTheTolerance) {
  for (const auto& [key, row] : read().audited) {
    if (row[4] == "one size") {
      EXPECT_EQ(key, "paper-block");
      continue;
    }
    EXPECT_TRUE(row[4].starts_with('+') || row[4].starts_with('-')) << key;
    EXPECT_LE(most_of(row[4]), tolerance_of(row)) << key;
  }
}

TEST(AuditTable, SomeExerciseIsCoarserAndSomeFinerBecauseOfIt) {
  const Table table = read();
  int coarser = 0, finer = 0;
  for (const auto& [key, row] : table.changed) {
    ASSERT_EQ(row.size(), 7u) << key;
    const auto now = load_builtin(key);
    ASSERT_TRUE(now) << key;
    const double from = std::atof(row[0].c_str()), to = std::atof(row[1].c_str());
    EXPECT_NEAR(to, now->specimen.voxel_mm, 0.0005) << key;
    EXPECT_EQ(row[2], to > from ? "coarser" : "finer") << key;
    // Coarser where it changes nothing; finer where the former did not hold, or grades otherwise. Both hold now.
    if (to > from) {
      EXPECT_LE(most_of(row[4]), now->tolerance_points) << key;
    } else {
      EXPECT_GT(std::max(most_of(row[3]), most_of(row[4])), now->tolerance_points) << key;
    }
    EXPECT_LE(most_of(row[5]), now->tolerance_points) << key;
    (to > from ? coarser : finer) += 1;
  }
  EXPECT_GE(coarser, 1);
  EXPECT_GE(finer, 1);
}

TEST(AuditTable, AMeanIsAsFarOffAsItsStandardErrorMayTakeIt) {
  EXPECT_DOUBLE_EQ(most_of("-1.5"), 1.5);
  EXPECT_DOUBLE_EQ(most_of("+1.6 ± 2.7 (8 attempts)"), 4.3);
  EXPECT_EQ(most_of("+0.1, a pass or fail parts"), INFINITY);
  EXPECT_EQ(cells_of("| a-1 | 0.1 mm; within 2 |  | b |"), (Cells{"a-1", "0.1 mm; within 2", "", "b"}));
}

}  // namespace
}  // namespace cusp::test
