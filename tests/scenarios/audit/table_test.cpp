// The table of scenarios/README.md against the exercises as they are set.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "scenarios/library/library.h"

namespace cusp {
namespace {

/// By key: the rest of its row, from the size of its voxels on.
std::map<std::string, std::string> rows() {
  std::map<std::string, std::string> out;
  std::ifstream in(CUSP_SOURCE_DIR "/scenarios/README.md");
  for (std::string line; std::getline(in, line);) {
    for (const std::string_view name : builtin_scenarios()) {
      const std::string key(name);
      const std::string begin = "| " + key + " | ";
      if (!line.starts_with(begin)) continue;
      EXPECT_TRUE(out.emplace(key, line.substr(begin.size())).second) << key << " stands there twice";
    }
  }
  return out;
}

TEST(AuditTable, HasEveryExerciseWithTheVoxelsThatItIsSetTo) {
  const auto table = rows();
  for (const std::string_view name : builtin_scenarios()) {
    const std::string key(name);
    const auto row = table.find(key);
    ASSERT_NE(row, table.end()) << key;
    const auto scenario = load_builtin(key);
    ASSERT_TRUE(scenario) << key;
    // 0.078 stands for the paper's 10 / 128 mm.
    EXPECT_NEAR(std::atof(row->second.c_str()), scenario->specimen.voxel_mm, 0.0005) << key;
  }
}

TEST(AuditTable, NamesTheToleranceOfEveryExercise) {
  for (const auto& [key, row] : rows()) {
    const auto at = row.find("within ");
    ASSERT_NE(at, row.npos) << key;
    EXPECT_NEAR(std::atof(row.c_str() + at + 7), load_builtin(key)->tolerance_points, 1e-9) << key;
  }
}

}  // namespace
}  // namespace cusp
