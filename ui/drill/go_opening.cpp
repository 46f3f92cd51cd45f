#include "ui/drill/go_opening.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "ui/render/scenery_look.h"
#include "ui/session/errand.h"
#include "ui/session/scene_builder.h"

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

}  // namespace

GoOpening::GoOpening(Order order, Answer answer) {
  auto shared = std::make_shared<Order>(std::move(order));
  thread_ = std::thread([this, shared, answer = std::move(answer)] {
    open(std::move(*shared), [this, &answer](std::shared_ptr<OpenedGo> go, std::optional<RunFailure> failure) {
      over_.store(true, std::memory_order_release);
      answer(std::move(go), std::move(failure));
    });
  });
}

GoOpening::~GoOpening() {
  // A port forgets a cancel() that came before its open().
  while (!over_.load(std::memory_order_acquire)) {
    call_off();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  thread_.join();
}

void GoOpening::call_off() noexcept {
  called_off_ = true;
  if (FalconPort* falcon = falcon_.load(std::memory_order_acquire)) falcon->cancel();
  if (InversePort* inverse = inverse_.load(std::memory_order_acquire)) inverse->cancel();
}

void GoOpening::open(Order order, const Answer& answer) {
  RunPlan& plan = order.plan;
  auto go = std::make_shared<OpenedGo>();
  // Beside the specimen: a jaw's other teeth take as long as its own.
  std::jthread beside([&go = *go, source = plan.scenario.specimen] { go.scenery = scenery_of(source); });
  auto specimen = plan.specimen ? Run<std::shared_ptr<const Specimen>>(plan.specimen)
                                : build_specimen(plan.scenario, plan.scenario_folder);
  if (!specimen) return answer(nullptr, specimen.error());
  plan.specimen = *specimen;
  go->look = std::make_shared<TargetLook>(plan.scenario.target, plan.scenario.leeway);
  go->patches = std::make_shared<PatchFeed>(go->look->feed());
  {
    const Volume whole(*specimen);
    go->patches->build_all(whole);
    go->lines = go->look->lines(whole);
  }
  const Grid& grid = (*specimen)->grid();
  go->bounds = {grid.origin_mm, grid.centre_mm(grid.size)};
  for (const ScenarioTissue& t : plan.scenario.tissues) go->has_pulp = go->has_pulp || t.tissue == Tissue::pulp;
  if (go->has_pulp) go->pulp_depth_mm = pulp_under(**specimen, *go->look);
  beside.join();
  go->feed = std::make_shared<DrillFeed>(go->patches, *go->look, go->bounds, std::move(order.frame_wanted), go->scenery);
  plan.observers.push_back(go->feed.get());
  if (order.port) {
    go->device.port = std::move(order.port);
  } else {
    const Vec3 start =
        start_place(**specimen, *go->look, plan.scenario.instruments.empty() ? Bur() : plan.scenario.instruments[0]);
    auto device = make_run_device(order.choice, start, plan.scenario.instruments.size());
    if (!device) return answer(nullptr, std::move(run_fail(RunError::device, device.error()).error()));
    go->device = std::move(*device);
  }
  wait_for_dropped_errands();  // a page may still be closing the device
  falcon_.store(go->device.falcon, std::memory_order_release);
  inverse_.store(go->device.inverse, std::memory_order_release);
  auto run = ExerciseRun::start(std::move(plan), *go->device.port);
  falcon_.store(nullptr, std::memory_order_release);
  inverse_.store(nullptr, std::memory_order_release);
  if (!run) {
    // The window may hold the pointer for the length of one look: the port goes with the answer, on its thread.
    auto failed = run.error();
    return answer(std::move(go), std::move(failed));
  }
  go->run = std::move(*run);
  answer(std::move(go), std::nullopt);
}

}  // namespace cusp::ui
