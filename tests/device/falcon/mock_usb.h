/// Emulated Falcons behind real libusb: usbfs nodes of a umockdev testbed whose ioctls are answered here. Has to run
/// under umockdev-wrapper. One testbed a process. Its ioctls arrive on a thread of its own.
#pragma once

#include <umockdev.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "device/falcon/emulator.h"
#include "tests/modules.h"

namespace cusp::test {

class MockBus;

/// One Falcon on the mock bus.
class MockFalcon {
 public:
  MockFalcon(MockBus& bus, int address, std::string port, std::string serial, const falcon::EmulatorSettings& settings);
  ~MockFalcon();
  MockFalcon(const MockFalcon&) = delete;
  MockFalcon& operator=(const MockFalcon&) = delete;

  void plug();
  void unplug();

  /// Calls f(Emulator&) while no ioctl runs.
  template <class F>
  auto with(F&& f) {
    const std::lock_guard lock(mutex_);
    return f(falcon_);
  }
  void set_kernel_driver(bool bound) {
    with([&](auto&) { kernel_driver_ = bound; });
  }
  bool kernel_driver() {
    return with([&](auto&) { return kernel_driver_; });
  }
  /// Another program has claimed the interface.
  void set_claimed_elsewhere(bool claimed) {
    with([&](auto&) { claimed_elsewhere_ = claimed; });
  }
  /// It does not give its serial number.
  void hide_serial(bool hidden) {
    with([&](auto&) { serial_hidden_ = hidden; });
  }
  /// The endpoint refuses every transfer until the host clears it.
  void stall(std::uint8_t endpoint) {
    with([&](auto&) { stalled_ = endpoint; });
  }
  std::uint64_t requests() {
    return with([&](auto&) { return requests_; });
  }

 private:
  struct Urb;
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockFalcon* self);
  gboolean ioctl(UMockdevIoctlClient* client);
  bool submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  void reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  void discard(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
  void answer_control(Urb& urb);
  void fill_reads();
  void drop_all();

  MockBus& bus_;
  int address_;
  std::string port_, serial_, node_, syspath_;
  std::mutex mutex_;
  falcon::Emulator falcon_;
  UMockdevIoctlBase* base_ = nullptr;
  std::vector<std::unique_ptr<Urb>> waiting_, done_;
  bool plugged_ = false, attached_ = false, kernel_driver_ = false, claimed_elsewhere_ = false, serial_hidden_ = false;
  unsigned stalled_ = 0;  // endpoint; 0: none
  std::uint64_t requests_ = 0;
};

class MockBus {
 public:
  MockBus() : testbed_(umockdev_testbed_new()) {}
  ~MockBus() { g_object_unref(testbed_); }
  MockBus(const MockBus&) = delete;
  MockBus& operator=(const MockBus&) = delete;
  UMockdevTestbed* testbed() noexcept { return testbed_; }

 private:
  UMockdevTestbed* testbed_;
};

}  // namespace cusp::test
