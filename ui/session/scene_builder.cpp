#include "ui/session/scene_builder.h"

#include <algorithm>
#include <array>

#include "engine/step/passivity.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/tool_axis.h"
#include "scenarios/specimens/specimens.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

std::array<bool, kTissueCodes> tissues_in(const Specimen& specimen) {
  std::array<bool, kTissueCodes> there{};
  const IVec3 n = specimen.brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const int last = specimen.uniform(b) ? 1 : kBrickVoxels;
    for (int o = 0; o < last; ++o) there[index_of(specimen.tissue_in(b, o))] = true;
  }
  there[index_of(Tissue::empty)] = false;
  return there;
}

}  // namespace

Outcome<std::shared_ptr<const Specimen>> build_specimen(const Scenario& scenario, const std::filesystem::path& folder,
                                                    const std::atomic<bool>* stop) {
  auto dense = make_specimen(scenario.specimen, folder, stop);
  if (!dense) return session_fail(SessionError::specimen, dense.error());
  return Specimen::build(*dense, reading_of(scenario.method));
}

StiffnessCut stiffness_cut(const Scenario& scenario, double voxel_mm, const DeviceLimits& device) noexcept {
  StiffnessCut out;
  out.rule = stiffness_rule(device, scenario.method, voxel_mm);
  for (const ScenarioTissue& tissue : scenario.tissues)
    out.asked_n_per_mm = std::max(out.asked_n_per_mm, tissue.stiffness_n_per_mm);
  if (out.asked_n_per_mm > out.rule.most_n_per_mm) out.share = out.rule.most_n_per_mm / out.asked_n_per_mm;
  return out;
}

Outcome<void> check_axes(const Scenario& scenario, const DeviceLimits& device) {
  if (device.device_class == "scripted" || sensed_axes(device) >= scenario.device.needs_dof) return {};
  return session_fail(SessionError::device_axes, device.device_class, std::to_string(scenario.device.needs_dof));
}

Outcome<std::shared_ptr<const Scene>> build_scene(const Scenario& scenario, std::shared_ptr<const Specimen> specimen,
                                              const DeviceLimits& device) {
  // Of a new attempt: one that was recorded with fewer axes still opens.
  if (auto enough = check_axes(scenario, device); !enough) return std::unexpected(std::move(enough.error()));
  GuardSettings guard;
  guard.limit_n = device.max_force_n;
  // A mouse and a script have no motor: a late tick cannot push a hand, and a busy desktop's stalls are no faults then.
  if (device.device_class == "pointer" || device.device_class == "emulated-falcon") guard.late_ms = 250.0;
  if (device.device_class == "scripted") guard.late_ms = 1000.0;
  if (!device.closed_loop) {
    // A trace's rows lie as far apart as they lie; and where the hand gives force, there is no energy to feed.
    guard = guard.without(GuardPart::stale).without(GuardPart::speed).without(GuardPart::passivity);
  }
  if (device.encoder_mm) guard.encoder_mm = *device.encoder_mm;
  guard.delay_ms = std::clamp(device.delay_ms.value_or(1.0), 0.0, static_cast<double>(kMostDelayTicks));
  const double share = stiffness_cut(scenario, specimen->grid().voxel_mm, device).share;
  return build_scene(scenario, std::move(specimen), device, guard, share);
}

Outcome<std::shared_ptr<const Scene>> build_scene(const Scenario& scenario, std::shared_ptr<const Specimen> specimen,
                                              const DeviceLimits& device, const GuardSettings& guard,
                                              double stiffness_share) {
  const auto& admitted = scenario.device.admitted;
  const bool scripted = device.device_class == "scripted";  // a script may play every exercise; its results stay apart
  if (!scripted && !admitted.empty() && std::find(admitted.begin(), admitted.end(), device.device_class) == admitted.end()) {
    return session_fail(SessionError::device_class, device.device_class);
  }
  if (scenario.instruments.empty()) return session_fail(SessionError::scene, "/instruments");

  auto scene = std::make_shared<Scene>();
  scene->method = scenario.method;
  std::array<bool, kTissueCodes> described{};
  for (std::size_t i = 0; i < scenario.tissues.size(); ++i) {
    const ScenarioTissue& tissue = scenario.tissues[i];
    const std::string where = "/tissues/" + std::to_string(i);
    const bool stiff = tissue.stiffness_n_per_mm > 0.0 && tissue.stiffness_n_per_mm <= 20.0;
    if (!stiff || index_of(tissue.tissue) >= kTissueCodes) return session_fail(SessionError::scene, where);
    if (!(tissue.speed_mm_s >= 0.0)) return session_fail(SessionError::scene, where);
    scene->tissues[index_of(tissue.tissue)] = {tissue.stiffness_n_per_mm * stiffness_share, tissue.speed_mm_s};
    described[index_of(tissue.tissue)] = true;
  }
  const auto there = tissues_in(*specimen);
  for (std::size_t t = 0; t < kTissueCodes; ++t) {
    if (there[t] && !described[t]) {
      return session_fail(SessionError::scene, "/tissues", t < kTissueKeys.size() ? std::string(kTissueKeys[t]) : std::to_string(t));
    }
  }
  for (std::size_t i = 0; i < scenario.instruments.size(); ++i) {
    if (!(scenario.instruments[i].radius_mm > 0.0)) return session_fail(SessionError::scene, "/instruments/" + std::to_string(i));
  }
  if (!(scenario.device.full_force_n > 0.0)) return session_fail(SessionError::scene, "/device/full_force_n");
  scene->specimen = std::move(specimen);
  scene->burs = scenario.instruments;
  scene->tool_axis = resting_axis(scenario.tool_tilt_deg);
  scene->tilt_cosine = sine_cosine(scenario.tool_turn_deg).cosine;
  scene->full_force_n = scenario.device.full_force_n;
  scene->friction = has_phenomenon(scenario.phenomena, "friction");
  scene->phenomena = phenomena_from_keys(scenario.phenomena);
  scene->guard = guard;
  return scene;
}

}  // namespace cusp::ui
