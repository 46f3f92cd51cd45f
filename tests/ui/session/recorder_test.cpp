#include "tests/modules.h"
#include "ui/session/recorder.h"

#include <gtest/gtest.h>

#include "storage/records/verify.h"
#include "tests/storage/failing_vfs.h"
#include "tests/ui/session/other_process.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/play_through.h"
#include "ui/session/replay.h"
#include "ui/session/session_setup.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using test::DrillingPort;
using test::eventually;
using test::LockHolder;
using test::Workplace;

RecordedSecond second_number(std::uint64_t number) {
  RecordedSecond second;
  second.first_tick = number * 10 + 1;
  second.inputs.resize(10);
  for (StepInput& input : second.inputs) input.elapsed_us = 100'000;
  return second;
}

/// A session that has begun, and a store of its own for the recorder.
struct Begun {
  explicit Begun(const Workplace& work, DatabaseOptions options = {}) {
    SessionPlan plan = work.plan();
    session = set_up(plan, DrillingPort(1).limits()).value().session;
    StoreOptions quick = test::quick_store();
    quick.database = std::move(options);
    store = std::move(Store::open(work.database(), quick).value());
  }
  SessionId session;
  std::unique_ptr<Store> store;
};

DatabaseOptions impatient() {
  DatabaseOptions options;
  options.busy_timeout_ms = 10;
  return options;
}

void expect_whole(const Workplace& work, SessionId session, std::size_t seconds) {
  const auto store = work.store();
  EXPECT_EQ(store->traces.chunks(session)->size(), seconds);
  EXPECT_TRUE(verify_session(store->context(), session)->intact());
}

TEST(Recorder, WaitsForAnotherProcessAndLosesNothing) {
  const Workplace work;
  LockHolder other(work.database());
  Begun begun(work, impatient());
  ASSERT_TRUE(other.take());
  Recorder recorder(std::move(begun.store), begun.session, Recorder::Writing::on_a_thread,
                    {.pause = 5ms, .tries = 100'000, .most_waiting = 30});
  recorder.add(second_number(0));
  ASSERT_TRUE(eventually([&] { return recorder.failure().has_value(); }));
  EXPECT_EQ(recorder.failure()->code, StorageError::busy);
  EXPECT_EQ(recorder.state(), RecordingState::behind) << "one second late is no reason to stop an attempt";
  for (std::uint64_t n = 1; n < 29; ++n) recorder.add(second_number(n));
  EXPECT_EQ(recorder.state(), RecordingState::behind);
  recorder.add(second_number(29));
  EXPECT_EQ(recorder.state(), RecordingState::failed) << "half a minute rests in memory alone: the attempt is held";
  other.release();
  EXPECT_TRUE(eventually([&] { return recorder.state() == RecordingState::recording; })) << "without anybody's retry()";
  EXPECT_TRUE(recorder.drain());
  recorder.take_store().reset();
  expect_whole(work, begun.session, 30);
}

TEST(Recorder, AtItsEndItWaitsForAnotherProcessButNotForEver) {
  const Workplace work;
  LockHolder other(work.database());
  Begun begun(work, impatient());
  ASSERT_TRUE(other.take());
  Recorder recorder(std::move(begun.store), begun.session, Recorder::Writing::on_a_thread, {.pause = 1ms, .tries = 5});
  recorder.add(second_number(0));
  recorder.add(second_number(1));
  EXPECT_FALSE(recorder.drain());
  ASSERT_TRUE(recorder.failure());
  EXPECT_EQ(recorder.failure()->code, StorageError::busy);
  other.release();
  recorder.retry();
  EXPECT_TRUE(recorder.drain());
  recorder.take_store().reset();
  expect_whole(work, begun.session, 2);
}

TEST(Recorder, WhatDoesNotPassByItselfFailsAtOnceUntilItIsTriedAgain) {
  const Workplace work;
  Begun begun(work);
  Recorder recorder(std::move(begun.store), begun.session, Recorder::Writing::on_a_thread, {.pause = 1ms});
  recorder.add(second_number(1));  // the first second is missing
  EXPECT_FALSE(recorder.drain());
  EXPECT_EQ(recorder.failure()->code, StorageError::wrong_state);
  EXPECT_EQ(recorder.state(), RecordingState::failed);
  recorder.retry();
  EXPECT_FALSE(recorder.drain());
}

TEST(Recorder, AFullDiskGivesTheCacheBackFirstAndIsTriedAgain) {
  const Workplace work;
  DatabaseOptions options;
  options.vfs = failing_vfs();
  fail_from(Failing::nothing, 0);
  Begun begun(work, options);
  const SessionId graded = SessionId::make();
  KeyStateCache& cache = begun.store->key_states;
  ASSERT_TRUE(cache.keep_rebuilt(graded, {5000, {std::byte{1}}, {}}));
  ASSERT_TRUE(cache.keep_live(begun.session, {5000, {std::byte{1}}, {}}));
  Recorder recorder(std::move(begun.store), begun.session, Recorder::Writing::at_once, {.pause = 1ms, .tries = 3});
  recorder.add(second_number(0));
  fail_from(Failing::disk_full, 1);
  recorder.add(second_number(1));
  EXPECT_EQ(recorder.state(), RecordingState::failed);
  EXPECT_EQ(recorder.failure()->code, StorageError::disk_full);
  EXPECT_TRUE(cache.ticks(graded).empty());
  EXPECT_EQ(cache.ticks(begun.session), std::vector<std::uint64_t>{5000}) << "needed to resume after a crash";
  recorder.add(second_number(2));
  fail_from(Failing::nothing, 0);
  recorder.retry();
  EXPECT_EQ(recorder.state(), RecordingState::recording);
  EXPECT_TRUE(recorder.drain());
  recorder.take_store().reset();
  expect_whole(work, begun.session, 3);
}

TEST(Recorder, UntilTheTryThatWasAskedForHasEndedNothingHasFailedAgain) {
  const Workplace work;
  LockHolder other(work.database());
  Begun begun(work);
  Recorder recorder(std::move(begun.store), begun.session, Recorder::Writing::on_a_thread, {.pause = 1ms});
  recorder.add(second_number(1));  // the first second is missing
  EXPECT_FALSE(recorder.drain());
  ASSERT_EQ(recorder.state(), RecordingState::failed);
  ASSERT_TRUE(other.take());  // the try waits for the file
  recorder.retry();
  EXPECT_EQ(recorder.state(), RecordingState::behind) << "a session that goes on would be held at once";
  other.release();
  EXPECT_FALSE(recorder.drain());
  EXPECT_EQ(recorder.state(), RecordingState::failed);
}

TEST(Recorder, OfAPlayedAttemptAtMostTheSecondThatWasReportedLastIsMissingOnTheDisk) {
  const Workplace work;
  LockHolder other(work.database());
  bool taken = false;
  std::vector<std::int64_t> missing_s;
  DrillingPort port(5500);
  PlaySettings settings;
  settings.go_on = [&](std::uint64_t elapsed_us) {
    auto file = Database::open(work.database(), {.access = DatabaseOptions::Access::read_only});
    const auto stored = file.value().first("SELECT count(*) FROM trace_chunks", [](Row row) { return row.integer(0); });
    missing_s.push_back(static_cast<std::int64_t>(elapsed_us / 1'000'000) - stored.value().value());
    if (!taken) taken = other.take(500ms);
    return taken;
  };
  ASSERT_TRUE(play_through(work.plan(), port, settings));
  ASSERT_TRUE(taken);
  ASSERT_EQ(missing_s.size(), 5u);
  for (const std::int64_t s : missing_s) EXPECT_LE(s, 1);
}

TEST(Recorder, APlayedAttemptOutlastsAProcessThatHoldsTheFileForTenSeconds) {
  const Workplace work;
  LockHolder other(work.database());
  bool taken = false;
  DrillingPort port(2500);
  PlaySettings settings;
  settings.go_on = [&](std::uint64_t) {
    if (!taken) taken = other.take(10s);
    return taken;
  };
  const auto result = play_through(work.plan(), port, settings);
  ASSERT_TRUE(taken);
  ASSERT_TRUE(result) << key_of(result.error().code) << ' ' << result.error().where;
  EXPECT_FALSE(result->interrupted);
  const auto store = work.store();
  EXPECT_EQ(store->sessions.state(result->session), SessionState::graded);
  EXPECT_TRUE(prove_session(*store, result->session)->holds());
}

}  // namespace
}  // namespace cusp::test
