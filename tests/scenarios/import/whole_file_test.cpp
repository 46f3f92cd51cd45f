// A file that is written beside its name: the old one stays or the whole new one, on a full disk, at a power cut and beside another
// writer.
#include "scenarios/import/whole_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <functional>
#include <set>
#include <string>
#include <thread>

#include "engine/base/ids.h"
#include "scenarios/blocks/blocks.h"
#include "scenarios/import/binvox.h"
#include "scenarios/import/nrrd.h"
#include "tests/file_limit.h"
#include "tests/modules.h"
#include "tests/refused_calls.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> entries_of(const TempFolder& folder) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder.path())) out.insert(entry.path().filename().string());
  return out;
}

Binvox one_voxel() {
  Binvox out;
  out.size = IVec3(1, 1, 1);
  out.scale = 1;
  out.value = {1};
  return out;
}

/// The system's reason that a write of this file fails with; empty: it does not.
using FileWriter = std::function<std::string(const fs::path&)>;

/// Everything of scenarios/import that writes a file.
std::vector<FileWriter> file_writers() {
  const auto reason = [](const Result<void, ImportFailure>& done) { return done ? std::string() : done.error().detail; };
  return {[](const fs::path& file) {
            const auto done = write_whole_file(file, "rows");
            return done ? std::string() : done.error().message();
          },
          [reason](const fs::path& file) { return reason(write_nrrd(dexterity_block(0.4), file)); },
          [reason](const fs::path& file) { return reason(write_binvox(one_voxel(), file)); }};
}

TEST(WholeFileTest, ThatWasCutOffGoesADayLaterWithTheNextOfItsName) {
  const TempFolder folder;
  const fs::path file = folder / "rows.csv";
  const std::string left = file.string() + ".part-0123456789ab", running = file.string() + ".part-ba9876543210";
  for (const std::string& part : {left, running}) write_text(part, "cut off");
  fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(25));
  WholeFile whole(file);
  ASSERT_TRUE(whole.write("rows"));
  ASSERT_TRUE(whole.finish());
  EXPECT_EQ(read_text(file), "rows");
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(running)) << "another program may write it";
}

TEST(WholeFileTest, ThatWasKilledBeforeItTookItsNameGoesADayLaterWithTheNextInItsFolder) {
  const TempFolder folder;
  WholeFile killed(folder / "results.csv");
  ASSERT_TRUE(killed.write("rows"));
  ASSERT_TRUE(killed.close());
  const std::string part = *entries_of(folder).begin();
  ASSERT_TRUE(killed.finish());
  fs::rename(folder / "results.csv", folder / part);  // as a program leaves it that is killed after close()
  ASSERT_TRUE(write_whole_file(folder / "other.csv", "rows"));
  EXPECT_TRUE(fs::exists(folder / part));
  fs::last_write_time(folder / part, fs::file_time_type::clock::now() - std::chrono::hours(25));
  ASSERT_TRUE(write_whole_file(folder / "other.csv", "rows"));
  EXPECT_EQ(entries_of(folder), std::set<std::string>{"other.csv"});
}

TEST(WholeFileTest, HasNoNameWhenItIsClosed) {
  const TempFolder folder;
  const fs::path file = folder / "rows.csv";
  WholeFile whole(file);
  ASSERT_TRUE(whole.write("rows"));
  ASSERT_TRUE(whole.close());
  EXPECT_FALSE(fs::exists(file));
  ASSERT_TRUE(whole.finish());
  EXPECT_EQ(entries_of(folder), std::set<std::string>{"rows.csv"});
}

TEST(WholeFileTest, ThatIsNotFinishedLeavesNothing) {
  const TempFolder folder;
  ASSERT_TRUE(WholeFile(folder / "rows.csv").write("rows"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WholeFileTest, FailsWhenItIsClosedOnAFullDisk) {
  WholeFile whole("/dev/full");
  ASSERT_TRUE(whole.write("rows")) << "they wait in memory";
  EXPECT_EQ(whole.close().error().value(), ENOSPC);
  EXPECT_EQ(whole.finish().error().value(), ENOSPC);
}

TEST(WholeFileTest, OfEveryWriterTakesNoNameUntilTheDiskHoldsIt) {
  for (const FileWriter& write : file_writers()) {
    const TempFolder folder;
    write_text(folder / "file", "old");
    bool refused = false;
    std::string reason;
    std::thread([&] {
      refused = refuse_calls({{SYS_fsync, EIO}});
      if (refused) reason = write(folder / "file");
    }).join();
    if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
    EXPECT_EQ(reason, std::strerror(EIO));
    EXPECT_EQ(read_text(folder / "file"), "old");
    EXPECT_EQ(entries_of(folder), std::set<std::string>{"file"});
  }
}

TEST(WholeFileTest, OfEveryWriterThatTheDiskHasNoRoomForLeavesTheOldFile) {
  for (const FileWriter& write : file_writers()) {
    const TempFolder folder;
    write_text(folder / "file", "old");
    EXPECT_EQ(with_files_up_to(3, [&] { return write(folder / "file"); }), std::strerror(EFBIG));
    EXPECT_EQ(read_text(folder / "file"), "old");
    EXPECT_EQ(entries_of(folder), std::set<std::string>{"file"});
    EXPECT_EQ(write(folder / "file"), "");
    EXPECT_NE(read_text(folder / "file"), "old");
  }
}

TEST(WholeFileTest, NamesTheReasonForWhichAStreamWasRefused) {
  const TempFolder folder;
  const auto done = with_files_up_to(100'000, [&] {
    WholeFile whole(folder / "file");
    for (int piece = 0; piece < 4; ++piece) whole.stream() << std::string(50'000, 'x');
    return whole.finish();
  });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().value(), EFBIG);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WholeFileTest, OfTwoWritersAtOnceIsThatOfTheLast) {
  const TempFolder folder;
  WholeFile one(folder / "file"), other(folder / "file");
  ASSERT_TRUE(one.write("one"));
  ASSERT_TRUE(other.write("other"));
  ASSERT_TRUE(one.finish());
  EXPECT_EQ(read_text(folder / "file"), "one");
  ASSERT_TRUE(other.finish());
  EXPECT_EQ(read_text(folder / "file"), "other");
  EXPECT_EQ(entries_of(folder), std::set<std::string>{"file"});
}

TEST(WholeFileTest, OfEveryWriterGoesWhereLinksLeadTo) {
  for (const FileWriter& write : file_writers()) {
    const TempFolder folder;
    fs::create_directory(folder / "disk");
    fs::create_symlink("disk/file", folder / "link");
    fs::create_symlink("link", folder / "second");
    EXPECT_EQ(write(folder / "second"), "") << "a link that leads to no file yet";
    EXPECT_TRUE(fs::is_regular_file(folder / "disk/file"));
    write_text(folder / "disk/file", "old");
    EXPECT_EQ(write(folder / "second"), "");
    EXPECT_NE(read_text(folder / "disk/file"), "old");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "second"));
  }
}

TEST(WholeFileTest, KeepsThePermissionsOfTheOldOne) {
  const TempFolder folder;
  write_text(folder / "file", "old");
  for (const fs::perms own : {fs::perms::owner_read | fs::perms::owner_write, fs::perms::none}) {
    fs::permissions(folder / "file", own);
    ASSERT_TRUE(write_whole_file(folder / "file", "new"));
    EXPECT_EQ(fs::status(folder / "file").permissions(), own);
  }
}

}  // namespace
}  // namespace cusp::test
