/// What every repository works with: the database, the clock, the cost of passwords, the station's id and key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "storage/base/clock.h"
#include "storage/base/password.h"
#include "storage/base/process.h"
#include "storage/base/unwritten_tries.h"
#include "storage/records/station_key.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

struct StorageContext {
  Database db;
  UtcClock clock;
  PasswordCost cost;
  Uuid station;
  std::optional<StationKey> key;                    // none if the file was opened read-only
  std::shared_ptr<const ProcessMark> mark{};        // set when this store starts or resumes its first session
  std::filesystem::path key_file{};                 // of the station's secret key
  std::filesystem::path counter_file{};             // rollback_counter.h
  std::optional<StorageFailure> counter_failure{};  // why the counter lags behind the log; none if it does not
  std::optional<std::string> incident{};            // found at opening or by a later write: an action of sealing.h
  std::shared_ptr<UnwrittenTries> tries = std::make_shared<UnwrittenTries>();  // at sign-in, while the file is read-only

  /// The file, beside the database, whose locks show that a session's process still runs.
  std::filesystem::path lock_file() const { return db.file().string() + ".running"; }

  /// Takes the station's next sequence number within the transaction: it orders rows when the clock cannot.
  std::int64_t next_sequence(Transaction& transaction);
};

}  // namespace cusp::storage
