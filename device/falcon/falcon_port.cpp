#include "device/falcon/falcon_port.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cusp::device {

namespace {

using falcon::LinkTime;
using falcon::Phase;
using falcon::Trouble;

constexpr LinkTime kPeriod = std::chrono::milliseconds(1);
// kRephase and kRepeat keep 982 samples a second on emulated lines of 50 to 1000 us with up to 500 us of jitter.
constexpr LinkTime kRephase = std::chrono::microseconds(200);  // a later answer restarts the pace
constexpr LinkTime kRepeat = std::chrono::microseconds(100);   // a packet waits so long for an answer to come first
constexpr LinkTime kLongestWait = std::chrono::milliseconds(20);
constexpr LinkTime kCancelPoll = std::chrono::milliseconds(100);  // open() checks cancelled_ so often
constexpr LinkTime kMostSilence = std::chrono::seconds(10);  // then open() gives up a device whose answers cannot be used
constexpr int kMostWaiting = 64;                              // events read at once after a stall
constexpr int kClosingPackets = 5;                            // of zero torque, before the device is closed
constexpr std::uint8_t kPressTicks = 20;  // a press counts after so many ticks: switches bounce

falcon::Workspace workspace_of(const falcon::WorkspaceSettings& settings) {
  if (const auto wanted = falcon::Workspace::from(settings)) return *wanted;
  return *falcon::Workspace::from({});
}

}  // namespace

DeviceLimits limits_of(const FalconSettings& settings) {
  const double scale = workspace_of(settings.workspace).scale();
  DeviceLimits limits;
  limits.name = settings.name;
  limits.device_class = settings.device_class;
  // A gain above 1 asks the motors for more, and they have no more.
  limits.max_force_n = settings.max_force_n / std::max(1.0, settings.calibration.force_gain);
  limits.max_stiffness_n_per_mm = settings.max_stiffness_n_per_mm / scale;
  limits.has_own_clock = true;
  limits.closed_loop = settings.closed_loop;
  if (settings.damping_ns_per_m) limits.damping_ns_per_m = *settings.damping_ns_per_m / scale;
  limits.delay_ms = settings.delay_ms;
  limits.encoder_mm = settings.encoder_mm.value_or(falcon::kCoarsestMmPerTick) * scale;
  return limits;
}

FalconPort::FalconPort(std::unique_ptr<falcon::FalconLink> link, const FalconSettings& settings)
    : link_(std::move(link)),
      settings_(settings),
      session_(settings.session),
      workspace_(workspace_of(settings.workspace)),
      force_gain_(settings.calibration.force_gain) {}

FalconPort::~FalconPort() { close(); }

void FalconPort::give_image(falcon::FirmwareImage image) {
  image_ = image;
  session_.give_image(std::move(image));
}

void FalconPort::hand_over() noexcept {
  while (const auto ask = session_.next_ask()) link_->start(*ask);
}

falcon::LinkEvent::Kind FalconPort::once(LinkTime until) noexcept {
  hand_over();
  const LinkTime now = link_->now();
  const falcon::LinkEvent event = link_->wait(std::min(until, std::max(session_.due(), now)));
  session_.advance(event, link_->now());
  hand_over();
  return event.kind;
}

/// Reads all waiting events before anything is sent: after a stall they are old.
void FalconPort::catch_up() noexcept {
  for (int i = 0; i < kMostWaiting; ++i) {
    if (once(link_->now()) == falcon::LinkEvent::Kind::time) return;
  }
}

bool FalconPort::answered(LinkTime now) const noexcept {
  return session_.phase() == Phase::ready && session_.state().replies != seen_replies_ &&
         session_.fresh(session_.asked(), now);
}

Result<void, PortFailure> FalconPort::open() {
  close();
  cancelled_.store(false, std::memory_order_release);
  session_ = falcon::Session(settings_.session);
  if (image_) session_.give_image(*image_);
  pose_.reset();
  reach_.forget();
  last_ = Sample{};
  pressed_ = false;
  open_ = true;
  LinkTime silent_from = link_->now();
  for (;;) {
    const bool homing = session_.phase() == Phase::homing;
    once(link_->now() + (homing ? kPeriod : kCancelPoll));
    if (homing && link_->now() >= due_) {
      session_.exchange(link_->now());
      hand_over();
      due_ = link_->now() + kPeriod;
    }
    publish();
    const falcon::SessionState& state = session_.state();
    std::optional<PortFailure> failure;
    const auto fails = [&](PortError code) {
      failure = PortFailure{code, link_->name(), std::string(falcon::key_of(state.trouble))};
    };
    if (state.phase == Phase::ready || (state.phase == Phase::homing && !settings_.home_in_open)) break;
    if (state.phase != Phase::silent) silent_from = link_->now();
    if (state.phase == Phase::needs_image) {
      failure = no_image_.value_or(PortFailure{PortError::bad_file, link_->name(), "needs_image"});
    } else if (state.phase == Phase::failed) {
      fails(PortError::io);
    } else if (state.phase == Phase::unplugged && state.trouble == Trouble::absent) {
      fails(PortError::not_found);
    } else if (state.phase == Phase::unplugged && state.trouble == Trouble::denied) {
      fails(PortError::no_permission);
    } else if (state.phase == Phase::unplugged && state.trouble == Trouble::busy) {
      fails(PortError::busy);
    } else if (link_->now() - silent_from >= kMostSilence) {
      const Trouble why = state.stale > state.flawed ? Trouble::late_answers : Trouble::link_failed;
      failure = PortFailure{PortError::io, link_->name(), std::string(falcon::key_of(why))};
    } else if (cancelled_.load(std::memory_order_acquire)) {
      failure = PortFailure{PortError::io, link_->name(), "cancelled"};
    }
    if (failure) {
      close();
      return std::unexpected(std::move(*failure));
    }
  }
  due_ = link_->now();
  seen_replies_ = session_.state().replies;
  by_port_ = link_->known_by_port();
  publish();
  return {};
}

bool FalconPort::forcing() const noexcept { return session_.phase() == Phase::ready && pose_ && !workspace_.held(); }

void FalconPort::take_buttons(std::uint8_t bits) noexcept {
  const FalconButtons& does = settings_.buttons;
  const bool cut = (bits & does.cut) != 0;
  last_.buttons = cut ? 1 : 0;
  last_.pedal = cut ? 65535 : 0;
  const auto pressed = [bits](std::uint8_t button, std::uint8_t& ticks) {
    if ((bits & button) == 0) {
      ticks = 0;
      return false;
    }
    if (ticks > kPressTicks) return false;
    return ++ticks == kPressTicks;
  };
  const std::uint16_t before = last_.bur;
  if (pressed(does.next_bur, next_ticks_) && last_.bur + 1 < settings_.burs) ++last_.bur;
  if (pressed(does.previous_bur, previous_ticks_) && last_.bur > 0) --last_.bur;
  pressed_ = pressed_ || last_.bur != before;
}

Sample FalconPort::fresh() noexcept {
  const falcon::SessionState& state = session_.state();
  seen_replies_ = state.replies;
  const Vec3 arms = falcon::arm_rad_of_ticks(settings_.geometry, settings_.calibration, state.encoders);
  const auto pose = falcon::forward(settings_.geometry, arms, last_grip_m_);
  Sample doubtful = last_;
  doubtful.status = Sample::Status::late;
  if (!pose) {
    // No position has these angles: a broken encoder, or a wrong offset. Such a reading gives no force.
    ++unsolved_;
    pose_.reset();
    session_.command({});
    return doubtful;
  }
  if (!reach_.accepts(pose->grip_m, session_.asked())) {
    ++unreached_;
    return doubtful;
  }
  pose_ = pose;
  pose_asked_ = session_.asked();
  last_grip_m_ = pose_->grip_m;
  const bool clutch = (state.buttons & settings_.buttons.clutch) != 0;
  // Two answers in a row must agree: one corrupt bit would shift the workspace for good.
  const bool certain = std::exchange(clutch_, clutch) == clutch;
  if (certain && clutch) {
    workspace_.hold(pose_->grip_m);
  } else if (certain && workspace_.held()) {
    workspace_.release(pose_->grip_m);
    session_.restart_ramp(link_->now());
  }
  take_buttons(state.buttons);
  last_.status = Sample::Status::fresh;
  last_.position_mm = workspace_.specimen_mm(pose_->grip_m);
  return last_;
}

Sample FalconPort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  Sample lost = last_;
  lost.status = Sample::Status::gone;
  lost.buttons = 0;  // a silent device counts as released
  lost.pedal = 0;
  if (!open_) return lost;
  session_.set_leds(leds_.load(std::memory_order_relaxed));
  const LinkTime wanted = std::chrono::duration_cast<LinkTime>(deadline.time_since_epoch());
  const LinkTime until = std::min(wanted, link_->now() + kLongestWait);
  catch_up();
  for (;;) {
    const LinkTime now = link_->now();
    const bool ready = session_.phase() == Phase::ready;
    if (now >= due_) {
      if (answered(now)) {
        // A late answer restarts the pace: missed periods are not made up for by a burst.
        due_ = now - due_ < kRephase ? due_ + kPeriod : now + kPeriod;
        repeated_ = false;
        const Sample sample = fresh();
        publish();
        return sample;
      }
      // No answer in time: a packet leaves nevertheless, so that two are under way if an answer takes over a millisecond.
      // Before `ready` this alone keeps the exchange running.
      if (!ready || (!repeated_ && now >= due_ + kRepeat)) {
        session_.exchange(now);
        repeated_ = true;
      }
      if (!ready) due_ = now + kPeriod;
    }
    if (now >= until) break;
    LinkTime next = until;
    if (now < due_) {
      next = due_;
    } else if (!repeated_) {
      next = due_ + kRepeat;
    }
    once(std::min(next, until));
  }
  if (session_.phase() != Phase::ready) {
    pose_.reset();
    reach_.forget();
    session_.command({});
    publish();
    return lost;
  }
  publish();
  Sample late = last_;
  late.status = Sample::Status::late;
  return late;
}

void FalconPort::write(const Feedback& feedback) noexcept {
  // The first feedback after a press may answer an older sample: only the next one can overrule the press.
  if (!std::exchange(pressed_, false)) last_.bur = feedback.bur;
  if (!open_ || session_.phase() != Phase::ready) return;
  // The engine ramps the push after a fault; the weight, which the engine does not know, needs the session's ramp.
  if (feedback.faulted) session_.restart_ramp(link_->now());
  if (feedback.faulted || !forcing()) {
    session_.command({});
  } else {
    const Vec3 push = falcon::torque_nm(pose_->rows, workspace_.device_n(feedback.force_n));
    const Vec3 weight = falcon::gravity_torque_nm(settings_.geometry, *pose_, settings_.gravity);
    falcon::Calibration calibration = settings_.calibration;
    calibration.force_gain = force_gain_.load(std::memory_order_relaxed);
    session_.command(falcon::counts_of_torque(calibration, push + weight), pose_asked_);
  }
  session_.exchange(link_->now());
  hand_over();
}

void FalconPort::close() noexcept {
  if (!open_) return;
  session_.command({});
  session_.set_leds(0);
  for (int i = 0; i < kClosingPackets && session_.phase() == Phase::ready; ++i) {
    const LinkTime until = link_->now() + kPeriod;
    session_.exchange(link_->now());
    while (link_->now() < until) once(until);
  }
  link_->start({.kind = falcon::LinkAsk::Kind::close});
  open_ = false;
  pose_.reset();
}

void FalconPort::publish() noexcept {
  FalconView view;
  view.session = session_.state();
  view.grip_m = last_grip_m_;
  view.torque = session_.last_torque();
  view.unsolved = unsolved_;
  view.unreached = unreached_;
  view.clutched = workspace_.held();
  view.by_port = by_port_;
  view_.write(view);
}

}  // namespace cusp::device
