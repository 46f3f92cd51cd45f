#include "storage/sqlite/database.h"

#include <sqlite3.h>

#include <array>
#include <fstream>
#include <string_view>

#include "storage/files.h"
#include "storage/sqlite/migrate.h"

namespace cusp {
namespace {

namespace fs = std::filesystem;
using Access = DatabaseOptions::Access;

/// "file:" URI of a file on a medium that nobody can write: SQLite then looks for no lock and no log.
std::string immutable_uri(const fs::path& file) {
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : fs::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') || c == '/' ||
        c == '.' || c == '-' || c == '_') {
      uri += c;
    } else {
      uri += '%';
      uri += digits[byte >> 4];
      uri += digits[byte & 15];
    }
  }
  return uri + "?immutable=1";
}

/// What the file's first hundred bytes say where nothing waits in a log: most files that are refused are then never
/// even opened. Offsets: SQLite's file format, 1.3.
Stored<void> check_header(const fs::path& file, std::size_t newest) {
  std::error_code ignored;
  const auto size = fs::file_size(file, ignored);
  if (ignored || size == 0) return {};
  std::array<char, 100> bytes{};
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), bytes.size());
  if (in.gcount() == 0 && !in.eof()) return {};  // SQLite will say why it cannot be read
  constexpr std::string_view magic{"SQLite format 3", 16};
  if (static_cast<std::size_t>(in.gcount()) < bytes.size() || !std::string_view{bytes.data(), 100}.starts_with(magic)) {
    return fail(StorageError::not_a_database, file.string());
  }
  for (const char* log : {"-wal", "-journal"}) {
    const fs::path beside = file.string() + log;
    if (fs::exists(beside, ignored) && fs::file_size(beside, ignored) > 0) return {};
  }
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
  };
  const std::uint32_t application = number(68), version = number(60), pages = number(28);
  if (application == static_cast<std::uint32_t>(kApplicationId)) {
    if (version > newest) {
      return fail(StorageError::newer_schema, file.string(), std::to_string(version));
    }
  } else if (application != 0 || version != 0 || pages > 1) {
    return fail(StorageError::not_a_database, file.string());
  }
  return {};
}

/// Whose file this is. new_file: empty as SQLite sees it.
enum class Owner { cusp, new_file };

Stored<Owner> owner_of(Database& database, std::size_t newest) {
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

}  // namespace

Stored<Database> Database::open(const fs::path& file, const DatabaseOptions& options) {
  std::error_code ignored;
  const bool existed = fs::exists(file, ignored);
  if (ignored == std::errc::permission_denied) return fail(StorageError::read_only, file.string());
  const bool reading = options.access == Access::read_only;
  if (!existed && options.access != Access::create) return fail(StorageError::not_found, file.string());
  if (existed && !fs::is_regular_file(file, ignored)) return fail(StorageError::not_a_database, file.string());
  const fs::path folder = fs::absolute(file, ignored).parent_path();
  if (!fs::is_directory(folder, ignored)) return fail(StorageError::not_found, folder.string(), "folder");
  const auto& on_network = options.on_network_drive;
  if (on_network ? on_network(folder) : on_network_drive(folder)) {
    return fail(StorageError::network_drive, folder.string());
  }

  if (existed) {
    if (auto good = check_header(file, options.migrations.size()); !good) return std::unexpected(good.error());
  }
  const std::size_t newest = options.migrations.size();
  const char* vfs = options.vfs.empty() ? nullptr : options.vfs.c_str();
  const auto connect = [&](const std::string& name, int flags) -> Stored<Database> {
    sqlite3* handle = nullptr;
    const int status = sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX, vfs);
    Database database{handle, file, reading};
    if (status != SQLITE_OK) return std::unexpected(failure_of(handle, status, file.string()));
    sqlite3_extended_result_codes(handle, 1);
    sqlite3_busy_timeout(handle, options.busy_timeout_ms);
    // Until it is known to be ours, closing must not fold another program's log into its file.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    return database;
  };

  if (reading) {
    auto database = connect(file.string(), SQLITE_OPEN_READONLY);
    if (!database) return database;
    auto owner = owner_of(*database, newest);
    const bool no_log = !fs::exists(file.string() + "-wal", ignored);
    if (!owner && owner.error().code != StorageError::not_a_database &&
        owner.error().code != StorageError::newer_schema && no_log) {
      // A folder that cannot be written has no place for the log's index: then nobody else can be writing either.
      auto still = connect(immutable_uri(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
      if (!still) return still;
      owner = owner_of(*still, newest);
      if (!owner) return std::unexpected(owner.error());
      if (*owner == Owner::cusp) return still;
    }
    if (!owner) return std::unexpected(owner.error());
    if (*owner == Owner::new_file) return fail(StorageError::not_a_database, file.string());
    // An older file would have to be migrated first, and may not be.
    if (database->schema_version() != static_cast<int>(newest)) {
      return fail(StorageError::read_only, file.string(), "older schema");
    }
    return database;
  }

  const auto prepare_for_writing = [&](Database& database) -> Stored<void> {
    if (sqlite3_db_readonly(database.handle_, "main") == 1) return fail(StorageError::read_only, file.string());
    const auto owner = owner_of(database, newest);
    if (!owner) return std::unexpected(owner.error());
    if (*owner == Owner::new_file && options.access == Access::existing) {
      return fail(StorageError::not_a_database, file.string());
    }
    if (*owner == Owner::new_file) {
      if (auto done = database.run("PRAGMA page_size = 8192"); !done) return done;
    }
    const auto mode = database.first("PRAGMA journal_mode = WAL", [](Row row) { return row.text(0); });
    if (!mode) return std::unexpected(mode.error());
    if (mode->value_or("") != "wal") return fail(StorageError::network_drive, folder.string(), mode->value_or(""));
    for (const char* setting :
         {"PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON", "PRAGMA cell_size_check = ON"}) {
      if (auto done = database.run(setting); !done) return done;
    }
    if (auto done = migrate(database, options.migrations); !done) return done;
    sqlite3_db_config(database.handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr);
    return {};
  };

  Stored<void> ready;
  {
    auto database = connect(file.string(), SQLITE_OPEN_READWRITE | (existed ? 0 : SQLITE_OPEN_CREATE));
    if (database) {
      ready = prepare_for_writing(*database);
      if (ready) return database;
    } else {
      ready = std::unexpected(database.error());
    }
  }
  // Nothing half written: what this call alone has made, and never got a page, goes again.
  if (!existed && fs::exists(file, ignored) && fs::file_size(file, ignored) == 0) fs::remove(file, ignored);
  // SQLite only says "cannot open" where its log finds no place.
  const bool vague = ready.error().code == StorageError::not_found || ready.error().code == StorageError::io;
  if (vague && (!can_write(folder) || (existed && !can_write(file)))) ready.error().code = StorageError::read_only;
  // The folder is there and still no file came of it: some (/sys) admit none, even to one who may write anything.
  if (!existed && ready.error().code == StorageError::not_found) ready.error().code = StorageError::read_only;
  if (!existed && ready.error().code == StorageError::read_only) ready.error().detail = "new file";
  return std::unexpected(ready.error());
}

Database::~Database() { sqlite3_close_v2(handle_); }
Database::Database(Database&& other) noexcept
    : handle_{std::exchange(other.handle_, nullptr)}, file_{std::move(other.file_)}, read_only_{other.read_only_} {}

int Database::schema_version() {
  const auto version = first("PRAGMA user_version", [](Row row) { return static_cast<int>(row.integer(0)); });
  return version && *version ? **version : 0;
}

Stored<void> Database::script(const std::string& sql) {
  if (const int status = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr); status != SQLITE_OK) {
    return std::unexpected(failure_of(handle_, status));
  }
  return {};
}

std::int64_t Database::changes() const noexcept { return sqlite3_changes64(handle_); }
bool Database::in_transaction() const noexcept { return sqlite3_get_autocommit(handle_) == 0; }

Stored<std::string> Database::integrity_check() {
  const auto lines = all("PRAGMA integrity_check", [](Row row) { return row.text(0); });
  if (!lines) return std::unexpected(lines.error());
  std::string out;
  for (const std::string& line : *lines) {
    if (line != "ok") out += line + "\n";
  }
  return out;
}

Transaction::Transaction(Database& database) : database_{database} {
  if (auto begun = database_.run("BEGIN IMMEDIATE"); begun) {
    open_ = true;
  } else {
    refuse(std::move(begun.error()));
  }
}

Transaction::~Transaction() {
  // Fails only where SQLite has undone it already.
  if (open_ && database_.in_transaction()) static_cast<void>(database_.run("ROLLBACK"));
}

Stored<void> Transaction::commit() {
  if (ok()) {
    if (auto done = database_.run("COMMIT"); !done) refuse(std::move(done.error()));
  }
  if (failure_) {
    if (open_ && database_.in_transaction()) static_cast<void>(database_.run("ROLLBACK"));
    open_ = false;
    return std::unexpected(*failure_);
  }
  open_ = false;
  return {};
}

}  // namespace cusp
