#include "storage/export/csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/modules.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {


TEST(CsvCells, text_is_quoted_as_rfc_4180_asks) {
  EXPECT_EQ(csv_text("plain"), "plain");
  EXPECT_EQ(csv_text(""), "");
  EXPECT_EQ(csv_text("Class I, 36"), "\"Class I, 36\"");
  EXPECT_EQ(csv_text("say \"ah\""), "\"say \"\"ah\"\"\"");
  EXPECT_EQ(csv_text("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_text(" space"), "\" space\"");
  EXPECT_EQ(csv_text("Ekström"), "Ekström");
}

TEST(CsvCells, what_a_spreadsheet_would_run_is_made_plain) {
  EXPECT_EQ(csv_text("=1+1"), "'=1+1");
  EXPECT_EQ(csv_text("+49 30"), "'+49 30");
  EXPECT_EQ(csv_text("-2"), "'-2");
  EXPECT_EQ(csv_text("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_text("\t=1"), "'\t=1");
  EXPECT_EQ(csv_text("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
}

TEST(CsvCells, numbers_read_back_exactly_and_carry_a_point) {
  EXPECT_EQ(csv_number(81.5), "81.5");
  EXPECT_EQ(csv_number(-0.25), "-0.25");
  EXPECT_EQ(std::stod(csv_number(1.0 / 3.0)), 1.0 / 3.0);
  EXPECT_EQ(csv_number(std::nan("")), "");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::infinity()), "");
}

TEST(CsvExport, the_history_is_one_line_a_session) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store, "=20267314", "Brandt, \"Lena\"");
  const SessionId id = complete_session(*store, student, keep(*store), 40, false);
  const Actor admin = make_administrator(*store).actor();
  const CsvFile csv = must(export_history(store->context(), admin, {}, {.language = "de"}));
  EXPECT_EQ(csv.rows, 1u);
  EXPECT_EQ(
      csv.text,
      "session,started_utc,student_number,student_name,exercise,exercise_key,version,kind,hand,device,device_class,"
      "go,duration_s,state,score,score_max,pass_mark,passed,critical,assignment,released\r\n" +
          id.text() +
          ",2026-11-20T09:14:03Z,'=20267314,\"Brandt, \"\"Lena\"\"\",Gerader Kanal,channel-1,1,practice,person,"
          "Mouse and keys,pointer,1,3.000024,graded,40,100,70,0,pulp_exposure,,1\r\n");
  EXPECT_TRUE(
      must(export_history(store->context(), admin, {}, {.byte_order_mark = true})).text.starts_with("\xEF\xBB\xBFsession"));
  EXPECT_EQ(must(store->audit.list(admin, 1))[0].action, "history_exported");
}

TEST(CsvExport, an_attempt_at_an_assignment_names_it_and_whether_its_result_is_released) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Actor instructor = make_instructor(*store).actor();
  const Account student = make_student(*store);
  const auto version = keep(*store);
  const CohortId cohort = must(store->cohorts.create(instructor, "Year 2")).id;
  must(store->cohorts.add(instructor, cohort, student.id));
  const AssignmentId assignment =
      must(store->assignments.create(instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, "4711")).id;
  NewSession wanted = new_session(student, version);
  wanted.assignment = assignment;
  wanted.start_code = "4711";
  must(store->sessions.start(student.actor(), wanted));
  EXPECT_TRUE(must(export_history(store->context(), instructor, {})).text.ends_with(',' + assignment.text() + ",0\r\n"));
}

TEST(CsvExport, criteria_are_one_line_each_and_what_was_not_measured_stays_empty) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store);
  const SessionId id = complete_session(*store, student, keep(*store));
  Grade grade = small_grade();
  grade.criteria[0].measure.measured = false;
  must(store->grades.save(id, grade, {}));
  const std::string csv = must(export_criteria(store->context(), make_instructor(*store).actor(), {}));
  const std::string start = id.text() + ",2026-11-20T09:14:03Z,20267314,channel-1,";
  EXPECT_EQ(csv,
            "session,started_utc,student_number,exercise_key,criterion,measured,value,uncertainty,unit,band,points,"
            "points_max,reason_code\r\n" +
                start + "target_removed,0,,,%,ideal,18,20,full\r\n" + start +
                "floor_depth_max,1,2.41,0.03,mm,fail,4,10,too_deep\r\n");
}

TEST(CsvExport, a_student_exports_nothing) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Actor student = make_student(*store).actor();
  EXPECT_EQ(code_of(export_history(store->context(), student, {})), StorageError::not_allowed);
  EXPECT_EQ(code_of(export_criteria(store->context(), student, {})), StorageError::not_allowed);
}

}  // namespace
}  // namespace cusp::test
