#include "storage/records/grade_rows.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "scenarios/format/keys.h"
#include "storage/records/trace_codec.h"

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

std::map<std::string, double> numbers_of(const json& in) {
  std::map<std::string, double> out;
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
  c.reason_args = numbers_of(json::parse(row.text(14), nullptr, false));
  return c;
}

double number_or_nan(const json& value) { return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(); }

/// Places in the array of a criterion.
enum Cell : std::size_t { kId, kMetric, kMeasured, kValue, kUncertainty, kUnit, kWhereMm, kBand, kPoints, kPointsMax, kReason, kArgs };

/// An array: it packs smaller and reads faster than an object with names.
json json_of(const CriterionGrade& c) {
  const Measure& m = c.measure;
  const json where_mm = m.where_mm ? json{m.where_mm->x, m.where_mm->y, m.where_mm->z} : json();
  return json::array({c.id, m.metric == c.id ? "" : m.metric, m.measured, m.value, m.uncertainty, m.unit, where_mm, c.band, c.points,
                      c.points_max, c.reason_code, c.reason_args});
}

/// Throws where the JSON is of another form. Its names are today's from here on.
CriterionGrade criterion_of(const json& in) {
  CriterionGrade c;
  const auto& id = in.at(kId).get_ref<const std::string&>();
  const auto& metric = in.at(kMetric).get_ref<const std::string&>();
  c.id = scenarios::present_metric(id);
  c.measure.metric = scenarios::present_metric(metric.empty() ? id : metric);
  c.measure.measured = in.at(kMeasured).get<bool>();
  c.measure.value = number_or_nan(in.at(kValue));
  c.measure.uncertainty = number_or_nan(in.at(kUncertainty));
  c.measure.unit = in.at(kUnit).get<std::string>();
  if (const json& at = in.at(kWhereMm); !at.is_null()) c.measure.where_mm = Vec3(at.at(0), at.at(1), at.at(2));
  c.band = in.at(kBand).get<std::string>();
  c.points = number_or_nan(in.at(kPoints));
  c.points_max = number_or_nan(in.at(kPointsMax));
  c.reason_code = in.at(kReason).get<std::string>();
  c.reason_args = numbers_of(in.at(kArgs));
  return c;
}

}  // namespace

std::vector<std::byte> packed_criteria(const std::vector<CriterionGrade>& criteria) {
  json all = json::array();
  for (const CriterionGrade& c : criteria) all.push_back(json_of(c));
  const std::string text = all.dump(-1, ' ', false, json::error_handler_t::replace);
  return pack(std::as_bytes(std::span(text)));
}

Stored<std::vector<CriterionGrade>> criteria_from(std::span<const std::byte> packed) {
  const auto bytes = unpack(packed);
  if (!bytes) return std::unexpected(bytes.error());
  try {
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    std::vector<CriterionGrade> out;
    for (const json& one : json::parse(text, text + bytes->size())) out.push_back(criterion_of(one));
    return out;
  } catch (const json::exception&) {
    return fail(StorageError::bad_trace, "graded_criteria");
  }
}

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
  const auto packed = db.all("SELECT row, packed FROM graded_criteria WHERE session = ?1",
                             [](Row row) { return std::pair{static_cast<int>(row.integer(0)), criteria_from(row.bytes(1))}; }, session);
  if (!packed) return std::unexpected(packed.error());
  for (StoredGrade& grade : *grades) {
    for (const auto& [number, of_grade] : *packed) {
      // What cannot be read is damage: the verifier reports it, and the grade stands without its criteria.
      if (number == grade.number && of_grade) grade.grade.criteria = *of_grade;
    }
  }
  return grades;
}

}  // namespace cusp::storage
