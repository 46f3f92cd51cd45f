// Database::open checks what the file is before it writes anything, then opens it for writing or reading.
#include <sqlite3.h>

#include <array>
#include <chrono>
#include <string_view>
#include <thread>

#include "storage/base/files.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/main_file.h"
#include "storage/sqlite/memory_copy.h"
#include "storage/sqlite/migrate.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;
using Access = DatabaseOptions::Access;

/// Whether a file with content lies at `beside`, a name from SQLite.
bool has_content(const char* beside) {
  std::error_code none;
  const auto size = beside == nullptr ? 0 : fs::file_size(beside, none);
  return !none && size > 0;
}

std::uint32_t header_number(std::span<const std::byte> header, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(header[at + i]);
  return value;
}

/// cut_short if the file ends before the last page that its header counts. SQLite itself does not miss a part of that page.
Stored<void> check_length(sqlite3_file* main, std::span<const std::byte> header, const fs::path& file) {
  const std::uint32_t page = header_number(header, 16) >> 16;  // two bytes; 1 stands for 65536
  // Otherwise a program wrote the file that keeps no count of pages (1.3.7).
  const bool counted = header_number(header, 24) == header_number(header, 92);
  const std::int64_t whole = std::int64_t{header_number(header, 28)} * (page == 1 ? 65536 : page);
  const auto there = size_of(main);
  if (!counted || !there || *there >= whole) return {};
  return fail(StorageError::cut_short, file.string(), std::to_string(*there) + ' ' + std::to_string(whole));
}

/// Checks the file's first hundred bytes, unless a log holds newer pages. Most refused files then keep every byte, and get
/// no log or index beside them. Offsets: SQLite's file format, 1.3.
Stored<void> check_header(sqlite3* database, const fs::path& file, const DatabaseOptions& options) {
  const MainFile main(database);
  if (main.handle() == nullptr || size_of(main.handle()).value_or(0) == 0) return {};
  std::array<std::byte, 100> bytes{};
  const int status = read_at(main.handle(), bytes, 0);
  if (status != SQLITE_OK && status != SQLITE_IOERR_SHORT_READ) return {};  // SQLite reports why it cannot be read
  const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  constexpr std::string_view magic{"SQLite format 3", 16};
  if (status != SQLITE_OK || !text.starts_with(magic)) return fail(StorageError::not_a_database, file.string());
  if (has_content(sqlite3_filename_wal(sqlite3_db_filename(database, "main")))) return {};
  const std::uint32_t application = header_number(bytes, 68), version = header_number(bytes, 60), pages = header_number(bytes, 28);
  if (application == static_cast<std::uint32_t>(kApplicationId)) {
    if (version > options.migrations.size()) return fail(StorageError::newer_schema, file.string(), std::to_string(version));
    if (options.kind == DatabaseOptions::Kind::travelling) return check_length(main.handle(), bytes, file);
  } else if (application != 0 || version != 0 || pages > 1) {
    return fail(StorageError::not_a_database, file.string());
  }
  return {};
}

/// new_file: SQLite sees an empty database.
enum class Owner { cusp, new_file };

Stored<Owner> owner_within(Database& database, std::size_t newest) {
  const auto number = [](Row row) { return row.integer(0); };
  const auto application = database.first("PRAGMA application_id", number);
  if (!application) return std::unexpected(application.error());
  const auto version = database.first("PRAGMA user_version", number);
  if (!version) return std::unexpected(version.error());
  const auto tables = database.first("SELECT count(*) FROM sqlite_schema", number);
  if (!tables) return std::unexpected(tables.error());
  if (application->value_or(0) == kApplicationId) {
    if (version->value_or(0) > static_cast<std::int64_t>(newest)) {
      return fail(StorageError::newer_schema, database.file().string(), std::to_string(version->value_or(0)));
    }
    return Owner::cusp;
  }
  if (application->value_or(0) == 0 && version->value_or(0) == 0 && tables->value_or(0) == 0) return Owner::new_file;
  return fail(StorageError::not_a_database, database.file().string());
}

/// Reads within one transaction: another program may be creating the file.
Stored<Owner> owner_of(Database& database, std::size_t newest) {
  if (auto begun = database.run("BEGIN"); !begun) return std::unexpected(begun.error());
  auto owner = owner_within(database, newest);
  if (database.in_transaction()) static_cast<void>(database.run("ROLLBACK"));
  return owner;
}

/// The folder of the log: SQLite follows links.
fs::path folder_of(const fs::path& file) {
  std::error_code bad;
  const fs::path whole = fs::absolute(file, bad), real = fs::weakly_canonical(whole, bad);
  return (bad ? whole : real).parent_path();
}

/// Whether the log's index could not be created or grown there. Other failures concern the file itself, or pass.
bool lacks_space(const StorageFailure& failure) {
  return out_of_space(failure.code) || failure.code == StorageError::file_too_large ||
         failure.code == StorageError::io || failure.code == StorageError::read_only ||
         failure.code == StorageError::not_found;
}

enum class LeftLog : std::uint8_t { none, without_file, beside_empty_file };

/// A log that lies there without its file, as where records were moved by hand after a crash, or beside one that lost its bytes: SQLite
/// removes it when it begins a file, with all that was written last. Another program that makes the file now makes its log later: the log
/// is looked for first.
LeftLog left_log(const fs::path& file) {
  constexpr std::uintmax_t kHeader = 32;  // file format, 4.1
  std::error_code none;
  const auto bytes = fs::file_size(file.string() + "-wal", none);
  if (none || bytes <= kHeader) return LeftLog::none;
  if (!fs::exists(file, none)) return none ? LeftLog::none : LeftLog::without_file;
  const auto of_file = fs::file_size(file, none);
  return !none && of_file == 0 ? LeftLog::beside_empty_file : LeftLog::none;
}

/// SQLite opens what lies beside, a journal for reading: it would wait for the other end of a pipe.
Stored<void> check_beside(const fs::path& file) {
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    const fs::path beside = file.string() + ending;
    std::error_code none;
    // Asked once: another program may remove its journal between two questions.
    const fs::file_status there = fs::status(beside, none);
    if (!fs::exists(there) || fs::is_regular_file(there)) continue;
    return std::unexpected(failure_from(std::make_error_code(std::errc::invalid_argument), beside));
  }
  return {};
}

Stored<void> check_place(const fs::path& file, const DatabaseOptions& options) {
  std::error_code ignored;
  const fs::file_status there = fs::status(file, ignored);  // asked once: another program may remove its empty file
  const bool existed = fs::exists(there);
  if (ignored == std::errc::permission_denied) return fail(StorageError::read_only, file.string());
  if (!existed && options.access != Access::create) return fail(StorageError::not_found, file.string());
  if (existed && !fs::is_regular_file(there)) return fail(StorageError::not_a_database, file.string());
  const LeftLog left = left_log(file);
  if (!existed && left == LeftLog::without_file) return fail(StorageError::duplicate, file.filename().string() + "-wal", "log");
  if (left == LeftLog::beside_empty_file) return fail(StorageError::corrupt, file.string());
  if (auto good = check_beside(file); !good) return good;
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, ignored)) return fail(StorageError::not_found, folder.string(), "folder");
  const auto& on_network = options.on_network_drive;
  if (on_network ? on_network(folder) : on_network_drive(folder)) {
    return fail(StorageError::network_drive, folder.string());
  }
  return {};
}

}  // namespace

Stored<Database> Database::open(const fs::path& file, const DatabaseOptions& options) {
  if (auto good = check_place(file, options); !good) return std::unexpected(good.error());
  // SQLite waits for a lock, but not if two connections want it exclusively, as two that create one file do.
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(options.busy_timeout_ms);
  while (true) {
    auto opened =
        options.access == Access::read_only ? open_for_reading(file, options) : open_for_writing(file, options);
    const bool busy = !opened && opened.error().code == StorageError::busy;
    if (!busy || std::chrono::steady_clock::now() >= until) return opened;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

Stored<Database> Database::connect(const fs::path& file, int flags, const DatabaseOptions& options) {
  sqlite3* handle = nullptr;
  const char* vfs = options.vfs.empty() ? nullptr : options.vfs.c_str();
  // An absolute path: SQLite would take the name ":memory:" for a database in memory, and one that begins with "file:" for a URI.
  std::error_code ignored;
  const fs::path whole = fs::absolute(file, ignored);
  const int status = sqlite3_open_v2(whole.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_URI, vfs);
  Database database{handle, file, (flags & SQLITE_OPEN_READONLY) != 0 ? Access::read_only : Access::existing};
  if (status != SQLITE_OK) return std::unexpected(failure_of(handle, status, file.string()));
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, options.busy_timeout_ms);
  // Closing must not checkpoint the log of another program's file.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  if (auto good = check_header(handle, file, options); !good) return std::unexpected(good.error());
  return database;
}

Stored<Database> Database::open_for_reading(const fs::path& file, const DatabaseOptions& options) {
  auto in_place = read_in_place(file, options);
  if (in_place) return current(std::move(*in_place), options);
  if (!lacks_space(in_place.error())) return in_place;
  auto copy = copy_in_memory(file, options);
  if (!copy) return std::unexpected(copy.error().code == StorageError::busy ? copy.error() : in_place.error());
  const auto owner = owner_of(*copy, options.migrations.size());
  if (!owner || *owner != Owner::cusp) return std::unexpected(owner ? in_place.error() : owner.error());
  return current(std::move(*copy), options);
}

Stored<Database> Database::read_in_place(const fs::path& file, const DatabaseOptions& options) {
  auto database = connect(file, SQLITE_OPEN_READONLY, options);
  if (!database) return database;
  const auto owner = owner_of(*database, options.migrations.size());
  if (!owner) return std::unexpected(owner.error());
  if (*owner == Owner::new_file) return fail(StorageError::not_a_database, file.string(), "empty");
  return database;
}

Stored<Database> Database::current(Database database, const DatabaseOptions& options) {
  // A copy of gigabytes would take as much memory, and whoever reads a travelling file refuses an older schema.
  if (options.kind == DatabaseOptions::Kind::travelling) return database;
  if (database.schema_version() == static_cast<int>(options.migrations.size())) return database;
  const std::string name = database.file().string();
  sqlite3* handle = nullptr;
  int status = sqlite3_open_v2(":memory:", &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  Database migrated{handle, database.file(), Access::read_only};
  if (status != SQLITE_OK) return std::unexpected(failure_of(handle, status, name));
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_backup* backup = sqlite3_backup_init(handle, "main", database.handle_, "main");
  if (backup == nullptr) return std::unexpected(failure_of(handle, sqlite3_errcode(handle), name));
  sqlite3_backup_step(backup, -1);
  status = sqlite3_backup_finish(backup);
  if (status != SQLITE_OK) return std::unexpected(failure_of(handle, status, name));
  if (auto done = migrate(migrated, options.migrations); !done) return std::unexpected(done.error());
  if (auto done = migrated.run("PRAGMA query_only = ON"); !done) return std::unexpected(done.error());
  return migrated;
}

Stored<Database> Database::copy_in_memory(const fs::path& file, const DatabaseOptions& options) {
  // Opened for writing if possible: only then can the connection lock the file exclusively. It writes nothing.
  auto source = connect(file, SQLITE_OPEN_READWRITE, options);
  if (!source) return source;
  auto copy = memory_copy(source->handle_);
  if (!copy) return std::unexpected(copy.error());
  return Database{*copy, file, Access::read_only};
}

Stored<Database> Database::open_for_writing(const fs::path& file, const DatabaseOptions& options) {
  std::error_code ignored;
  const bool existed = fs::exists(file, ignored);
  // The umask decides the mode of a file that SQLite makes. Log and index get the mode of the main file. If no file can be
  // made, SQLite reports why.
  if (!existed) static_cast<void>(make_private_file(file));
  Stored<void> ready;
  {
    auto database = connect(file, SQLITE_OPEN_READWRITE | (existed ? 0 : SQLITE_OPEN_CREATE), options);
    if (database) {
      ready = prepare_for_writing(*database, options);
      if (ready) return database;
      // Another process created this file too, and has removed its empty one meanwhile.
      if (sqlite3_extended_errcode(database->handle_) == SQLITE_READONLY_DBMOVED)
        ready.error().code = StorageError::busy;
    } else {
      ready = std::unexpected(database.error());
      // Another process has removed its empty file since this one saw it.
      if (existed && options.access == Access::create && !fs::exists(file, ignored)) ready.error().code = StorageError::busy;
    }
  }
  if (!existed) remove_if_empty(file, options);
  // SQLite only reports "cannot open" if it cannot create its log.
  StorageFailure& why = ready.error();
  const bool vague = why.code == StorageError::not_found || why.code == StorageError::io;
  if (vague && (!can_write(folder_of(file)) || (existed && !can_write(file)))) why.code = StorageError::read_only;
  // The folder exists, and still no file was created: some (/sys) admit none, even with all rights.
  if (!existed && why.code == StorageError::not_found) why.code = StorageError::read_only;
  if (!existed && why.code == StorageError::read_only) why.detail = "new file";
  return std::unexpected(why);
}

Stored<void> Database::prepare_for_writing(Database& database, const DatabaseOptions& options) {
  const std::string name = database.file().string();
  if (sqlite3_db_readonly(database.handle_, "main") == 1) return fail(StorageError::read_only, name);
  const auto owner = owner_of(database, options.migrations.size());
  if (!owner) return std::unexpected(owner.error());
  if (*owner == Owner::new_file) {
    if (options.access == Access::existing) return fail(StorageError::not_a_database, name, "empty");
    if (auto done = database.run("PRAGMA page_size = 8192"); !done) return done;
    // So that thinning gives the disk its pages back (storage/retention/thinning.cpp).
    if (auto done = database.run("PRAGMA auto_vacuum = INCREMENTAL"); !done) return done;
  }
  const auto mode = database.first("PRAGMA journal_mode = WAL", [](Row row) { return row.text(0); });
  if (!mode) return std::unexpected(mode.error());
  if (mode->value_or("") != "wal") {
    return fail(StorageError::network_drive, folder_of(database.file()).string(), mode->value_or(""));
  }
  // secure_delete: bytes that a change or an erasure takes from a page are zeroed, not merely set free.
  for (const char* setting : {"PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON", "PRAGMA cell_size_check = ON", "PRAGMA secure_delete = ON"}) {
    if (auto done = database.run(setting); !done) return done;
  }
  if (auto done = migrate(database, options.migrations); !done) return done;
  sqlite3_db_config(database.handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr);
  return {};
}

void Database::remove_if_empty(const fs::path& file, const DatabaseOptions& options) {
  std::error_code ignored;
  if (fs::file_size(file, ignored) != 0 || ignored) return;
  auto database = connect(file, SQLITE_OPEN_READWRITE, options);
  if (!database) return;
  MainFile main(database->handle_);
  if (main.handle() == nullptr || main.lock_shared() != SQLITE_OK || main.lock_exclusive() != SQLITE_OK) return;
  // The lock is exclusive. A process that has opened the file but not read it finds it moved before its first write.
  if (size_of(main.handle()) == 0) fs::remove(file, ignored);
}

}  // namespace cusp::storage
