/// HID devices in memory, for a reader under test: a test plugs them in, sends their reports and pulls them out.
#pragma once

#include <algorithm>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "device/hid/hid_bus.h"
#include "tests/device/hid/descriptors.h"
#include "tests/modules.h"

namespace cusp::test {

using hid::HidBus;
using hid::HidDevice;
using hid::HidRead;
using hid::HidReader;

/// What is plugged into a test's computer.
struct Desk {
  struct Plugged {
    HidDevice device;
    std::deque<Bytes> reports;
    bool denied = false;
  };
  std::mutex mutex;
  std::vector<std::shared_ptr<Plugged>> devices;
  std::atomic<int> looks{0};

  std::shared_ptr<Plugged> plug(std::string path, std::uint16_t vendor, std::uint16_t product, Bytes descriptor) {
    auto plugged = std::make_shared<Plugged>();
    plugged->device = {std::move(path), vendor, product, 0, "device", "", std::move(descriptor)};
    const std::lock_guard lock(mutex);
    devices.push_back(plugged);
    return plugged;
  }
  void unplug(const std::shared_ptr<Plugged>& plugged) {
    const std::lock_guard lock(mutex);
    std::erase(devices, plugged);
  }
  void send(const std::shared_ptr<Plugged>& plugged, Bytes report) {
    const std::lock_guard lock(mutex);
    plugged->reports.push_back(std::move(report));
  }
};

class DeskReader final : public HidReader {
 public:
  DeskReader(Desk& desk, std::shared_ptr<Desk::Plugged> plugged) : desk_(desk), plugged_(std::move(plugged)) {}
  HidRead read(std::span<std::uint8_t> into, std::chrono::milliseconds) noexcept override {
    const std::lock_guard lock(desk_.mutex);
    ++desk_.looks;
    if (std::ranges::find(desk_.devices, plugged_) == desk_.devices.end()) return {HidRead::Kind::lost, 0};
    if (plugged_->reports.empty()) return {};
    const Bytes report = plugged_->reports.front();
    plugged_->reports.pop_front();
    std::ranges::copy(report, into.begin());
    return {HidRead::Kind::report, report.size()};
  }

 private:
  Desk& desk_;
  std::shared_ptr<Desk::Plugged> plugged_;
};

class DeskBus final : public HidBus {
 public:
  explicit DeskBus(Desk& desk) : desk_(desk) {}
  std::vector<HidDevice> list() override {
    const std::lock_guard lock(desk_.mutex);
    std::vector<HidDevice> out;
    for (const auto& plugged : desk_.devices) out.push_back(plugged->device);
    return out;
  }
  Result<std::unique_ptr<HidReader>, PortFailure> open(const std::string& path) override {
    const std::lock_guard lock(desk_.mutex);
    for (const auto& plugged : desk_.devices) {
      if (plugged->device.path != path) continue;
      if (plugged->denied) return fail(PortError::no_permission, path);
      return std::make_unique<DeskReader>(desk_, plugged);
    }
    return fail(PortError::not_found, path);
  }

 private:
  Desk& desk_;
};

inline std::function<std::unique_ptr<HidBus>()> bus_of(Desk& desk) {
  return [&desk] { return std::make_unique<DeskBus>(desk); };
}

}  // namespace cusp::test
