// The attempts themselves, on a coarse block that takes a moment.

#include "tests/modules.h"
#include "ui/session/audit_run.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/audit/audit.h"
#include "scenarios/library/library.h"
#include "ui/session/cpu_meter.h"

namespace cusp::test {
namespace {

#ifdef CUSP_SANITIZED
constexpr bool kHeapIsCounted = false;  // its own heap, which mallinfo2 knows nothing of
#else
constexpr bool kHeapIsCounted = true;
#endif

/// A short groove for a bur of 0.7 mm in plastic of 0.2 mm voxels.
Scenario small() {
  Scenario s = *load_builtin("line-1");
  s.specimen.voxel_mm = 0.2;
  const double floor = s.target.outline.paths[0][0].z;
  s.target.outline.paths = {{Vec3(-0.4, 0, floor + 1.2), Vec3(0.4, 0, floor + 1.2)}};
  s.target.outline.depth_mm -= 1.2;
  return s;
}

TEST(AuditRun, TheSameModelGradesTheSameAndFeelsTheSame) {
  AuditRun wish;
  wish.home = small();
  wish.models = {{small()}, {small()}};
  wish.operators = {{"expert", 1}};
  double last = 0;
  const auto results = audit_runner({})(wish, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  });
  ASSERT_TRUE(results);
  ASSERT_TRUE((*results)[0] && (*results)[1]);
  const ModelResult &a = *(*results)[0], &b = *(*results)[1];
  EXPECT_EQ(a.attempts.at(0).grade.score, b.attempts.at(0).grade.score);
  EXPECT_EQ(a.attempts.at(0).seconds, b.attempts.at(0).seconds);
  EXPECT_EQ(b.force_rms_n, 0.0);
  EXPECT_EQ(b.force_most_n, 0.0);
  EXPECT_GT(a.attempts[0].grade.score, 50.0);
  EXPECT_EQ(a.attempts[0].lost, 0u);
  if (kHeapIsCounted) {
    EXPECT_GT(a.cost.bytes, 1'000'000u);
  }
  EXPECT_GT(a.cost.us_a_tick, 0.0);
  EXPECT_EQ(a.cost.us_more, 0.0) << "against itself";
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(AuditRun, FrictionIsFeltOnTheSamePath) {
  Scenario rough = small();
  rough.phenomena = {"friction"};
  AuditRun wish;
  wish.home = rough;
  wish.models = {{rough}, with({rough}, {Aspect::friction, {}, 1, 0})};
  wish.operators = {{"expert", 1}};
  const auto results = audit_runner({})(wish, {});
  ASSERT_TRUE(results);
  EXPECT_GT((*results)[1]->force_rms_n, 0.01);
  EXPECT_GE((*results)[1]->force_most_n, (*results)[1]->force_rms_n);
}

TEST(AuditRun, StopsInTheMiddleOfAnAttempt) {
  AuditRun wish;
  wish.home = small();
  wish.models = {{small()}};
  wish.operators = {{"expert", 1}};
  wish.costs = false;
  int asked = 0;
  const auto results = audit_runner({})(wish, [&](double) { return ++asked < 10; });
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().code, AuditError::cancelled);
  EXPECT_EQ(asked, 10);
}

TEST(AuditRun, StopsWhileAToothGrows) {
  Scenario tooth = *load_builtin("class-1-36");
  tooth.specimen.voxel_mm = 0.4;
  AuditRun wish;
  wish.home = tooth;
  wish.models = {{tooth}};
  wish.operators = {{"expert", 1}};
  double last = 0;
  const auto results = audit_runner({})(wish, [&](double share) {
    last = share;
    return share == 0.0;  // until it begins
  });
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().code, AuditError::cancelled);
  EXPECT_GT(last, 0.0);
  EXPECT_LT(last, 0.1) << "the attempts begin there";
}

/// The CPU time of a start is never the same twice: what has the same was not made again.
TEST(AuditRun, WhatTheRunBeforeHasMadeIsNotMadeAgain) {
  AuditRun wish;
  wish.home = small();
  wish.models = {{small()}, with({small()}, {Aspect::region, {}, 1, 0})};
  const AuditRunner runner = audit_runner({});
  const auto first = runner(wish, {}), second = runner(wish, {});
  ASSERT_TRUE(first && second);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ((*first)[i]->cost.start_s, (*second)[i]->cost.start_s) << i;
  EXPECT_NE((*first)[0]->cost.start_s, (*first)[1]->cost.start_s) << "another model";
}

TEST(AuditRun, AnExerciseThatCannotBePlayedIsRefused) {
  Scenario s = small();
  s.instruments.clear();
  AuditRun wish;
  wish.home = s;
  wish.models = {{s}};
  wish.operators = {{"expert", 1}};
  const auto results = audit_runner({})(wish, {});
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().code, AuditError::unplayable);
}

/// Its groove lies 30 mm beside the block: no operator touches anything, and every model would grade the same.
TEST(AuditRun, AnExerciseThatNobodyTouchesIsRefused) {
  Scenario s = small();
  for (Vec3& p : s.target.outline.paths[0]) p.x += 30;
  AuditRun wish;
  wish.home = s;
  wish.models = {{s}};
  wish.operators = {{"expert", 1}};
  const auto results = audit_runner({})(wish, {});
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().code, AuditError::no_path);
  EXPECT_EQ(results.error().where, "expert");
}

/// The second question from the costs on is answered no. Without operators nothing follows them.
TEST(AuditRun, StopsWhileCostsAreMeasured) {
  AuditRun wish;
  wish.home = small();
  wish.models = {{small()}};
  int asked = 0;
  const auto results = audit_runner({})(wish, [&](double share) { return share < 0.1 || ++asked < 2; });
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().code, AuditError::cancelled);
}

TEST(CpuMeter, CountsWhatTheThreadAndTheHeapTake) {
  const double before = thread_cpu_s();
  volatile double sum = 0;
  const InstructionCounter counter;
  const auto first = counter.read();
  while (thread_cpu_s() - before < 0.001) sum = sum + 1;
  EXPECT_GT(thread_cpu_s(), before);
  if (first) {  // where the machine counts
    EXPECT_GT(*counter.read(), *first);
  }
  const std::uint64_t heap = heap_bytes();
  const std::vector<char> block(10'000'000, 'x');
  if (kHeapIsCounted) {
    EXPECT_GE(heap_bytes(), heap + 10'000'000);
  }
  EXPECT_EQ(block.back(), 'x');
}

}  // namespace
}  // namespace cusp::test
