#include "ui/session/replay.h"

#include <algorithm>
#include <bit>

#include "engine/base/fp_guard.h"
#include "scenarios/format/read.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "ui/session/run_setup.h"
#include "ui/session/scene_builder.h"
#include "ui/session/specimen_blob.h"

namespace cusp {

namespace {

template <class T>
std::unexpected<RunFailure> storage_failed(const Stored<T>& result) {
  return run_fail(RunError::storage, result.error());
}

}  // namespace

Run<OpenedSession> open_session(Store& store, SessionId id) {
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
  auto scenario = read_scenario(out.version.json);
  if (!scenario) return run_fail(RunError::scenario, scenario.error());
  out.scenario = std::move(*scenario);
  const SessionHeader& header = out.session.header;
  out.same_engine = header.engine_version == kEngineVersion;

  auto bytes = store.blobs.get(header.specimen_blob);
  if (!bytes) return storage_failed(bytes);
  const auto dense = specimen_from_bytes(*bytes);
  if (!dense) return run_fail(RunError::specimen_changed, id.text());
  auto specimen = Specimen::build(*dense, reading_of(out.scenario.method));
  if (specimen->hash() != header.specimen_hash) return run_fail(RunError::specimen_changed, id.text());
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

Replay::Replay(Store& store, OpenedSession session, std::vector<StepInput> inputs)
    : store_(&store), session_(std::move(session)), inputs_(std::move(inputs)), state_(std::in_place, session_.scene) {
  const IVec3 n = session_.scene->specimen->brick_count();
  shown_revision_.assign(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), 0);
}

Run<Replay> Replay::open(Store& store, OpenedSession session) {
  if (!session.same_engine) {
    return run_fail(RunError::other_engine, std::to_string(session.session.header.engine_version));
  }
  auto inputs = store.traces.inputs(session.session.id);
  if (!inputs) return storage_failed(inputs);
  return Replay(store, std::move(session), std::move(*inputs));
}

Run<void> Replay::to(std::uint64_t tick, bool full) {
  const FpGuard fp;
  const std::uint64_t target = std::min<std::uint64_t>(tick, inputs_.size());
  bool jumped = false;
  const auto begin_anew = [&] {
    state_.emplace(session_.scene);
    process_ = Process();
    whole_ = true;
    jumped = true;
  };
  if (full) {
    if (!whole_ || state_->last().tick > target) begin_anew();
  } else {
    const bool back = state_->last().tick > target;
    auto key = store_->traces.key_state_before(session_.session.id, target);
    if (!key) return storage_failed(key);
    if (*key && (back || (*key)->tick > state_->last().tick)) {
      auto restored = StepState::restore(session_.scene, (*key)->state);
      if (!restored) return run_fail(RunError::storage, Failure<StorageError>{StorageError::bad_trace, "key_states", {}});
      state_ = std::move(restored);
      whole_ = false;
      jumped = true;
    } else if (back) {
      begin_anew();
    }
  }
  for (std::uint64_t at = state_->last().tick; at < target; ++at) {
    process_.add(step(*state_, inputs_[static_cast<std::size_t>(at)]));
  }
  show(jumped || !shown_);
  return {};
}

void Replay::show(bool first) {
  std::vector<std::int32_t> changed;
  for (const std::int32_t brick : state_->volume().cut_bricks()) {
    std::uint32_t& shown = shown_revision_[static_cast<std::size_t>(brick)];
    const std::uint32_t revision = state_->volume().revision(brick);
    if (revision != shown || first) changed.push_back(brick);
    shown = revision;
  }
  const StateNews news{changed, 0, first, false};
  for (Observer* observer : observers_) observer->on_state(*state_, news);
  shown_ = true;
}

namespace {

RunResult result_of(const OpenedSession& opened) {
  RunResult result;
  result.session = opened.session.id;
  result.state = opened.state;
  result.interrupted = std::ranges::none_of(opened.events, [](const SessionEvent& e) { return e.kind == EventKind::finished; });
  result.scenario = opened.scenario;
  result.seconds = static_cast<double>(opened.elapsed_us) * 1e-6;
  result.device = opened.session.header.device;
  result.stiffness_share = opened.session.header.stiffness_share;
  result.hand = opened.session.hand;
  result.engine_version = opened.session.header.engine_version;
  return result;
}

Run<void> keep_grade(Store& store, const RunResult& result, const Rubric& rubric, std::uint64_t tick,
                     const std::optional<Actor>& grader) {
  auto volume = store.traces.final_volume(result.session);
  if (!volume) return storage_failed(volume);
  if (!*volume && result.interrupted) {
    const FinalVolume whole{result.volume->save_cuts(), result.volume_hash, tick};
    if (auto done = store.traces.save_final_volume(result.session, whole); !done) return storage_failed(done);
  }
  auto saved = store.grades.save(result.session, result.grade, rubric_hash(rubric), grader);
  if (!saved) return storage_failed(saved);
  return {};
}

}  // namespace

Run<RunResult> grade_session(Store& store, SessionId id, const Rubric* other_rubric, bool keep,
                             const std::optional<Actor>& grader) {
  auto opened = open_session(store, id);
  if (!opened) return std::unexpected(opened.error());
  if (opened->state == SessionState::running) return run_fail(RunError::wrong_state, id.text());
  RunResult result = result_of(*opened);
  if (other_rubric) result.scenario.rubric = *other_rubric;
  auto replay = Replay::open(store, *opened);
  if (!replay) return std::unexpected(replay.error());
  if (auto done = replay->to(UINT64_MAX, true); !done) return std::unexpected(done.error());
  const Reference reference(opened->scenario, opened->scene->specimen);
  result.volume = std::make_shared<const Volume>(replay->state().volume());
  result.volume_hash = result.volume->hash();
  result.measures = measure(reference, *result.volume, replay->process());
  result.grade = grade(result.scenario, result.measures);
  if (keep) {
    auto kept = keep_grade(store, result, result.scenario.rubric, replay->state().last().tick, grader);
    if (!kept) return std::unexpected(kept.error());
    result.state = SessionState::graded;
  }
  return result;
}

Run<RunResult> open_result(Store& store, SessionId id, bool keep) {
  auto opened = open_session(store, id);
  if (!opened) return std::unexpected(opened.error());
  auto graded = store.grades.newest(id);
  if (!graded) return storage_failed(graded);
  auto stored = store.traces.final_volume(id);
  if (!stored) return storage_failed(stored);
  if (!*graded || !*stored) return grade_session(store, id, nullptr, keep);

  RunResult result = result_of(*opened);
  result.grade = std::move((*graded)->grade);
  auto volume = std::make_shared<Volume>(opened->scene->specimen);
  if (!volume->load_cuts((*stored)->cuts)) {
    return run_fail(RunError::storage, Failure<StorageError>{StorageError::bad_trace, "final_volumes", {}});
  }
  result.volume_hash = volume->hash();
  result.volume = std::move(volume);
  return result;
}

namespace {

bool same(double a, double b) noexcept {
  // Bit for bit; a value that was not measured is stored as null and comes back as some NaN.
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}
bool same(const std::optional<Vec3>& a, const std::optional<Vec3>& b) noexcept {
  if (a.has_value() != b.has_value()) return false;
  return !a || (same(a->x, b->x) && same(a->y, b->y) && same(a->z, b->z));
}
bool same(const CriterionGrade& a, const CriterionGrade& b) {
  const Measure& x = a.measure;
  const Measure& y = b.measure;
  return a.id == b.id && x.metric == y.metric && x.measured == y.measured && same(x.value, y.value) &&
         same(x.uncertainty, y.uncertainty) && x.unit == y.unit && same(x.where_mm, y.where_mm) && a.band == b.band &&
         same(a.points, b.points) && same(a.points_max, b.points_max) && a.reason_code == b.reason_code &&
         std::ranges::equal(a.reason_args, b.reason_args,
                            [](const auto& l, const auto& r) { return l.first == r.first && same(l.second, r.second); });
}

/// What differs first: a criterion's id, "score", or nothing.
std::string difference(const Grade& a, const Grade& b) {
  for (std::size_t i = 0; i < std::max(a.criteria.size(), b.criteria.size()); ++i) {
    if (i >= a.criteria.size()) return b.criteria[i].id;
    if (i >= b.criteria.size() || !same(a.criteria[i], b.criteria[i])) return a.criteria[i].id;
  }
  const bool equal = same(a.score, b.score) && same(a.score_max, b.score_max) && same(a.pass_mark, b.pass_mark) &&
                     a.passed == b.passed && a.critical == b.critical && a.evaluator == b.evaluator;
  return equal ? std::string() : "score";
}

}  // namespace

bool ReplayProof::holds() const noexcept {
  if (!chain.intact()) return false;
  if (!same_engine) return true;
  return !differs_at_tick && (!has_final_volume || volume_equal) && (!has_grade || grade_equal);
}

Run<ReplayProof> prove_session(Store& store, SessionId id) {
  ReplayProof proof;
  auto chain = verify_session(store.context(), id);
  if (!chain && chain.error().code == StorageError::not_found) chain.error().where = id.text();
  if (!chain) return storage_failed(chain);
  proof.chain = std::move(*chain);
  // What was changed may not open any more: the finding names it better than the failure would.
  const bool damaged = !proof.chain.intact();
  const auto failed = [&](const RunFailure& failure) -> Run<ReplayProof> {
    if (damaged) return proof;
    return std::unexpected(failure);
  };

  auto opened = open_session(store, id);
  if (!opened) return failed(opened.error());
  proof.engine_version = opened->session.header.engine_version;
  proof.same_engine = opened->same_engine;
  if (!proof.same_engine) return proof;

  auto chunks = store.traces.chunks(id);
  if (!chunks) return failed({RunError::storage, chunks.error().where, chunks.error().detail, chunks.error().code});
  auto replay = Replay::open(store, *opened);
  if (!replay) return failed(replay.error());
  for (const ChunkInfo& chunk : *chunks) {
    if (auto done = replay->to(chunk.first_tick + chunk.count - 1, true); !done) return failed(done.error());
    if (!chunk.state_hash) continue;
    ++proof.seconds_compared;
    if (*chunk.state_hash != replay->state().hash() && !proof.differs_at_tick) {
      proof.differs_at_tick = replay->state().last().tick;
    }
  }
  if (auto done = replay->to(UINT64_MAX, true); !done) return failed(done.error());
  proof.ticks = replay->state().last().tick;
  const Volume& volume = replay->state().volume();
  proof.volume_hash = volume.hash();

  auto stored = store.traces.final_volume(id);
  if (!stored) return failed({RunError::storage, stored.error().where, stored.error().detail, stored.error().code});
  if (*stored) {
    proof.has_final_volume = true;
    proof.volume_equal = (*stored)->hash == proof.volume_hash && (*stored)->cuts == volume.save_cuts();
  }
  auto grades = store.grades.all(id);
  if (!grades) return failed({RunError::storage, grades.error().where, grades.error().detail, grades.error().code});
  // Of the program's own grades by the scenario's rubric the newest; others cannot follow from the replay alone.
  const Hash256 own_rubric = rubric_hash(opened->scenario.rubric);
  const auto by_program = [&](const StoredGrade& g) {
    return g.grader.is_nil() && g.rubric_hash == own_rubric && g.engine_version == kEngineVersion;
  };
  const auto found = std::find_if(grades->rbegin(), grades->rend(), by_program);
  if (found != grades->rend()) {
    const Reference reference(opened->scenario, opened->scene->specimen);
    const Grade again = grade(opened->scenario, measure(reference, volume, replay->process()));
    if (again.evaluator == found->grade.evaluator) {
      proof.has_grade = true;
      proof.grade_differs = difference(found->grade, again);
      proof.grade_equal = proof.grade_differs.empty();
    }
  }
  return proof;
}

}  // namespace cusp
