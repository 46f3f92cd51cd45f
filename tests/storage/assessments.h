/// An instructor and two students with an exercise; a cohort with one of them, and attempts that are assigned to it.
#pragma once

#include <gtest/gtest.h>

#include "tests/storage/sample.h"

namespace cusp::test {

inline constexpr std::int64_t kHour = 3'600'000'000;

struct TwoStudents : ::testing::Test {
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Actor instructor = make_instructor(*store).actor();
  Account lena = make_student(*store), omar = make_student(*store, "20260002", "Omar Haddad");
  ScenarioVersion version = keep(*store);
};

struct AssessmentTest : TwoStudents {
  CohortId cohort;

  void SetUp() override {
    cohort = must(store->cohorts.create(instructor, "Year 2")).id;
    must(store->cohorts.add(instructor, cohort, lena.id));
  }
  Assignment assign(SessionKind kind, std::optional<int> attempts = {}) {
    Assignment a{.version = version.id, .cohort = cohort, .kind = kind};
    a.opens_utc_us = kNow;
    a.due_utc_us = kNow + kHour;
    a.attempts_allowed = attempts;
    return must(store->assignments.create(instructor, a, kind == SessionKind::assessment ? "4711" : ""));
  }
  Stored<Session> begin(const Account& student, const Assignment& assignment, const std::string& code = "4711") {
    NewSession wanted = new_session(student, version);
    wanted.assignment = assignment.id;
    wanted.start_code = assignment.kind == SessionKind::assessment ? code : "";
    return store->sessions.start(student.actor(), wanted);
  }
  SessionId sit(const Assignment& assignment, double score, bool passed) {
    const SessionId id = must(begin(lena, assignment)).id;
    must(store->traces.append(id, second_from(1)));
    must(store->sessions.finish(id, volume_after(12), "student"));
    must(store->grades.save(id, small_grade(score, passed), {}));
    return id;
  }
  std::string admission(const Account& student, const Assignment& assignment, const std::string& code) {
    NewSession wanted = new_session(student, version);
    wanted.assignment = assignment.id;
    wanted.start_code = code;
    const auto done = store->sessions.admit(student.actor(), wanted);
    return done ? "admitted" : done.error().where;
  }
  /// "withheld" if the student reads nothing of the result in any way, else its score.
  std::string seen(SessionId id) {
    const Actor student = lena.actor();
    const HistoryRow row = must(store->history.details(student, id)).row;
    const HistoryRow listed = must(store->history.details(instructor, id)).row;
    const bool readable = store->history.may_read_result(student, id).has_value();
    EXPECT_EQ(row.score.has_value(), readable);
    EXPECT_EQ(row.released, readable);
    EXPECT_EQ(listed.released, readable) << "an instructor's list says what the student sees";
    EXPECT_EQ(must(store->history.figures(student)).attempts, readable ? 1 : 0);
    EXPECT_EQ(must(store->statements.of(student, id)).empty(), !readable);
    EXPECT_TRUE(must(verify_store(store->context())).intact());
    return readable ? std::to_string(static_cast<int>(*row.score)) : "withheld";
  }
  static std::string refusal(const Stored<Session>& result) {
    return result ? "begun" : result.error().where;
  }
};

}  // namespace cusp::test
