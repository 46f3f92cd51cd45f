#include "storage/records/grade_rows.h"

#include <nlohmann/json.hpp>

#include "scenarios/format/keys.h"

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

Stored<std::vector<StoredGrade>> grades_of(Database& db, SessionId session) {
  auto grades = db.all(
      "SELECT row, at, grader, score, score_max, pass_mark, passed, critical, rubric_hash, evaluator, engine_version "
      "FROM grades WHERE session = ?1 ORDER BY row",
      grade_of, session);
  if (!grades) return grades;
  const auto criteria = db.all(
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

}  // namespace cusp::storage
