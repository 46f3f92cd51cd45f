// Practice whose records cannot be read does not begin, and a briefing shows where practice would not count.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTemporaryDir>
#include <algorithm>
#include <memory>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/student/briefing.h"
#include "ui/student/start_page.h"
#include "ui/widgets/empty_state.h"

namespace cusp::test {
namespace {

struct UnreadPractice : ::testing::Test {
  UnreadPractice() {
    const Account lena = records.student("1", "Lena Brandt");
    exercise.scenario = *load_builtin("channel-1");
    exercise.scenario.version += 1;
    exercise.scenario.specimen.voxel_mm = 0.4;  // so that it grows at once
    exercise.version = records.store().scenarios.ensure(exercise.scenario, canonical_json(exercise.scenario), content_hash(exercise.scenario).bytes)->id;
    exercise.version_number = exercise.scenario.version;
    desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(lena);
  }
  AssignmentId assign(Assignment wanted) {
    Store& store = records.store();
    const Actor examiner = store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    wanted.version = exercise.version;
    wanted.cohort = store.cohorts.create(examiner, "Year 3")->id;
    EXPECT_TRUE(store.cohorts.add(examiner, wanted.cohort, desktop->account()->id));
    return store.assignments.create(examiner, wanted)->id;
  }
  /// Whether a page shows the sentence.
  bool shows(const QString& sentence) const {
    for (const QLabel* label : desktop->page()->findChildren<QLabel*>())
      if (label->text().contains(sentence)) return true;
    return false;
  }
  /// Whether the exercise begins; else a page gives the reason.
  bool begins() {
    desktop->drill(exercise);
    const bool drills = qobject_cast<DrillScreen*>(desktop->page()) != nullptr;
    EXPECT_NE(drills, desktop->page()->findChild<EmptyState*>() != nullptr);
    desktop->back();
    EXPECT_EQ(desktop->page(), desktop->shell());
    return drills;
  }

  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Exercise exercise;
  std::unique_ptr<Desktop> desktop;
};

TEST_F(UnreadPractice, whose_assignments_are_not_known_would_count_for_none) {
  ASSERT_TRUE(records.store().database().run("ALTER TABLE cohort_students RENAME TO lost_students"));
  desktop->drill(exercise);
  EXPECT_TRUE(shows(QStringLiteral("This exercise cannot be practised now.")));
  EXPECT_TRUE(shows(QStringLiteral("ask your instructor"))) << "what is damaged is no student's to restore";
  desktop->back();
  EXPECT_FALSE(begins());
  ASSERT_TRUE(records.store().database().run("ALTER TABLE lost_students RENAME TO cohort_students"));
  EXPECT_TRUE(begins());
}

TEST_F(UnreadPractice, whose_assignment_cannot_be_asked_would_count_for_none) {
  assign({});
  ASSERT_TRUE(records.store().database().run("DROP INDEX adjustments_of_assignment"));  // no attempt is admitted without it
  EXPECT_FALSE(begins());
}

TEST_F(UnreadPractice, that_counts_only_with_another_device_shows_that_before_and_while_it_is_drilled) {
  assign({.device_classes = {"falcon"}});
  Q_EMIT desktop->findChild<StartPage*>()->briefing_wanted(exercise);
  ASSERT_NE(qobject_cast<Briefing*>(desktop->page()), nullptr);
  EXPECT_TRUE(shows(QStringLiteral("Counts only with Falcon")));
  desktop->drill(exercise);
  const auto labels = desktop->page()->findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) { return label->accessibleName() == QStringLiteral("Practice, attempt 1, not counted"); }));
}

TEST_F(UnreadPractice, whose_last_attempt_is_used_shows_that_in_the_briefing_that_it_began_from) {
  NewSession wanted{.student = desktop->account()->id, .version = exercise.version, .assignment = assign({.attempts_allowed = 1})};
  wanted.header.device.device_class = "pointer";
  wanted.header.scene = "{}";
  Q_EMIT desktop->findChild<StartPage*>()->briefing_wanted(exercise);
  const QString used = QStringLiteral("Every attempt that counts is used");
  EXPECT_FALSE(shows(used));
  desktop->push(new QWidget);
  ASSERT_TRUE(records.store().sessions.start(desktop->account()->actor(), wanted));
  desktop->back();
  ASSERT_NE(qobject_cast<Briefing*>(desktop->page()), nullptr);
  EXPECT_TRUE(shows(used));
}

TEST_F(UnreadPractice, whose_volume_is_not_there_names_that_and_not_the_file_that_was_never_written) {
  exercise.files["tooth.nrrd"] = Hash256{};  // of no blob
  EXPECT_FALSE(begins());
}

}  // namespace
}  // namespace cusp::test
