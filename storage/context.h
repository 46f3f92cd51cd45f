/// What every repository works with: the file, the clock, the cost of passwords, and the station's identity and key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "storage/chain.h"
#include "storage/clock.h"
#include "storage/password.h"
#include "storage/process.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

struct StorageContext {
  Database db;
  UtcClock clock;
  PasswordCost cost;
  Uuid station;
  std::optional<StationKey> key;                    // none when the file was opened read-only
  std::shared_ptr<const ProcessMark> mark{};        // from the first session on that this store starts or resumes
  std::filesystem::path counter_file{};             // storage/rollback_counter.h
  std::optional<StorageFailure> counter_failure{};  // why the counter lags behind the log; none when it does not
  std::optional<std::string> incident{};            // what opening or a later write met: an action of storage/sealing.h

  /// Beside the database: holds the locks by which others see that a session's process still runs.
  std::filesystem::path lock_file() const { return db.file().string() + ".running"; }

  /// The station's next sequence number, taken within the transaction: orders what the clock cannot.
  std::int64_t next_sequence(Transaction& transaction);
};

}  // namespace cusp::storage
