// BackgroundTasks and the watch in the background: whoever starts one never waits for it. A step that would wait is held by a
// gate that only opens afterwards; the gate gives up by itself, so that a fault is a failure and no hang.
#include "tests/modules.h"
#include "ui/session/background_task.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#include "tests/eventually.h"
#include "tests/ui/session/gate.h"
#include "ui/session/background_watch.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using test::Gate;
using test::eventually;

TEST(BackgroundTask, dropping_one_that_hangs_does_not_wait_and_it_is_waited_for_by_who_must) {
  auto gate = std::make_shared<Gate>();
  auto done = std::make_shared<std::atomic<bool>>(false);
  {
    BackgroundTask background_task([gate, done] {
      gate->pass();
      *done = true;
    });
    EXPECT_FALSE(background_task.over());
  }
  EXPECT_FALSE(*done);
  gate->open();
  wait_for_dropped_tasks();
  EXPECT_TRUE(*done);
  EXPECT_FALSE(gate->gave_up());
}

TEST(BackgroundTask, what_it_holds_goes_on_its_own_thread_before_it_is_over) {
  struct Held {
    std::atomic<std::thread::id>& where;
    ~Held() { where = std::this_thread::get_id(); }
  };
  std::atomic<std::thread::id> where{};
  BackgroundTask background_task([held = std::make_shared<Held>(where)] {});
  ASSERT_TRUE(eventually([&] { return background_task.over(); }));
  EXPECT_NE(where.load(), std::thread::id());
  EXPECT_NE(where.load(), std::this_thread::get_id());
}

TEST(BackgroundTask, who_needs_a_device_waits_for_the_tasks_that_hold_one_alone) {
  auto gate = std::make_shared<Gate>();
  auto closed = std::make_shared<std::atomic<bool>>(false);
  BackgroundTask([gate] { gate->pass(); });
  BackgroundTask([closed] { *closed = true; }, BackgroundTask::Holds::device);
  wait_for_dropped_devices();
  EXPECT_TRUE(*closed);
  EXPECT_FALSE(gate->gave_up());
  gate->open();
  wait_for_dropped_tasks();
}

TEST(BackgroundTask, who_needs_a_device_may_stop_waiting_for_it) {
  auto gate = std::make_shared<Gate>();
  BackgroundTask([gate] { gate->pass(); }, BackgroundTask::Holds::device);
  int asked = 0;
  wait_for_dropped_devices([&asked] { return ++asked > 3; });
  EXPECT_EQ(asked, 4);
  EXPECT_FALSE(gate->gave_up());
  gate->open();
  wait_for_dropped_devices();
  EXPECT_FALSE(gate->gave_up());
}

std::atomic<bool> g_made{false}, g_gone{false};

[[noreturn]] void end_with_a_task_at_work() {
  {
    const TasksEndHere end;
    BackgroundTask([] {
      static const struct Table {
        ~Table() { g_gone = true; }
      } table;  // younger than the list of dropped tasks
      static_cast<void>(table);
      g_made = true;
      for (int i = 0; i < 200 && !g_gone; ++i) std::this_thread::sleep_for(1ms);
      if (g_gone) std::_Exit(3);
    });
    while (!g_made) std::this_thread::sleep_for(1ms);
  }
  std::exit(0);
}

TEST(BackgroundTaskDeathTest, one_that_works_when_the_program_ends_still_has_its_statics) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(end_with_a_task_at_work(), testing::ExitedWithCode(0), "");
}

[[noreturn]] void end_beside_a_task_that_hangs() {
  {
    TasksEndHere end;
    BackgroundTask([] {
      for (;;) std::this_thread::sleep_for(1s);
    });
    end.leave_tasks(4);
  }
  std::exit(0);
}

TEST(BackgroundTaskDeathTest, one_that_hangs_ends_with_the_program_where_nobody_waits_for_it) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(end_beside_a_task_that_hangs(), testing::ExitedWithCode(4), "");
}

TEST(BackgroundTask, what_was_dropped_is_known_by_what_its_end_would_lose) {
  wait_for_dropped_tasks();
  EXPECT_EQ(dropped_work(), DroppedWork::none);
  auto reads = std::make_shared<Gate>(), writes = std::make_shared<Gate>(), closes = std::make_shared<Gate>();
  BackgroundTask([closes] { closes->pass(); }, BackgroundTask::Holds::device);
  EXPECT_EQ(dropped_work(), DroppedWork::harmless);
  BackgroundTask([writes] { writes->pass(); });
  EXPECT_EQ(dropped_work(), DroppedWork::change) << "unless it says otherwise";
  BackgroundTask([reads] { reads->pass(); }, BackgroundTask::Holds::nothing);
  EXPECT_EQ(dropped_work(), DroppedWork::change);
  writes->open();
  EXPECT_TRUE(eventually([] { return dropped_work() == DroppedWork::harmless; }));
  closes->open();
  reads->open();
  EXPECT_TRUE(eventually([] { return dropped_work() == DroppedWork::none; }));
  EXPECT_FALSE(reads->gave_up() || writes->gave_up() || closes->gave_up());
}

TEST(BackgroundTask, none_is_over_and_another_may_take_its_place) {
  BackgroundTask background_task;
  EXPECT_TRUE(background_task.over());
  std::atomic<int> runs{0};
  for (int i = 0; i < 20; ++i) background_task = BackgroundTask([&runs] { ++runs; });
  background_task = {};
  wait_for_dropped_tasks();
  EXPECT_EQ(runs, 20);
}

/// A bus that hangs until the gate opens.
class SlowWatch final : public DeviceWatch {
 public:
  explicit SlowWatch(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}
  std::vector<FoundDevice> list() override {
    gate_->pass();
    return with_software_devices({{.kind = "falcon", .name = "FT000001", .port = "1-1"}});
  }
  bool changed() noexcept override { return true; }

 private:
  std::shared_ptr<Gate> gate_;
};

TEST(BackgroundWatch, a_bus_that_hangs_holds_nobody_and_is_listed_when_it_answers) {
  auto gate = std::make_shared<Gate>();
  auto watch = watch_in_background([gate] { return std::make_unique<SlowWatch>(gate); }, 1ms);
  EXPECT_EQ(watch->list(), with_software_devices({}));
  EXPECT_FALSE(watch->changed());
  gate->open();
  ASSERT_TRUE(eventually([&] { return watch->changed(); }));
  ASSERT_EQ(watch->list().size(), 3u);
  EXPECT_EQ(watch->list()[0].name, "FT000001");
  EXPECT_FALSE(watch->changed());  // the same again is no news
  EXPECT_FALSE(gate->gave_up());
}

TEST(BackgroundWatch, it_can_be_left_while_the_bus_hangs) {
  auto gate = std::make_shared<Gate>();
  watch_in_background([gate] { return std::make_unique<SlowWatch>(gate); }, 1ms).reset();
  EXPECT_FALSE(gate->gave_up());
  gate->open();
  wait_for_dropped_tasks();
  EXPECT_FALSE(gate->gave_up());
}

TEST(BackgroundWatch, an_empty_bus_is_an_answer_too) {
  struct Empty final : DeviceWatch {
    std::vector<FoundDevice> list() override { return with_software_devices({}); }
    bool changed() noexcept override { return !std::exchange(asked, true); }
    bool asked = false;
  };
  auto watch = watch_in_background([] { return std::make_unique<Empty>(); }, 1ms);
  EXPECT_TRUE(eventually([&] { return watch->changed(); }));
}

}  // namespace
}  // namespace cusp::test
