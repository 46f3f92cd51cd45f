#include "device/hid/hid_follower.h"

#include <array>

namespace cusp::device::hid {

namespace {

constexpr std::chrono::milliseconds kRead{20};    // time-out of a read
constexpr std::chrono::milliseconds kPause{20};   // while nothing is open
constexpr std::chrono::seconds kListInterval{1};
constexpr std::size_t kMostBytes = 4096;
constexpr std::size_t kAtOnce = 64;               // most reports between two checks of clock and stop

bool still_there(const std::vector<HidDevice>& devices, const HidDevice& device) {
  for (const HidDevice& other : devices) {
    if (other.path == device.path && other.vendor == device.vendor && other.product == device.product) return true;
  }
  return false;
}

}  // namespace

HidFollower::HidFollower(std::function<std::unique_ptr<HidBus>()> make_bus, HidSink& sink)
    : make_bus_(std::move(make_bus)), sink_(sink) {}

HidFollower::~HidFollower() { stop(); }

void HidFollower::start() {
  if (thread_.joinable()) return;
  stop_.store(false, std::memory_order_release);
  thread_ = std::thread([this] { run(); });
}

void HidFollower::stop() {
  stop_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

void HidFollower::run() {
  using Clock = std::chrono::steady_clock;
  const std::unique_ptr<HidBus> bus = make_bus_();
  std::unique_ptr<HidReader> reader;
  HidDevice open;  // while there is a reader
  HidTime listed{};
  std::array<std::uint8_t, kMostBytes> bytes{};
  const auto release = [&] {
    if (!reader) return;
    reader.reset();
    sink_.lost();
  };
  while (!stop_.load(std::memory_order_acquire)) {
    HidTime now = Clock::now();
    const bool asked = again_.exchange(false, std::memory_order_acq_rel);
    if (bus && (asked || now - listed >= kListInterval)) {
      listed = now;
      const std::vector<HidDevice> devices = bus->list();
      // Some systems do not report the loss of an open device.
      if (reader && !still_there(devices, open)) release();
      const std::optional<HidDevice> chosen = sink_.choose(devices);
      if (reader && (!chosen || chosen->path != open.path)) release();
      if (chosen && !reader) {
        auto opened = bus->open(chosen->path);
        if (opened) {
          reader = std::move(*opened);
          open = *chosen;
          sink_.opened(*chosen);
        } else {
          sink_.refused(*chosen, opened.error());
        }
      }
    }
    if (!reader) {
      sink_.polled(now);
      std::this_thread::sleep_for(kPause);
      continue;
    }
    HidRead read = reader->read(bytes, kRead);
    bool came = false;
    for (std::size_t i = 0; read.kind == HidRead::Kind::report && i < kAtOnce; ++i) {
      came = true;
      sink_.report(std::span(bytes).first(read.size), Clock::now());
      read = reader->read(bytes, std::chrono::milliseconds(0));
    }
    now = Clock::now();
    if (read.kind == HidRead::Kind::lost) {
      release();
      listed = {};  // it may be back already
    } else if (!came) {
      // A file that is always ready answers "nothing" at once: without this it would take a whole core.
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    sink_.polled(now);
  }
  release();
}

}  // namespace cusp::device::hid
