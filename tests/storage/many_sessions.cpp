#include "tests/storage/many_sessions.h"

#include <array>
#include <cmath>
#include <map>

#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/session_summary.h"
#include "storage/records/session_tables.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kThreeYears = 3ll * 365 * 86'400 * 1'000'000;
constexpr int kWithAssessment = 10'000;  // sessions
constexpr const char* kStartCode = "4711";
constexpr int kAtOnce = 20'000;  // copies in one transaction

void step_once(Statement& statement) { must(statement.step()); }

const char* class_of(int i) noexcept { return i % 10 < 7 ? "pointer" : "falcon"; }
std::int64_t start_of(std::int64_t i, std::int64_t of) noexcept { return kNow - kThreeYears + kThreeYears / of * i; }

/// In one transaction: two of the product's calls a student would take seconds.
void write_people(Store& store, ManySessions& m) {
  for (int i = 0; i < ManySessions::kCohorts; ++i) {
    m.cohorts.push_back(must(store.cohorts.create(m.admin.actor(), "Group " + std::to_string(i))).id);
  }
  Transaction transaction(store.database());
  AuditWriter log(store.context(), transaction);
  const auto seal_of = [&](UserId id) {
    return transaction.first(kSelectSealedAccounts + std::string("WHERE id = ?1"), [](Row row) { return text_of(account_seal(row)); }, id).value();
  };
  for (int i = 0; i < ManySessions::kStudents; ++i) {
    const Account a{.id = UserId::make(), .number = std::to_string(20260000 + i), .name = "Student " + std::to_string(i)};
    const CohortId cohort = m.cohorts[static_cast<std::size_t>(i % ManySessions::kCohorts)];
    transaction.run("INSERT INTO people (id, number, name, role, created_at) VALUES (?1, ?2, ?3, 'student', ?4)", a.id, a.number,
                    a.name, kNow);
    log.add({.actor = m.admin.id, .action = "account_created", .subject = a.id.uuid, .detail = seal_of(a.id)});
    transaction.run("INSERT INTO cohort_students VALUES (?1, ?2)", cohort, a.id);
    log.add({.actor = m.admin.id, .action = "cohort_joined", .subject = a.id.uuid, .detail = cohort.text()});
    m.students.push_back(a);
  }
  log.finish();
  must(commit_sealed(store.context(), transaction));
}

void write_versions(Store& store, ManySessions& m, const std::vector<PublishedExercise>& exercises) {
  for (const PublishedExercise& one : exercises) m.versions.push_back(must(store.scenarios.ensure(one.scenario, one.json, one.content_hash)));
  for (int i = static_cast<int>(exercises.size()); i < ManySessions::kExercises; ++i) {
    Scenario scenario = small_scenario();
    scenario.id = ScenarioId::make();
    scenario.key.clear();
    scenario.title = {{"en", "Exercise " + std::to_string(i)}};
    m.versions.push_back(keep(store, scenario, "{\"id\":" + std::to_string(i) + "}"));
  }
}

/// Returns the number of candidates.
int write_assessment(Store& store, ManySessions& m) {
  m.assessment = must(store.assignments.create(
      make_instructor(store).actor(), {.version = m.versions[0].id, .cohort = m.cohorts[0], .kind = SessionKind::assessment}, kStartCode)).id;
  int candidates = 0;
  for (std::size_t i = 0; i < m.students.size(); i += ManySessions::kCohorts, ++candidates) {
    const double score = 60 + static_cast<double>(candidates) * 0.3;
    drill(store, {.student = m.students[i], .version = m.versions[0], .score = score, .assignment = m.assessment});
  }
  return candidates;
}

/// One entry of a chain, without its hashes.
struct Entry {
  SessionTable table;
  std::uint64_t row;
  std::int64_t second;
};

/// Copies sessions with prepared statements: of the product's calls each prepares its own.
class Copier {
 public:
  Copier(Store& store, const ManySessions& m, int of, CopiedRows rows) : c_{store.context()}, m_{m}, of_{of}, rows_{rows} {
    for (const SessionId id : m.templates) {
      chains_.push_back(must(c_.db.all("SELECT table_number, row, second FROM session_chain WHERE session = ?1 ORDER BY position",
                                       [](Row row) { return Entry{static_cast<SessionTable>(row.integer(0)), row.u64(1), row.integer(2)}; },
                                       id)));
    }
    for (std::size_t i = 0; i < chains_[0].size(); ++i) {
      if (chains_[0][i].table == SessionTable::session_events) sealed_after_.push_back(i + 1);
    }
    for (const ScenarioVersion& version : m.versions) {
      hashes_.push_back(*must(c_.db.first("SELECT content_hash, json FROM scenario_versions WHERE id = ?1",
                                          [](Row row) { return std::pair{row.hash(0), blake2b_256(row.bytes(1))}; }, version.id)));
    }
    for (const SessionTable table : kSessionTables) read_.emplace(table, c_.db.prepare(select_row(table)));
    log_ = *must(c_.db.first("SELECT entries, link FROM audit_head", [](Row row) { return ChainHead{row.u64(0), row.hash(1)}; }));
    sequence_ = *must(c_.db.first("SELECT next_sequence FROM station", [](Row row) { return row.integer(0); }));
  }

  SessionId copy(int i) {
    const SessionId id = SessionId::make();
    const auto number = static_cast<std::size_t>(i % ManySessions::kTemplates);
    const SessionId from = m_.templates[number];
    const Drilled drilled = as_copy(m_, i);
    const std::int64_t at = start_of(i, of_);
    const auto& [content, json] = hashes_[static_cast<std::size_t>(&drilled.version - m_.versions.data())];
    session_.bind(id, from, drilled.student.id, drilled.version.id, content, json, at, sequence_);
    step_once(session_);
    event_.bind(id, from, at, sequence_, is_graded(i) ? 3 : 2);
    step_once(event_);
    for (Statement* plain : {&chunk_, &metric_, &removed_, &volume_}) step_once(plain->bind(id, from));
    if (is_graded(i)) {
      step_once(grade_.bind(id, from, at, sequence_ + 5, drilled.score));
      step_once(criteria_.bind(id, from));
    }
    if (rows_ == CopiedRows::all) link(id, drilled.student.id, at, chains_[number], is_graded(i) ? 3 : 2);
    sequence_ += is_graded(i) ? 8 : 5;
    return id;
  }

  /// Signs the head of the audit log, and counts on.
  void finish() {
    must(c_.db.run("UPDATE audit_head SET entries = ?1, link = ?2, key = ?3, signature = ?4", log_.links, log_.link, c_.key->id(),
                   c_.key->sign_head(c_.station, log_)));
    must(c_.db.run("UPDATE station SET next_sequence = ?1", sequence_));
  }

 private:
  /// The session's chain and head, with a seal after each of the first `events` events.
  void link(SessionId id, UserId student, std::int64_t at, const std::vector<Entry>& chain, std::size_t events) {
    constexpr std::array<const char*, 3> kEvents = {"started ", "finished ", "graded "};
    constexpr std::array<std::int64_t, 3> kSequences = {2, 4, 7};
    ChainHead head{0, chain_start(id.uuid)};
    for (std::size_t seal = 0; seal < events; ++seal) {
      for (; head.links < sealed_after_[seal]; ++head.links) {
        const Entry& entry = chain[head.links];
        Statement& read = read_.at(entry.table);
        step_once(read.bind(id, entry.row));
        const ChainLink next{head.links, static_cast<std::uint64_t>(entry.table), entry.row, entry.second, read.row().content_hash()};
        head.link = chain_link(head.link, id.uuid, next);
        read.reset();  // an open read would keep the log from being copied into the file
        step_once(chain_link_.bind(id, next.position, next.table, next.row, next.second, next.content, head.link));
      }
      log(seal == 0 ? student : UserId{}, id, at, sequence_ + kSequences[seal],
          kEvents[seal] + std::to_string(head.links) + ' ' + hex(head.link));
    }
    step_once(head_.bind(id, head.links, head.link, c_.key->id(), c_.key->sign_head(id.uuid, head)));
  }

  void log(UserId actor, SessionId session, std::int64_t at, std::int64_t sequence, const std::string& detail) {
    step_once(seal_.bind(log_.links, at, sequence, actor, session, detail));
    step_once(sealed_.bind(log_.links));
    log_.link = chain_link(log_.link, c_.station, {log_.links, 0, log_.links, -1, sealed_.row().content_hash()});
    sealed_.reset();
    step_once(seal_link_.bind(log_.links, log_.link));
    ++log_.links;
  }

  StorageContext& c_;
  const ManySessions& m_;
  int of_;
  CopiedRows rows_;
  std::vector<std::vector<Entry>> chains_;  // of each template
  std::vector<std::size_t> sealed_after_;  // links of the chain when an event was sealed
  std::vector<std::pair<Hash256, Hash256>> hashes_;  // of each version: content, JSON
  std::map<SessionTable, Statement> read_;
  ChainHead log_;
  std::int64_t sequence_ = 0;
  Statement session_ = c_.db.prepare(
      "INSERT INTO sessions SELECT ?1, station, ?3, ?4, ?5, ?6, kind, assignment, hand, device, device_class, engine_version, "
      "specimen_blob, header, ?7, ?8 FROM sessions WHERE id = ?2");
  Statement event_ = c_.db.prepare(
      "INSERT INTO session_events SELECT ?1, row, kind, ?3, ?4 + CASE row WHEN 0 THEN 1 WHEN 1 THEN 3 ELSE 6 END, tick, reason, process "
      "FROM session_events WHERE session = ?2 AND row < ?5");
  Statement chunk_ = c_.db.prepare(
      "INSERT INTO trace_chunks SELECT ?1, row, first_tick, inputs, elapsed_us, state_hash, trace FROM trace_chunks WHERE session = ?2");
  Statement metric_ = c_.db.prepare(
      "INSERT INTO metrics SELECT ?1, row, elapsed_us, force_peak_n, force_mean_n, contact_ticks, cutting_ticks FROM metrics "
      "WHERE session = ?2");
  Statement removed_ =
      c_.db.prepare("INSERT INTO removed_tissues SELECT ?1, row, chunk, tissue, voxels, mm3 FROM removed_tissues WHERE session = ?2");
  Statement volume_ = c_.db.prepare("INSERT INTO final_volumes SELECT ?1, row, tick, volume_hash, cuts FROM final_volumes WHERE session = ?2");
  Statement grade_ = c_.db.prepare(
      "INSERT INTO grades SELECT ?1, row, ?3, ?4, grader, ?5, score_max, pass_mark, ?5 >= pass_mark, critical, rubric_hash, evaluator, "
      "engine_version, device_class, calibration FROM grades WHERE session = ?2");
  Statement criteria_ = c_.db.prepare("INSERT INTO graded_criteria SELECT ?1, row, packed FROM graded_criteria WHERE session = ?2");
  Statement chain_link_ = c_.db.prepare("INSERT INTO session_chain VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)");
  Statement head_ = c_.db.prepare("INSERT INTO session_heads VALUES (?1, ?2, ?3, ?4, ?5)");
  Statement seal_ = c_.db.prepare("INSERT INTO audit_log VALUES (?1, ?2, ?3, ?4, 'session_sealed', ?5, ?6, zeroblob(32))");
  Statement sealed_ = c_.db.prepare("SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number = ?1");
  Statement seal_link_ = c_.db.prepare("UPDATE audit_log SET link = ?2 WHERE number = ?1");
};

void write_copies(Store& store, ManySessions& m, int sessions, CopiedRows rows) {
  Database& db = store.database();
  Copier copier(store, m, sessions, rows);
  for (int i = 0; i < sessions; ++i) {
    if (i % kAtOnce == 0) must(db.run("BEGIN"));
    m.copies.push_back(copier.copy(i));
    m.graded += is_graded(i) ? 1 : 0;
    if (i + 1 < sessions && (i + 1) % kAtOnce != 0) continue;
    copier.finish();
    must(db.run("COMMIT"));
  }
  m.listed += sessions;
}

}  // namespace

Grade grade_of_ten(double score) {
  Grade grade = small_grade(score, score >= 70);
  grade.critical.clear();
  for (int i = 2; i < 10; ++i) {
    CriterionGrade c = grade.criteria[1];
    c.id = c.measure.metric = c.id + '_' + std::to_string(i);
    // Figures of full length, as measures have: JSON of short ones would pack too well.
    const double own = i;
    c.measure.value = 2 + std::sin(own);
    c.measure.uncertainty = 0.05 + 0.01 * std::cos(own);
    c.measure.where_mm = Vec3(std::sin(own + 1), std::sin(own + 2), std::sin(own + 3));
    c.points = 5 + 4 * std::sin(own + 4);
    c.reason_args = {{"limit", 2.0}, {"lost", 10 - c.points}, {"value", c.measure.value}};
    grade.criteria.push_back(c);
  }
  return grade;
}

Drilled as_copy(const ManySessions& m, int i) {
  const auto number = static_cast<std::int64_t>(i);
  const auto student = static_cast<std::size_t>(number * 7919 % ManySessions::kStudents);
  const auto exercise = static_cast<std::size_t>((number / ManySessions::kStudents + number * 5) % ManySessions::kExercises);
  return {m.students[student], m.versions[exercise], class_of(i),
          83'334u + 10'000u * static_cast<std::uint32_t>(i % ManySessions::kTemplates), 1,
          30 + static_cast<double>(number * 37 % 700) * 0.1};
}

SessionId drill(Store& store, const Drilled& d) {
  NewSession wanted = new_session(d.student, d.version);
  wanted.header.device.device_class = d.device_class;
  wanted.assignment = d.assignment;
  if (d.assignment) wanted.start_code = kStartCode;
  const SessionId id = must(store.sessions.start(d.student.actor(), wanted)).id;
  std::uint64_t tick = 0;
  for (int second = 0; second < d.seconds; ++second, tick += 12) {
    RecordedSecond recorded = second_from(tick + 1);
    for (StepInput& input : recorded.inputs) input.elapsed_us = d.input_us;
    must(store.traces.append(id, recorded));
  }
  must(store.sessions.finish(id, volume_after(tick), "student"));
  must(store.grades.save(id, grade_of_ten(d.score), blake2b_256(std::string_view{"rubric"})));
  return id;
}

ManySessions write_many(Store& store, int sessions, CopiedRows rows, const std::vector<PublishedExercise>& exercises) {
  ManySessions m;
  m.admin = make_administrator(store);
  Database& db = store.database();
  must(db.run("PRAGMA synchronous = OFF"));
  must(db.run("PRAGMA cache_size = -1000000"));  // 1 GB
  must(db.run("PRAGMA temp_store = MEMORY"));
  write_people(store, m);
  write_versions(store, m, exercises);
  for (int i = 0; i < ManySessions::kTemplates; ++i) m.templates.push_back(drill(store, as_copy(m, i)));
  m.first = m.templates.front();
  for (int i = 0; i < sessions / 1000; ++i) {
    Drilled traced = as_copy(m, i);
    traced.seconds = ManySessions::kSecondsOfTraced;
    drill(store, traced);
  }
  m.listed = m.graded = ManySessions::kTemplates + sessions / 1000;
  if (sessions >= kWithAssessment) m.graded = m.listed += write_assessment(store, m);
  must(db.run("PRAGMA foreign_keys = OFF"));
  write_copies(store, m, sessions, rows);
  must(rebuild_summaries(store.context(), m.admin.actor()));
  return m;
}

}  // namespace cusp::test
