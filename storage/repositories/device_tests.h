/// Self-tests of this station's devices. Each is an entry of the audit log: device class, outcome and the device's name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "storage/base/rights.h"
#include "storage/records/context.h"

namespace cusp::storage {

enum class TestOutcome : std::uint8_t { passed, failed };

struct DeviceTest {
  std::string device_class{};  // DeviceLimits::device_class
  std::string device{};        // serial number or name
  TestOutcome outcome = TestOutcome::passed;
  UserId tester{};
  std::int64_t at_utc_us = 0;
};

/// The newest test of the device class on this station, by its number in the log; none before the first. Reads the tests by an index.
/// A test that a wrong clock dated after `now_utc_us` says nothing of today: it is passed over.
Stored<std::optional<DeviceTest>> newest_device_test(Database& db, std::string_view device_class, std::int64_t now_utc_us);

/// Whether `test` passed at most `days` days before `now_utc_us`, and not after it.
bool is_recent(const std::optional<DeviceTest>& test, int days, std::int64_t now_utc_us) noexcept;

class DeviceTests {
 public:
  explicit DeviceTests(StorageContext& context) : c_{context} {}
  /// Sets tester and time. Needs see_all_results, as staff have. bad_value (where = device_class, device).
  Stored<void> add(const Actor& actor, const DeviceTest& test);
  Stored<std::optional<DeviceTest>> newest(std::string_view device_class) {
    return newest_device_test(c_.db, device_class, c_.clock());
  }

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
