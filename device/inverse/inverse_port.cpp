#include "device/inverse/inverse_port.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <semaphore>
#include <thread>
#include <utility>

#include "engine/base/triple_buffer.h"

namespace cusp::device {

namespace {

using inverse::LinkTime;
using inverse::Phase;
using inverse::Session;
using inverse::SessionState;
using inverse::Trouble;

constexpr double kMmPerM = 1000.0;
constexpr double kLeastScale = 0.05, kMostScale = 1.0;  // a larger scale would make tissue feel stiffer than the scene sets
constexpr std::chrono::milliseconds kOpenPoll{5};
constexpr std::chrono::milliseconds kLongestWait{20};
constexpr std::chrono::milliseconds kFlush{50};      // for the closing message to leave
constexpr std::uint8_t kPressTicks = 20;             // a button counts when it was down so long: switches bounce

/// What the talking thread hands to the loop.
struct NewestReading {
  inverse::Reading reading;
  std::uint64_t readings = 0;
};
/// And the loop to it.
struct Wanted {
  Vec3 force_n{0.0};
  LinkTime at{};
  LinkTime ramp_from{};  // of the last write without a force
};

}  // namespace

struct InversePort::Inner {
  Inner(std::unique_ptr<inverse::InverseLink> l, const InverseSettings& s)
      : link(std::move(l)), settings(s), cosine(std::cos(s.yaw_rad)), sine(std::sin(s.yaw_rad)) {
    settings.scale = std::isfinite(s.scale) ? std::clamp(s.scale, kLeastScale, kMostScale) : 0.5;
  }

  std::unique_ptr<inverse::InverseLink> link;
  InverseSettings settings;
  double cosine, sine;

  // Between the two threads.
  std::thread thread;
  std::atomic<bool> stop{false}, cancelled{false};
  std::atomic<bool> ready{false};
  TripleBuffer<NewestReading> newest;
  TripleBuffer<Wanted> wanted;
  std::counting_semaphore<> news{0};
  mutable std::mutex mutex;  // view; the loop never takes it
  InverseView view;

  // The loop's.
  bool open = false;
  std::uint64_t seen = 0;
  std::optional<Vec3> centre_m;
  std::optional<Quat> rest;             // the bur has turned by orientation * conjugate(rest)
  Quat turned{1.0, 0.0, 0.0, 0.0};      // last of these, as the device has its axes
  Vec3 origin_mm{0.0};
  bool held = false;
  std::uint8_t next_ticks = 0;
  bool pressed = false;  // the button changed last.bur since the last write()
  LinkTime ramp_from{};  // the last write without a force
  Sample last;

  Vec3 to_specimen(Vec3 device) const noexcept {
    return {cosine * device.x - sine * device.y, sine * device.x + cosine * device.y, device.z};
  }
  Vec3 to_device(Vec3 specimen) const noexcept {
    return {cosine * specimen.x + sine * specimen.y, -sine * specimen.x + cosine * specimen.y, specimen.z};
  }

  void exchange();
  void publish(const SessionState& state, LinkTime now, LinkTime& since, std::uint64_t& before);
  Sample fresh(const inverse::Reading& reading) noexcept;
};

void InversePort::Inner::publish(const SessionState& state, LinkTime now, LinkTime& since, std::uint64_t& before) {
  const std::lock_guard lock(mutex);
  view.session = state;
  const double s = std::chrono::duration<double>(now - since).count();
  if (s < 1.0) return;
  view.updates_per_s = static_cast<double>(state.readings - before) / s;
  since = now;
  before = state.readings;
}

void InversePort::Inner::exchange() {
  Session session(settings.session, settings.device);
  std::uint64_t readings = 0, rated = 0;
  LinkTime rate_since = link->now(), commanded{}, published{};
  Phase shown = Phase::closed;
  while (!stop.load(std::memory_order_acquire)) {
    LinkTime now = link->now();
    switch (session.take_request(now)) {
      case Session::LinkRequest::open: link->open(); break;
      case Session::LinkRequest::close: link->close(); break;
      case Session::LinkRequest::none: break;
    }
    if (const Wanted& want = wanted.read(); want.at != commanded) {
      commanded = want.at;
      session.command(want.force_n, want.at, want.ramp_from);
    }
    if (auto message = session.take_message(now)) link->send(std::move(*message));
    const inverse::LinkEvent event = link->wait(std::min(session.due(), now + kLongestWait));
    now = link->now();
    session.advance(event, now);
    const SessionState& state = session.state();
    if (state.readings != readings) {
      readings = state.readings;
      newest.write({state.reading, readings});
      news.release();
    }
    // A copy for the screen, every kLongestWait and at each change of phase.
    if (state.phase != shown || now - published >= kLongestWait) {
      shown = state.phase;
      published = now;
      publish(state, now, rate_since, rated);
    }
    // After the view: open() returns on it, and limits() then reads the view.
    ready.store(state.phase == Phase::ready, std::memory_order_release);
  }
  ready.store(false, std::memory_order_release);
  if (auto message = session.closing_message()) {
    link->send(std::move(*message));
    const LinkTime until = link->now() + kFlush;
    while (link->now() < until && link->wait(until).kind == inverse::LinkEvent::Kind::time) continue;
  }
  link->close();
  publish(SessionState{}, link->now(), rate_since, rated);
}

InversePort::InversePort(std::unique_ptr<inverse::InverseLink> link, const InverseSettings& settings)
    : inner_(std::make_unique<Inner>(std::move(link), settings)) {}

InversePort::~InversePort() { close(); }

Result<void, PortFailure> InversePort::open() {
  close();
  Inner& in = *inner_;
  in.stop.store(false);
  in.seen = 0;
  in.newest.write({});
  in.wanted.write({});
  in.centre_m.reset();
  in.rest.reset();
  in.origin_mm = in.settings.origin_mm;
  in.held = in.pressed = false;
  in.last = Sample{};
  {
    const std::lock_guard lock(in.mutex);
    in.view = {};
  }
  in.open = true;
  in.thread = std::thread([&in] { in.exchange(); });
  const auto until = std::chrono::steady_clock::now() + kLongestOpen;
  while (!in.ready.load(std::memory_order_acquire)) {
    const SessionState state = view().session;
    const bool over = std::chrono::steady_clock::now() >= until;
    if (in.cancelled.load(std::memory_order_acquire)) {
      close();
      return fail(PortError::io, "service", "cancelled");
    }
    if (over || state.trouble == Trouble::no_service || state.trouble == Trouble::no_device ||
        state.trouble == Trouble::garbage) {
      const Trouble trouble = state.trouble == Trouble::none ? Trouble::no_answer : state.trouble;
      close();
      if (trouble == Trouble::no_service) return fail(PortError::not_found, "service");
      if (trouble == Trouble::no_device) return fail(PortError::not_found, "device");
      return fail(PortError::io, "service", std::string(key_of(trouble)));
    }
    std::this_thread::sleep_for(kOpenPoll);
  }
  return {};
}

Sample InversePort::Inner::fresh(const inverse::Reading& reading) noexcept {
  if (!centre_m) centre_m = reading.position_m;
  if (reading.orientation && !rest) rest = reading.orientation;
  const double mm = kMmPerM * settings.scale;
  const Vec3 place = origin_mm + to_specimen(reading.position_m - *centre_m) * mm;
  if (reading.b && !held) held = true;
  if (held && !reading.b) {
    // The bur continues from its position and its orientation.
    origin_mm += last.position_mm - place;
    if (reading.orientation) rest = glm::conjugate(turned) * *reading.orientation;
    held = false;
    last.position_mm = origin_mm + to_specimen(reading.position_m - *centre_m) * mm;
  } else if (!held) {
    last.position_mm = place;
  }
  if (reading.orientation && rest && !held) {
    turned = *reading.orientation * glm::conjugate(*rest);
    const Vec3 axis = to_specimen({turned.x, turned.y, turned.z});
    last.orientation = Quat(turned.w, axis.x, axis.y, axis.z);
  }
  last.buttons = reading.a ? 1 : 0;
  last.pedal = reading.a ? 65535 : 0;
  next_ticks = reading.c ? static_cast<std::uint8_t>(std::min(next_ticks + 1, kPressTicks + 1)) : std::uint8_t{0};
  if (next_ticks == kPressTicks) {
    last.bur = static_cast<std::uint16_t>((last.bur + 1) % std::max<int>(settings.burs, 1));
    pressed = true;
  }
  last.status = Sample::Status::fresh;
  return last;
}

Sample InversePort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  Inner& in = *inner_;
  const auto until = std::min(deadline, std::chrono::steady_clock::now() + kLongestWait);
  for (;;) {
    const NewestReading& newest = in.newest.read();
    if (in.open && in.ready.load(std::memory_order_acquire) && newest.readings > in.seen) {
      in.seen = newest.readings;
      return in.fresh(newest.reading);
    }
    if (!in.news.try_acquire_until(until)) break;
    while (in.news.try_acquire()) continue;
  }
  Sample stale = in.last;
  if (in.open && in.ready.load(std::memory_order_acquire)) {
    stale.status = Sample::Status::late;
    return stale;
  }
  stale.status = Sample::Status::gone;
  stale.buttons = 0;  // a silent device counts as released
  stale.pedal = 0;
  return stale;
}

void InversePort::write(const Feedback& feedback) noexcept {
  Inner& in = *inner_;
  // The first feedback after a press may answer an older sample: only the next one can overrule the press.
  if (!std::exchange(in.pressed, false)) in.last.bur = feedback.bur;
  if (!in.open) return;
  const LinkTime now = std::chrono::steady_clock::now();
  Vec3 force = in.to_device(feedback.force_n);
  const double length = glm::length(force);
  if (feedback.faulted || in.held || !std::isfinite(length)) {
    force = Vec3(0.0);
    in.ramp_from = now;
  } else if (length > in.settings.max_force_n) {
    force *= in.settings.max_force_n / length;
  }
  in.wanted.write({force, now, in.ramp_from});
}

DeviceLimits InversePort::limits() const {
  const InverseView seen = view();
  DeviceLimits limits;
  limits.name = "Haply Inverse3";
  limits.device_class = "inverse3";
  limits.rotation_axes = seen.session.has_orientation ? 3 : 0;
  limits.max_force_n = inner_->settings.max_force_n;
  limits.max_stiffness_n_per_mm = inner_->settings.max_stiffness_n_per_mm / inner_->settings.scale;
  limits.has_own_clock = true;
  return limits;
}

void InversePort::cancel() noexcept { inner_->cancelled.store(true, std::memory_order_release); }

void InversePort::close() noexcept {
  Inner& in = *inner_;
  in.stop.store(true, std::memory_order_release);
  if (in.thread.joinable()) in.thread.join();
  in.open = false;
}

InverseView InversePort::view() const {
  const std::lock_guard lock(inner_->mutex);
  return inner_->view;
}

}  // namespace cusp::device
