#include "storage/sqlite/hold_alone.h"

#include <sqlite3.h>

#include <optional>

#include "storage/sqlite/main_file.h"

namespace cusp::storage {
namespace {

struct Held {
  sqlite3* database = nullptr;
  std::optional<MainFile> main{};

  Held() = default;
  ~Held() {
    main.reset();
    sqlite3_close_v2(database);
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
};

}  // namespace

Stored<std::shared_ptr<void>> hold_alone(const std::filesystem::path& file) {
  std::error_code ignored;
  const auto held = std::make_shared<Held>();
  const std::filesystem::path whole = std::filesystem::absolute(file, ignored);
  if (sqlite3_open_v2(whole.c_str(), &held->database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr) != SQLITE_OK) return held;
  held->main.emplace(held->database);
  if (held->main->handle() == nullptr) return held;
  int status = held->main->lock_shared();
  if (status == SQLITE_OK) status = held->main->lock_exclusive();
  if (status == SQLITE_BUSY) return fail(StorageError::busy, file.string());
  return held;
}

}  // namespace cusp::storage
