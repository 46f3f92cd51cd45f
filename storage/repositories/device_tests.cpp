#include "storage/repositories/device_tests.h"

#include <sstream>

#include "storage/base/text_length.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/key_list.h"

namespace cusp::storage {
namespace {

constexpr std::int64_t kDayUs = 86'400'000'000;
constexpr std::size_t kMostDeviceName = 200;  // characters

/// "falcon passed FT8XYZ": a device's name may hold spaces.
std::string detail_of(const DeviceTest& test) {
  return test.device_class + (test.outcome == TestOutcome::passed ? " passed " : " failed ") + test.device;
}

DeviceTest test_in(Row row) {
  DeviceTest out;
  out.at_utc_us = row.integer(0);
  out.tester = row.id<UserId>(1);
  std::istringstream in(row.text(2));
  std::string outcome;
  in >> out.device_class >> outcome;
  in.ignore();
  std::getline(in, out.device);
  out.outcome = outcome == "passed" ? TestOutcome::passed : TestOutcome::failed;
  return out;
}

}  // namespace

Stored<std::optional<DeviceTest>> newest_device_test(Database& db, std::string_view device_class,
                                                       std::int64_t now_utc_us) {
  return db.first(
      "SELECT at, actor, detail FROM audit_log INDEXED BY audit_by_action WHERE action = 'device_tested' AND action <> 'session_sealed' "
      "AND substr(detail, 1, length(?1) + 1) = ?1 || ' ' AND at <= ?2 ORDER BY number DESC LIMIT 1",
      test_in, device_class, now_utc_us);
}

bool is_recent(const std::optional<DeviceTest>& test, int days, std::int64_t now_utc_us) noexcept {
  return test && test->outcome == TestOutcome::passed && test->at_utc_us <= now_utc_us && now_utc_us - test->at_utc_us <= days * kDayUs;
}

Stored<void> DeviceTests::add(const Actor& actor, const DeviceTest& test) {
  if (auto allowed = require(actor, Action::see_all_results); !allowed) return allowed;
  if (!is_device_class(test.device_class)) return fail(StorageError::bad_value, "device_class");
  if (!has_length(test.device, 0, kMostDeviceName)) return fail(StorageError::bad_value, "device");
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::see_all_results);
  log_event(c_, transaction, {.actor = actor.id, .action = "device_tested", .subject = c_.station, .detail = detail_of(test)});
  return commit_sealed(c_, transaction);
}

}  // namespace cusp::storage
