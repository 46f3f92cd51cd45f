// A FalconPort over an emulated Falcon, ticked in a time of its own.
#pragma once

#include <memory>

#include "device/falcon/falcon_port.h"
#include "tests/device/falcon/rig.h"
#include "tests/modules.h"

namespace cusp::test {

using namespace std::chrono_literals;
using falcon::EmulatedLink;
using falcon::EmulatedLinkSettings;
using falcon::Emulator;
using falcon::EmulatorSettings;
using falcon::LinkTime;

/// With deadlines two periods ahead, as the loop gives them.
struct PortBench {
  explicit PortBench(const EmulatorSettings& device = {.firmware_running = true}, const FalconSettings& settings = {},
                     const EmulatedLinkSettings& line = {})
      : falcon(device) {
    auto made = std::make_unique<EmulatedLink>(falcon, line);
    link = made.get();
    port = std::make_unique<FalconPort>(std::move(made), settings);
  }
  Emulator falcon;
  EmulatedLink* link = nullptr;
  std::unique_ptr<FalconPort> port;
  int fresh = 0, late = 0, gone = 0;

  std::chrono::steady_clock::time_point in(LinkTime time) const {
    return std::chrono::steady_clock::time_point(link->now() + time);
  }
  Sample tick(const Feedback& feedback = {}) {
    const Sample sample = port->wait(in(2ms));
    fresh += sample.status == Sample::Status::fresh;
    late += sample.status == Sample::Status::late;
    gone += sample.status == Sample::Status::gone;
    port->write(feedback);
    return sample;
  }
  /// Out and in, until the samples come fresh.
  bool home() {
    double z = 0.100, step = 0.001;
    for (int i = 0; i < 2000; ++i) {
      z += step;
      if (z > 0.172 || z < 0.080) step = -step;
      falcon.set_grip({0, 0, z});
      if (tick().status == Sample::Status::fresh) return true;
    }
    return false;
  }
};

}  // namespace cusp::test
