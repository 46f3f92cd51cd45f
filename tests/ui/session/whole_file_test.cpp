// A file that is written beside its name: what a killed program left of it goes with the next one.
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "engine/base/ids.h"
#include "tests/modules.h"
#include "tests/storage/refused_calls.h"
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

TEST(WholeFileTest, IsOnTheDiskWhenItIsClosed) {
  const Folder folder;
  const fs::path file = folder / "rows.csv";
  bool refused = false;
  std::string reason;
  std::thread([&] {
    WholeFile whole(file);
    refused = whole.write("rows").has_value() && refuse_calls({{SYS_fsync, EIO}});
    if (const auto closed = whole.close(); !closed) reason = closed.error().detail;
    EXPECT_EQ(whole.finish().has_value(), !refused);
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  EXPECT_EQ(reason, std::strerror(EIO));
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace cusp::test
