/// A session, its link and an emulated Falcon in a time that stands still until somebody waits.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

#include "device/falcon/emulated_link.h"
#include "device/falcon/session.h"
#include "tests/device/falcon/images.h"
#include "tests/modules.h"

namespace cusp::test {

using namespace std::chrono_literals;
using falcon::LinkTime;
using falcon::Phase;

inline falcon::FirmwareImage image() { return *falcon::FirmwareImage::from_bytes(boot_image()); }

struct Rig {
  explicit Rig(const falcon::EmulatorSettings& device = {}, const falcon::EmulatedLinkSettings& line = {},
               const falcon::SessionSettings& driver = {})
      : falcon(device), link(falcon, line), session(driver) {}

  falcon::Emulator falcon;
  falcon::EmulatedLink link;
  falcon::Session session;
  std::set<Phase> seen;
  bool forced = false;  // a packet with torque was sent outside `ready`
  bool forced_ever = false;

  void hand_over() {
    while (const auto ask = session.next_ask()) {
      if (ask->kind == falcon::LinkAsk::Kind::send && ask->size == falcon::kFrameBytes) {
        const auto frame = falcon::decode(std::span<const std::uint8_t, 16>(ask->bytes.data(), 16));
        if (frame && frame->words != std::array<std::int16_t, 3>{}) {
          forced_ever = true;
          if (session.phase() != Phase::ready) forced = true;
        }
      }
      link.start(*ask);
    }
  }
  /// One event.
  void once(LinkTime until) {
    hand_over();
    const auto event = link.wait(std::min(until, std::max(session.due(), link.now())));
    session.advance(event, link.now());
    seen.insert(session.phase());
    hand_over();
  }
  /// Until the phase is reached or so much time has gone by; true when reached.
  bool reach(Phase phase, LinkTime within = 60s) {
    const LinkTime end = link.now() + within;
    while (session.phase() != phase && link.now() < end) once(end);
    return session.phase() == phase;
  }
  /// Exchanges once a millisecond, as a loop does, asking for this torque all the time.
  void run(LinkTime time, std::array<std::int16_t, 3> torque = {1000, -2000, 500}) {
    const LinkTime end = link.now() + time;
    LinkTime tick = link.now();
    while (link.now() < end) {
      while (link.now() < tick) once(tick);
      session.command(torque);
      session.exchange(link.now());
      hand_over();
      tick += 1ms;
    }
  }
  /// Pulls the grip out and pushes it in, 5 mm a tick.
  void home(LinkTime within = 2s) {
    const LinkTime end = link.now() + within;
    double z = 0.100, step = 0.0005;
    while (session.phase() != Phase::ready && link.now() < end) {
      z += step;
      if (z > 0.170 || z < 0.080) step = -step;
      falcon.set_grip({0, 0, z});
      run(1ms);
    }
  }
};

}  // namespace cusp::test
