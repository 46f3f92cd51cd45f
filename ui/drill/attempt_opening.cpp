#include "ui/drill/attempt_opening.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/session/background_task.h"
#include "ui/session/drawn_tooth.h"
#include "ui/session/replay.h"

namespace cusp::ui {
namespace {

constexpr double kStartAboveMm = 1.5;

/// Place above the target where the bur begins, clear of all tissue.
Vec3 start_place(const Specimen& specimen, const TargetLook& look, const Bur& bur) {
  const Grid& grid = specimen.grid();
  const Vec3 top = grid.centre_mm(grid.size);
  Vec3 at = 0.5 * (grid.origin_mm + top);
  if (!look.empty()) {
    at.x = 0.5 * (look.shape().low().x + look.shape().high().x);
    at.y = 0.5 * (look.shape().low().y + look.shape().high().y);
  }
  at.z = top.z + bur.radius_mm + kStartAboveMm;
  return at;
}

/// A practice block bears its task; a tooth does not.
bool has_printed_target(const Scenario& scenario) { return scenario.specimen.generator.ends_with("block"); }

/// Of the highest pulp under the target and what stands about it, below the target's top; nullopt where there is none.
std::optional<double> pulp_under(const Specimen& specimen, const TargetLook& look) {
  if (look.empty()) return std::nullopt;
  constexpr double kAboutMm = 0.5;  // about the outline: a wall that leans out reaches there
  const Grid& grid = specimen.grid();
  const TargetShape& shape = look.shape();
  std::optional<double> highest_mm;
  for (int y = 0; y < grid.size.y; ++y) {
    for (int x = 0; x < grid.size.x; ++x) {
      const Vec3 foot = grid.centre_mm({x, y, 0});
      if (shape.outline_mm({foot.x, foot.y}) > kAboutMm) continue;
      for (int z = grid.size.z - 1; z >= 0; --z) {
        if (specimen.tissue({x, y, z}) != Tissue::pulp) continue;
        highest_mm = std::max(highest_mm.value_or(-1e300), grid.centre_mm({x, y, z}).z);
        break;
      }
    }
  }
  return highest_mm ? std::optional(shape.top_mm() - *highest_mm) : std::nullopt;
}

/// The tooth that an interrupted attempt began with, if it is not `grown`: another program may grow another one of the same exercise,
/// and the session goes on with its own. nullptr: it is the same.
Outcome<std::shared_ptr<const Specimen>> other_tooth(const SessionPlan& plan, const Specimen& grown) {
  auto store = Store::open(plan.database);
  if (!store) return session_fail(SessionError::storage, store.error());
  const auto session = (*store)->sessions.find(plan.resumes);
  if (!session) return session_fail(SessionError::storage, session.error());
  if (session->header.specimen_hash == grown.hash()) return std::shared_ptr<const Specimen>();
  auto opened = open_session(**store, plan.resumes);
  if (!opened) return std::unexpected(std::move(opened.error()));
  return opened->scene->specimen;
}

}  // namespace

AttemptOpening::AttemptOpening(Order order, Answer answer) {
  auto shared = std::make_shared<Order>(std::move(order));
  thread_ = std::thread([this, shared, answer = std::move(answer)] {
    open(std::move(*shared), [this, &answer](std::shared_ptr<OpenedAttempt> attempt, std::optional<SessionFailure> failure) {
      over_.store(true, std::memory_order_release);
      answer(std::move(attempt), std::move(failure));
    });
  });
}

AttemptOpening::~AttemptOpening() {
  // A port forgets a cancel() that came before its open().
  while (!over_.load(std::memory_order_acquire)) {
    call_off();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  thread_.join();
}

void AttemptOpening::call_off() noexcept {
  called_off_ = true;
  stop_ = true;
  if (FalconPort* falcon = falcon_.load(std::memory_order_acquire)) falcon->cancel();
  if (InversePort* inverse = inverse_.load(std::memory_order_acquire)) inverse->cancel();
}

AttemptOpening::Progress AttemptOpening::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

Outcome<std::shared_ptr<const ReadyTooth>> AttemptOpening::tooth(Order& order) {
  SessionPlan& plan = order.plan;
  if (!order.teeth) order.teeth = std::make_shared<ToothCache>(std::filesystem::path());
  const auto ready = [&](const Scenario& exercise) {
    return order.teeth->tooth({exercise, plan.scenario_folder, plan.guidance, plan.specimen}, &stop_, [this](ToothPart part, double share) {
      const std::lock_guard lock(mutex_);
      progress_ = {part, part == ToothPart::specimen ? share : -1};
    });
  };
  if (plan.drawn_tooth && plan.assignment) {
    auto drawn = draw_tooth(plan.scenario, *plan.assignment, plan.student.id, [&](const Scenario& exercise) -> Outcome<std::shared_ptr<const Specimen>> {
      const auto grown = ready(exercise);
      if (!grown) return std::unexpected(grown.error());
      return (*grown)->specimen;
    });
    if (!drawn) return std::unexpected(drawn.error());
    plan.scenario = std::move(*drawn);
  }
  auto grown = ready(plan.scenario);
  if (!grown || plan.resumes.is_nil() || plan.database.empty()) return grown;
  auto own = other_tooth(plan, *(*grown)->specimen);
  if (!own) return std::unexpected(std::move(own.error()));
  if (*own == nullptr) return grown;
  plan.specimen = std::move(*own);
  return ready(plan.scenario);
}

void AttemptOpening::open(Order order, const Answer& answer) {
  SessionPlan& plan = order.plan;
  auto attempt = std::make_shared<OpenedAttempt>();
  const auto ready = tooth(order);
  if (!ready) return answer(nullptr, ready.error());
  {
    const std::lock_guard lock(mutex_);
    progress_ = {};
  }
  const std::shared_ptr<const Specimen>& specimen = (*ready)->specimen;
  plan.specimen = specimen;
  plan.reference = (*ready)->reference;
  attempt->scenery = (*ready)->scenery;
  const auto target = std::make_shared<TargetLook>(plan.scenario.target, plan.scenario.leeway, specimen);
  const bool guided = plan.guidance == Guidance::full;
  attempt->look = guided ? target : std::make_shared<TargetLook>(Region{}, plan.scenario.leeway, specimen);
  FeedSettings feed = target->feed();
  if (!guided) feed.deviation = {};
  attempt->patches = std::make_shared<PatchFeed>(std::move(feed));
  {
    const Volume whole(specimen);
    attempt->patches->begin(whole, (*ready)->mesh);
    if (guided || has_printed_target(plan.scenario)) attempt->lines = target->lines(whole);
  }
  const Grid& grid = specimen->grid();
  attempt->bounds = {grid.origin_mm, grid.centre_mm(grid.size)};
  attempt->start_view = start_view(grid, *target);
  for (const ScenarioTissue& t : plan.scenario.tissues) attempt->has_pulp = attempt->has_pulp || t.tissue == Tissue::pulp;
  if (attempt->has_pulp) attempt->pulp_depth_mm = pulp_under(*specimen, *attempt->look);
  attempt->feed = std::make_shared<DrillFeed>(attempt->patches, *attempt->look, attempt->bounds, std::move(order.frame_wanted), attempt->scenery);
  plan.observers.push_back(attempt->feed.get());
  if (order.port) {
    attempt->device.port = std::move(order.port);
  } else {
    const Vec3 start =
        start_place(*specimen, *target, plan.scenario.instruments.empty() ? Bur() : plan.scenario.instruments[0]);
    auto device = make_session_device(order.choice, start, plan.scenario.instruments.size());
    if (!device) return answer(nullptr, std::move(session_fail(SessionError::device, device.error()).error()));
    attempt->device = std::move(*device);
  }
  const auto called_off = [this] { return stop_.load(); };
  wait_for_dropped_devices(called_off);  // a page may still be closing the device
  if (stop_) return answer(nullptr, session_fail(SessionError::specimen, ImportFailure{ImportError::cancelled, "attempt", {}}).error());
  falcon_.store(attempt->device.falcon, std::memory_order_release);
  inverse_.store(attempt->device.inverse, std::memory_order_release);
  attempt->port = std::move(attempt->device.port);
  auto session = ExerciseSession::start(std::move(plan), attempt->port, called_off);
  falcon_.store(nullptr, std::memory_order_release);
  inverse_.store(nullptr, std::memory_order_release);
  if (!session) {
    // The window may hold the pointer for the length of one look: the port goes with the answer, on its thread.
    auto failed = session.error();
    return answer(std::move(attempt), std::move(failed));
  }
  attempt->session = std::move(*session);
  answer(std::move(attempt), std::nullopt);
}

}  // namespace cusp::ui
