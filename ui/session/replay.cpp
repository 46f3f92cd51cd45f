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

/// `before`: how many grades the session had when the caller looked.
Stored<void> keep_grade(Store& store, const SessionResult& result, std::uint64_t tick, const std::optional<Actor>& grader,
                        std::size_t before) {
  std::optional<FinalVolume> whole;
  if (result.interrupted) whole = FinalVolume{result.volume->save_cuts(), result.volume_hash, tick};
  const auto saved =
      store.grades.save(result.session, result.grade, rubric_hash(result.scenario.rubric), grader, whole ? &*whole : nullptr, before);
  if (!saved) return std::unexpected(saved.error());
  store.key_states.release(result.session);
  return {};
}

bool graded_meanwhile(const StorageFailure& failure) { return failure.code == StorageError::wrong_state && failure.where == "graded"; }

/// What grade_session() does. `before`: the grades that the caller has seen.
struct GradingOrder {
  const Rubric* other_rubric = nullptr;
  Keep keep = Keep::nothing;
  std::optional<Actor> grader{};
  std::vector<StoredGrade> before{};
};

Outcome<SessionResult> carry_out(Store& store, SessionId id, const GradingOrder& order) {
  auto opened = open_session(store, id);
  if (!opened) return std::unexpected(opened.error());
  if (opened->state == SessionState::running) return session_fail(SessionError::wrong_state, id.text());
  SessionResult result = result_of(*opened);
  if (order.other_rubric) result.scenario.rubric = *order.other_rubric;
  auto replay = Replay::open(store, *opened);
  if (!replay) return std::unexpected(replay.error());
  if (auto done = replay->to(UINT64_MAX, {.from = ReplayFrom::first_tick}); !done) return std::unexpected(done.error());
  const Reference reference(result.scenario, opened->scene->specimen);  // what the rubric asks for is measured
  result.volume = std::make_shared<const Volume>(replay->state().volume());
  result.volume_hash = result.volume->hash();
  result.measures = measure(reference, *result.volume, replay->process());
  result.grade = grade(result.scenario, result.measures, sensed_axes(result.device));
  if (!order.before.empty() && !order.other_rubric) result.changes = changes(order.before.back().grade, result.grade);
  if (order.keep == Keep::grade) {
    const auto kept = keep_grade(store, result, replay->state().last().tick, order.grader, order.before.size());
    // Another desk was first: its grade counts, and what was stated about it.
    if (!kept && !order.other_rubric && graded_meanwhile(kept.error())) return open_result(store, id);
    if (!kept) return storage_failed(kept);
    result.state = SessionState::graded;
  }
  return result;
}

}  // namespace

Outcome<SessionResult> grade_session(Store& store, SessionId id, const Rubric* other_rubric, Keep keep,
                             const std::optional<Actor>& grader) {
  auto before = store.grades.all(id);
  if (!before) return storage_failed(before);
  return carry_out(store, id, {other_rubric, keep, grader, std::move(*before)});
}

Outcome<SessionResult> open_result(Store& store, SessionId id, Keep keep) {
  auto opened = open_session(store, id);
  if (!opened) return std::unexpected(opened.error());
  auto grades = store.grades.all(id);
  if (!grades) return storage_failed(grades);
  auto stored = store.traces.final_volume(id);
  if (!stored) return storage_failed(stored);
  if (grades->empty() || !*stored) return carry_out(store, id, {.keep = keep, .before = std::move(*grades)});

  SessionResult result = result_of(*opened);
  result.grade = std::move(grades->back().grade);
  auto volume = std::make_shared<Volume>(opened->scene->specimen);
  if (!volume->load_cuts((*stored)->cuts)) {
    return session_fail(SessionError::storage, Failure<StorageError>{StorageError::bad_trace, "final_volumes", {}});
  }
  result.volume_hash = volume->hash();
  result.volume = std::move(volume);
  return result;
}

}  // namespace cusp::ui
