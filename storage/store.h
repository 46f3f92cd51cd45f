/// Everything kept on this station, opened in one call. Start here.
/// Thread: one Store per thread; open another on the same file for another thread.
#pragma once

#include <filesystem>
#include <memory>

#include "storage/context.h"
#include "storage/key_state_cache.h"
#include "storage/repositories/assignments.h"
#include "storage/repositories/audit_log.h"
#include "storage/repositories/blobs.h"
#include "storage/repositories/cohorts.h"
#include "storage/repositories/comments.h"
#include "storage/repositories/grades.h"
#include "storage/repositories/history.h"
#include "storage/repositories/metrics.h"
#include "storage/repositories/people.h"
#include "storage/repositories/scenarios.h"
#include "storage/repositories/sessions.h"
#include "storage/repositories/traces.h"

namespace cusp::storage {

struct StoreOptions {
  DatabaseOptions database{};
  UtcClock clock = system_utc_us;
  PasswordCost cost = PasswordCost::interactive();
  std::filesystem::path key_file{};  // of the station's secret key; empty = the database's name with ".key" added
  bool mark_interrupted = true;      // sessions whose process is gone get their event on opening
};

class Store {
 private:
  StorageContext context_;

 public:
  /// Opens or makes the file and the station's key. Where the key's file is gone a new key is made; old signatures are
  /// still checked against the key that they name. A damaged one fails with corrupt, where = its name.
  /// What the rollback counter shows refuses nothing: it stands in context().incident, and for good in the log.
  static Stored<std::unique_ptr<Store>> open(const std::filesystem::path& file, StoreOptions options = {});
  explicit Store(StorageContext context);
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  StorageContext& context() noexcept { return context_; }
  Database& database() noexcept { return context_.db; }

  AuditLog audit;
  Blobs blobs;
  People people;
  Cohorts cohorts;
  Scenarios scenarios;
  Assignments assignments;
  Sessions sessions;
  Traces traces;
  Metrics metrics;
  Grades grades;
  Comments comments;
  History history;
  KeyStateCache key_states;
};

}  // namespace cusp::storage
