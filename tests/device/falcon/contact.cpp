// falcon_contact: what a technician runs on the first real Falcon (device/falcon/README.md, "First contact"). Speaks in
// keys and figures. With --emulated it runs on the emulated one, in no time: that is how it is tested.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "device/falcon/emulated_link.h"
#include "device/falcon/falcon_port.h"
#include "device/falcon/transport_libusb.h"
#include "device/falcon/transport_watch.h"
#include "tests/device/falcon/images.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using falcon::LinkTime;

constexpr const char* kUsage =
    "falcon_contact list\n"
    "falcon_contact watch SECONDS            rate, losses, place, buttons once a second\n"
    "falcon_contact push FX FY FZ SECONDS    newtons in the device's frame: x right, y up, z to the user\n"
    "falcon_contact angle X Y Z              trim that makes the place where the grip is now be this one, metres\n"
    "falcon_contact weigh                    holds nine places softly: weight of grip and arms\n"
    "falcon_contact hold FX FY FZ            travel during silences of 5 to 320 ms after a push\n"
    "  --name NAME   --image FILE   --gain G   --event-character   --emulated\n";

struct Options {
  std::vector<std::string> arguments;
  std::string name, image;
  double gain = 1.0;
  bool event_character = false, emulated = false;
};

/// What hangs on the emulated grip after homing: a mass with friction, and the weight that `weigh` is to find again.
struct Body {
  falcon::Emulator& emulator;
  Vec3 at_m, speed{0.0};
  LinkTime before;
  static constexpr falcon::GravityCalibration kWeight{0.2, 0.003};

  void live(LinkTime now) {
    constexpr double kMassKg = 0.3, kFrictionNsPerM = 4.0;
    for (; before < now; before += 100us) {
      const auto legs = falcon::inverse({}, at_m);
      const auto rows = legs ? falcon::jacobian({}, *legs) : std::nullopt;
      if (!rows) return;
      const Vec3 weight = falcon::force_n(*rows, falcon::gravity_torque_nm({}, {at_m, *legs, *rows}, kWeight));
      speed += (emulator.force_n(before) - weight - speed * kFrictionNsPerM) / kMassKg * 1e-4;
      at_m += speed * 1e-4;
      emulator.set_grip(at_m);
    }
  }
};

/// The link and port of one run, and on the emulated device a hand that homes it.
struct Contact {
  std::unique_ptr<falcon::Emulator> emulator;
  std::optional<Body> body;  // the link's clock moves it: outlives the port
  falcon::FalconLink* link = nullptr;
  std::unique_ptr<FalconPort> port;
  double z = 0.100, step = 0.0005;

  std::chrono::steady_clock::time_point soon(LinkTime time) const {
    return std::chrono::steady_clock::time_point(link->now() + time);
  }
  Sample tick(Vec3 force_n) {
    if (emulator && port->view().session.phase == falcon::Phase::homing) {
      z += step;
      if (z < 0.080 || z > 0.170) step = -step;
      emulator->set_grip({0.0, 0.0, z});
    }
    const Sample sample = port->wait(soon(2ms));
    // The workspace stands at scale 1 and yaw 0: the specimen's x, y, z are the device's x, -z, y.
    port->write({.force_n = Vec3(force_n.x, -force_n.z, force_n.y)});
    return sample;
  }
};

int list() {
  auto watch = falcon::watch_usb_falcons();
  if (!watch) return fmt::print(stderr, "io {}\n", watch.error().detail), 1;
  for (const auto& one : (*watch)->list()) {
    fmt::print("{} port {} serial {} {}\n", one.name, one.port, one.serial.empty() ? "-" : one.serial,
               one.denied ? "denied" : "may_be_opened");
  }
  return 0;
}

bool begin(const Options& options, Contact& contact) {
  FalconSettings settings;
  settings.workspace.scale = 1.0;
  settings.session.event_character = options.event_character;
  settings.calibration.force_gain = options.gain;
  settings.buttons = {.cut = falcon::status::kCentre, .clutch = 0, .next_bur = 0, .previous_bur = 0};
  std::unique_ptr<falcon::FalconLink> link;
  if (options.emulated) {
    contact.emulator = std::make_unique<falcon::Emulator>();
    link = std::make_unique<falcon::EmulatedLink>(*contact.emulator);
  } else {
    auto made = falcon::make_usb_link(options.name);
    if (!made) return fmt::print(stderr, "io {}\n", made.error().detail), false;
    link = std::move(*made);
  }
  contact.link = link.get();
  contact.port = std::make_unique<FalconPort>(std::move(link), settings);
  if (!options.image.empty() || options.emulated) {
    auto image = options.emulated ? falcon::FirmwareImage::from_bytes(test::boot_image())
                                  : falcon::FirmwareImage::from_file(options.image);
    if (!image) return fmt::print(stderr, "image {} {}\n", key_of(image.error().code), image.error().where), false;
    const auto known = image->known_as();
    fmt::print("image sha256 {} blocks {} known_as {}\n", image->sha256(), image->blocks(),
               known.empty() ? "-" : known);
    contact.port->give_image(std::move(*image));
  }
  const LinkTime start = contact.link->now();
  if (auto opened = contact.port->open(); !opened) {
    return fmt::print(stderr, "open failed: {} {}\n", opened.error().detail, opened.error().where), false;
  }
  const auto& state = contact.port->view().session;
  fmt::print("open {} after_s {:.2f} uploaded {}\n", contact.link->name(),
             std::chrono::duration<double>(contact.link->now() - start).count(), state.upload_size);
  fmt::print("homing: pull the grip out and push it in\n");
  const LinkTime patience = contact.link->now() + 60s;
  std::uint8_t homed = 0xFF;
  while (contact.link->now() < patience) {
    const Sample sample = contact.tick(Vec3(0.0));
    const auto& now = contact.port->view().session;
    if (now.homed != homed && sample.status == Sample::Status::gone) {
      homed = now.homed;
      fmt::print("phase {} homed_bits {:#04x}\n", key_of(now.phase), homed);
    }
    if (sample.status == Sample::Status::fresh) return true;
  }
  return fmt::print(stderr, "not_homed\n"), false;
}

void watch(Contact& contact, Vec3 force, double seconds) {
  for (int second = 0; second < seconds; ++second) {
    const LinkTime end = contact.link->now() + 1s;
    const falcon::SessionState before = contact.port->view().session;
    std::map<Sample::Status, int> seen;
    while (contact.link->now() < end) ++seen[contact.tick(force).status];
    const FalconView& view = contact.port->view();
    const falcon::SessionState& now = view.session;
    fmt::print(
        "{} fresh {} late {} gone {} answers {} lost {} dropped {} line_errors {} ticks {} {} {} "
        "place_mm {:.2f} {:.2f} {:.2f} torque {} {} {} buttons {:#x}\n",
        key_of(now.phase), seen[Sample::Status::fresh], seen[Sample::Status::late], seen[Sample::Status::gone],
        now.replies - before.replies, now.lost - before.lost, now.dropped_bytes - before.dropped_bytes,
        now.line.overrun + now.line.parity + now.line.framing + now.line.broken, now.encoders[0], now.encoders[1],
        now.encoders[2], view.grip_m.x * 1e3, view.grip_m.y * 1e3, view.grip_m.z * 1e3, view.torque[0], view.torque[1],
        view.torque[2], now.buttons);
  }
}

void angle(Contact& contact, Vec3 place_m) {
  Vec3 sum(0.0);
  constexpr int kMean = 500;
  for (int i = 0; i < kMean; ++i) {
    contact.tick(Vec3(0.0));
    sum += falcon::arm_rad_of_ticks({}, {}, contact.port->view().session.encoders);
  }
  const auto legs = falcon::inverse({}, place_m);
  if (!legs) return fmt::print("out_of_reach\n");
  const Vec3 trim = legs->arm_rad - sum / static_cast<double>(kMean);
  fmt::print("trim_rad {:.5f} {:.5f} {:.5f}\n", trim.x, trim.y, trim.z);
}

void hold(Contact& contact, Vec3 force) {
  for (int silence_ms = 5; silence_ms <= 320; silence_ms *= 2) {
    for (int i = 0; i < 800; ++i) contact.tick(force);
    const Vec3 from = contact.port->view().grip_m;
    // Nothing is asked of the port meanwhile, so that nothing is sent.
    const LinkTime end = contact.link->now() + std::chrono::milliseconds(silence_ms);
    while (contact.link->now() < end) static_cast<void>(contact.link->wait(end));
    for (int i = 0; i < 4; ++i) contact.tick(Vec3(0.0));
    fmt::print("silence_ms {} travel_mm {:.3f}\n", silence_ms, glm::length(contact.port->view().grip_m - from) * 1e3);
    for (int i = 0; i < 1000; ++i) contact.tick(Vec3(0.0));
  }
}

/// A soft spring with a damper draws the grip to each place; what it takes on average to keep it there is the weight's.
void weigh(Contact& contact) {
  if (contact.emulator) {
    auto& body = contact.body;
    body.emplace(*contact.emulator, contact.emulator->grip_m(), Vec3(0.0), contact.link->now());
    static_cast<falcon::EmulatedLink*>(contact.link)->on_time([&body](LinkTime now) { body->live(now); });
  }
  constexpr double kSpring = 300.0, kDamper = 8.0;  // N/m and Ns/m: soft, and far from ringing on what the lab knows
  constexpr int kDraw = 1500, kSettle = 1000, kMean = 500;
  std::vector<falcon::HeldPose> held;
  Vec3 from = contact.port->view().grip_m, last = from, speed(0.0);
  for (const double x : {-0.02, 0.0, 0.02})
    for (const double y : {-0.02, 0.0, 0.02}) {
      const Vec3 to(x, y, falcon::kMiddleM.z);
      Vec3 place(0.0), torque(0.0);
      for (int i = 0; i < kDraw + kSettle + kMean; ++i) {
        const Vec3 target = from + (to - from) * std::min(1.0, i / static_cast<double>(kDraw));
        const Vec3 now = contact.port->view().grip_m;
        speed += ((now - last) * 1e3 - speed) * 0.1;
        last = now;
        contact.tick((target - now) * kSpring - speed * kDamper);
        if (i < kDraw + kSettle) continue;
        place += contact.port->view().grip_m / static_cast<double>(kMean);
        torque += falcon::torque_of_counts({}, contact.port->view().torque) / static_cast<double>(kMean);
      }
      from = to;
      const auto legs = falcon::inverse({}, place);
      const auto rows = legs ? falcon::jacobian({}, *legs) : std::nullopt;
      if (!rows) return fmt::print("out_of_reach\n");
      held.push_back({{place, *legs, *rows}, torque});
      fmt::print("place_mm {:.1f} {:.1f} {:.1f} torque_nm {:.4f} {:.4f} {:.4f}\n", place.x * 1e3, place.y * 1e3,
                 place.z * 1e3, torque.x, torque.y, torque.z);
    }
  const auto fit = falcon::fit_gravity({}, held);
  if (!fit) return fmt::print("no_fit\n");
  fmt::print("grip_kg {:.3f} arm_kg_m {:.4f}\n", fit->grip_kg, fit->arm_kg_m);
}

int run(const Options& options) {
  const auto number = [&options](std::size_t at) {
    return at < options.arguments.size() ? std::strtod(options.arguments[at].c_str(), nullptr) : 0.0;
  };
  if (options.arguments.empty()) return fmt::print(stderr, "{}", kUsage), 2;
  const std::string& verb = options.arguments[0];
  if (verb == "list") return list();
  const std::size_t wants = verb == "watch"                     ? 2
                            : verb == "push"                    ? 5
                            : verb == "angle" || verb == "hold" ? 4
                            : verb == "weigh"                   ? 1
                                                                : 0;
  if (options.arguments.size() != wants) return fmt::print(stderr, "{}", kUsage), 2;
  Contact contact;
  if (!begin(options, contact)) return 1;
  const Vec3 three(number(1), number(2), number(3));
  if (verb == "watch") watch(contact, Vec3(0.0), number(1));
  if (verb == "push") watch(contact, three, number(4));
  if (verb == "angle") angle(contact, three);
  if (verb == "hold") hold(contact, three);
  if (verb == "weigh") weigh(contact);
  contact.port->close();
  return 0;
}

}  // namespace
}  // namespace cusp::test

int main(int count, char** arguments) {
  cusp::test::Options options;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const bool more = i + 1 < count;
    if (argument == "--emulated") {
      options.emulated = true;
    } else if (argument == "--event-character") {
      options.event_character = true;
    } else if (argument == "--name" && more) {
      options.name = arguments[++i];
    } else if (argument == "--image" && more) {
      options.image = arguments[++i];
    } else if (argument == "--gain" && more) {
      options.gain = std::strtod(arguments[++i], nullptr);
    } else {
      options.arguments.push_back(argument);
    }
  }
  return cusp::test::run(options);
}
