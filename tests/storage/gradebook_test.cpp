/// A column of results for another system's gradebook: who is in it, with which result, and how each system reads it.
#include <gtest/gtest.h>

#include "storage/export/gradebook.h"
#include "tests/storage/sample.h"
#include "tests/storage/statements_seen.h"

namespace cusp::test {
namespace {

struct GradebookTest : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Actor administrator = make_administrator(*store).actor();
  Actor instructor = make_instructor(*store).actor();
  Account lena = make_student(*store), omar = make_student(*store, "20260002", "Haddad, Omar"), ida = make_student(*store, "20260003", "Ida Berg");
  ScenarioVersion version = keep(*store);
  Assignment exam{};

  void SetUp() override {
    const CohortId cohort = must(store->cohorts.create(instructor, "Year 2")).id;
    for (const Account& student : {lena, omar, ida}) must(store->cohorts.add(instructor, cohort, student.id));
    exam = must(store->assignments.create(instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, "4711"));
  }
  SessionId sit(const Account& student, double score, bool released = true) {
    const SessionId id = sit_graded(student, small_grade(score, true));
    if (released) must(store->statements.release(instructor, id));
    return id;
  }
  SessionId sit_graded(const Account& student, const Grade& grade) {
    NewSession wanted = new_session(student, version);
    wanted.assignment = exam.id;
    wanted.start_code = "4711";
    const SessionId id = must(store->sessions.start(student.actor(), wanted)).id;
    must(store->traces.append(id, second_from(1)));
    must(store->sessions.finish(id, volume_after(12), "student"));
    must(store->grades.save(id, grade, {}));
    return id;
  }
  GradebookFile file(Gradebook system) { return must(make_gradebook(store->context(), administrator, exam.id, system)); }
};

TEST_F(GradebookTest, holds_the_best_released_result_of_each_student_and_nobody_without_one) {
  sit(lena, 62);
  sit(lena, 81.5);
  sit(lena, 99, false);
  sit(omar, 70, false);
  const GradebookFile moodle = file(Gradebook::moodle);
  EXPECT_EQ(moodle.students, 1u);
  EXPECT_EQ(moodle.withheld, 1u) << "Omar; one of Lena's is released";
  EXPECT_EQ(moodle.text.substr(0, 10), "ID number,");
  EXPECT_NE(moodle.text.find("\r\n20267314,81.5\r\n"), std::string::npos) << moodle.text;
  EXPECT_EQ(moodle.text.find("20260002"), std::string::npos);
  EXPECT_EQ(moodle.text.find("20260003"), std::string::npos);
}

TEST_F(GradebookTest, names_whose_attempts_have_no_grade_and_gives_them_no_cell) {
  const auto begin = [&](const Account& student) {
    NewSession wanted = new_session(student, version);
    wanted.assignment = exam.id;
    wanted.start_code = "4711";
    must(store->traces.append(must(store->sessions.start(student.actor(), wanted)).id, second_from(1)));
  };
  for (const Account& student : {lena, omar, ida}) begin(student);
  sit(lena, 81.5);
  sit(omar, 70, false);
  const GradebookFile moodle = file(Gradebook::moodle);
  EXPECT_EQ(moodle.ungraded, std::vector<std::string>{"20260003"}) << "Lena and Omar have a graded attempt beside it";
  EXPECT_EQ(moodle.students, 1u);
  EXPECT_EQ(moodle.withheld, 1u);
  EXPECT_EQ(moodle.text.find("20260003"), std::string::npos) << "an empty cell would clear a grade there";
}

TEST_F(GradebookTest, has_one_line_of_a_student_whom_another_window_renames_meanwhile) {
  sit(lena, 62);
  sit(lena, 81.5);
  const StatementsSeen seen;
  const auto reading = open(folder / "a.db");
  int rows = 0;
  StatementsSeen::at_each([&](std::string_view sql) {
    if (!sql.starts_with("SELECT m.session, m.student, p.number") || ++rows != 2) return;
    must(store->accounts.rename(administrator, lena.id, "20269999", lena.name));
  });
  const GradebookFile moodle = must(make_gradebook(reading->context(), administrator, exam.id, Gradebook::moodle));
  EXPECT_EQ(rows, 2) << "renamed between the two attempts";
  EXPECT_EQ(moodle.text, "ID number,Straight channel\r\n20267314,81.5\r\n");
}

TEST_F(GradebookTest, leaves_out_who_was_erased) {
  sit(lena, 62);
  sit(omar, 70);
  sit(ida, 70, false);
  for (const Account& gone : {omar, ida}) must(store->accounts.erase(administrator, gone.id));
  EXPECT_EQ(file(Gradebook::moodle).text, "ID number,Straight channel\r\n20267314,62\r\n");
  EXPECT_EQ(file(Gradebook::moodle).withheld, 0u);
}

TEST_F(GradebookTest, counts_what_examiners_changed) {
  const SessionId id = sit(lena, 68, false);
  must(store->statements.override_points(instructor, id, "target_removed", 20, "The block was worn."));
  must(store->statements.release(instructor, id));
  EXPECT_NE(file(Gradebook::moodle).text.find("20267314,70\r\n"), std::string::npos) << file(Gradebook::moodle).text;
}

TEST_F(GradebookTest, counts_who_failed_by_a_critical_event_with_points_above_the_pass_mark) {
  const SessionId exposed = sit_graded(lena, small_grade(90, false)), poor = sit_graded(ida, small_grade(40, false));
  for (const SessionId& id : {exposed, poor}) {
    must(store->statements.confirm(instructor, id));
    must(store->statements.release(instructor, id));
  }
  sit(omar, 90);
  const GradebookFile moodle = file(Gradebook::moodle);
  EXPECT_EQ(moodle.students, 3u);
  EXPECT_EQ(moodle.failed, 1u) << "Lena; the points of Ida show it";
  EXPECT_NE(moodle.text.find("\r\n20267314,90\r\n"), std::string::npos) << moodle.text;
}

TEST_F(GradebookTest, has_points_in_hundredths) {
  sit(lena, 36.998821908701814);
  sit(omar, 200.0 / 3);
  for (const Gradebook system : {Gradebook::moodle, Gradebook::canvas}) {
    const std::string text = file(system).text;
    EXPECT_NE(text.find(",37\r\n"), std::string::npos) << text;
    EXPECT_NE(text.find(",66.67\r\n"), std::string::npos) << text;
  }
}

TEST_F(GradebookTest, never_rounds_a_score_up_to_the_pass_mark) {
  sit(lena, 69.996);  // of small_grade(), whose mark is 70
  sit(omar, 69.996 + 0.004);
  sit(ida, 79.996);
  const std::string text = file(Gradebook::moodle).text;
  EXPECT_NE(text.find("20267314,69.99\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("20260002,70\r\n"), std::string::npos) << text;
  EXPECT_NE(text.find("20260003,80\r\n"), std::string::npos) << "no mark lies there: " << text;
}

TEST_F(GradebookTest, leaves_out_what_was_lowered_to_an_unconfirmed_fail_after_its_release) {
  const SessionId id = sit(lena, 72);
  must(store->statements.override_points(instructor, id, "target_removed", 0, "Not cut."));
  EXPECT_EQ(file(Gradebook::moodle).students, 0u);
  EXPECT_EQ(file(Gradebook::moodle).withheld, 1u);
  must(store->statements.confirm(instructor, id));
  EXPECT_NE(file(Gradebook::moodle).text.find("20267314,54\r\n"), std::string::npos) << file(Gradebook::moodle).text;
}

TEST_F(GradebookTest, has_the_columns_that_canvas_asks_for_and_quotes_names) {
  sit(omar, 75);
  const std::string text = file(Gradebook::canvas).text;
  EXPECT_EQ(text.find("Student,ID,SIS User ID,SIS Login ID,Section,"), 0u) << text;
  EXPECT_NE(text.find("\r\nPoints Possible,,,,,"), std::string::npos) << text;
  EXPECT_NE(text.find("\r\n\"Haddad, Omar\",,20260002,20260002,,75\r\n"), std::string::npos) << text;
}

TEST_F(GradebookTest, has_its_title_before_anybody_has_a_result) {
  EXPECT_EQ(file(Gradebook::moodle).text, "ID number,Straight channel\r\n");
  EXPECT_EQ(file(Gradebook::canvas).text,
            "Student,ID,SIS User ID,SIS Login ID,Section,Straight channel\r\nPoints Possible,,,,,100\r\n");
  sit(lena, 70);
  EXPECT_EQ(file(Gradebook::moodle).text, "ID number,Straight channel\r\n20267314,70\r\n") << "the same title with results";
}

TEST_F(GradebookTest, needs_the_right_and_stands_in_the_log) {
  EXPECT_EQ(code_of(make_gradebook(store->context(), lena.actor(), exam.id, Gradebook::moodle)), StorageError::not_allowed);
  EXPECT_EQ(code_of(make_gradebook(store->context(), administrator, AssignmentId::make(), Gradebook::moodle)), StorageError::not_found);
  const GradebookFile made = file(Gradebook::canvas);
  EXPECT_EQ(made.students, 0u);
  EXPECT_NE(must(store->audit.list(administrator, 1)).at(0).action, "gradebook_exported") << "it is not written yet";
  EXPECT_EQ(code_of(log_gradebook(store->context(), lena.actor(), exam.id, made)), StorageError::not_allowed);
  must(log_gradebook(store->context(), administrator, exam.id, made));
  EXPECT_EQ(must(store->audit.list(administrator, 1)).at(0).action, "gradebook_exported");
}

TEST_F(GradebookTest, is_refused_to_whom_another_window_switched_off_since_signing_in) {
  sit(lena, 62);
  must(open(folder / "a.db")->accounts.disable(administrator, instructor.id));
  EXPECT_EQ(code_of(log_gradebook(store->context(), instructor, exam.id, file(Gradebook::moodle))), StorageError::disabled);
  EXPECT_NE(must(store->audit.list(administrator, 1)).at(0).action, "gradebook_exported");
}

}  // namespace
}  // namespace cusp::test
