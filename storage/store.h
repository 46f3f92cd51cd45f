/// All repositories of one database, opened in one call. Start here.
/// Thread: one Store per thread; several threads open several stores on the same file.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "storage/cache/key_state_cache.h"
#include "storage/records/context.h"
#include "storage/repositories/accounts.h"
#include "storage/repositories/assignments.h"
#include "storage/repositories/audit_log.h"
#include "storage/repositories/blobs.h"
#include "storage/repositories/cohorts.h"
#include "storage/repositories/comments.h"
#include "storage/repositories/device_tests.h"
#include "storage/repositories/grades.h"
#include "storage/repositories/metrics.h"
#include "storage/repositories/scenarios.h"
#include "storage/repositories/sessions.h"
#include "storage/repositories/statements.h"
#include "storage/repositories/traces.h"
#include "storage/summary/history.h"

namespace cusp::storage {

/// The station's secret key of a database: beside the file itself, or beside the link that leads to it if the key lies there alone.
std::filesystem::path station_key_file(const std::filesystem::path& database);

/// Whose records stand at the name, from the counter beside their key, which can be read where they cannot. nullopt: nothing names it.
std::optional<Uuid> station_beside(const std::filesystem::path& database);

struct StoreOptions {
  DatabaseOptions database{};
  UtcClock clock = system_utc_us;
  PasswordCost cost = PasswordCost::interactive();
  std::filesystem::path key_file{};  // of the station's secret key; empty: station_key_file() of the database
  bool mark_interrupted = true;      // opening adds the event "interrupted" to sessions whose process has ended
  std::shared_ptr<UnwrittenTries> tries{};  // of another store of the same records; none: its own
};

class Store {
 private:
  StorageContext context_;

 public:
  /// Opens or makes the database and the station's key. If the key file is gone, the store makes a new key; old signatures
  /// are still checked against the keys that they name. corrupt (where = key file, detail = key) if the key file is damaged,
  /// (where = the database) if the database is empty and its counter has counted entries.
  /// Follows links: the key's name is made from that of the file itself. Finishes a restore that was killed between two moves; busy while it
  /// runs.
  /// An incident that the rollback counter shows does not fail: context().incident and the audit log keep it.
  static Stored<std::unique_ptr<Store>> open(const std::filesystem::path& file, StoreOptions options = {});
  explicit Store(StorageContext context);
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  StorageContext& context() noexcept { return context_; }
  Database& database() noexcept { return context_.db; }

  AuditLog audit;
  Blobs blobs;
  Accounts accounts;
  Cohorts cohorts;
  Scenarios scenarios;
  Assignments assignments;
  DeviceTests device_tests;
  Sessions sessions;
  Traces traces;
  Metrics metrics;
  Grades grades;
  Comments comments;
  Statements statements;
  History history;
  KeyStateCache key_states;
};

}  // namespace cusp::storage
