#include "ui/cli/play_live.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>
#include <tuple>
#include <utility>

#include "engine/step/step.h"
#include "scenarios/operators/faults.h"
#include "scenarios/shapes/target.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

using namespace std::chrono_literals;

constexpr auto kLook = std::chrono::milliseconds(50);
constexpr double kTravelMmS = 30.0;
constexpr double kSilenceS = 0.050;
constexpr double kStartAboveMm = 1.5;
constexpr std::size_t kMostOperators = 64;
/// A loader that does not answer takes up to a minute (FalconPort::open); homing sends a packet a millisecond.
constexpr std::chrono::seconds kQuiet{120};

/// Scripted operators one after the other, as the hand of an emulated Falcon. Made before the attempt; the haptic thread neither
/// allocates nor waits in it.
class OperatorsInTurn {
 public:
  explicit OperatorsInTurn(std::vector<ScriptedOperator> operators) : operators_(std::move(operators)), at_mm_(operators_.front().start_mm()) {}

  EmulatedHandPose next(const Feedback& felt, double dt_s) noexcept {
    const double dt = std::clamp(dt_s, 1e-6, 0.004);
    clock_s_ += dt;
    if (travels_) {
      // Up first, then across to where the next begins.
      const Vec3 start = operators_[now_].start_mm();
      const Vec3 to = at_mm_.z < start.z - 1e-6 ? Vec3(at_mm_.x, at_mm_.y, start.z) : start;
      const Vec3 way = to - at_mm_;
      const double length = glm::length(way), step = kTravelMmS * dt;
      at_mm_ = length > step ? at_mm_ + way * (step / length) : to;
      travels_ = at_mm_ != start;
      felt_.device_mm = felt_.proxy_mm = at_mm_;
      return {at_mm_, false, 0};
    }
    if (operators_[now_].done()) {
      if (now_ + 1 == operators_.size()) {
        done_.store(true, std::memory_order_release);
      } else {
        ++now_;
        travels_ = true;
      }
      return {at_mm_, false, 0};
    }
    felt_.proxy_mm = felt.proxy_mm;
    felt_.force_n = felt.force_n;
    felt_.contact = felt.in_contact;
    felt_.stiffness_n_per_mm = felt.in_contact ? felt.stiffness_n_per_mm : 0.0;
    felt_.faulted = felt.faulted;
    felt_.device_mm = at_mm_;
    const Sample sample = operators_[now_].next(felt_, dt);
    at_mm_ = sample.position_mm;
    if ((sample.buttons & StepInput::kCoolant) != 0) coolant_.store(true, std::memory_order_relaxed);
    return {at_mm_, (sample.buttons & 1) != 0, sample.bur};
  }
  double clock_s() const noexcept { return clock_s_; }
  bool done() const noexcept { return done_.load(std::memory_order_acquire); }
  bool wants_coolant() const noexcept { return coolant_.load(std::memory_order_relaxed); }
  Vec3 start_mm() const noexcept { return operators_.front().start_mm(); }

 private:
  std::vector<ScriptedOperator> operators_;
  std::size_t now_ = 0;
  Vec3 at_mm_;
  StepOutput felt_;
  bool travels_ = false;
  double clock_s_ = 0;
  std::atomic<bool> done_{false}, coolant_{false};
};

/// Above the middle of what is to be cut, clear of all tissue.
Vec3 start_above(const Specimen& specimen, const Scenario& scenario) {
  const Grid& grid = specimen.grid();
  const Vec3 top = grid.centre_mm(grid.size);
  Vec3 at = 0.5 * (grid.origin_mm + top);
  if (const TargetShape shape(scenario.target, lent(specimen)); !shape.empty()) {
    at.x = 0.5 * (shape.low().x + shape.high().x);
    at.y = 0.5 * (shape.low().y + shape.high().y);
  }
  at.z = top.z + scenario.instruments.front().radius_mm + kStartAboveMm;
  return at;
}

/// Whether an opening driver still works: something of what it shows has changed within kQuiet.
class DriverLife {
 public:
  /// `view` null: it shows nothing.
  bool stands_still(const FalconView* view) {
    const auto now = std::chrono::steady_clock::now();
    const Shown shown = view == nullptr ? Shown{} : Shown{view->session.phase, view->session.attempt, view->session.uploaded, view->session.sent};
    if (std::exchange(shown_, shown) != shown) since_ = now;
    return now - since_ > kQuiet;
  }

 private:
  using Shown = std::tuple<falcon::Phase, int, std::uint32_t, std::uint64_t>;
  Shown shown_{};
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

void print_phase(const FalconView& view, falcon::Phase& printed) {
  if (view.session.phase == printed) return;
  printed = view.session.phase;
  std::fprintf(stderr, "falcon %s\n", std::string(falcon::key_of(printed)).c_str());
}

/// Until the operator has finished, the time is up, or somebody stops it. `operators` null: a real device.
void follow(ExerciseSession& session, const OperatorsInTurn* operators, const LiveOptions& options, const std::function<bool()>& stop,
            LiveFigures& figures) {
  bool was_held = false, coolant = false;
  double printed_s = 0;
  for (;;) {
    std::this_thread::sleep_for(kLook);
    const LiveView view = session.view();
    if (options.progress && view.seconds >= printed_s + 1.0) {
      printed_s = view.seconds;
      std::fprintf(stderr, "%.3f\n", view.seconds);
    }
    if (view.loop.tick_max_us > figures.loop.tick_max_us) {
      figures.loop.tick_max_us = view.loop.tick_max_us;
      figures.tick_max_at_s = view.seconds;
      if (options.progress) std::fprintf(stderr, "tick %.0f us\n", view.loop.tick_max_us);
    }
    if (operators && operators->wants_coolant() && !coolant) session.set_coolant(coolant = true);
    const bool held = view.phase == LoopPhase::held;
    if (held && !was_held) {
      ++figures.holds;
      if (options.progress) std::fprintf(stderr, "held\n");
    }
    was_held = held;
    // Nobody is there to press a button: the session resumes as soon as the device has come back.
    if (held && view.device == Sample::Status::fresh) session.resume();
    if (stop() || view.time_is_up || view.phase == LoopPhase::ended) break;
    if (options.seconds > 0 && view.seconds >= options.seconds) break;
    if (operators && operators->done()) break;
  }
}

}  // namespace

bool can_play_live(const DeviceChoice& choice) noexcept {
  return choice.kind == "falcon" || choice.kind == "emulated-falcon";
}

nlohmann::ordered_json to_json(const LiveFigures& f) {
  return {{"wall_s", f.wall_s},
          {"ticks", f.loop.ticks},
          {"tick_cpu_us",
           {{"p50", f.loop.tick_p50_us}, {"p99", f.loop.tick_p99_us}, {"p999", f.loop.tick_p999_us}, {"max", f.loop.tick_max_us}}},
          {"tick_cpu_max_at_s", f.tick_max_at_s},
          {"exchange_p99_us", f.loop.exchange_p99_us},
          {"realtime", f.grant.realtime()},
          {"holds", f.holds},
          {"silences", f.silences},
          {"answers", f.answers},
          {"lost_answers", f.lost_answers},
          {"stale_answers", f.stale_answers},
          {"dropped_answers", f.dropped_answers}};
}

Outcome<SessionResult> play_live(SessionPlan plan, const DeviceChoice& choice, const LiveOptions& options,
                         const std::function<bool()>& stop, LiveFigures& figures) {
  Vec3 start_mm = start_above(*plan.specimen, plan.scenario);
  std::shared_ptr<OperatorsInTurn> operators;
  const auto emulated = std::make_shared<std::atomic<EmulatedFalconPort*>>(nullptr);  // a driver that stands still keeps its hand beyond this call
  EmulatedHand lead;
  if (choice.kind == "emulated-falcon") {
    std::vector<ScriptedOperator> made;
    for (std::size_t i = 0; i < (options.seconds > 0 ? kMostOperators : 1); ++i) {
      auto scripted = operator_by_name(options.script, plan.scenario, *plan.specimen, options.seed + i);
      if (!scripted) return session_fail(SessionError::device, Failure<PortError>{PortError::bad_file, options.script, "operator"});
      made.push_back(std::move(*scripted));
    }
    operators = std::make_shared<OperatorsInTurn>(std::move(made));
    start_mm = operators->start_mm();
    // The emulated device falls mute from its own thread: only the hand's calls reach it.
    lead = [operators, emulated, every = options.silence_every_s](const Feedback& felt, double dt_s) noexcept {
      const EmulatedHandPose pose = operators->next(felt, dt_s);
      if (EmulatedFalconPort* own = emulated->load(std::memory_order_relaxed); own != nullptr && every > 0) {
        const double s = operators->clock_s();
        own->falcon().fall_mute(s >= every && s - every * static_cast<double>(static_cast<long>(s / every)) < kSilenceS);
      }
      return pose;
    };
    plan.operator_name = options.script;
  }
  auto made = make_session_device(choice, start_mm, plan.scenario.instruments.size(), std::move(lead));
  if (!made) return session_fail(SessionError::device, made.error());
  SessionDevice device = std::move(*made);
  *emulated = device.emulated;
  const std::shared_ptr<HapticPort> port = std::move(device.port);
  std::atomic<bool> called_off{false};
  auto starting = std::async(std::launch::async, [&plan, &port, &called_off] {
    return ExerciseSession::start(std::move(plan), port, [&called_off] { return called_off.load(); });
  });
  falcon::Phase printed = falcon::Phase::unplugged;
  DriverLife life;
  while (starting.wait_for(kLook) != std::future_status::ready) {
    if (device.falcon != nullptr && options.progress) print_phase(device.falcon->view(), printed);
    if (life.stands_still(device.view()) || stop()) called_off = true;
    if (device.falcon != nullptr && called_off) device.falcon->cancel();
  }
  auto started = starting.get();
  if (!started) return std::unexpected(started.error());
  ExerciseSession& session = **started;
  const auto began = std::chrono::steady_clock::now();
  follow(session, operators.get(), options, stop, figures);
  figures.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const LiveView last = session.view();
  figures.loop = last.loop;
  figures.grant = last.grant;
  auto result = session.finish();
  if (const FalconView* falcon = device.view()) {
    figures.silences = falcon->session.silences;
    figures.lost_answers = falcon->session.lost;
    figures.answers = falcon->session.replies;
    figures.stale_answers = falcon->session.stale;
    figures.dropped_answers = falcon->session.flawed + falcon->session.unasked + falcon->unreached;
  }
  return result;
}

}  // namespace cusp::ui
