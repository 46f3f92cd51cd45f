// Volumes of exercises as files, from the records.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <QTemporaryDir>

#include "tests/modules.h"
#include "tests/refused_calls.h"
#include "tests/ui/desk_records.h"
#include "ui/student/exercises.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct Volumes : ::testing::Test {
  DeskRecords records;
  QTemporaryDir cache;
  const fs::path folder = cache.path().toStdString();
  const std::vector<std::byte> bytes = std::vector<std::byte>(8);

  /// An exercise of one volume.
  Exercise exercise() {
    Exercise out;
    out.version = VersionId::make();
    const auto hash = records.store().blobs.put(bytes);
    EXPECT_TRUE(hash);
    if (hash) out.files["tooth.nrrd"] = *hash;
    return out;
  }
};

TEST_F(Volumes, that_cannot_be_written_are_not_called_a_full_disk) {
  std::ofstream(folder / "not-a-folder") << "in the way";
  const auto in = exercise_folder(records.store(), exercise(), folder / "not-a-folder");
  ASSERT_FALSE(in);
  EXPECT_EQ(in.error().code, StorageError::io);
  EXPECT_EQ(in.error().detail, "Not a directory");
}

TEST_F(Volumes, that_a_power_cut_left_empty_are_written_anew) {
  const Exercise one = exercise();
  const auto in = exercise_folder(records.store(), one, folder);
  ASSERT_TRUE(in);
  fs::resize_file(*in / "tooth.nrrd", 0);
  ASSERT_TRUE(exercise_folder(records.store(), one, folder));
  EXPECT_EQ(fs::file_size(*in / "tooth.nrrd"), 8u);
}

TEST_F(Volumes, take_no_name_until_the_disk_holds_them) {
  const fs::path file = folder / "tooth.nrrd";
  ASSERT_TRUE(write_beside(file, std::vector<std::byte>(16)));
  bool refused = false;
  std::string reason;
  std::thread([&] {
    refused = refuse_calls({{SYS_fsync, EIO}});
    if (const auto written = write_beside(file, bytes); !written) reason = written.error().detail;
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  EXPECT_EQ(reason, std::strerror(EIO));
  EXPECT_EQ(fs::file_size(file), 16u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "a part is left";
}

TEST_F(Volumes, are_written_beside_the_part_of_another_program) {
  fs::create_directory(folder / "tooth.nrrd.part");
  EXPECT_TRUE(write_beside(folder / "tooth.nrrd", bytes));
}

}  // namespace
}  // namespace cusp::test
