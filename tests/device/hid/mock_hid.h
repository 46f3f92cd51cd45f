/// HID devices behind the real hidapi: hidraw nodes of a umockdev testbed whose ioctls and reads are answered here. Has to
/// run under umockdev-wrapper. One testbed a process. Its calls arrive on a thread of its own.
#pragma once

#include <umockdev.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <string>

#include "tests/device/hid/descriptors.h"

namespace cusp::test {

class MockHidBus {
 public:
  MockHidBus() : testbed_(umockdev_testbed_new()) {}
  /// Beside other devices, on a testbed that is there already.
  explicit MockHidBus(UMockdevTestbed* testbed) : testbed_(static_cast<UMockdevTestbed*>(g_object_ref(testbed))) {}
  ~MockHidBus() { g_object_unref(testbed_); }
  MockHidBus(const MockHidBus&) = delete;
  MockHidBus& operator=(const MockHidBus&) = delete;
  UMockdevTestbed* testbed() noexcept { return testbed_; }

 private:
  UMockdevTestbed* testbed_;
};

class MockHid {
 public:
  /// `number`: of /dev/hidrawN and of the socket.
  MockHid(MockHidBus& bus, int number, std::uint16_t vendor, std::uint16_t product, std::string name, Bytes descriptor);
  ~MockHid();
  MockHid(const MockHid&) = delete;
  MockHid& operator=(const MockHid&) = delete;

  void plug();
  void unplug();
  /// Queues a report for the next read.
  void send(Bytes report);
  /// Reports that have not been read yet.
  std::size_t waiting();
  std::string path() const { return "/dev/" + node_; }

 private:
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockHid* self);
  static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockHid* self);

  MockHidBus& bus_;
  int number_;
  std::uint16_t vendor_, product_;
  std::string name_, node_, usb_path_;
  Bytes descriptor_;
  UMockdevIoctlBase* base_;
  std::mutex mutex_;
  std::deque<Bytes> reports_;
  bool plugged_ = false, attached_ = false;
};

}  // namespace cusp::test
