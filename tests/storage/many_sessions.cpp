#include "tests/storage/many_sessions.h"

#include "storage/records/session_summary.h"
#include "storage/repositories/session_header.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kThreeYears = 3ll * 365 * 86'400 * 1'000'000;

void step_once(Statement& statement) { must(statement.step()); }

void write_people(Store& store, ManySessions& m) {
  Database& db = store.database();
  for (int i = 0; i < ManySessions::kCohorts; ++i) {
    m.cohorts.push_back(must(store.cohorts.create(m.admin.actor(), "Group " + std::to_string(i))).id);
  }
  must(db.run("BEGIN"));
  for (int i = 0; i < ManySessions::kStudents; ++i) {
    const Account a{.id = UserId::make(), .number = std::to_string(20260000 + i), .name = "Student " + std::to_string(i)};
    must(db.run("INSERT INTO people (id, number, name, role, created_at) VALUES (?1, ?2, ?3, 'student', ?4)", a.id,
                a.number, a.name, kNow));
    const CohortId cohort = m.cohorts[static_cast<std::size_t>(i % ManySessions::kCohorts)];
    must(db.run("INSERT INTO cohort_students VALUES (?1, ?2)", cohort, a.id));
    m.students.push_back(a);
  }
  must(db.run("COMMIT"));
}

void write_versions(Store& store, ManySessions& m) {
  for (int i = 0; i < ManySessions::kExercises; ++i) {
    Scenario scenario = small_scenario();
    scenario.id = ScenarioId::make();
    scenario.key.clear();
    scenario.title = {{"en", "Exercise " + std::to_string(i)}};
    m.versions.push_back(keep(store, scenario, "{\"id\":" + std::to_string(i) + "}"));
  }
}

struct Inserts {
  Statement session, event, grade, criterion, head;
  explicit Inserts(Database& db)
      : session{db.prepare("INSERT INTO sessions SELECT ?1, station, ?2, ?3, version_hash, json_hash, 'practice', NULL, hand, "
                           "device, ?4, engine_version, specimen_blob, header, ?5, ?6 FROM sessions WHERE id = ?7")},
        event{db.prepare("INSERT INTO session_events VALUES (?1, ?2, ?3, ?4, ?5, 30, '', '')")},
        grade{db.prepare("INSERT INTO grades SELECT ?1, 0, ?2, ?3, grader, ?4, 100, 70, ?4 >= 70, critical, rubric_hash, "
                         "evaluator, engine_version, ?5, calibration FROM grades WHERE session = ?6")},
        criterion{db.prepare("INSERT INTO criteria SELECT ?1, row, grade, id, metric, measured, value, uncertainty, unit, "
                             "where_x_mm, where_y_mm, where_z_mm, band, points, points_max, reason_code, reason_args "
                             "FROM criteria WHERE session = ?2")},
        head{db.prepare("INSERT INTO session_heads SELECT ?1, links, link, key, signature FROM session_heads WHERE session = ?2")} {}
};

/// Session i of n: the student comes round every two thousand sessions, in another exercise each time.
void write_session(Inserts& insert, const ManySessions& m, std::int64_t i, std::int64_t n) {
  const SessionId id = SessionId::make();
  const auto student = static_cast<std::size_t>(i * 7919 % ManySessions::kStudents);
  const auto exercise = static_cast<std::size_t>((i / ManySessions::kStudents + i * 5) % ManySessions::kExercises);
  const std::int64_t at = kNow - kThreeYears + kThreeYears / n * i, sequence = 100 + 10 * i;
  const char* device_class = i % 10 < 7 ? "pointer" : "falcon";
  insert.session.bind(id, m.students[student].id, m.versions[exercise].id, device_class, at, sequence, m.first);
  step_once(insert.session);
  const bool graded = i % 5 != 4;
  int row = 0;
  for (const char* kind : {"started", "finished", "graded"}) {
    if (row == 2 && !graded) break;
    insert.event.bind(id, row, kind, at, sequence + 1 + row);
    step_once(insert.event);
    ++row;
  }
  insert.head.bind(id, m.first);
  step_once(insert.head);
  if (!graded) return;
  insert.grade.bind(id, at, sequence + 5, static_cast<double>(30 + i * 37 % 700 * 0.1), device_class, m.first);
  step_once(insert.grade);
  insert.criterion.bind(id, m.first);
  step_once(insert.criterion);
}

}  // namespace

ManySessions write_many(Store& store, int sessions) {
  ManySessions m;
  m.admin = make_administrator(store);
  write_people(store, m);
  write_versions(store, m);
  Database& db = store.database();
  m.first = must(store.sessions.start(m.students[0].actor(), new_session(m.students[0], m.versions[0]))).id;
  must(store.traces.append(m.first, second_from(1)));
  must(store.sessions.finish(m.first, volume_after(12), "student"));
  must(store.grades.save(m.first, small_grade(), {}));
  must(db.run("PRAGMA foreign_keys = OFF"));
  must(db.run("PRAGMA cache_size = -1000000"));  // 1 GB: a million sessions are written without spilling pages
  must(db.run("PRAGMA synchronous = OFF"));
  must(db.run("PRAGMA temp_store = MEMORY"));
  must(db.run("BEGIN"));
  {
    Inserts insert(db);
    for (int i = 0; i < sessions; ++i) write_session(insert, m, i, sessions);
  }
  must(db.run("COMMIT"));
  must(rebuild_summaries(store.context(), m.admin.actor()));
  return m;
}

}  // namespace cusp::test
