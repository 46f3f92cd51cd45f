#include "storage/export/csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "storage/base/clock.h"
#include "tests/modules.h"
#include "tests/storage/assessments.h"

namespace cusp::test {
namespace {

std::string exported_text(Store& store, const Actor& actor, const CsvOptions& options = {}) {
  std::string text;
  must(export_rows(store.context(), actor, {}, [&](std::span<const ExportRow> rows, std::size_t) -> Stored<bool> {
    text += history_csv(rows, text.empty() ? CsvPart::beginning : CsvPart::further, options);
    return true;
  }));
  return text;
}

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
  EXPECT_EQ(csv_text("\t=1"), "'\t'=1");
  EXPECT_EQ(csv_text("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
}

TEST(CsvCells, signs_of_full_width_begin_a_formula_too) {
  for (const std::string sign : {"\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"}) {
    EXPECT_EQ(csv_text(sign + "1"), "'" + sign + "1");
    EXPECT_EQ(csv_text("Lena;" + sign + "1"), "Lena;'" + sign + "1");
  }
  EXPECT_EQ(csv_text("1\uFF1D1"), "1\uFF1D1");
}

TEST(CsvCells, so_is_what_a_spreadsheet_with_another_separator_would_run) {
  EXPECT_EQ(csv_text("Lena;=1+1"), "Lena;'=1+1");
  EXPECT_EQ(csv_text("Lena\t@SUM(A1)"), "Lena\t'@SUM(A1)");
  EXPECT_EQ(csv_text("a;+1;-2"), "a;'+1;'-2");
  EXPECT_EQ(csv_text("a\n=1+1\r\n-2"), "\"a\n'=1+1\r\n'-2\"");
  EXPECT_EQ(csv_text("a;\"=1\""), "\"a;\"\"'=1\"\"\"");
  for (const char* plain : {"a; b", "a;b", "1-2", "x = 1; y = 2", "2.5;3", "Brandt-Meier"}) EXPECT_EQ(csv_text(plain), plain);
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
  EXPECT_EQ(
      exported_text(*store, admin, {.language = "de"}),
      "session,started_utc,student_number,student_name,exercise,exercise_key,version,kind,hand,device,device_class,"
      "go,duration_s,state,score,score_max,pass_mark,passed,critical,assignment,released,"
      "finished_utc,cohort,opens_utc,due_utc\r\n" +
          id.text() +
          ",2026-11-20T09:14:03Z,'=20267314,\"Brandt, \"\"Lena\"\"\",Gerader Kanal,channel-1,1,practice,person,"
          "Mouse and keys,pointer,1,3.000024,graded,40,100,70,0,pulp_exposure,,1,2026-11-20T09:14:03Z,,,\r\n");
  EXPECT_TRUE(exported_text(*store, admin, {.byte_order_mark = true}).starts_with("\xEF\xBB\xBFsession"));
  EXPECT_EQ(must(store->audit.list(admin, 1))[0].action, "history_exported");
}

constexpr std::int64_t kDayUs = 24 * kHour;

/// Two cohorts of one student each, and an assignment of the first.
struct ExportOfCohorts : TwoStudents {
  CohortId year_2 = cohort_of("=Year 2, group \"A\"", lena), year_3 = cohort_of("Year 3", omar);

  CohortId cohort_of(const std::string& name, const Account& student) {
    const CohortId id = must(store->cohorts.create(instructor, name)).id;
    must(store->cohorts.add(instructor, id, student.id));
    return id;
  }
  SessionId sit(const Assignment& assignment, const std::string& start_code = {}) {
    NewSession wanted = new_session(lena, version);
    wanted.assignment = assignment.id;
    wanted.start_code = start_code;
    return must(store->sessions.start(lena.actor(), wanted)).id;
  }
  std::vector<SessionId> exported(const HistoryFilter& filter) {
    std::vector<SessionId> ids;
    must(export_rows(store->context(), instructor, filter, [&](std::span<const ExportRow> rows, std::size_t) -> Stored<bool> {
      for (const ExportRow& row : rows) ids.push_back(row.attempt.session);
      return true;
    }));
    return ids;
  }
};

TEST_F(ExportOfCohorts, a_row_names_assignment_release_cohort_and_dates) {
  const Assignment exam = must(store->assignments.create(instructor,
      {.version = version.id, .cohort = year_2, .kind = SessionKind::assessment, .opens_utc_us = kNow - kHour, .due_utc_us = kNow + kDayUs}, "4711"));
  const SessionId id = sit(exam, "4711");
  const std::string start = ',' + exam.id.text() + ",0,", cohort = "\"'=Year 2, group \"\"A\"\"\"",
                    dates = ",2026-11-20T08:14:03Z,2026-11-21T09:14:03Z\r\n";
  const auto text = [&] { return exported_text(*store, instructor); };
  EXPECT_TRUE(text().ends_with(start + ',' + cohort + dates)) << "not finished: " << text();
  must(store->traces.append(id, second_from(1)));
  *now += kHour;
  must(store->sessions.finish(id, volume_after(12), "student"));
  EXPECT_TRUE(text().ends_with(start + "2026-11-20T10:14:03Z," + cohort + dates)) << text();
}

TEST_F(ExportOfCohorts, an_assignment_without_dates_leaves_them_empty) {
  const Assignment practice = must(store->assignments.create(instructor, {.version = version.id, .cohort = year_2}));
  sit(practice);
  const std::string text = exported_text(*store, instructor);
  EXPECT_TRUE(text.ends_with(practice.id.text() + ",1,,\"'=Year 2, group \"\"A\"\"\",,\r\n")) << text;
}

TEST_F(ExportOfCohorts, an_attempt_that_is_graded_as_it_stands_ends_with_its_first_grade) {
  const Assignment practice = must(store->assignments.create(instructor, {.version = version.id, .cohort = year_2}));
  const SessionId id = sit(practice);
  const std::string start = practice.id.text() + ",1,", cohort = ",\"'=Year 2, group \"\"A\"\"\",,\r\n";
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "process_gone"));
  EXPECT_TRUE(exported_text(*store, instructor).ends_with(start + cohort)) << "it can be resumed";
  for (int grades = 0; grades < 2; ++grades) {
    *now += kHour;
    must(store->grades.save(id, small_grade(), {}));
    EXPECT_TRUE(exported_text(*store, instructor).ends_with(start + "2026-11-20T10:14:03Z" + cohort)) << exported_text(*store, instructor);
  }
}

TEST_F(ExportOfCohorts, a_cohort_and_dates_narrow_it) {
  const SessionId first = complete_session(*store, lena, version);
  *now += kDayUs;
  const SessionId second = complete_session(*store, omar, version);
  *now += kDayUs;
  const SessionId third = complete_session(*store, lena, version);
  EXPECT_EQ(exported({}), (std::vector{third, second, first}));
  EXPECT_EQ(exported({.cohort = year_2}), (std::vector{third, first}));
  EXPECT_EQ(exported({.cohort = year_3}), std::vector{second});
  EXPECT_TRUE(exported({.cohort = CohortId::make()}).empty());
  const auto day = [](const char* iso) { return utc_span_of(iso).value(); };
  EXPECT_EQ(exported({.from_utc_us = day("2026-11-21").begin_utc_us}), (std::vector{third, second}));
  EXPECT_EQ(exported({.to_utc_us = day("2026-11-21").end_utc_us}), (std::vector{second, first}));
  EXPECT_EQ(exported({.to_utc_us = day("2026-11-20T09:14:03Z").end_utc_us}), std::vector{first}) << "its own second";
  EXPECT_TRUE(exported({.to_utc_us = day("2026-11-20T09:14:02Z").end_utc_us}).empty());
  EXPECT_EQ(exported({.cohort = year_2, .from_utc_us = day("2026-11-21").begin_utc_us}), std::vector{third});
  EXPECT_EQ(must(store->audit.list(make_administrator(*store).actor(), 2))[1].detail, "1") << "the rows that left";
}

TEST(CsvExport, many_attempts_come_piece_by_piece_and_a_stopped_export_leaves_no_entry) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store);
  const ScenarioVersion version = keep(*store);
  for (std::size_t i = 0; i < kExportedAtOnce + 2; ++i) must(store->sessions.start(student.actor(), new_session(student, version)));
  const Actor admin = make_administrator(*store).actor();
  std::vector<std::size_t> pieces;
  const auto take = [&](std::span<const ExportRow> rows, std::size_t all) -> Stored<bool> {
    EXPECT_EQ(all, kExportedAtOnce + 2);
    pieces.push_back(rows.size());
    return pieces.size() != 3;
  };
  EXPECT_EQ(must(export_rows(store->context(), admin, {}, take)), kExportedAtOnce + 2);
  EXPECT_EQ(pieces, (std::vector<std::size_t>{kExportedAtOnce, 2}));
  EXPECT_EQ(must(store->audit.list(admin, 1))[0].detail, std::to_string(kExportedAtOnce + 2));
  const std::int64_t entries = must(store->audit.list(admin, 1))[0].number;
  EXPECT_FALSE(must(export_rows(store->context(), admin, {}, take)));
  EXPECT_EQ(pieces.size(), 3u);
  EXPECT_EQ(must(store->audit.list(admin, 1))[0].number, entries);
}

TEST_F(ExportOfCohorts, rows_that_could_not_be_written_to_their_end_leave_no_entry) {
  const Actor admin = make_administrator(*store).actor();
  complete_session(*store, lena, version);
  const std::int64_t newest = must(store->audit.list(admin, 1)).at(0).number;
  bool taken = false;
  const auto rows = export_rows(
      store->context(), instructor, {},
      [&](std::span<const ExportRow>, std::size_t) -> Stored<bool> { return taken = true; },
      [&]() -> Stored<void> {
        EXPECT_TRUE(taken);
        return fail(StorageError::disk_full, "out.csv");
      });
  EXPECT_EQ(code_of(rows), StorageError::disk_full);
  EXPECT_EQ(must(store->audit.list(admin, 1)).at(0).number, newest);
}

TEST(CsvExport, the_first_entry_of_the_log_has_the_number_one) {
  AuditEntry first;
  first.action = "station_key_added";
  EXPECT_TRUE(audit_csv_line(first, [](const Uuid&) { return std::string(); }).starts_with("1,"));
}

TEST(CsvExport, a_student_exports_nothing) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Actor student = make_student(*store).actor();
  const auto rows = export_rows(store->context(), student, {}, [](std::span<const ExportRow>, std::size_t) -> Stored<bool> { return true; });
  EXPECT_EQ(code_of(rows), StorageError::not_allowed);
}

TEST_F(ExportOfCohorts, who_is_switched_off_while_the_rows_are_read_has_no_export) {
  const Actor admin = make_administrator(*store).actor();
  complete_session(*store, lena, version);
  const auto rows = export_rows(store->context(), instructor, {}, [&](std::span<const ExportRow>, std::size_t) -> Stored<bool> {
    must(open(folder / "a.db", quick(now))->accounts.disable(admin, instructor.id));
    return true;
  });
  EXPECT_EQ(code_of(rows), StorageError::disabled);
  EXPECT_EQ(must(store->audit.list(admin, 1)).at(0).action, "account_disabled");
}

}  // namespace
}  // namespace cusp::test
