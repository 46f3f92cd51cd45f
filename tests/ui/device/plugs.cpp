// Devices that a test plugs into a running program: a Falcon, a foot pedal and a SpaceMouse on a umockdev testbed, led by
// lines on standard input, each answered by one line. Has to run under umockdev-wrapper; the program that is to see the
// devices gets UMOCKDEV_DIR from the first line, and the same preload.
//
//   falcon plug | unplug | forget | home | hold X Y Z | sway X Y Z | buttons BITS | frames | homed
//   pedal plug | unplug | down | up
//   mouse plug | unplug | move X Y Z | turn X Y Z | buttons BITS
//
// Places in metres, device's frame; sway goes 2 mm to and fro about the place. forget: homing is lost, as without
// power. Deflections of -350 to 350; a SpaceMouse
// speaks all the time while it is deflected.
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <sstream>
#include <thread>

#include "tests/device/falcon/mock_usb.h"
#include "tests/device/hid/descriptors.h"
#include "tests/device/hid/mock_hid.h"

namespace cusp::test {
namespace {

using falcon::Emulator;
using test::MockBus;
using test::MockFalcon;
using test::MockHid;
using test::MockHidBus;

/// What the hands do, a thousand times a second.
class Hands {
 public:
  Hands(MockFalcon& falcon, MockHid& mouse) : falcon_(falcon), mouse_(mouse), thread_([this] { run(); }) {}
  ~Hands() {
    stop_ = true;
    thread_.join();
  }

  enum class Way { still, home, hold, sway };
  void grip(Way way, Vec3 at) {
    const std::lock_guard lock(mutex_);
    way_ = way;
    at_ = at;
  }
  void cap(test::Bytes report, bool deflected) {
    const std::lock_guard lock(mutex_);
    report_ = std::move(report);
    deflected_ = deflected;
    if (!deflected) mouse_.send(report_);
  }
  void cap_plugged(bool on) {
    const std::lock_guard lock(mutex_);
    deflected_ = deflected_ && on;
  }

 private:
  static constexpr double kStepM = 0.00002;  // a millisecond's way: 20 mm/s
  static constexpr std::uint64_t kReportsEvery = 16;

  void run() {
    for (std::uint64_t i = 0; !stop_; ++i) {
      {
        const std::lock_guard lock(mutex_);
        if (deflected_ && i % kReportsEvery == 0 && mouse_.waiting() < 4) mouse_.send(report_);
        falcon_.with([&](Emulator& falcon) { lead(falcon, i); });
      }
      g_usleep(1000);
    }
  }
  void lead(Emulator& falcon, std::uint64_t i) {
    if (way_ == Way::still) return;
    if (way_ == Way::home) {
      const auto turn = static_cast<double>(i % 400);
      falcon.set_grip({0.0, 0.0, 0.09 + 0.00035 * (turn < 200 ? turn : 400 - turn)});
      if (falcon.homed() != falcon::status::kHomed) return;
      way_ = Way::hold;
      at_ = falcon::kMiddleM;
    }
    Vec3 goal = at_;
    if (way_ == Way::sway) goal.x += 0.002 * std::sin(0.004 * static_cast<double>(i));
    const Vec3 left = goal - falcon.grip_m();
    const double far = glm::length(left);
    falcon.set_grip(far <= kStepM ? goal : falcon.grip_m() + left * (kStepM / far));
  }

  MockFalcon& falcon_;
  MockHid& mouse_;
  std::mutex mutex_;
  Way way_ = Way::still;
  Vec3 at_ = falcon::kMiddleM;
  test::Bytes report_;
  bool deflected_ = false;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

struct Desk {
  MockBus bus;
  MockFalcon falcon{bus, 2, "1-1", "FT000001", {.firmware_running = true, .at_once = true}};
  MockHidBus hid{bus.testbed()};
  MockHid pedal{hid, 3, 0x05f3, 0x00ff, "VEC USB Footpedal", test::vec_descriptor()};
  MockHid mouse{hid, 4, 0x256f, 0xc635, "SpaceMouse Compact", test::space_mouse_descriptor()};
  Hands hands{falcon, mouse};

  std::string lead_falcon(const std::string& act, std::istringstream& arguments) {
    Vec3 at{0.0};
    unsigned bits = 0;
    if (act == "plug") {
      falcon.plug();
    } else if (act == "unplug") {
      falcon.unplug();
    } else if (act == "forget") {
      falcon.with([](Emulator& f) { f.lose_homing(); });
    } else if (act == "home") {
      hands.grip(Hands::Way::home, {});
    } else if ((act == "hold" || act == "sway") && arguments >> at.x >> at.y >> at.z) {
      hands.grip(act == "hold" ? Hands::Way::hold : Hands::Way::sway, at);
    } else if (act == "buttons" && arguments >> bits) {
      falcon.with([bits](Emulator& f) { f.set_buttons(static_cast<std::uint8_t>(bits)); });
    } else if (act == "frames") {
      return std::to_string(falcon.with([](Emulator& f) { return f.frames(); }));
    } else if (act == "homed") {
      return falcon.with([](Emulator& f) { return f.homed(); }) == falcon::status::kHomed ? "yes" : "no";
    } else {
      return "?";
    }
    return "ok";
  }
  std::string lead_pedal(const std::string& act) {
    if (act == "plug") {
      pedal.plug();
    } else if (act == "unplug") {
      pedal.unplug();
    } else if (act == "down") {
      pedal.send({0x02, 0x00});
    } else if (act == "up") {
      pedal.send({0x00, 0x00});
    } else {
      return "?";
    }
    return "ok";
  }
  std::string lead_mouse(const std::string& act, std::istringstream& arguments) {
    int x = 0, y = 0, z = 0;
    unsigned bits = 0;
    if (act == "plug") {
      mouse.plug();
    } else if (act == "unplug") {
      hands.cap_plugged(false);
      mouse.unplug();
    } else if ((act == "move" || act == "turn") && arguments >> x >> y >> z) {
      hands.cap(test::words(act == "move" ? 1 : 2, {x, y, z}), x != 0 || y != 0 || z != 0);
    } else if (act == "buttons" && arguments >> bits) {
      mouse.send({3, static_cast<std::uint8_t>(bits), 0});
    } else {
      return "?";
    }
    return "ok";
  }
};

}  // namespace
}  // namespace cusp::test

int main() {
  cusp::test::Desk desk;
  std::cout << g_getenv("UMOCKDEV_DIR") << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream arguments(line);
    std::string who, act;
    arguments >> who >> act;
    std::cout << (who == "falcon"  ? desk.lead_falcon(act, arguments)
                  : who == "pedal" ? desk.lead_pedal(act)
                  : who == "mouse" ? desk.lead_mouse(act, arguments)
                                   : "?")
              << std::endl;
  }
}
