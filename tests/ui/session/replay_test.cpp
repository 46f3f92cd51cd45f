#include "tests/modules.h"
#include "ui/session/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "storage/records/trace_codec.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/play_through.h"
#include "ui/session/session_setup.h"

namespace cusp::test {
namespace {

using test::DrillingPort;
using test::Workplace;

const ReplayJump kOnlyInputs{.from = ReplayFrom::first_tick};
const ReplayJump kKeeping{.keep = true};

std::int64_t key_state_rows(Store& store) {
  return store.database().first("SELECT count(*) FROM key_states", [](Row row) { return row.integer(0); })->value();
}

TEST(Replay, JumpsByKeyStatesToTheSameStateAsTickByTick) {
  const Workplace work;
  DrillingPort port(10'400);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  const auto store = work.store();
  EXPECT_EQ(key_state_rows(*store), 0) << "key states are no part of the record";
  EXPECT_EQ(store->key_states.ticks(result->session), (std::vector<std::uint64_t>{5000, 10'000}));
  auto opened = open_session(*store, result->session);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->ticks, 10'400u);
  auto whole = Replay::open(*store, *opened);
  auto jumping = Replay::open(*store, *opened);
  ASSERT_TRUE(whole && jumping);
  for (const std::uint64_t tick : {10'200u, 700u, 5001u, 10'400u, 4999u}) {
    ASSERT_TRUE(whole->to(tick, kOnlyInputs));
    ASSERT_TRUE(jumping->to(tick));
    EXPECT_EQ(whole->state().hash(), jumping->state().hash()) << "tick " << tick;
  }
  // 200, 700, 1, 400 and 4999 after a key state or the start.
  EXPECT_EQ(jumping->ticks_computed(), 200u + 700u + 1u + 400u + 4999u);
}

TEST(Replay, AJumpWithoutACacheFillsItAndTheNextOneIsShort) {
  const Workplace work;
  DrillingPort port(15'500);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  const auto store = work.store();
  EXPECT_EQ(store->key_states.ticks(result->session), (std::vector<std::uint64_t>{10'000, 15'000}));
  std::filesystem::remove_all(store->key_states.folder());
  const auto opened = open_session(*store, result->session);
  auto cold = Replay::open(*store, *opened);
  ASSERT_TRUE(cold->to(15'400, kKeeping));
  EXPECT_EQ(cold->ticks_computed(), 15'400u);
  EXPECT_EQ(store->key_states.ticks(result->session), (std::vector<std::uint64_t>{5000, 10'000, 15'000}));
  auto warm = Replay::open(*store, *opened);
  for (const std::uint64_t tick : {15'400u, 9000u, 11'000u, 5100u}) {
    const std::uint64_t before = warm->ticks_computed();
    ASSERT_TRUE(warm->to(tick));
    EXPECT_LT(warm->ticks_computed() - before, 5000u) << tick;
  }
  ASSERT_TRUE(cold->to(5100, kOnlyInputs));
  EXPECT_EQ(cold->state().hash(), warm->state().hash());
  // What another program empties meanwhile is no harm.
  std::filesystem::remove_all(store->key_states.folder());
  ASSERT_TRUE(warm->to(15'450));
  ASSERT_TRUE(cold->to(15'450));
  EXPECT_EQ(cold->state().hash(), warm->state().hash());
}

TEST(Replay, AnExerciseThatWasPublishedInFormat1IsPlayedReplayedAndGradedAsThatVersion) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.rubric.criteria.push_back({"uncut_remainder", 10, {0, 0, 0, 0.5, 1, 2}});
  const std::string of_format_1 = hashed_json(plan.scenario);
  ASSERT_THAT(of_format_1, testing::HasSubstr("\"format\":1"));
  ASSERT_THAT(of_format_1, testing::HasSubstr("\"undercut\""));
  auto store = work.store();
  const auto published = store->scenarios.ensure(plan.scenario, of_format_1, content_hash(plan.scenario).bytes);
  ASSERT_TRUE(published);

  DrillingPort port(1500);
  const auto result = play_through(plan, port);
  ASSERT_TRUE(result);
  const auto versions = store->scenarios.versions(plan.scenario.id);
  ASSERT_EQ(versions->size(), 1u) << "the attempt belongs to the version that there was";
  EXPECT_EQ(versions->front().json, of_format_1);
  const auto opened = open_session(*store, result->session);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->scenario, plan.scenario);
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->volume_equal);
  EXPECT_TRUE(proof->grade_equal) << proof->grade_differs;
}

TEST(Replay, ALongJumpReportsHowFarItIsAndStopsWhenAsked) {
  const Workplace work;
  DrillingPort port(3000);
  const auto result = play_through(work.plan(), port);
  const auto store = work.store();
  auto replay = Replay::open(*store, *open_session(*store, result->session));
  std::vector<double> shares;
  const auto stopped = replay->to(3000, {.watch = [&](double share) {
                                    shares.push_back(share);
                                    return shares.size() < 4;
                                  }});
  ASSERT_TRUE(stopped);
  EXPECT_FALSE(*stopped);
  ASSERT_EQ(shares.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GT(shares.front(), 0.0);
  EXPECT_LT(shares.back(), 0.5);
  const std::uint64_t stands = replay->state().last().tick;
  EXPECT_GT(stands, 0u);
  EXPECT_LT(stands, 3000u);
  const auto on = replay->to(3000);
  ASSERT_TRUE(on && *on);
  EXPECT_EQ(replay->ticks_computed(), 3000u) << "it continued from where it stood";
  auto whole = Replay::open(*store, *open_session(*store, result->session));
  ASSERT_TRUE(whole->to(3000, kOnlyInputs));
  EXPECT_EQ(whole->state().hash(), replay->state().hash());
}

TEST(Replay, KeyStatesInTheDatabaseOfOlderProgramsAreUsedWhenTheirHashIsTheChainedOne) {
  const Workplace work;
  DrillingPort port(10'300);
  const auto result = play_through(work.plan(), port);
  const auto store = work.store();
  const KeyState good = *store->key_states.read(result->session, 5000);
  std::filesystem::remove_all(store->key_states.folder());
  const auto row = [&](int number, std::uint64_t tick, const std::vector<std::byte>& state) {
    ASSERT_TRUE(store->database().run("INSERT INTO key_states (session, row, tick, state) VALUES (?1, ?2, ?3, ?4)",
                                      result->session, number, tick, pack(state)));
  };
  row(0, 5000, good.state);
  row(1, 10'000, good.state);  // another moment's
  const auto opened = open_session(*store, result->session);
  auto replay = Replay::open(*store, *opened);
  ASSERT_TRUE(replay->to(10'200, kKeeping));
  EXPECT_EQ(replay->ticks_computed(), 5200u);
  EXPECT_EQ(store->key_states.ticks(result->session), std::vector<std::uint64_t>{10'000}) << "only what is missing";
  auto whole = Replay::open(*store, *opened);
  ASSERT_TRUE(whole->to(10'200, kOnlyInputs));
  EXPECT_EQ(whole->state().hash(), replay->state().hash());
}

TEST(Replay, ACacheThatCannotBeWrittenChangesNothing) {
  const Workplace work;
  std::ofstream(work.folder / "cusp.db.states") << "in the way";
  DrillingPort port(5300);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result) << key_of(result.error().code);
  EXPECT_FALSE(result->interrupted);
  const auto store = work.store();
  EXPECT_TRUE(prove_session(*store, result->session)->holds());
  auto replay = Replay::open(*store, *open_session(*store, result->session));
  ASSERT_TRUE(replay->to(5200, kKeeping));
  EXPECT_EQ(replay->ticks_computed(), 5200u);
}

TEST(Replay, ItsObserversAreNotifiedOfEveryBrickThatAJumpChanged) {
  class Sketch final : public Observer {
   public:
    void on_state(const StepState& state, const StateNews& news) override {
      if (news.first) cut.clear();
      for (const std::int32_t b : news.changed_bricks) {
        cut[b].assign(state.volume().cut_of(b), state.volume().cut_of(b) + kBrickVoxels);
      }
      equal = cut.size() == state.volume().cut_bricks().size();
      for (const auto& [b, values] : cut) {
        equal = equal && std::equal(values.begin(), values.end(), state.volume().cut_of(b));
      }
    }
    std::map<std::int32_t, std::vector<std::uint16_t>> cut;
    bool equal = false;
  };
  const Workplace work;
  DrillingPort port(5600);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  const auto store = work.store();
  auto replay = Replay::open(*store, *open_session(*store, result->session));
  ASSERT_TRUE(replay);
  Sketch sketch;
  replay->add(sketch);
  for (const std::uint64_t tick : {300u, 900u, 5500u, 200u, 5600u}) {
    ASSERT_TRUE(replay->to(tick));
    EXPECT_TRUE(sketch.equal) << "tick " << tick;
  }
}

TEST(Replay, AByteChangedInTheRecordIsFoundAndNamed) {
  const Workplace work;
  DrillingPort port(1500);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  {
    const auto store = work.store();
    // As somebody with a database tool would: one byte of the second second's inputs.
    const auto changed = store->database().run(
        "UPDATE trace_chunks SET trace = CAST(substr(trace, 1, 40) || x'5a' || substr(trace, 42) AS BLOB) "
        "WHERE row = 1");
    ASSERT_TRUE(changed) << changed.error().where << changed.error().detail;
    ASSERT_EQ(store->database().changes(), 1);
  }
  const auto store = work.store();
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof);
  EXPECT_FALSE(proof->holds());
  ASSERT_FALSE(proof->chain.findings.empty());
  EXPECT_EQ(proof->chain.findings.front().table, "trace_chunks");
  EXPECT_EQ(proof->chain.findings.front().row, 1);
}

TEST(Replay, AnotherRubricGradesTheSameToothOtherwiseAndKeepsNothingUnlessAsked) {
  const Workplace work;
  DrillingPort port(1200);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  const auto store = work.store();
  Rubric strict = work.plan().scenario.rubric;
  strict.pass = 100;
  strict.criteria.resize(1);
  const auto graded = grade_session(*store, result->session, &strict, Keep::nothing);
  ASSERT_TRUE(graded);
  EXPECT_EQ(graded->volume_hash, result->volume_hash);
  EXPECT_EQ(graded->grade.criteria.size(), 1u);
  EXPECT_EQ(graded->grade.pass_mark, 100);
  EXPECT_EQ(store->grades.all(result->session)->size(), 1u);
}

TEST(Replay, AGradeMadeAnewNamesTheStoredEvaluatorAndWhatDiffers) {
  const Workplace work;
  DrillingPort port(1200);
  const auto result = play_through(work.plan(), port);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->changes);
  const auto store = work.store();
  const auto again = grade_session(*store, result->session, nullptr, Keep::nothing);
  ASSERT_TRUE(again && again->changes);
  EXPECT_TRUE(again->changes->none()) << "the same program gives the same grade";
  Grade older = result->grade;
  older.evaluator = "3";
  older.criteria.front().points += 1;
  ASSERT_TRUE(store->grades.save(result->session, older, rubric_hash(work.plan().scenario.rubric), std::nullopt));
  const auto anew = grade_session(*store, result->session, nullptr, Keep::nothing);
  ASSERT_TRUE(anew && anew->changes);
  EXPECT_EQ(anew->changes->evaluator_before, "3");
  EXPECT_EQ(anew->changes->evaluator_after, anew->grade.evaluator);
  ASSERT_EQ(anew->changes->criteria.size(), 1u);
  EXPECT_EQ(anew->changes->criteria.front().id, older.criteria.front().id);
  EXPECT_EQ(store->grades.newest(result->session)->value().grade.evaluator, "3") << "stored grades stay";
}

TEST(Replay, ASessionThatIsNotThereFails) {
  const Workplace work;
  const auto store = work.store();
  const auto opened = open_session(*store, SessionId::make());
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, SessionError::storage);
  EXPECT_EQ(std::get<StorageError>(opened.error().cause), StorageError::not_found);
}

}  // namespace
}  // namespace cusp::test
