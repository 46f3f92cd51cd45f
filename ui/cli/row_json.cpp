#include "ui/cli/row_json.h"

#include <nlohmann/json.hpp>

#include "storage/base/clock.h"

namespace cusp::ui {
namespace {

nlohmann::ordered_json time_json(const std::optional<std::int64_t>& utc_us) {
  return utc_us ? nlohmann::ordered_json(iso_utc(*utc_us)) : nullptr;
}

}  // namespace

nlohmann::ordered_json row_json(const HistoryRow& row) {
  nlohmann::ordered_json json;
  json["session"] = row.session.text();
  json["student"] = row.student_number;
  json["scenario"] = row.scenario.text();
  json["scenario_key"] = row.scenario_key;
  json["version"] = row.version_number;
  json["kind"] = std::string(key_of(row.kind));
  json["hand"] = row.operator_name == kUserOperator ? std::string() : row.operator_name;
  json["device"] = row.device;
  json["device_class"] = row.device_class;
  json["started"] = iso_utc(row.started_utc_us);
  json["duration_s"] = static_cast<double>(row.elapsed_us) / 1e6;
  json["state"] = std::string(key_of(row.state));
  json["go"] = row.attempt;
  json["score"] = row.score ? nlohmann::ordered_json(*row.score) : nullptr;
  json["score_max"] = row.score_max ? nlohmann::ordered_json(*row.score_max) : nullptr;
  json["pass_mark"] = row.pass_mark ? nlohmann::ordered_json(*row.pass_mark) : nullptr;
  json["passed"] = row.passed ? nlohmann::ordered_json(*row.passed) : nullptr;
  json["critical"] = row.critical;
  json["assignment"] = row.assignment ? nlohmann::ordered_json(row.assignment->text()) : nullptr;
  json["released"] = row.released;
  return json;
}

nlohmann::ordered_json row_json(const ExportRow& row) {
  nlohmann::ordered_json json = row_json(row.attempt);
  json["student_name"] = row.attempt.student_name;
  json["finished"] = time_json(row.dates.finished_utc_us);
  json["cohort"] = row.attempt.assignment ? nlohmann::ordered_json(row.dates.cohort) : nullptr;
  json["opens"] = time_json(row.dates.opens_utc_us);
  json["due"] = time_json(row.dates.due_utc_us);
  return json;
}

}  // namespace cusp::ui
