// Requests, their order, and the grant. Needs no privileges; with some, the system's answers are compared with the
// kernel's.
#include "engine/loop/realtime.h"
#include "tests/modules.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <thread>
#include <vector>

namespace cusp::test {
namespace {

struct FakeWays final : RealtimeWays {
  int most = 0, limit = 0;
  Service service = Service::absent;
  bool locks = true;
  std::vector<int> asked_fifo;
  int asked_service = 0, tightened = 0;
  int own_limit() noexcept override { return limit; }
  bool take_fifo(int priority) noexcept override {
    asked_fifo.push_back(priority);
    return priority <= most;
  }
  Service ask_service(int& priority) noexcept override {
    ++asked_service;
    if (service == Service::granted) priority = 10;
    return service;
  }
  bool lock_memory() noexcept override { return locks; }
  void tighten_timer() noexcept override { ++tightened; }
};

TEST(Realtime, a_privileged_user_has_it_at_once_and_no_service_is_asked) {
  FakeWays ways;
  ways.most = 99;
  const RealtimeGrant grant = ask_by(ways);
  EXPECT_EQ(grant, (RealtimeGrant{RealtimeLevel::fifo, RealtimeRefusal::none, kFifoPriority, true}));
  EXPECT_EQ(ways.asked_service, 0);
}

TEST(Realtime, a_user_with_a_limit_has_as_much_as_that) {
  FakeWays ways;
  ways.most = ways.limit = 20;
  EXPECT_EQ(ask_by(ways), (RealtimeGrant{RealtimeLevel::fifo, RealtimeRefusal::none, 20, true}));
  EXPECT_EQ(ways.asked_fifo, (std::vector<int>{kFifoPriority, 20}));
}

TEST(Realtime, without_rights_the_service_is_asked_and_memory_that_cannot_be_locked_is_reported) {
  FakeWays ways;
  ways.service = RealtimeWays::Service::granted;
  ways.locks = false;
  EXPECT_EQ(ask_by(ways), (RealtimeGrant{RealtimeLevel::rtkit, RealtimeRefusal::none, 10, false}));
  EXPECT_EQ(ways.asked_fifo, std::vector<int>{kFifoPriority});  // no limit: not tried again with zero
  EXPECT_EQ(ways.tightened, 0);
}

TEST(Realtime, refused_by_all_it_goes_on_as_normal_and_reports_why) {
  FakeWays refused, alone;
  refused.service = RealtimeWays::Service::refused;
  EXPECT_EQ(ask_by(refused).refusal, RealtimeRefusal::not_permitted);
  EXPECT_EQ(ask_by(alone).refusal, RealtimeRefusal::no_service);
  EXPECT_FALSE(ask_by(alone).realtime());
  EXPECT_FALSE(ask_by(alone).memory_locked);
  EXPECT_GT(alone.tightened, 0);
}

TEST(Realtime, nobody_asked_is_no_refusal) {
  EXPECT_EQ(RealtimeGrant{}.refusal, RealtimeRefusal::not_asked);
  EXPECT_FALSE(RealtimeGrant{}.realtime());
}

TEST(Realtime, the_reported_grant_is_the_kernels) {
  std::thread([] {
    prefault_stack();
    const RealtimeGrant grant = ask_for_realtime();
    const int kind = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    switch (grant.level) {
      case RealtimeLevel::fifo: EXPECT_EQ(kind, SCHED_FIFO); break;
      case RealtimeLevel::rtkit: EXPECT_EQ(kind, SCHED_RR); break;
      case RealtimeLevel::normal:
        EXPECT_EQ(kind, SCHED_OTHER);
        EXPECT_NE(grant.refusal, RealtimeRefusal::none);
        EXPECT_NE(grant.refusal, RealtimeRefusal::not_asked);
        break;
    }
    sched_param parameters{};
    sched_getparam(0, &parameters);
    EXPECT_EQ(parameters.sched_priority, grant.priority);
  }).join();
}

}  // namespace
}  // namespace cusp::test
