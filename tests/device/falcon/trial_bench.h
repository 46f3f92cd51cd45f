/// An emulated Falcon with a body, under the whole driver, in a time that stands still until somebody waits.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "device/falcon/emulated_body.h"
#include "device/falcon/emulated_link.h"
#include "device/falcon/falcon_port.h"
#include "device/falcon/trial.h"
#include "tests/modules.h"

namespace cusp::test {

using namespace std::chrono_literals;
using falcon::EmulatedBody;
using falcon::EmulatedBodySettings;
using falcon::EmulatedLink;
using falcon::EmulatedLinkSettings;
using falcon::Emulator;
using falcon::FalconLink;
using falcon::LinkTime;
using falcon::Trial;
using falcon::TrialEnd;
using falcon::TrialReading;
namespace status = falcon::status;

struct TrialBench {
  Emulator emulator;
  EmulatedBody body;
  EmulatedLink* link;
  FalconPort port;

  static FalconSettings driver() {
    FalconSettings out;
    out.workspace.scale = 1.0;
    out.buttons = {.cut = status::kCentre, .clutch = 0, .next_bur = 0, .previous_bur = 0};
    return out;
  }
  explicit TrialBench(const EmulatedBodySettings& settings, const EmulatedLinkSettings& line = {})
      : emulator({.firmware_running = true}),
        body(emulator, settings),
        link(new EmulatedLink(emulator, line)),
        port(std::unique_ptr<FalconLink>(link), driver()) {
    link->on_time([this](LinkTime now) { body.advance(now); });
    EXPECT_TRUE(port.open());
    for (int i = 0; i < 10000 && wait().status != Sample::Status::fresh; ++i) port.write({});
    for (int i = 0; i < 1000; ++i) {  // until the ramp is over; a grip with weight lies at its lowest by then
      port.write({});
      wait();
    }
  }
  Sample wait() { return port.wait(std::chrono::steady_clock::time_point(link->now() + 2ms)); }
  /// The workspace stands at scale 1 and yaw 0: the specimen's x, y, z are the device's x, -z, y.
  void push(Vec3 n) { port.write({.force_n = Vec3(n.x, -n.z, n.y)}); }
  TrialReading read() {
    const Sample sample = wait();
    const FalconView& view = port.view();
    return {std::chrono::duration<double>(link->now()).count(), view.grip_m, view.session.encoders, view.torque,
            sample.status == Sample::Status::fresh, sample.status == Sample::Status::gone};
  }
  void run(Trial& trial, int most = 60000) {
    for (int i = 0; i < most && trial.end() == TrialEnd::none; ++i) push(trial.advance(read()));
    push(Vec3(0.0));
  }
};

}  // namespace cusp::test
