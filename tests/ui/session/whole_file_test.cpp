// A file that is written beside its name: what a killed program left of it goes with the next one.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "engine/base/ids.h"
#include "tests/modules.h"
#include "tests/storage/sample.h"
#include "ui/session/whole_file.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

TEST(WholeFileTest, ThatWasCutOffGoesADayLaterWithTheNextOfItsName) {
  const Folder folder;
  const fs::path file = folder / "rows.csv", left = file.string() + '.' + Uuid::v7().text(), running = file.string() + '.' + Uuid::v7().text();
  for (const fs::path& part : {left, running}) std::ofstream(part) << "cut off";
  fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(25));
  WholeFile whole(file);
  ASSERT_TRUE(whole.write("rows"));
  ASSERT_TRUE(whole.finish());
  EXPECT_EQ(fs::file_size(file), 4u);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(running)) << "another program may write it";
}

TEST(WholeFileTest, HasNoNameWhenItIsClosed) {
  const Folder folder;
  const fs::path file = folder / "rows.csv";
  WholeFile whole(file);
  ASSERT_TRUE(whole.write("rows"));
  ASSERT_TRUE(whole.close());
  EXPECT_FALSE(fs::exists(file));
  ASSERT_TRUE(whole.finish());
  EXPECT_EQ(fs::file_size(file), 4u);
}

TEST(WholeFileTest, SaysWhenItIsClosedThatTheDiskIsFull) {
  WholeFile whole("/dev/full");
  ASSERT_TRUE(whole.write("rows")) << "they wait in memory";
  EXPECT_FALSE(whole.close());
  EXPECT_FALSE(whole.finish());
}

}  // namespace
}  // namespace cusp::test
