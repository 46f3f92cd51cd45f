/// A student's start page over real records, with an assessment that has begun.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <memory>
#include <optional>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/briefing.h"
#include "ui/student/start_page.h"
#include "ui/student/thumbnail_cache.h"

namespace cusp::test {

struct StartPageCards : ::testing::Test {
  StartPageCards() {
    Store& store = records.store();
    examiner = store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    cohort = store.cohorts.create(examiner, "Year 3")->id;
    EXPECT_TRUE(store.cohorts.add(examiner, cohort, lena.id));
    const Scenario scenario = *load_builtin("channel-1");
    const VersionId version = store.scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes)->id;
    exam = *store.assignments.create(examiner, {.version = version, .cohort = cohort, .kind = SessionKind::assessment, .attempts_allowed = 1}, "4711");
  }
  /// With tissue removed.
  SessionId sit(int engine_version = kEngineVersion) {
    NewSession wanted{.student = lena.id, .version = exam.version, .assignment = exam.id, .start_code = "4711"};
    wanted.header.scene = "{}";
    wanted.header.device.device_class = "pointer";
    wanted.header.engine_version = engine_version;
    const SessionId session = records.store().sessions.start(lena.actor(), wanted)->id;
    RecordedSecond second;
    second.inputs.resize(1);
    second.metrics.removed = {{Tissue::plastic, 300, 0.3}};
    EXPECT_TRUE(records.store().traces.append(session, second));
    records.now_us += 60'000'000;
    return session;
  }
  SessionId broken_off() {
    const SessionId session = sit();
    EXPECT_TRUE(records.store().sessions.interrupt(session, "left"));
    return session;
  }
  StartPage* page() {
    shown = std::make_unique<StartPage>(records.store(), lena, pictures, now);
    return shown.get();
  }
  std::optional<Message> refusal(const char* key) { return why_no_practice(records.store(), lena.actor(), load_builtin(key)->id); }

  DeskRecords records;
  QTemporaryDir cache;
  ThumbnailCache pictures{cache.path().toStdString()};
  QDateTime now{QDate(2026, 11, 20), QTime(10, 0)};
  Account lena = records.student("1", "Lena Brandt");
  Actor examiner;
  CohortId cohort;
  Assignment exam;
  std::unique_ptr<StartPage> shown;
};

}  // namespace cusp::test
