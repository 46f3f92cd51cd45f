/// Attempts that end with their process: from the newest key state that can be trusted they resume as if nothing had happened.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>

#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/play_through.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;
using test::DrillingPort;
using test::Workplace;

constexpr std::uint64_t kTicks = 13'400;
constexpr std::uint64_t kKilledAtUs = 12'000'000;

/// The same operator, from after `tick` on.
class LaterPort : public DrillingPort {
 public:
  LaterPort(std::uint64_t tick, std::uint64_t ticks) : DrillingPort(ticks) {
    while (tick-- > 0) wait({});
  }
};

/// Of an attempt that was never cut off.
struct Uninterrupted {
  Uninterrupted() {
    DrillingPort port(kTicks);
    result = play_through(work.plan(), port).value();
    const auto store = work.store();
    chunks = store->traces.chunks(result.session).value();
    proof = prove_session(*store, result.session).value();
  }
  Workplace work;
  SessionResult result;
  std::vector<ChunkInfo> chunks;
  ReplayProof proof;
};
const Uninterrupted& uninterrupted() {
  static const Uninterrupted one;
  return one;
}

/// In a process of its own: plays until it is killed. The session.
SessionId play_and_die(const Workplace& work) {
  const pid_t child = fork();
  if (child == 0) {
    DrillingPort port(kTicks);
    PlaySettings settings;
    settings.go_on = [](std::uint64_t elapsed_us) {
      if (elapsed_us >= kKilledAtUs) raise(SIGKILL);
      return true;
    };
    static_cast<void>(play_through(work.plan(), port, settings));
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  const auto store = work.store();
  const auto waiting = store->history.interrupted(work.demo.actor(), work.demo.id);
  EXPECT_EQ(waiting->size(), 1u);
  return waiting->at(0).session;
}

void expect_same_as_uninterrupted(const Workplace& work, SessionId session) {
  SessionPlan plan = work.plan();
  plan.resumes = session;
  const std::uint64_t stored = open_session(*work.store(), session)->ticks;
  LaterPort port(stored, kTicks);
  const auto result = play_through(plan, port);
  ASSERT_TRUE(result) << key_of(result.error().code) << ' ' << result.error().where << ' ' << result.error().detail;
  const SessionResult& whole = uninterrupted().result;
  EXPECT_EQ(result->volume_hash, whole.volume_hash);
  EXPECT_EQ(result->seconds, whole.seconds);
  EXPECT_EQ(result->grade.score, whole.grade.score);
  ASSERT_EQ(result->measures.size(), whole.measures.size());
  for (std::size_t i = 0; i < whole.measures.size(); ++i) {
    EXPECT_EQ(result->measures[i].measured, whole.measures[i].measured) << whole.measures[i].metric;
    if (!whole.measures[i].measured) continue;
    EXPECT_EQ(result->measures[i].value, whole.measures[i].value) << whole.measures[i].metric;
  }
  const auto store = work.store();
  const auto chunks = store->traces.chunks(session).value();
  ASSERT_EQ(chunks.size(), uninterrupted().chunks.size());
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    EXPECT_EQ(chunks[i].first_tick, uninterrupted().chunks[i].first_tick);
    EXPECT_EQ(chunks[i].state_hash, uninterrupted().chunks[i].state_hash) << "second " << i;
  }
  EXPECT_TRUE(prove_session(*store, session)->holds());
}

/// What going on costs before the first tick.
std::uint64_t ticks_to_resume(Store& store, SessionId session) {
  auto replay = Replay::open(store, *open_session(store, session));
  EXPECT_TRUE(replay->to(UINT64_MAX, {.from = ReplayFrom::whole_process}));
  return replay->ticks_computed();
}

TEST(Resume, AfterAKillItGoesOnFromTheNewestKeyStateBitForBit) {
  ASSERT_TRUE(uninterrupted().proof.holds());
  const Workplace work;
  const SessionId session = play_and_die(work);
  {
    const auto store = work.store();
    const std::uint64_t stored = open_session(*store, session)->ticks;
    ASSERT_GE(stored, 11'000u);
    EXPECT_EQ(store->key_states.ticks(session), (std::vector<std::uint64_t>{5000, 10'000}));
    EXPECT_EQ(ticks_to_resume(*store, session), stored - 10'000);
  }
  expect_same_as_uninterrupted(work, session);
}

/// What it opens for is called off by then.
class OpenedPort final : public DrillingPort {
 public:
  explicit OpenedPort(std::atomic<bool>& opened) : DrillingPort(kTicks), opened_(opened) {}
  Result<void, PortFailure> open() override {
    opened_ = true;
    return DrillingPort::open();
  }

 private:
  std::atomic<bool>& opened_;
};

TEST(Resume, IsCalledOffWhileItsPastIsComputedAndStaysInterrupted) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.resumes = play_and_die(work);
  std::atomic<bool> opened{false};
  const auto started = ExerciseSession::start(plan, std::make_shared<OpenedPort>(opened), [&opened] { return opened.load(); });
  ASSERT_FALSE(started);
  EXPECT_EQ(std::get<ImportError>(started.error().cause), ImportError::cancelled);
  EXPECT_EQ(*work.store()->sessions.state(plan.resumes), SessionState::interrupted);
}

TEST(Resume, WithTheNewestKeyStateDamagedItGoesOnFromTheOneBefore) {
  const Workplace work;
  const SessionId session = play_and_die(work);
  const auto store = work.store();
  const fs::path newest = store->key_states.folder() / (session.text() + "-000000010000.live");
  ASSERT_TRUE(fs::exists(newest));
  fs::resize_file(newest, fs::file_size(newest) / 2);
  EXPECT_EQ(ticks_to_resume(*store, session), open_session(*store, session)->ticks - 5000);
}

TEST(Resume, WithBothKeyStatesDamagedItGoesOnFromTheFirstTick) {
  const Workplace work;
  const SessionId session = play_and_die(work);
  {
    const auto store = work.store();
    for (const char* tick : {"5000", "10000"}) {
      const std::string digits = std::string(12 - std::string(tick).size(), '0') + tick;
      std::fstream file(store->key_states.folder() / (session.text() + "-" + digits + ".live"),
                        std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(100);
      file.put('?').put('!');
      ASSERT_TRUE(file);
    }
    EXPECT_EQ(ticks_to_resume(*store, session), open_session(*store, session)->ticks);
    EXPECT_TRUE(store->key_states.ticks(session).empty()) << "damaged ones are gone";
  }
  expect_same_as_uninterrupted(work, session);
}

TEST(Resume, AKeyStateOfAnotherMomentUnderAGoodSealIsNotBelieved) {
  const Workplace work;
  const SessionId session = play_and_die(work);
  const auto store = work.store();
  const auto earlier = store->key_states.read(session, 5000);
  ASSERT_TRUE(earlier);
  ASSERT_TRUE(store->key_states.keep_live(session, {10'000, earlier->state, earlier->process}));
  EXPECT_EQ(ticks_to_resume(*store, session), open_session(*store, session)->ticks - 5000);
  EXPECT_EQ(store->key_states.ticks(session), std::vector<std::uint64_t>{5000});
}

}  // namespace
}  // namespace cusp::test
