/// Lists by key and figures: every filter against a plain reading of all rows, the plan of every statement that a screen
/// runs, and the time of each screen among many sessions. CUSP_SESSIONS=1000000 measures a million with all their rows (5 minutes, 7 GB).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iterator>

#include "storage/export/csv.h"
#include "tests/storage/many_sessions.h"
#include "tests/storage/statements_seen.h"

namespace cusp::test {
namespace {

/// Every combination of conditions, each with a value that some rows have.
std::vector<HistoryFilter> every_filter(const ManySessions& m) {
  std::vector<HistoryFilter> out;
  for (unsigned bits = 0; bits < 256; ++bits) {
    HistoryFilter f;
    if (bits & 1) f.student = m.students[7].id;
    if (bits & 2) f.scenario = m.versions[3].scenario;
    if (bits & 4) f.cohort = m.cohorts[7];
    if (bits & 8) f.device_class = "falcon";
    if (bits & 16) f.passed = true;
    if (bits & 32) f.scripted = false;
    if (bits & 64) f.search = "student 7";
    if (bits & 128) f.from_utc_us = kNow - 300ll * 86'400 * 1'000'000, f.to_utc_us = kNow - 86'400ll * 1'000'000;
    out.push_back(f);
  }
  for (const unsigned bits : {0u, 2u, 4u, 16u, 64u, 128u})
    for (const SessionKind kind : {SessionKind::practice, SessionKind::assessment}) {
      out.push_back(out[bits]);
      out.back().kind = kind;
    }
  return out;
}

bool fits(const HistoryRow& r, const HistoryFilter& f) {
  const bool in_cohort = std::atoi(r.student_number.c_str()) % ManySessions::kCohorts == 7;
  return (!f.student || *f.student == r.student) && (!f.scenario || *f.scenario == r.scenario) &&
         (!f.cohort || in_cohort) && (!f.device_class || *f.device_class == r.device_class) &&
         (!f.passed || f.passed == r.passed) && (!f.scripted || !*f.scripted) && (!f.kind || *f.kind == r.kind) &&
         (f.search.empty() || r.student_name.starts_with("Student 7")) &&
         (!f.from_utc_us || (r.started_utc_us >= *f.from_utc_us && r.started_utc_us < *f.to_utc_us));
}

Figures figures_of(Store& store, const Actor& actor, const HistoryFilter& filter = {}) {
  return must(store.history.figures(actor, filter));
}

std::vector<SessionId> ids_of(const std::vector<HistoryRow>& rows) {
  std::vector<SessionId> ids;
  for (const HistoryRow& r : rows) ids.push_back(r.session);
  return ids;
}

TEST(Pages, of_every_filter_hold_the_rows_that_fit_each_once_and_in_order) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const ManySessions m = write_many(*store, 3000);
  const auto all = must(store->history.list(m.admin.actor()));
  ASSERT_EQ(std::ssize(all), m.listed);
  EXPECT_TRUE(std::ranges::is_sorted(all, std::greater<>{}, &HistoryRow::started_utc_us));
  std::size_t listed = 0;
  for (const HistoryFilter& f : every_filter(m)) {
    std::vector<SessionId> expected;
    FigureCount count;
    for (const HistoryRow& r : all) {
      if (!fits(r, f)) continue;
      expected.push_back(r.session);
      if (r.score) count.add({r.student, r.attempt, *r.score, r.pass_mark, r.passed.value_or(false), r.elapsed_us});
    }
    std::vector<SessionId> paged;
    std::optional<HistoryKey> after;
    do {
      const auto page = must(store->history.page(m.admin.actor(), f, after, 700));
      for (const SessionId id : ids_of(page.rows)) paged.push_back(id);
      after = page.after;
    } while (after);
    EXPECT_EQ(paged, expected);
    EXPECT_EQ(ids_of(must(store->history.list(m.admin.actor(), f))), expected);
    const Figures wanted = count.figures(), found = figures_of(*store, m.admin.actor(), f);
    EXPECT_EQ(found.attempts, wanted.attempts);
    EXPECT_EQ(found.students, wanted.students);
    EXPECT_EQ(found.median_score, wanted.median_score);
    EXPECT_EQ(found.spread, wanted.spread);
    EXPECT_EQ(found.learning.size(), wanted.learning.size());
    listed += expected.size();
  }
  EXPECT_GT(listed, 5'000u);
}

TEST(Pages, end_where_a_row_was_although_newer_ones_came) {
  const Folder folder;
  const auto now = std::make_shared<std::int64_t>(kNow);
  const auto store = open(folder / "a.db", quick(now));
  const Account lena = make_student(*store);
  const ScenarioVersion version = keep(*store);
  std::vector<SessionId> sessions;
  // Two sessions a moment: the sequence orders them.
  for (int i = 0; i < 6; ++i, *now += i % 2 * 60'000'000) {
    sessions.push_back(must(store->sessions.start(lena.actor(), new_session(lena, version))).id);
  }
  const auto first = must(store->history.page(lena.actor(), {}, {}, 3));
  EXPECT_EQ(ids_of(first.rows), (std::vector{sessions[5], sessions[4], sessions[3]}));
  must(store->sessions.start(lena.actor(), new_session(lena, version)));
  const auto second = must(store->history.page(lena.actor(), {}, first.after, 4));
  EXPECT_EQ(ids_of(second.rows), (std::vector{sessions[2], sessions[1], sessions[0]}));
  EXPECT_FALSE(second.after);
}

/// Two versions of an exercise, drilled by a student and by an instructor.
TEST(Pages, narrow_to_a_version_and_to_students_or_staff) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account lena = make_student(*store), okafor = make_instructor(*store);
  const ScenarioVersion first = keep(*store);
  Scenario deeper = small_scenario();
  deeper.version = 2;
  const ScenarioVersion second = keep(*store, deeper, "{\"id\":2}");
  ASSERT_EQ(second.number, 2);
  const SessionId a = complete_session(*store, lena, first, 50, false), b = complete_session(*store, lena, second, 60, false),
                  c = complete_session(*store, okafor, second, 90);
  const Actor reader = okafor.actor();
  const auto fit = [&](const HistoryFilter& f) {
    const auto rows = ids_of(must(store->history.list(reader, f)));
    EXPECT_EQ(static_cast<std::size_t>(figures_of(*store, reader, f).attempts), rows.size());
    return rows;
  };
  const ScenarioId exercise = first.scenario;
  EXPECT_EQ(fit({.scenario = exercise}), (std::vector{c, b, a}));
  EXPECT_EQ(fit({.scenario = exercise, .version_number = 1}), std::vector{a});
  EXPECT_EQ(fit({.scenario = exercise, .version_number = 2}), (std::vector{c, b}));
  EXPECT_EQ(fit({.student = lena.id, .scenario = exercise, .version_number = 2}), std::vector{b});
  EXPECT_EQ(fit({.drilled_by = DrilledBy::students}), (std::vector{b, a}));
  EXPECT_EQ(fit({.drilled_by = DrilledBy::staff}), std::vector{c});
  EXPECT_EQ(fit({.scenario = exercise, .version_number = 2, .drilled_by = DrilledBy::students}), std::vector{b});
  EXPECT_TRUE(fit({.student = lena.id, .drilled_by = DrilledBy::staff}).empty());
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST(Pages, of_others_are_refused_to_a_student) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account lena = make_student(*store), noah = make_student(*store, "2", "Noah Adler");
  complete_session(*store, noah, keep(*store));
  const HistoryFilter others{.student = noah.id};
  EXPECT_EQ(code_of(store->history.page(lena.actor(), others, {}, 10)), StorageError::not_allowed);
  EXPECT_EQ(code_of(store->history.figures(lena.actor(), others)), StorageError::not_allowed);
  EXPECT_EQ(code_of(store->history.scenarios(lena.actor(), noah.id)), StorageError::not_allowed);
  EXPECT_EQ(code_of(store->history.standings(lena.actor(), noah.id)), StorageError::not_allowed);
  EXPECT_EQ(code_of(store->history.newest_comment(lena.actor(), noah.id)), StorageError::not_allowed);
  EXPECT_EQ(code_of(store->history.device_classes(lena.actor())), StorageError::not_allowed);
  EXPECT_EQ(figures_of(*store, lena.actor()).attempts, 0);
  EXPECT_EQ(code_of(store->history.by_criterion(lena.actor(), others)), StorageError::not_allowed);
  EXPECT_TRUE(must(store->history.scenarios(lena.actor())).empty());
  EXPECT_EQ(must(store->history.scenarios(noah.actor())).size(), 1u);
}

/// What the screens ask, by screen. `i` chooses student, cohort and exercise.
struct Screen {
  const char* name;
  std::function<void(Store&, const ManySessions&, std::size_t i)> read;
};
constexpr int kPage = 100;

const Account& student_of(const ManySessions& m, std::size_t i) { return m.students[i * 37 % m.students.size()]; }

std::vector<Screen> student_screens() {
  return {
      {"start page", [](Store& s, const ManySessions& m, std::size_t i) {
         const Actor own = student_of(m, i).actor();
         must(s.sessions.mark_interrupted());
         const auto standings = must(s.history.standings(own, own.id));
         must(s.assignments.for_student(own.id));
         must(s.history.interrupted(own, own.id));
         must(s.history.newest_comment(own, own.id));
         for (const ExerciseStanding& standing : standings) {
           if (!standing.last) continue;
           must(s.history.best_before(own, standing.last->session));
           must(s.history.list(own, {.scenario = standing.scenario, .device_class = standing.last->device_class}));
           break;
         }
       }},
      {"own history", [](Store& s, const ManySessions& m, std::size_t i) {
         const Actor own = student_of(m, i).actor();
         must(s.history.scenarios(own, own.id));
         const auto page = must(s.history.page(own, {}, {}, kPage));
         if (!page.rows.empty()) must(s.history.list(own, {.scenario = page.rows[0].scenario, .device_class = "pointer"}));
         if (!page.rows.empty()) must(s.history.rated_attempts(own, own.id, page.rows[0].scenario, page.rows[0].device_class));
         must(s.history.attempts(own, own.id, m.versions[0].scenario));
       }},
  };
}

ScenarioId exercise_of(const ManySessions& m, std::size_t i) { return m.versions[i % m.versions.size()].scenario; }
void list_and_figures(Store& s, const ManySessions& m, const HistoryFilter& f) {
  must(s.history.page(m.admin.actor(), f, {}, kPage));
  figures_of(s, m.admin.actor(), f);
}

std::vector<Screen> exercise_screens() {
  return {
      {"exercise, list", [](Store& s, const ManySessions& m, std::size_t i) {
         must(s.history.page(m.admin.actor(), {.scenario = exercise_of(m, i), .passed = i % 2 == 0}, {}, kPage));
       }},
      {"exercise, figures", [](Store& s, const ManySessions& m, std::size_t i) {
         figures_of(s, m.admin.actor(), {.scenario = exercise_of(m, i)});
       }},
      {"exercise, by criterion", [](Store& s, const ManySessions& m, std::size_t i) {
         must(s.history.by_criterion(m.admin.actor(), {.scenario = exercise_of(m, i)}));
       }},
      {"exercise, a rare version", [](Store& s, const ManySessions& m, std::size_t i) {
         list_and_figures(s, m, {.scenario = exercise_of(m, i), .version_number = 7});
       }},
      {"students, last 30 days", [](Store& s, const ManySessions& m, std::size_t) {
         list_and_figures(s, m, {.drilled_by = DrilledBy::students, .from_utc_us = kNow - 30ll * 86'400 * 1'000'000});
       }},
      {"staff", [](Store& s, const ManySessions& m, std::size_t) { list_and_figures(s, m, {.drilled_by = DrilledBy::staff}); }},
      {"assessments", [](Store& s, const ManySessions& m, std::size_t) { list_and_figures(s, m, {.kind = SessionKind::assessment}); }},
  };
}

std::vector<Screen> staff_screens() {
  return {
      {"cohort", [](Store& s, const ManySessions& m, std::size_t i) {
         list_and_figures(s, m, {.cohort = m.cohorts[i % m.cohorts.size()]});
       }},
      {"cohort, one exercise", [](Store& s, const ManySessions& m, std::size_t i) {
         list_and_figures(s, m, {.scenario = exercise_of(m, i), .cohort = m.cohorts[i % m.cohorts.size()]});
       }},
      {"all, list", [](Store& s, const ManySessions& m, std::size_t) {
         must(s.history.scenarios(m.admin.actor()));
         must(s.history.device_classes(m.admin.actor()));
         must(s.history.page(m.admin.actor(), {}, {}, kPage));
       }},
      {"last 30 days, figures", [](Store& s, const ManySessions& m, std::size_t) {
         figures_of(s, m.admin.actor(), {.from_utc_us = kNow - 30ll * 86'400 * 1'000'000});
       }},
      {"all, figures", [](Store& s, const ManySessions& m, std::size_t) { figures_of(s, m.admin.actor()); }},
      {"cohort page", [](Store& s, const ManySessions& m, std::size_t i) {
         const CohortId cohort = m.cohorts[i % m.cohorts.size()];
         must(s.cohorts.list());
         must(s.cohorts.students(cohort));
         must(s.cohorts.find_name("Group 1"));
         must(s.accounts.list(m.admin.actor()));
         must(s.assignments.for_cohort(cohort));
       }},
      {"export of an assessment", [](Store& s, const ManySessions& m, std::size_t) {
         must(export_rows(s.context(), m.admin.actor(), {.scenario = m.versions[0].scenario, .cohort = m.cohorts[0], .limit = kPage},
                          [](std::span<const ExportRow>, std::size_t) -> Stored<bool> { return true; }));
         HistoryRow candidate;  // few sessions are without an assessment: its query runs all the same
         candidate.assignment = m.assessment;
         must(dates_of(s.database(), {candidate}));
       }},
      {"assessment of a hundred", [](Store& s, const ManySessions& m, std::size_t) {
         for (const HistoryRow& attempt : must(s.history.of_assignment(m.admin.actor(), m.assessment))) {
           must(s.assignments.adjustment(m.assessment, attempt.student));
           must(s.history.details(m.admin.actor(), attempt.session));
           must(s.accounts.find(attempt.student));
         }
         must(s.assignments.attempts(m.assessment, m.students[0].id));
         must(s.statements.of(m.admin.actor(), m.first));
         must(s.history.details(m.admin.actor(), m.first));
       }},
      {"audit log", [](Store& s, const ManySessions& m, std::size_t i) {
         must(s.audit.list(m.admin.actor(), kPage));
         must(s.audit.list(m.admin.actor(), kPage, INT64_MAX, {.person = student_of(m, i).id}));
       }},
      {"search, one student", [](Store& s, const ManySessions& m, std::size_t i) {
         list_and_figures(s, m, {.search = student_of(m, i).number});
       }},
      {"search, many students", [](Store& s, const ManySessions& m, std::size_t i) {
         list_and_figures(s, m, {.search = "student " + std::to_string(1 + i % 9)});
       }},
  };
}

std::vector<Screen> screens() {
  std::vector<Screen> out = student_screens();
  std::ranges::move(exercise_screens(), std::back_inserter(out));
  std::ranges::move(staff_screens(), std::back_inserter(out));
  return out;
}

/// `people` has a few thousand rows at most, which a part of a name must search; `cohorts` and `codes`, the kinds of entries in
/// the audit log, have some dozens; `station` has one.
bool is_small(const std::string& line) {
  return line == "SCAN people" || line == "SCAN station" || line == "SCAN codes" || line.starts_with("SCAN cohorts ");
}

TEST(Pages, no_statement_of_a_screen_and_of_opening_scans_a_table) {
  const Folder folder;
  ManySessions m;
  {
    const auto store = open(folder / "a.db");
    m = write_many(*store, 4000);
  }
  const StatementsSeen seen;
  const auto store = open(folder / "a.db");
  for (const Screen& screen : screens()) screen.read(*store, m, 1);
  for (const HistoryFilter& f : every_filter(m)) {
    must(store->history.page(m.admin.actor(), f, {}, kPage));
    figures_of(*store, m.admin.actor(), f);
  }
  int statements = 0;
  for (const std::string& sql : StatementsSeen::texts()) {
    if (sql.find(" FROM ") == std::string::npos && !sql.starts_with("UPDATE")) continue;
    if (sql.find("sqlite_schema") != std::string::npos) continue;
    ++statements;
    for (const std::string& line : plan_of(store->database(), sql)) {
      EXPECT_TRUE(!line.starts_with("SCAN") || line == "SCAN CONSTANT ROW" || is_small(line)) << line << "\n" << sql;
      const bool sorts = line.find("TEMP B-TREE FOR ORDER BY") != std::string::npos;
      EXPECT_FALSE(sorts && sql.find("LIMIT ?11") != std::string::npos) << line << "\n" << sql;
      EXPECT_EQ(line.find("AUTOMATIC"), std::string::npos) << line << "\n" << sql;
    }
  }
  EXPECT_GT(statements, 60);
  // And the test can fail.
  EXPECT_EQ(plan_of(store->database(), "SELECT count(*) FROM grades WHERE score > 1").front().substr(0, 4), "SCAN");
}

double ms_of(const std::function<void()>& work) {
  const auto before = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
}

void print_times(const char* name, std::size_t reads, const std::function<void(std::size_t i)>& act) {
  std::vector<double> times;
  for (std::size_t i = 0; i < reads; ++i) times.push_back(ms_of([&] { act(i); }));
  std::ranges::sort(times);
  std::printf("%-24s p50 %8.1f  p95 %8.1f  most %8.1f ms\n", name, times[reads / 2], times[reads * 19 / 20 - 1], times.back());
}

/// Bytes a session of each table and index that has at least five, of whole pages.
void print_bytes(Database& db, int sessions) {
  const auto parts = must(db.all("SELECT name, pgsize FROM dbstat WHERE aggregate = 1 ORDER BY pgsize DESC",
                                 [](Row row) { return std::pair{row.text(0), row.real(1)}; }));
  double all = 0;
  for (const auto& [name, bytes] : parts) {
    all += bytes / sessions;
    if (bytes >= 5.0 * sessions) std::printf("%-36s %8.1f\n", name.c_str(), bytes / sessions);
  }
  std::printf("%-36s %8.1f bytes a session\n", "all", all);
}

TEST(Pages, among_many_sessions_are_read_by_screen) {
  const char* wanted = std::getenv("CUSP_SESSIONS");
  const int sessions = wanted ? std::atoi(wanted) : 50'000;
  const Folder folder;
  ManySessions m;
  const double writing = ms_of([&] {
    const auto store = open(folder / "a.db");
    m = write_many(*store, sessions, wanted ? CopiedRows::all : CopiedRows::of_pages);
  });
  std::printf("%d sessions written in %.1f s\n", sessions, writing * 1e-3);
  std::unique_ptr<Store> store;
  std::printf("%-24s %8.1f ms\n", "Store::open", ms_of([&] { store = open(folder / "a.db"); }));
  ASSERT_EQ(figures_of(*store, m.admin.actor()).attempts, m.graded);
  const std::size_t reads = wanted ? 40 : 20;
  for (const Screen& screen : screens()) {
    print_times(screen.name, reads, [&](std::size_t i) { screen.read(*store, m, i); });
  }
  print_times("saving a grade", reads, [&](std::size_t i) { must(store->grades.save(m.templates[i % m.templates.size()], grade_of_ten(60), {})); });
  if (wanted) print_bytes(store->database(), sessions);
}

}  // namespace
}  // namespace cusp::test
