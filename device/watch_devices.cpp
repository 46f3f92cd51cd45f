#include <chrono>
#include <utility>

#include "device/catalogue.h"
#include "device/falcon/transport_watch.h"
#include "device/inverse/service_probe.h"

namespace cusp::device {
namespace {

class Watch final : public DeviceWatch {
 public:
  explicit Watch(const inverse::ServiceAddress& address) : address_(address) {
    if (auto watch = falcon::watch_usb_falcons()) falcons_ = std::move(*watch);
  }
  std::vector<FoundDevice> list() override {
    std::vector<FoundDevice> out;
    if (falcons_) {
      for (const falcon::FalconOnBus& one : falcons_->list()) {
        out.push_back({.kind = "falcon", .name = one.name, .port = one.port, .denied = one.denied});
      }
    }
    listed_service_ = service();
    if (listed_service_) out.push_back({.kind = "inverse3"});
    return with_software_devices(std::move(out));
  }
  bool changed() noexcept override {
    const bool other = service() != listed_service_;
    if (falcons_) return falcons_->changed() || other;
    return !std::exchange(asked_, true) || other;
  }

 private:
  /// Whether the Inverse3's service listens. Probes every 3 s, each for 0.2 s at most.
  bool service() noexcept {
    const auto now = std::chrono::steady_clock::now();
    if (!probed_ || now - probed_at_ > std::chrono::seconds(3)) {
      probed_ = true;
      probed_at_ = now;
      listens_ = inverse::service_listens(address_);
    }
    return listens_;
  }

  inverse::ServiceAddress address_;
  std::unique_ptr<falcon::FalconWatch> falcons_;
  bool listens_ = false, listed_service_ = false, probed_ = false;
  std::chrono::steady_clock::time_point probed_at_{};
  bool asked_ = false;
};

}  // namespace

std::unique_ptr<DeviceWatch> watch_devices() { return watch_devices_at({}); }

std::unique_ptr<DeviceWatch> watch_devices_at(const inverse::ServiceAddress& service) { return std::make_unique<Watch>(service); }

}  // namespace cusp::device
