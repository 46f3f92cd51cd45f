#include "ui/session/session_setup.h"

#include <nlohmann/json.hpp>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "ui/modules.h"
#include "ui/session/build_info.h"
#include "ui/session/file_bytes.h"
#include "ui/session/patience.h"
#include "ui/session/replay.h"
#include "ui/session/scene_builder.h"
#include "ui/session/specimen_blob.h"

namespace cusp::ui {

namespace {

/// The version that this attempt is of: the one that the plan names, or the scenario's own, published at need.
Outcome<VersionId> version_of(const SessionPlan& plan, Store& store) {
  if (!plan.version.is_nil()) return plan.version;
  std::map<std::string, std::vector<std::byte>> beside;
  std::map<std::string, Hash256> files;
  if (plan.scenario.specimen.generator.empty()) {
    const std::string& name = plan.scenario.specimen.volume;
    auto bytes = bytes_of(plan.scenario_folder / name);
    if (!bytes) return session_fail(SessionError::specimen, import_failure_of(bytes.error()));
    auto kept = store.blobs.put(*bytes);
    if (!kept) return session_fail(SessionError::storage, kept.error());
    files[name] = *kept;
    beside[name] = std::move(*bytes);
  }
  const std::string json = canonical_json(plan.scenario);
  auto version = store.scenarios.ensure(plan.scenario, json, content_hash(plan.scenario, beside).bytes, files);
  if (!version) return session_fail(SessionError::storage, version.error());
  return version->id;
}

Outcome<void> resume(SessionPlan& plan, SessionSetup& setup, const std::function<bool()>& called_off) {
  auto opened = open_session(*setup.store, plan.resumes);
  if (!opened) return std::unexpected(opened.error());
  if (opened->session.student != plan.student.id) {
    return session_fail(SessionError::storage, Failure<StorageError>{StorageError::not_allowed, "drill", {}});
  }
  if (opened->session.header.device.device_class != setup.device.device_class) {
    return session_fail(SessionError::device_class, setup.device.device_class);
  }
  // The record has the axes of the device that it began with: of this class, another one or the same without its handle may sense fewer.
  if (auto enough = check_axes(opened->scenario, setup.device); !enough) return std::unexpected(std::move(enough.error()));
  plan.scenario = opened->scenario;
  plan.specimen = opened->scene->specimen;
  setup.device = opened->session.header.device;
  setup.scene = opened->scene;
  setup.stiffness_share = opened->session.header.stiffness_share;
  setup.time_limit_s = extended_limit_s(plan.scenario.time_limit_s, opened->session.header.extra_time_percent);
  auto replay = Replay::open(*setup.store, std::move(*opened));
  if (!replay) return std::unexpected(replay.error());
  ReplayJump whole{.from = ReplayFrom::whole_process};
  if (called_off) whole.watch = [&called_off](double) { return !called_off(); };
  const auto arrived = replay->to(UINT64_MAX, whole);
  if (!arrived) return std::unexpected(arrived.error());
  if (!*arrived) return session_fail(SessionError::specimen, ImportFailure{ImportError::cancelled, "attempt", {}});
  setup.process = replay->process();
  const auto bytes = replay->state().save();
  setup.loop_start = StepState::restore(setup.scene, bytes);
  setup.mirror_start = StepState::restore(setup.scene, bytes);
  setup.reference = std::make_shared<const Reference>(plan.scenario, plan.specimen);
  if (auto resumed = setup.store->sessions.resume(plan.resumes, "student"); !resumed) {
    return session_fail(SessionError::storage, resumed.error());
  }
  setup.session = plan.resumes;
  return {};
}

/// The attempt's row. `plan` has its specimen, `setup` its scene and device.
NewSession row_of(const SessionPlan& plan, const SessionSetup& setup, VersionId version, const Hash256& specimen) {
  NewSession row;
  row.student = plan.student.id;
  row.version = version;
  row.kind = plan.kind;
  row.assignment = plan.assignment;
  row.start_code = plan.start_code;
  row.operator_name = plan.operator_name;
  row.header.build = build_info();
  row.header.device = setup.device;
  row.header.guard = setup.scene->guard;
  row.header.stiffness_share = setup.stiffness_share;
  row.header.specimen_hash = plan.specimen->hash();
  row.header.specimen_blob = specimen;
  if (plan.drawn_tooth) row.header.exercise = canonical_json(plan.scenario);
  nlohmann::json account;
  account["method"] = std::string(key_of(setup.scene->method));
  account["friction"] = setup.scene->friction;
  account["full_force_n"] = setup.scene->full_force_n;
  row.header.scene = account.dump();
  return row;
}

}  // namespace

Outcome<SessionSetup> set_up(SessionPlan& plan, const DeviceLimits& device, const std::function<bool()>& called_off) {
  SessionSetup setup;
  setup.device = device;
  if (!plan.database.empty()) {
    auto store = Store::open(plan.database);
    if (!store) return session_fail(SessionError::storage, store.error());
    setup.store = std::move(*store);
  }
  if (!plan.resumes.is_nil()) {
    if (!setup.store) return session_fail(SessionError::wrong_state, plan.resumes.text());
    if (auto done = resume(plan, setup, called_off); !done) return std::unexpected(done.error());
    return setup;
  }

  if (!plan.specimen) {
    auto specimen = build_specimen(plan.scenario, plan.scenario_folder);
    if (!specimen) return std::unexpected(specimen.error());
    plan.specimen = std::move(*specimen);
  }
  auto scene = build_scene(plan.scenario, plan.specimen, device);
  if (!scene) return std::unexpected(scene.error());
  setup.scene = std::move(*scene);
  setup.stiffness_share = stiffness_cut(plan.scenario, plan.specimen->grid().voxel_mm, device).share;
  setup.reference = plan.reference ? plan.reference : std::make_shared<const Reference>(plan.scenario, plan.specimen);
  setup.time_limit_s = plan.scenario.time_limit_s;
  setup.loop_start.emplace(setup.scene);
  setup.mirror_start.emplace(setup.scene);
  if (!setup.store) return setup;

  // A session that could not be opened again must not begin.
  if (auto readable = read_scenario(canonical_json(plan.scenario)); !readable) {
    return session_fail(SessionError::scenario, readable.error());
  }
  auto version = version_of(plan, *setup.store);
  if (!version) return std::unexpected(version.error());
  auto blob = setup.store->blobs.put(specimen_bytes(plan.specimen->dense()));
  if (!blob) return session_fail(SessionError::storage, blob.error());
  const NewSession row = row_of(plan, setup, *version, *blob);
  auto session = setup.store->sessions.start(plan.student, row);
  if (!session) return session_fail(SessionError::storage, session.error());
  setup.session = session->id;
  setup.time_limit_s = extended_limit_s(plan.scenario.time_limit_s, session->header.extra_time_percent);
  return setup;
}

std::string_view key_of(SessionEnd end) noexcept {
  switch (end) {
    case SessionEnd::student: return "student";
    case SessionEnd::time_limit: return "time_limit";
    case SessionEnd::script: return "script";
    case SessionEnd::recorder_full: return "recorder_full";
    case SessionEnd::stopped: return "stopped";
  }
  return "stopped";
}

Hash256 rubric_hash(const Rubric& rubric) {
  Scenario only;
  only.rubric = rubric;
  const auto json = nlohmann::json::parse(hashed_json(only), nullptr, false);
  // Sorted keys and the shortest numbers, as canonical JSON of the whole: a part of it is canonical again.
  return blake2b_256(json.is_object() && json.contains("rubric") ? json["rubric"].dump() : std::string());
}

namespace {

/// The event, of a finished attempt with its volume; that of an interrupted one is kept with the grade, so that it can be resumed
/// until then. What passes by itself is waited for; a second try after any failure continues where the first stopped.
Stored<void> keep_end(Store& store, SessionId session, const FinalVolume& volume, SessionEnd end) {
  const std::string reason(key_of(end));
  const auto now = write_patiently({}, [&] { return store.sessions.state(session); });
  if (!now) return std::unexpected(now.error());
  if (*now == SessionState::running && !interrupts(end)) {
    return write_patiently({}, [&] { return store.sessions.finish(session, volume, reason); });
  }
  if (*now == SessionState::running) {
    return write_patiently({}, [&] { return store.sessions.interrupt(session, reason); });
  }
  return {};
}

}  // namespace

Outcome<SessionResult> conclude(const SessionPlan& plan, const SessionSetup& setup, Store* store, const StepState& state,
                        const Process& process, SessionEnd end, const MeasureProgress& progress) {
  SessionResult result;
  result.session = setup.session;
  result.scenario = plan.scenario;
  result.volume = std::make_shared<const Volume>(state.volume());
  result.volume_hash = state.volume().hash();
  result.seconds = process.time_s();
  result.device = setup.device;
  result.stiffness_share = setup.stiffness_share;
  result.operator_name = plan.operator_name;
  result.interrupted = interrupts(end);
  result.measures = measure(*setup.reference, *result.volume, process, progress);
  result.grade = grade(plan.scenario, result.measures, sensed_axes(setup.device));
  if (!store) return result;

  const FinalVolume volume{result.volume->save_cuts(), result.volume_hash, state.last().tick};
  if (auto done = keep_end(*store, setup.session, volume, end); !done) {
    return session_fail(SessionError::recording_failed, done.error());
  }
  const Hash256 rubric = rubric_hash(plan.scenario.rubric);
  const auto graded = write_patiently({}, [&] { return store->grades.save(setup.session, result.grade, rubric, std::nullopt, &volume); });
  if (!graded) return session_fail(SessionError::recording_failed, graded.error());
  store->key_states.release(setup.session);
  return result;
}

}  // namespace cusp::ui
