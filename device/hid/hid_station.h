/// Pedal and SpaceMouse of this station, each on a thread of its own after start(). One per program.
#pragma once

#include <functional>
#include <memory>

#include "device/hid/pedal_reader.h"
#include "device/hid/space_mouse_reader.h"

namespace cusp::device::hid {

class HidStation {
 public:
  /// `make_bus`: make_hidapi_bus (device/hid/transport_hidapi.h), or a test's own.
  explicit HidStation(const std::function<std::unique_ptr<HidBus>()>& make_bus, const PedalSettings& pedal = {},
                      const SpaceMouseSettings& space_mouse = {})
      : pedal_(std::make_shared<PedalReader>(make_bus, pedal)), space_mouse_(make_bus, space_mouse) {}

  void start() {
    pedal_->start();
    space_mouse_.start();
  }

  PedalReader& pedal() noexcept { return *pedal_; }
  /// For RunPlan::pedal.
  std::shared_ptr<const PedalSource> pedal_source() const noexcept { return pedal_; }
  SpaceMouseReader& space_mouse() noexcept { return space_mouse_; }

 private:
  std::shared_ptr<PedalReader> pedal_;
  SpaceMouseReader space_mouse_;
};

}  // namespace cusp::device::hid
