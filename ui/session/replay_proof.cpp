#include <algorithm>
#include <bit>

#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "ui/modules.h"
#include "ui/session/replay.h"
#include "ui/session/scene_builder.h"
#include "ui/session/session_setup.h"

namespace cusp::ui {

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

namespace {

void compare_grade(ReplayProof& proof, const std::vector<StoredGrade>& grades, const OpenedSession& opened,
                   const Replay& replay) {
  // Of the program's own grades by the scenario's rubric the newest; others cannot follow from the replay alone.
  const Hash256 own_rubric = rubric_hash(opened.scenario.rubric);
  const auto by_program = [&](const StoredGrade& g) {
    return g.grader.is_nil() && g.rubric_hash == own_rubric && g.engine_version == kEngineVersion;
  };
  const auto found = std::find_if(grades.rbegin(), grades.rend(), by_program);
  if (found != grades.rend()) {
    const Reference reference(opened.scenario, opened.scene->specimen);
    const Grade again = grade(opened.scenario, measure(reference, replay.state().volume(), replay.process()),
                              sensed_axes(opened.session.header.device));
    if (again.evaluator == found->grade.evaluator) {
      proof.has_grade = true;
      proof.grade_differs = difference(found->grade, again);
      proof.grade_equal = proof.grade_differs.empty();
    }
  }
}

}  // namespace

Outcome<ReplayProof> prove_session(Store& store, SessionId id) {
  ReplayProof proof;
  auto chain = verify_session(store.context(), id);
  if (!chain && chain.error().code == StorageError::not_found) chain.error().where = id.text();
  if (!chain) return session_fail(SessionError::storage, chain.error());
  proof.chain = std::move(*chain);
  // What was changed may not open any more: the finding names it better than the failure would.
  const bool damaged = !proof.chain.intact();
  const auto failed = [&](const SessionFailure& failure) -> Outcome<ReplayProof> {
    if (damaged) return proof;
    return std::unexpected(failure);
  };

  auto opened = open_session(store, id);
  if (!opened) return failed(opened.error());
  proof.engine_version = opened->session.header.engine_version;
  proof.same_engine = opened->same_engine;
  if (!proof.same_engine) return proof;

  auto chunks = store.traces.chunks(id);
  if (!chunks) return failed({SessionError::storage, chunks.error().where, chunks.error().detail, chunks.error().code});
  auto replay = Replay::open(store, *opened);
  const ReplayJump only_inputs{.from = ReplayFrom::first_tick};
  if (!replay) return failed(replay.error());
  for (const ChunkInfo& chunk : *chunks) {
    if (auto done = replay->to(chunk.first_tick + chunk.count - 1, only_inputs); !done) return failed(done.error());
    if (!chunk.state_hash) continue;
    ++proof.seconds_compared;
    if (*chunk.state_hash != replay->state().hash() && !proof.differs_at_tick) {
      proof.differs_at_tick = replay->state().last().tick;
    }
  }
  if (auto done = replay->to(UINT64_MAX, only_inputs); !done) return failed(done.error());
  proof.ticks = replay->state().last().tick;
  const Volume& volume = replay->state().volume();
  proof.volume_hash = volume.hash();

  auto stored = store.traces.final_volume(id);
  if (!stored) return failed({SessionError::storage, stored.error().where, stored.error().detail, stored.error().code});
  if (*stored) {
    proof.has_final_volume = true;
    proof.volume_equal = (*stored)->hash == proof.volume_hash && (*stored)->cuts == volume.save_cuts();
  }
  auto grades = store.grades.all(id);
  if (!grades) return failed({SessionError::storage, grades.error().where, grades.error().detail, grades.error().code});
  compare_grade(proof, *grades, *opened, *replay);
  return proof;
}

}  // namespace cusp::ui
