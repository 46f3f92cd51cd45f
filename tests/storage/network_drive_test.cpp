/// Backups and files that travel, on a drive that machines share. Folders named "nfs-drive" pass for NFS.
#include <gtest/gtest.h>
#include <linux/magic.h>
#include <sys/syscall.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <string_view>

#include "storage/backup/backup.h"
#include "tests/storage/two_stations.h"

/// Takes the place of the C library's in this program.
extern "C" int statfs(const char* path, struct statfs* about) noexcept {
  const long status = ::syscall(SYS_statfs, path, about);
  if (status == 0 && std::string_view(path).contains("/nfs-drive")) about->f_type = NFS_SUPER_MAGIC;
  return static_cast<int>(status);
}

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct NetworkDriveTest : TwoStations {
  fs::path share = folder / "nfs-drive";
  void SetUp() override { fs::create_directory(share); }
};

TEST_F(NetworkDriveTest, takes_a_backup_and_gives_it_back_to_a_local_disk_alone) {
  const Backup backup = must(make_backup(station->context(), keeper, share));
  must(restore_backup(backup, folder / "new.db"));
  EXPECT_EQ(code_of(restore_backup(backup, share / "new.db")), StorageError::network_drive);
  EXPECT_EQ(code_of(Store::open(share / "a.db", quick())), StorageError::network_drive);
}

TEST_F(NetworkDriveTest, carries_files_from_station_to_station) {
  trust_each_other();
  must(give_out(station->context(), keeper, ExchangeKind::results, share / "results"));
  must(look_into(office->context(), chief, share / "results"));
  must(read_in(office->context(), chief, share / "results"));
}

}  // namespace
}  // namespace cusp::test
