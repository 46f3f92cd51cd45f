// Ten thousand ticks of every method, in contact and cutting, must not allocate, free or lock. The functions are replaced
// for this program alone; a thread counts only while it is armed, so that the test's own memory does not.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <cstdlib>

#include "engine/loop/haptic_loop.h"
#include "engine/mirror/mirror.h"
#include "engine/tool/heads.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace {

thread_local bool armed = false;
thread_local std::uint64_t allocations = 0, frees = 0, locks = 0;

void count(std::uint64_t& what) noexcept {
  if (armed) ++what;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t bytes) {
  count(allocations);
  return __libc_malloc(bytes);
}
void* calloc(std::size_t n, std::size_t bytes) {
  count(allocations);
  return __libc_calloc(n, bytes);
}
void* realloc(void* old, std::size_t bytes) {
  count(allocations);
  return __libc_realloc(old, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  count(allocations);
  return __libc_memalign(alignment, bytes);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t bytes) {
  count(allocations);
  *out = __libc_memalign(alignment, bytes);
  return *out ? 0 : ENOMEM;
}
void free(void* what) {
  count(frees);
  __libc_free(what);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  count(locks);
  using Lock = int (*)(pthread_mutex_t*);
  static Lock real = nullptr;
  if (!real) real = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  return real(mutex);
}

}  // extern "C"

namespace cusp::test {
namespace {

struct Counts {
  std::uint64_t allocations, frees, locks;
};
Counts disarm() {
  armed = false;
  return {allocations, frees, locks};
}
void arm() {
  allocations = frees = locks = 0;
  armed = true;
}

TEST(Counters, SeeAPlantedAllocationAndAPlantedLock) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  arm();
  auto* planted = new volatile int(1);
  delete planted;
  pthread_mutex_lock(&mutex);
  const Counts counts = disarm();
  pthread_mutex_unlock(&mutex);
  EXPECT_EQ(counts.allocations, 1u);
  EXPECT_EQ(counts.frees, 1u);
  EXPECT_EQ(counts.locks, 1u);
}

class EveryMethod : public testing::TestWithParam<Method> {};

TEST_P(EveryMethod, TenThousandTicksInContactAndCuttingTakeNoHeapAndNoLock) {
  auto scene = std::make_shared<Scene>(*test::block_scene(GetParam()));
  Bur fissure = scene->burs[0];
  fissure.head = flat_head(fissure.radius_mm, fissure.radius_mm, 2.0).value();
  scene->burs.push_back(fissure);
  HandOver hand_over(16'384);
  Ticker ticker(StepState(scene), hand_over);
  std::vector<Sample> samples;
  for (int i = 0; i < 10'000; ++i) {
    samples.push_back(test::drilling_sample(static_cast<std::uint64_t>(i)));
    // A bur is changed in the air.
    for (const int lift : {6050, 8050}) samples.back().position_mm.z += 0.02 * std::max(0, 150 - std::abs(i - lift));
  }
  std::uint64_t contact = 0, cutting = 0, by_fissure = 0;
  arm();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // Every command that a tick may meet is among them.
    if (i == 4000) ticker.pause();
    if (i == 4010) ticker.resume();
    if (i == 6000) ticker.change_bur(1);
    if (i == 8000) ticker.change_bur(2);
    const Feedback feedback = ticker.tick(samples[i], 1000);
    contact += feedback.in_contact ? 1 : 0;
    const StepOutput& output = hand_over.latest.read().output;
    cutting += output.cutting ? 1 : 0;
    by_fissure += output.bur == 2 ? 1 : 0;
  }
  const Counts counts = disarm();
  EXPECT_EQ(counts.allocations, 0u);
  EXPECT_EQ(counts.frees, 0u);
  EXPECT_EQ(counts.locks, 0u);
  EXPECT_GT(contact, 2000u) << "without contact the counts prove nothing";
  EXPECT_GT(cutting, 1000u);
  EXPECT_GT(by_fissure, 500u);
  EXPECT_GT(ticker.state().volume().cut_bricks().size(), 0u);
}

TEST_P(EveryMethod, WithSpindleVibrationAndHeatTicksTakeNoHeapAndNoLock) {
  const auto scene = std::make_shared<Scene>(*test::block_scene(GetParam()));
  scene->phenomena = {Handpiece::turbine, true, true};
  HandOver hand_over(4096);
  Ticker ticker(StepState(scene), hand_over);
  double most_rpm = 0;
  arm();
  for (std::uint64_t i = 0; i < 3000; ++i) {
    ticker.set_coolant(i > 1500);
    ticker.tick(test::drilling_sample(i), 1000);
    most_rpm = std::max(most_rpm, static_cast<double>(hand_over.latest.read().output.spindle_rpm));
  }
  const Counts counts = disarm();
  EXPECT_EQ(counts.allocations, 0u);
  EXPECT_EQ(counts.frees, 0u);
  EXPECT_EQ(counts.locks, 0u);
  EXPECT_GT(most_rpm, 1e5);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::Values(Method::surface, Method::occupancy, Method::occupancy_pivot, Method::ray,
                                         Method::penalty, Method::gradient),
                         [](const auto& instance) {
                           std::string name(key_of(instance.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace cusp::test
