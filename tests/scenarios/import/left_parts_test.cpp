// Parts that killed writers left: the next write into the folder removes them a day later, and nothing else.
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "engine/base/ids.h"
#include "scenarios/blocks/blocks.h"
#include "scenarios/import/binvox.h"
#include "scenarios/import/nrrd.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) out.insert(entry.path().filename().string());
  return out;
}

TEST(LeftParts, OfTheFileGoADayLaterAndAnythingElseStays) {
  const TempFolder folder;
  const std::string id = Uuid::v7().text(), another = Uuid::v7().text();
  const std::set<std::string> parts = {"v.nrrd." + id, "v.nrrd." + id + ".part", "v.nrrd.part-0123456789ab"};
  const std::set<std::string> others = {"w.nrrd." + id + ".part", "v.nrrd.notes.part", "v.nrrd.part", "v.nrrd.part-0123456789", "v.nrrd." + id + ".txt"};
  const std::string running = "v.nrrd." + another + ".part";
  for (const auto& names : {parts, others, std::set{running}}) {
    for (const std::string& name : names) write_text(folder / name, "cut off");
  }
  for (const auto& names : {parts, others}) {
    for (const std::string& name : names) fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(25));
  }
  ASSERT_TRUE(write_nrrd(dexterity_block(0.4), folder / "v.nrrd"));
  std::set<std::string> left = others;
  left.insert(running);
  left.insert("v.nrrd");
  EXPECT_EQ(names_in(folder.path()), left);
}

TEST(LeftParts, OfAnotherFileGoADayLaterIfNobodyElseNamesAFileSo) {
  const TempFolder folder;
  const std::string old = "results.csv.cusp-part-0123456789ab", running = "results.csv.cusp-part-ba9876543210", link = "link.cusp-part-0123456789ab";
  const std::set<std::string> others = {"results.csv.part-0123456789ab",       "results.csv.cusp-part-0123456789AB", "results.csv.cusp-part-0123456789a",
                                        "results.csv.cusp-part-0123456789abc", ".cusp-part-0123456789ab",            "results.csv.cusp-part-0123456789ab.csv"};
  for (const std::string& name : others) write_text(folder / name, "somebody's");
  for (const std::string& name : {old, running}) write_text(folder / name, "cut off");
  fs::create_directory(folder / "folder.cusp-part-0123456789ab");
  fs::create_symlink("results.csv.part-0123456789ab", folder / link);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().filename() != running) fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(25));
  ASSERT_TRUE(write_nrrd(dexterity_block(0.4), folder / "v.nrrd"));
  std::set<std::string> left = others;
  left.insert({running, link, "folder.cusp-part-0123456789ab", "v.nrrd"});
  EXPECT_EQ(names_in(folder.path()), left);
}

TEST(LeftParts, OfABinvoxGoToo) {
  const TempFolder folder;
  const fs::path part = folder / ("v.binvox." + Uuid::v7().text() + ".part");
  write_text(part, "cut off");
  fs::last_write_time(part, fs::file_time_type::clock::now() - std::chrono::hours(25));
  Binvox what;
  what.size = IVec3(1, 1, 1);
  what.scale = 1;
  what.value = {1};
  ASSERT_TRUE(write_binvox(what, folder / "v.binvox"));
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"v.binvox"});
}

}  // namespace
}  // namespace cusp::test
