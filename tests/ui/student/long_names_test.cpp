// A student's pages of an exercise with a very long name: the name is whole or elided, and no page grows wider than its window.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/briefing.h"
#include "ui/student/interrupted_card.h"
#include "ui/student/own_history.h"
#include "ui/student/start_page.h"

namespace cusp::test {
namespace {

constexpr QSize kPage(1080, 672);  // of a window of 1280 x 720

struct LongNames : ::testing::Test {
  LongNames() {
    Store& store = records.store();
    const Actor examiner = store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    const CohortId cohort = store.cohorts.create(examiner, "Year 3")->id;
    EXPECT_TRUE(store.cohorts.add(examiner, cohort, lena.id));
    Scenario scenario = *load_builtin("channel-1");
    scenario.version += 1;
    for (auto& [language, title] : scenario.title) title = name.toStdString();
    exercise.scenario = scenario;
    exercise.version = store.scenarios.publish(examiner, scenario, canonical_json(scenario), content_hash(scenario).bytes)->id;
    EXPECT_TRUE(store.assignments.create(examiner, {.version = exercise.version, .cohort = cohort, .due_utc_us = kMorning + 3'600'000'000}));
    const SessionId graded = drill();
    FinalVolume volume;
    volume.tick = 1;
    EXPECT_TRUE(store.sessions.finish(graded, volume, "student"));
    EXPECT_TRUE(store.grades.save(graded, sample_grade(60), Hash256{}));
    EXPECT_TRUE(store.sessions.interrupt(drill(), "left"));
  }
  SessionId drill() {
    NewSession wanted{.student = lena.id, .version = exercise.version};
    wanted.header.scene = "{}";
    wanted.header.device.device_class = "pointer";
    const SessionId session = records.store().sessions.start(lena.actor(), wanted)->id;
    RecordedSecond second;
    second.inputs.resize(1);
    EXPECT_TRUE(records.store().traces.append(session, second));
    records.now_us += 60'000'000;
    return session;
  }
  int labels_with_the_name(const QWidget& page) const {
    int out = 0;
    for (const QLabel* label : page.findChildren<QLabel*>()) out += label->text().contains(name) ? 1 : 0;
    return out;
  }

  const QString name = QString(QStringLiteral("Class II cavity with two boxes ")).repeated(10).trimmed();
  DeskRecords records;
  QTemporaryDir cache;
  ThumbnailCache pictures{cache.path().toStdString()};
  Account lena = records.student("1", "Lena Brandt");
  Exercise exercise;
};

TEST_F(LongNames, do_not_widen_the_start_page) {
  StartPage page(records.store(), lena, pictures, QDateTime::fromMSecsSinceEpoch(kMorning / 1000));
  page.resize(kPage);
  page.show();
  QTest::qWait(0);
  ASSERT_NE(page.interrupted(), nullptr);
  EXPECT_GE(labels_with_the_name(page), 3) << "interrupted, next and last";
  EXPECT_EQ(page.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
}

TEST_F(LongNames, do_not_widen_own_results) {
  OwnHistory page(records.store(), lena.actor());
  EXPECT_LE(page.minimumSizeHint().width(), kPage.width());
  EXPECT_LE(page.exercise()->sizeHint().boundedTo(page.exercise()->maximumSize()).width(), kPage.width() / 2);
}

TEST_F(LongNames, do_not_widen_a_briefing) {
  Briefing page(exercise, pictures, {}, nullptr);
  EXPECT_LE(page.minimumSizeHint().width(), kPage.width());
  page.resize(kPage);
  page.show();
  QTest::qWait(0);
  EXPECT_EQ(page.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
  EXPECT_EQ(labels_with_the_name(page), 1) << "whole in the text, elided in the bar";
}

}  // namespace
}  // namespace cusp::test
