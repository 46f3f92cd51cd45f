// Files that are read whole: what is no file, and what is longer than anything that is read, is refused by its name.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <span>
#include <variant>

#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/file_bytes.h"
#include "ui/session/session_setup.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct FileBytes : ::testing::Test {
  Workplace work;
  fs::path file = work.folder / "tooth.nrrd";

  void write(std::string_view text) const { std::ofstream(file, std::ios::binary) << text; }
  StorageError refused(std::uintmax_t most_bytes) const {
    const auto read = text_of_file(file, most_bytes);
    if (read) return StorageError::wrong_state;
    EXPECT_EQ(read.error().where, file.string());
    return read.error().code;
  }
};

TEST_F(FileBytes, AreAllThatTheFileHoldsAsOftenAsItIsRead) {
  std::string text(200'000, 'x');  // more than one piece
  text[70'000] = '\0';
  write(text);
  EXPECT_EQ(text_of_file(file, text.size()).value(), text);
  const auto bytes = bytes_of(file).value();
  EXPECT_TRUE(std::ranges::equal(bytes, std::as_bytes(std::span(text))));
}

TEST_F(FileBytes, OfNoFileAreRefusedBeforeTheyAreRead) {
  EXPECT_EQ(refused(1000), StorageError::not_found);
  fs::create_directory(file);  // opens as a file does; each read of it fails
  EXPECT_EQ(refused(1000), StorageError::io);
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), S_IRUSR | S_IWUSR), 0);  // whoever opens it waits for its other end
  EXPECT_EQ(refused(1000), StorageError::io);
  fs::remove(file);
  fs::create_symlink("/dev/zero", file);  // it has no end
  EXPECT_EQ(refused(1000), StorageError::io);
}

TEST_F(FileBytes, BeyondTheBoundAreRefused) {
  write("tooth");
  EXPECT_EQ(text_of_file(file, 5).value(), "tooth");
  EXPECT_EQ(refused(4), StorageError::file_too_large);
  fs::resize_file(file, kMostVolumeBytes + 1);  // takes no space on the disk
  const auto read = bytes_of(file);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, StorageError::file_too_large);
  EXPECT_EQ(import_failure_of(read.error()).code, ImportError::too_large);
}

TEST_F(FileBytes, ThatCannotBeReadLetNoSessionBeginAndNameTheVolume) {
  SessionPlan plan = work.plan();
  plan.scenario.specimen.generator.clear();
  plan.scenario.specimen.volume = file.filename().string();
  plan.scenario_folder = work.folder;
  fs::create_directory(file);
  const auto begun = set_up(plan, DrillingPort(1).limits());
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().code, SessionError::specimen);
  EXPECT_EQ(begun.error().where, file.string());
  EXPECT_EQ(begun.error().cause, (decltype(SessionFailure::cause)(ImportError::io)));
  EXPECT_TRUE(work.store()->scenarios.library()->empty());
}

}  // namespace
}  // namespace cusp::test
