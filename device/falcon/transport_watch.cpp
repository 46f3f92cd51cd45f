#include "device/falcon/transport_watch.h"

#include <algorithm>
#include <atomic>
#include <map>

#include "device/falcon/ftdi.h"
#include "device/falcon/transport_bus.h"

namespace cusp::device::falcon {

namespace {

class UsbWatch final : public FalconWatch {
 public:
  explicit UsbWatch(Context context) : context_(std::move(context)) {
    if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) == 0) return;
    hotplug_ = libusb_hotplug_register_callback(
                   context_.get(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0, kVendor,
                   kProduct, LIBUSB_HOTPLUG_MATCH_ANY, &UsbWatch::on_hotplug, this, nullptr) == LIBUSB_SUCCESS;
  }

  std::vector<FalconOnBus> list() override {
    std::vector<FalconOnBus> out;
    std::map<std::string, Known> known;
    const DeviceList devices(context_.get());
    for (libusb_device* device : devices.all()) {
      libusb_device_descriptor descriptor{};
      if (!is_falcon(device, descriptor)) continue;
      const std::string port = port_of(device);
      const std::string key = port + "/" + std::to_string(libusb_get_device_address(device));
      const auto before = known_.find(key);
      Known one = before == known_.end() ? Known{} : before->second;
      if (before == known_.end() || one.falcon.denied || one.is_asked_again()) {
        one.falcon = look_at(device, descriptor, port);
        const bool unread = !one.falcon.denied && one.falcon.serial.empty() && descriptor.iSerialNumber != 0;
        one.unread = unread ? one.unread + 1 : 0;
      }
      if (one.is_asked_again()) changed_ = true;
      out.push_back(one.falcon);
      known[key] = std::move(one);
    }
    known_ = std::move(known);
    std::sort(out.begin(), out.end(), [](const FalconOnBus& a, const FalconOnBus& b) { return a.port < b.port; });
    for (FalconOnBus& falcon : out) {
      const auto same = std::count_if(out.begin(), out.end(), [&falcon](const FalconOnBus& other) {
        return !falcon.serial.empty() && other.serial == falcon.serial;
      });
      falcon.name = same == 1 ? falcon.serial : falcon.port;  // two devices share the serial number
    }
    return out;
  }

  bool changed() noexcept override {
    if (!hotplug_) return changed_by_list();
    timeval at_once{0, 0};
    libusb_handle_events_timeout_completed(context_.get(), &at_once, nullptr);
    return changed_.exchange(false);
  }

 private:
  /// Times that a serial number is asked for: a device that was just plugged in may not give it yet, and without it another
  /// Falcon's calibration, or none, would count.
  static constexpr int kMostAsked = 10;

  struct Known {
    FalconOnBus falcon;
    int unread = 0;  // times that it did not give the serial number that it has
    bool is_asked_again() const noexcept { return unread > 0 && unread < kMostAsked; }
  };

  static int LIBUSB_CALL on_hotplug(libusb_context*, libusb_device*, libusb_hotplug_event, void* self) {
    static_cast<UsbWatch*>(self)->changed_ = true;
    return 0;
  }

  static FalconOnBus look_at(libusb_device* device, const libusb_device_descriptor& descriptor,
                             const std::string& port) {
    FalconOnBus out;
    out.port = port;
    libusb_device_handle* handle = nullptr;
    const int error = libusb_open(device, &handle);
    out.denied = error == LIBUSB_ERROR_ACCESS;
    if (error == 0) {
      out.serial = serial_of(handle, descriptor);
      libusb_close(handle);
    }
    return out;
  }

  bool changed_by_list() noexcept {
    std::size_t count = 0, sum = 0;
    const DeviceList devices(context_.get());
    for (libusb_device* device : devices.all()) {
      libusb_device_descriptor descriptor{};
      if (!is_falcon(device, descriptor)) continue;
      ++count;
      sum += std::size_t{libusb_get_bus_number(device)} << 8 | libusb_get_device_address(device);
    }
    const bool first = changed_.exchange(false);
    const bool differs = first || count != count_ || sum != sum_;
    count_ = count;
    sum_ = sum;
    return differs;
  }

  Context context_;
  std::map<std::string, Known> known_;  // [port/address]
  bool hotplug_ = false;
  std::atomic<bool> changed_{true};
  std::size_t count_ = 0, sum_ = 0;
};

}  // namespace

Result<std::unique_ptr<FalconWatch>, PortFailure> watch_usb_falcons() {
  auto context = start_libusb();
  if (!context) return std::unexpected(std::move(context.error()));
  return std::make_unique<UsbWatch>(std::move(*context));
}

}  // namespace cusp::device::falcon
