#include <utility>

#include "device/catalogue.h"
#include "device/falcon/transport_libusb.h"

namespace cusp {
namespace {

class Watch final : public DeviceWatch {
 public:
  Watch() {
    if (auto watch = falcon::watch_usb_falcons()) falcons_ = std::move(*watch);
  }
  std::vector<FoundDevice> list() override {
    std::vector<FoundDevice> out;
    if (falcons_) {
      for (const falcon::FalconOnBus& one : falcons_->list()) {
        out.push_back({.kind = "falcon", .name = one.name, .port = one.port, .denied = one.denied});
      }
    }
    return with_those_of_no_hardware(std::move(out));
  }
  bool changed() noexcept override {
    if (falcons_) return falcons_->changed();
    return !std::exchange(asked_, true);
  }

 private:
  std::unique_ptr<falcon::FalconWatch> falcons_;
  bool asked_ = false;
};

}  // namespace

std::unique_ptr<DeviceWatch> watch_devices() { return std::make_unique<Watch>(); }

}  // namespace cusp
