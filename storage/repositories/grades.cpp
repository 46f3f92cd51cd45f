#include "storage/repositories/grades.h"

#include <nlohmann/json.hpp>

#include "scenarios/format/keys.h"
#include "storage/records/chain_writer.h"
#include "storage/records/session_summary.h"
#include "storage/repositories/session_state.h"
#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

using nlohmann::json;

std::vector<std::string> texts_of(const std::string& text) {
  std::vector<std::string> out;
  const json in = json::parse(text, nullptr, false);
  if (!in.is_array()) return out;
  for (const json& item : in) {
    if (item.is_string()) out.push_back(item.get<std::string>());
  }
  return out;
}

std::map<std::string, double> numbers_of(const std::string& text) {
  std::map<std::string, double> out;
  const json in = json::parse(text, nullptr, false);
  if (!in.is_object()) return out;
  for (const auto& [key, value] : in.items()) {
    if (value.is_number()) out[key] = value.get<double>();
  }
  return out;
}

std::string dump(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

StoredGrade grade_of(Row row) {
  StoredGrade g;
  g.number = static_cast<int>(row.integer(0));
  g.graded_utc_us = row.integer(1);
  g.grader = row.id<UserId>(2);
  g.grade.score = row.real(3);
  g.grade.score_max = row.real(4);
  g.grade.pass_mark = row.real(5);
  g.grade.passed = row.flag(6);
  g.grade.critical = texts_of(row.text(7));
  g.rubric_hash = row.hash(8);
  g.grade.evaluator = row.text(9);
  g.engine_version = static_cast<int>(row.integer(10));
  return g;
}

CriterionGrade criterion_of(Row row) {
  CriterionGrade c;
  // The row stays as it was written; its names are today's from here on.
  c.id = scenarios::present_metric(row.text(1));
  c.measure.metric = scenarios::present_metric(row.text(2));
  c.measure.measured = row.flag(3);
  c.measure.value = row.real(4);
  c.measure.uncertainty = row.real(5);
  c.measure.unit = row.text(6);
  if (!row.is_null(7) && !row.is_null(8) && !row.is_null(9)) {
    c.measure.where_mm = Vec3(row.real(7), row.real(8), row.real(9));
  }
  c.band = row.text(10);
  c.points = row.real(11);
  c.points_max = row.real(12);
  c.reason_code = row.text(13);
  c.reason_args = numbers_of(row.text(14));
  return c;
}

}  // namespace

Stored<StoredGrade> Grades::save(SessionId session, const Grade& grade, const Hash256& rubric_hash,
                                 const std::optional<Actor>& grader) {
  if (grader) {
    if (auto allowed = require(*grader, Action::grade_again); !allowed) return std::unexpected(allowed.error());
  }
  Transaction transaction(c_.db);
  require_state(transaction, session, Need::not_running);
  const TraceEnd end = trace_end(transaction, session);
  const std::uint64_t number = next_row(transaction, SessionTable::grades, session);
  const std::int64_t sequence = c_.next_sequence(transaction);
  ChainWriter chain(c_, transaction, session);
  transaction.run(
      "INSERT INTO grades (session, row, at, sequence, grader, score, score_max, pass_mark, passed, critical, "
      "rubric_hash, evaluator, engine_version, device_class, calibration) "
      "SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, engine_version, device_class, "
      "coalesce(json_extract(header, '$.calibration'), '') FROM sessions WHERE id = ?1",
      session, number, c_.clock(), sequence, grader ? grader->id : UserId{}, grade.score, grade.score_max,
      grade.pass_mark, grade.passed, dump(json(grade.critical)), rubric_hash, grade.evaluator);
  chain.add(SessionTable::grades, number, -1);
  std::uint64_t row = next_row(transaction, SessionTable::criteria, session);
  for (const CriterionGrade& c : grade.criteria) {
    std::optional<double> x, y, z;
    if (c.measure.where_mm) {
      x = c.measure.where_mm->x;
      y = c.measure.where_mm->y;
      z = c.measure.where_mm->z;
    }
    transaction.run(
        "INSERT INTO criteria (session, row, grade, id, metric, measured, value, uncertainty, unit, where_x_mm, "
        "where_y_mm, where_z_mm, band, points, points_max, reason_code, reason_args) "
        "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17)",
        session, row, number, c.id, c.measure.metric, c.measure.measured, c.measure.value, c.measure.uncertainty,
        c.measure.unit, x, y, z, c.band, c.points, c.points_max, c.reason_code, dump(json(c.reason_args)));
    chain.add(SessionTable::criteria, row++, -1);
  }
  chain.add(SessionTable::session_events, insert_event(c_, transaction, session, EventKind::graded, "", end),
            end.second());
  chain.finish();
  follow_event(transaction, session);
  log_session(c_, transaction, grader ? grader->id : UserId{}, session, key_of(EventKind::graded));
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  auto saved = newest(session);
  if (!saved) return std::unexpected(saved.error());
  return std::move(**saved);
}

Stored<std::vector<StoredGrade>> Grades::all(SessionId session) {
  auto grades = c_.db.all(
      "SELECT row, at, grader, score, score_max, pass_mark, passed, critical, rubric_hash, evaluator, engine_version "
      "FROM grades WHERE session = ?1 ORDER BY row",
      grade_of, session);
  if (!grades) return grades;
  const auto criteria = c_.db.all(
      "SELECT grade, id, metric, measured, value, uncertainty, unit, where_x_mm, where_y_mm, where_z_mm, band, points, "
      "points_max, reason_code, reason_args FROM criteria WHERE session = ?1 ORDER BY row",
      [](Row row) {
        return std::pair{static_cast<int>(row.integer(0)), criterion_of(row)};
      },
      session);
  if (!criteria) return std::unexpected(criteria.error());
  for (StoredGrade& grade : *grades) {
    for (const auto& [number, criterion] : *criteria) {
      if (number == grade.number) grade.grade.criteria.push_back(criterion);
    }
  }
  return grades;
}

Stored<std::optional<StoredGrade>> Grades::newest(SessionId session) {
  auto grades = all(session);
  if (!grades) return std::unexpected(grades.error());
  if (grades->empty()) return std::optional<StoredGrade>{};
  return std::move(grades->back());
}

}  // namespace cusp::storage
