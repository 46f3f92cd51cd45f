#include "ui/session/device_bench.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "device/falcon/transport_libusb.h"
#include "engine/base/fp_guard.h"
#include "engine/base/triple_buffer.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;
using falcon::Trial;
using falcon::TrialEnd;

constexpr std::chrono::milliseconds kPeriod{1}, kPatience{2}, kWindow{1000};

}  // namespace

struct DeviceBench::Inner {
  // The emulated device outlives the port, which owns the link to it.
  std::unique_ptr<falcon::Emulator> emulator;
  std::unique_ptr<falcon::EmulatedBody> body;
  std::unique_ptr<FalconPort> port;

  TripleBuffer<BenchView> shown;
  std::atomic<bool> stop{false}, stop_trial{false}, ended{false};
  // A trial goes to the thread by `given`, and back by `over`.
  std::atomic<Trial*> given{nullptr}, over{nullptr};
  bool trial_out = false;  // window's thread: given, and not back yet
  mutable std::mutex failure_mutex;  // never taken once the exchange runs
  std::optional<PortFailure> failure;
  std::thread thread;

  // The thread's own.
  BenchView view;
  std::array<std::uint32_t, 4096> late_ns{};  // of this second's readings
  std::size_t late_count = 0;
  std::uint64_t fresh_in_window = 0;
  Clock::time_point window_at{}, last_fresh{};

  void run();
  void exchange();
  void take_window(Clock::time_point now);
  void fail_with(PortFailure why) {
    {
      const std::lock_guard lock(failure_mutex);
      failure = std::move(why);
    }
    view.phase = BenchPhase::failed;
    shown.write(view);
  }
};

DeviceBench::DeviceBench(const DeviceChoice& choice, const falcon::EmulatedBodySettings& body)
    : inner_(std::make_unique<Inner>()) {
  Inner& in = *inner_;
  FalconSettings settings = settings_for(choice.profile);
  settings.workspace = {.scale = 1.0};  // a trial knows the device's own frame
  settings.buttons = {.cut = 0, .clutch = 0, .next_bur = 0, .previous_bur = 0};
  settings.home_in_open = true;
  std::unique_ptr<falcon::FalconLink> link;
  if (choice.kind == "emulated-falcon") {
    in.emulator = std::make_unique<falcon::Emulator>(falcon::EmulatorSettings{.firmware_running = true});
    in.body = std::make_unique<falcon::EmulatedBody>(*in.emulator, body);
    auto emulated = std::make_unique<falcon::EmulatedLink>(
        *in.emulator, falcon::EmulatedLinkSettings{.time = falcon::EmulatedTime::runs});
    emulated->on_time([&in](falcon::LinkTime now) { in.body->advance(now); });
    link = std::move(emulated);
  } else {
    auto made = falcon::make_usb_link(choice.name);
    if (!made) {
      in.fail_with(made.error());
      return;
    }
    link = std::move(*made);
  }
  in.port = std::make_unique<FalconPort>(std::move(link), settings);
  if (choice.kind == "falcon" && !choice.firmware.file.empty()) {
    auto image = read_firmware(choice.firmware);
    if (image) {
      in.port->give_image(std::move(*image));
    } else {
      in.port->lack_image(image.error());
    }
  }
  in.thread = std::thread([&in] {
    in.run();
    in.ended.store(true, std::memory_order_release);
  });
}

DeviceBench::~DeviceBench() {
  Inner& in = *inner_;
  in.stop.store(true, std::memory_order_release);
  // open() forgets a cancel() that came before it.
  while (in.thread.joinable() && !in.ended.load(std::memory_order_acquire)) {
    in.port->cancel();
    std::this_thread::sleep_for(kPeriod);
  }
  if (in.thread.joinable()) in.thread.join();
  delete in.given.exchange(nullptr);
  delete in.over.exchange(nullptr);
}

void DeviceBench::Inner::run() {
  name_this_thread("cusp-bench");
  const FpGuard fp;
  if (stop.load(std::memory_order_acquire)) return;
  if (auto opened = port->open(); !opened) {
    view.falcon = FalconView{};
    fail_with(opened.error());
    return;
  }
  view.grant = ask_for_realtime();
  view.phase = BenchPhase::running;
  window_at = last_fresh = Clock::now();
  exchange();
  port->close();
}

void DeviceBench::Inner::take_window(Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - window_at).count();
  view.answers_per_s = static_cast<double>(fresh_in_window) / seconds;
  std::sort(late_ns.begin(), late_ns.begin() + static_cast<std::ptrdiff_t>(late_count));
  const auto share = [this](std::size_t percent) {
    return late_count == 0 ? 0.0 : 1e-3 * late_ns[(late_count - 1) * percent / 100];
  };
  view.late_p50_us = share(50);
  view.late_p99_us = share(99);
  view.late_max_us = share(100);
  late_count = 0;
  fresh_in_window = 0;
  window_at = now;
}

void DeviceBench::Inner::exchange() {
  std::unique_ptr<Trial> trial;
  const Clock::time_point start = Clock::now();
  while (!stop.load(std::memory_order_acquire)) {
    const Sample sample = port->wait(Clock::now() + kPatience);
    const Clock::time_point now = Clock::now();
    if (sample.status == Sample::Status::fresh) {
      ++fresh_in_window;
      const auto late = std::clamp<std::int64_t>((now - last_fresh - kPeriod).count(), 0, 4'000'000'000);
      if (late_count < late_ns.size()) late_ns[late_count++] = static_cast<std::uint32_t>(late);
      last_fresh = now;
    }
    if (now - window_at >= kWindow) take_window(now);
    view.falcon = port->view();
    view.phase = sample.status == Sample::Status::gone ? BenchPhase::lost : BenchPhase::running;
    view.silences = view.falcon.session.silences;
    view.lost_answers = view.falcon.session.lost;

    Vec3 force(0.0);
    if (!trial) {
      trial.reset(given.exchange(nullptr, std::memory_order_acq_rel));
      stop_trial.store(false, std::memory_order_relaxed);
    }
    if (trial) {
      if (stop_trial.exchange(false, std::memory_order_relaxed)) trial->stop();
      force = trial->advance({std::chrono::duration<double>(now - start).count(), view.falcon.grip_m,
                              view.falcon.session.encoders, view.falcon.torque, sample.status == Sample::Status::fresh,
                              sample.status == Sample::Status::gone});
      view.trial_share = trial->share();
      view.trial_step = trial->step();
      view.trial_end = trial->end();
      view.trial_runs = trial->end() == TrialEnd::none;
      if (!view.trial_runs) over.store(trial.release(), std::memory_order_release);
    }
    view.force_n = force;
    // The workspace stands at scale 1 and yaw 0: the specimen's x, y, z are the device's x, -z, y.
    port->write({.force_n = Vec3(force.x, -force.z, force.y)});
    shown.write(view);
    if (sample.status == Sample::Status::gone) std::this_thread::sleep_for(kPeriod);
  }
  if (trial) over.store(trial.release(), std::memory_order_release);
}

const BenchView& DeviceBench::view() noexcept { return inner_->shown.read(); }

std::optional<PortFailure> DeviceBench::failure() const {
  const std::lock_guard lock(inner_->failure_mutex);
  return inner_->failure;
}

bool DeviceBench::start(std::unique_ptr<Trial> trial) {
  Inner& in = *inner_;
  if (!trial || in.trial_out || in.shown.read().phase != BenchPhase::running) return false;
  in.trial_out = true;
  in.given.store(trial.release(), std::memory_order_release);
  return true;
}

void DeviceBench::stop_trial() noexcept { inner_->stop_trial.store(true, std::memory_order_relaxed); }

std::unique_ptr<Trial> DeviceBench::take_trial() {
  std::unique_ptr<Trial> out(inner_->over.exchange(nullptr, std::memory_order_acq_rel));
  if (out) inner_->trial_out = false;
  return out;
}

void DeviceBench::set_force_gain(double gain) noexcept {
  if (inner_->port && !inner_->trial_out) inner_->port->set_force_gain(gain);
}

void DeviceBench::set_leds(std::uint8_t leds) noexcept {
  if (inner_->port) inner_->port->set_leds(leds);
}

}  // namespace cusp::ui
