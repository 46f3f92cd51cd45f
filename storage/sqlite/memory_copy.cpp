#include "storage/sqlite/memory_copy.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "storage/sqlite/log_replay.h"
#include "storage/sqlite/main_file.h"
#include "storage/sqlite/statement.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

struct SqliteFree {
  void operator()(void* memory) const noexcept { sqlite3_free(memory); }
};

/// The log's bytes, read through SQLite's file system. Empty if there is no log.
Stored<std::vector<std::byte>> log_of(sqlite3* source, const char* name) {
  std::error_code ignored;
  if (!fs::exists(name, ignored)) return std::vector<std::byte>{};
  sqlite3_vfs* system = nullptr;
  sqlite3_file_control(source, "main", SQLITE_FCNTL_VFS_POINTER, &system);
  if (system == nullptr) return fail(StorageError::io, name);
  std::vector<std::max_align_t> place(static_cast<std::size_t>(system->szOsFile) / sizeof(std::max_align_t) + 1);
  auto* file = reinterpret_cast<sqlite3_file*>(place.data());
  int status = system->xOpen(system, name, file, SQLITE_OPEN_READONLY | SQLITE_OPEN_WAL, nullptr);
  if (status != SQLITE_OK) return std::unexpected(failure_of(nullptr, status, name));
  std::vector<std::byte> bytes(static_cast<std::size_t>(size_of(file).value_or(0)));
  status = read_at(file, bytes, 0);
  file->pMethods->xClose(file);
  if (status != SQLITE_OK) return std::unexpected(failure_of(nullptr, status, name));
  return bytes;
}

using Image = std::unique_ptr<std::byte, SqliteFree>;

/// The file with the log's pages laid over it, in memory of SQLite. Sets `size` to its bytes.
Stored<Image> image_of(sqlite3* source, sqlite3_file* main, std::size_t& size) {
  const char* name = sqlite3_db_filename(source, "main");
  const auto bytes = log_of(source, sqlite3_filename_wal(name));
  if (!bytes) return std::unexpected(bytes.error());
  const CommittedLog log = read_log(*bytes);
  const auto on_disk = static_cast<std::size_t>(size_of(main).value_or(0));
  size = log.page_size > 0 ? std::size_t{log.pages} * log.page_size : on_disk;
  if (on_disk < 100 || size < 100) return fail(StorageError::corrupt, name);
  Image image(static_cast<std::byte*>(sqlite3_malloc64(size)));
  if (!image) return fail(StorageError::out_of_memory, name);
  const std::span<std::byte> all(image.get(), size);
  std::ranges::fill(all, std::byte{0});
  const std::size_t kept = std::min(size, on_disk);
  if (const int status = read_at(main, all.first(kept), 0); status != SQLITE_OK) {
    return std::unexpected(failure_of(nullptr, status, name));
  }
  const std::uint32_t page = std::to_integer<std::uint32_t>(all[16]) << 8 | std::to_integer<std::uint32_t>(all[17]);
  if (log.page_size > 0 && log.page_size != (page == 1 ? 65536 : page)) return fail(StorageError::corrupt, name);
  lay_over(log, *bytes, all);
  // A database in memory has no log: read and write version 1 (file format, 1.3.2).
  all[18] = all[19] = std::byte{1};
  return image;
}

}  // namespace

Stored<sqlite3*> memory_copy(sqlite3* source) {
  const std::string name = sqlite3_db_filename(source, "main");
  MainFile main(source);
  if (main.handle() == nullptr) return fail(StorageError::io, name);
  const bool writable = sqlite3_db_readonly(source, "main") == 0;
  if (const int status = main.lock_shared(); status != SQLITE_OK)
    return std::unexpected(failure_of(nullptr, status, name));
  std::error_code ignored;
  // A smaller index is left over from a full disk: no connection uses it.
  const auto index_stands = [&] {
    constexpr std::uintmax_t kLeast = 32768;  // file format, 4.2: the index grows in blocks of so many bytes
    const auto bytes = fs::file_size(name + "-shm", ignored);
    return !writable && !ignored && bytes >= kLeast;
  };
  if (writable) {
    if (const int status = main.lock_exclusive(); status != SQLITE_OK) {
      return std::unexpected(failure_of(nullptr, status, name));
    }
  } else if (index_stands()) {
    return fail(StorageError::busy, name);
  }
  // The next writer rolls a journal back; until then the pages are inconsistent.
  if (fs::exists(name + "-journal", ignored) && fs::file_size(name + "-journal", ignored) > 0) {
    return fail(StorageError::read_only, name);
  }
  std::size_t size = 0;
  auto image = image_of(source, main.handle(), size);
  if (!image) return std::unexpected(image.error());
  if (index_stands()) return fail(StorageError::busy, name);
  main.unlock();

  sqlite3* copy = nullptr;
  int status = sqlite3_open_v2(":memory:", &copy, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  if (status == SQLITE_OK) {
    // SQLite owns the image from here on, also if it fails.
    status = sqlite3_deserialize(copy, "main", reinterpret_cast<unsigned char*>(image->release()),
                                 static_cast<sqlite3_int64>(size), static_cast<sqlite3_int64>(size),
                                 SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_READONLY);
  }
  if (status != SQLITE_OK) {
    sqlite3_close_v2(copy);
    return std::unexpected(failure_of(nullptr, status, name));
  }
  sqlite3_extended_result_codes(copy, 1);
  sqlite3_db_config(copy, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(copy, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return copy;
}

}  // namespace cusp::storage
