// Self-tests of devices: who keeps one, and which assessment asks for it.
#include <gtest/gtest.h>

#include "tests/storage/assessments.h"

namespace cusp::test {
namespace {

using DeviceTestsTest = AssessmentTest;

TEST_F(DeviceTestsTest, it_begins_only_if_the_device_passed_its_newest_self_test_within_the_days_that_the_assignment_asks) {
  constexpr std::int64_t kDay = 24 * kHour;
  Assignment wish{.version = version.id, .cohort = cohort, .kind = SessionKind::assessment, .self_test_days = 7};
  const Assignment exam = must(store->assignments.create(instructor, wish, "4711"));
  EXPECT_EQ(must(store->assignments.find(exam.id)).self_test_days, 7);
  const auto with = [&](const std::string& device_class) {
    NewSession wanted = new_session(lena, version);
    wanted.assignment = exam.id;
    wanted.start_code = "4711";
    wanted.header.device.device_class = device_class;
    const auto done = store->sessions.admit(lena.actor(), wanted);
    EXPECT_EQ(store->sessions.start(lena.actor(), wanted).has_value(), done.has_value()) << "start() says what admit() says";
    if (done) return std::string("admitted");
    EXPECT_EQ(done.error().code, StorageError::self_test_due);
    return done.error().where + ' ' + done.error().detail;
  };
  const auto tested = [&](const std::string& device_class, TestOutcome outcome) {
    must(store->device_tests.add(instructor, {.device_class = device_class, .device = "room 2, left", .outcome = outcome}));
  };
  EXPECT_EQ(with("falcon"), "falcon 7");
  tested("falcon", TestOutcome::passed);
  tested("falcon-2", TestOutcome::failed);
  EXPECT_EQ(with("falcon"), "admitted");
  EXPECT_EQ(with("falcon-2"), "falcon-2 7");
  EXPECT_EQ(with("pointer"), "pointer 7") << "another class was tested";
  *now += 7 * kDay;
  EXPECT_EQ(with("falcon"), "admitted");
  *now += 1;
  EXPECT_EQ(with("falcon"), "falcon 7");
  tested("falcon", TestOutcome::passed);
  tested("falcon", TestOutcome::failed);
  EXPECT_EQ(with("falcon"), "falcon 7") << "the newest counts";
  *now -= kDay;
  EXPECT_EQ(with("falcon"), "admitted") << "the one that passed a week ago; those of a clock that was set back are passed over";
  tested("falcon", TestOutcome::failed);
  EXPECT_EQ(with("falcon"), "falcon 7");
  tested("falcon", TestOutcome::passed);
  EXPECT_EQ(with("falcon"), "admitted");
  *now += kDay;
  EXPECT_EQ(with("falcon"), "admitted") << "what failed before the clock was set back is older, whatever its time";
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(DeviceTestsTest, a_self_test_is_asked_for_within_a_year_and_of_an_assessment_alone) {
  const auto where = [&](SessionKind kind, int days) {
    const Assignment wish{.version = version.id, .cohort = cohort, .kind = kind, .self_test_days = days};
    const auto made = store->assignments.create(instructor, wish, kind == SessionKind::assessment ? "4711" : "");
    return made ? "made" : made.error().where;
  };
  for (const int days : {0, -1, kMostSelfTestDays + 1}) EXPECT_EQ(where(SessionKind::assessment, days), "self_test_days") << days;
  EXPECT_EQ(where(SessionKind::practice, 7), "self_test_days");
  EXPECT_EQ(where(SessionKind::assessment, kMostSelfTestDays), "made");
}

TEST_F(DeviceTestsTest, a_self_test_of_who_was_switched_off_at_another_window_is_not_kept) {
  must(store->accounts.disable(make_administrator(*store).actor(), instructor.id));
  EXPECT_EQ(code_of(store->device_tests.add(instructor, {.device_class = "falcon", .device = "room 2, left"})), StorageError::disabled);
  EXPECT_FALSE(must(store->device_tests.newest("falcon")));
}

TEST_F(DeviceTestsTest, a_self_test_is_kept_by_staff_with_device_tester_and_time) {
  EXPECT_FALSE(must(store->device_tests.newest("falcon")));
  EXPECT_EQ(code_of(store->device_tests.add(lena.actor(), {.device_class = "falcon"})), StorageError::not_allowed);
  for (const char* wrong : {"", "Falcon", "a b"}) {
    EXPECT_EQ(store->device_tests.add(instructor, {.device_class = wrong}).error().where, "device_class") << wrong;
  }
  EXPECT_EQ(store->device_tests.add(instructor, {.device_class = "falcon", .device = std::string(201, 'x')}).error().where, "device");
  must(store->device_tests.add(instructor, {.device_class = "falcon", .device = "room 2, left"}));
  const DeviceTest kept = *must(store->device_tests.newest("falcon"));
  EXPECT_EQ(kept.device_class, "falcon");
  EXPECT_EQ(kept.device, "room 2, left");
  EXPECT_EQ(kept.outcome, TestOutcome::passed);
  EXPECT_EQ(kept.tester, instructor.id);
  EXPECT_EQ(kept.at_utc_us, kNow);
  EXPECT_FALSE(must(store->device_tests.newest("falco")));
  EXPECT_EQ(must(store->audit.list(make_administrator(*store).actor(), 2))[1].action, "device_tested");
}

}  // namespace
}  // namespace cusp::test
