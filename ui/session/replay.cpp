#include "ui/session/replay.h"

#include <algorithm>
#include <optional>

#include "scenarios/format/read.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "ui/modules.h"
#include "ui/session/session_setup.h"
#include "ui/session/scene_builder.h"
#include "ui/session/specimen_blob.h"

namespace cusp::ui {

namespace {

template <class T>
std::unexpected<SessionFailure> storage_failed(const Stored<T>& result) {
  return session_fail(SessionError::storage, result.error());
}

}  // namespace

Outcome<Scenario> exercise_of(const Session& session, const ScenarioVersion& version) {
  auto scenario = read_scenario(session.header.exercise.empty() ? version.json : session.header.exercise);
  if (!scenario) return session_fail(SessionError::scenario, scenario.error());
  return std::move(*scenario);
}

Outcome<OpenedSession> open_session(Store& store, SessionId id) {
  OpenedSession out;
  auto session = store.sessions.find(id);
  if (!session && session.error().code == StorageError::not_found) session.error().where = id.text();
  if (!session) return storage_failed(session);
  out.session = std::move(*session);
  auto events = store.sessions.events(id);
  if (!events) return storage_failed(events);
  out.events = std::move(*events);
  out.state = state_after(out.events);
  auto version = store.scenarios.version(out.session.version);
  if (!version) return storage_failed(version);
  out.version = std::move(*version);
  auto scenario = exercise_of(out.session, out.version);
  if (!scenario) return std::unexpected(scenario.error());
  out.scenario = std::move(*scenario);
  const SessionHeader& header = out.session.header;
  out.same_engine = header.engine_version == kEngineVersion;

  auto bytes = store.blobs.get(header.specimen_blob);
  if (!bytes) return storage_failed(bytes);
  const auto dense = specimen_from_bytes(*bytes);
  if (!dense) return session_fail(SessionError::specimen_changed, id.text());
  auto specimen = Specimen::build(*dense, reading_of(out.scenario.method));
  if (specimen->hash() != header.specimen_hash) return session_fail(SessionError::specimen_changed, id.text());
  auto scene = build_scene(out.scenario, std::move(specimen), header.device, header.guard,
                           header.stiffness_share);
  if (!scene) return std::unexpected(scene.error());
  out.scene = std::move(*scene);

  auto chunks = store.traces.chunks(id);
  if (!chunks) return storage_failed(chunks);
  if (!chunks->empty()) {
    out.ticks = chunks->back().first_tick + chunks->back().count - 1;
    out.elapsed_us = chunks->back().elapsed_us;
  }
  return out;
}

namespace {

SessionResult result_of(const OpenedSession& opened) {
  SessionResult result;
  result.session = opened.session.id;
  result.state = opened.state;
  result.interrupted = std::ranges::none_of(opened.events, [](const SessionEvent& e) { return e.kind == EventKind::finished; });
  result.scenario = opened.scenario;
  result.seconds = static_cast<double>(opened.elapsed_us) * 1e-6;
  result.device = opened.session.header.device;
  result.stiffness_share = opened.session.header.stiffness_share;
  result.operator_name = opened.session.operator_name;
  result.engine_version = opened.session.header.engine_version;
  return result;
}

Outcome<void> keep_grade(Store& store, const SessionResult& result, const Rubric& rubric, std::uint64_t tick,
                     const std::optional<Actor>& grader) {
  std::optional<FinalVolume> whole;
  if (result.interrupted) whole = FinalVolume{result.volume->save_cuts(), result.volume_hash, tick};
  auto saved = store.grades.save(result.session, result.grade, rubric_hash(rubric), grader, whole ? &*whole : nullptr);
  if (!saved) return storage_failed(saved);
  store.key_states.release(result.session);
  return {};
}

}  // namespace

Outcome<SessionResult> grade_session(Store& store, SessionId id, const Rubric* other_rubric, Keep keep,
                             const std::optional<Actor>& grader) {
  auto opened = open_session(store, id);
  if (!opened) return std::unexpected(opened.error());
  if (opened->state == SessionState::running) return session_fail(SessionError::wrong_state, id.text());
  SessionResult result = result_of(*opened);
  if (other_rubric) result.scenario.rubric = *other_rubric;
  auto replay = Replay::open(store, *opened);
  if (!replay) return std::unexpected(replay.error());
  if (auto done = replay->to(UINT64_MAX, {.from = ReplayFrom::first_tick}); !done) return std::unexpected(done.error());
  const Reference reference(result.scenario, opened->scene->specimen);  // what the rubric asks for is measured
  result.volume = std::make_shared<const Volume>(replay->state().volume());
  result.volume_hash = result.volume->hash();
  result.measures = measure(reference, *result.volume, replay->process());
  result.grade = grade(result.scenario, result.measures, sensed_axes(result.device));
  const auto stored = store.grades.newest(id);
  if (!stored) return storage_failed(stored);
  if (*stored && !other_rubric) result.changes = changes((*stored)->grade, result.grade);
  if (keep == Keep::grade) {
    auto kept = keep_grade(store, result, result.scenario.rubric, replay->state().last().tick, grader);
    if (!kept) return std::unexpected(kept.error());
    result.state = SessionState::graded;
  }
  return result;
}

Outcome<SessionResult> open_result(Store& store, SessionId id, Keep keep) {
  auto opened = open_session(store, id);
  if (!opened) return std::unexpected(opened.error());
  auto graded = store.grades.newest(id);
  if (!graded) return storage_failed(graded);
  auto stored = store.traces.final_volume(id);
  if (!stored) return storage_failed(stored);
  if (!*graded || !*stored) return grade_session(store, id, nullptr, keep);

  SessionResult result = result_of(*opened);
  result.grade = std::move((*graded)->grade);
  auto volume = std::make_shared<Volume>(opened->scene->specimen);
  if (!volume->load_cuts((*stored)->cuts)) {
    return session_fail(SessionError::storage, Failure<StorageError>{StorageError::bad_trace, "final_volumes", {}});
  }
  result.volume_hash = volume->hash();
  result.volume = std::move(volume);
  return result;
}

}  // namespace cusp::ui
