#include "scenarios/audit/audit_json.h"

#include <nlohmann/json.hpp>

#include "engine/scene/scene.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Choice& choice) {
  Json out;
  out["aspect"] = key_of(choice.aspect);
  if (!choice.subject.empty()) out["subject"] = choice.subject;
  out["as_set"] = choice.as_set;
  out["instead"] = choice.instead;
  return out;
}

Json json_of(const ModelCost& cost) {
  Json out;
  out["us_a_tick"] = cost.us_a_tick;
  out["us_more"] = cost.us_more;
  out["instructions_a_tick"] = cost.instructions_a_tick ? Json(*cost.instructions_a_tick) : Json();
  out["start_s"] = cost.start_s;
  out["mb"] = static_cast<double>(cost.bytes) / 1e6;
  return out;
}

Json json_of(const GradeChange& change, double tolerance) {
  Json out;
  out["within_tolerance"] = change.within(tolerance);
  out["score"] = change.score;
  out["goes_a_hand"] = change.attempts_per_operator;
  out["standard_error"] = change.standard_error;
  out["passes_alike"] = change.passes_alike;
  out["measures_alike"] = change.measures_alike;
  Json criteria = Json::object();
  for (const auto& [metric, points] : change.points) {
    criteria[metric]["points"] = points;
    const auto value = change.values.find(metric);
    criteria[metric]["value"] = value == change.values.end() ? Json() : Json(value->second);
  }
  out["criteria"] = std::move(criteria);
  return out;
}

Json json_of(const std::vector<ModelAttempt>& list) {
  Json attempts = Json::array();
  for (const ModelAttempt& attempt : list) {
    Json one;
    one["hand"] = attempt.by.name;
    one["seed"] = attempt.by.seed;
    one["score"] = attempt.grade.score;
    one["passed"] = attempt.grade.passed;
    one["critical"] = attempt.grade.critical;
    one["seconds"] = attempt.seconds;
    one["lost_ticks"] = attempt.lost;
    attempts.push_back(std::move(one));
  }
  return attempts;
}

Json json_of(const ModelResult& result) {
  Json out;
  out["cost"] = json_of(result.cost);
  out["force_rms_n"] = result.force_rms_n;
  out["force_most_n"] = result.force_most_n;
  out["goes"] = json_of(result.attempts);
  return out;
}

}  // namespace

std::string audit_json(const AuditReport& report) {
  const double tolerance = report.tolerance_points;
  Json out;
  out["scenario"] = {{"id", report.scenario.id.text()}, {"version", report.scenario.version}, {"key", report.scenario.key},
                     {"voxel_mm", report.scenario.specimen.voxel_mm}};
  out["engine_version"] = kEngineVersion;
  out["tolerance_points"] = tolerance;
  out["as_set"] = json_of(report.as_set);
  Json rows = Json::array();
  for (const AuditRow& row : report.rows) {
    Json one;
    one["choice"] = json_of(row.choice);
    one["verdict"] = key_of(row.verdict);
    if (row.result) {
      one["change"] = json_of(row.change, tolerance);
      one["result"] = json_of(*row.result);
    }
    rows.push_back(std::move(one));
  }
  out["choices"] = std::move(rows);
  Json steps = Json::array();
  for (const AuditStep& step : report.steps) {
    Json one;
    one["choice"] = json_of(step.choice);
    one["taken"] = step.taken;
    one["change"] = json_of(step.change, tolerance);
    steps.push_back(std::move(one));
  }
  Json leanest;
  leanest["search"] = "greedy";
  leanest["changed"] = report.changed();
  leanest["voxel_mm"] = report.leanest.specimen.voxel_mm;
  leanest["around"] = report.leanest.specimen.around;
  leanest["phenomena"] = report.leanest.phenomena;
  leanest["steps"] = std::move(steps);
  if (report.leanest_result) {
    leanest["change"] = json_of(report.leanest_change, tolerance);
    leanest["result"] = json_of(*report.leanest_result);
    leanest["own_goes"] = json_of(report.leanest_attempts);
  }
  leanest["at_half_voxel"] = report.at_half_voxel ? json_of(*report.at_half_voxel, tolerance) : Json();
  leanest["detail_holds"] = report.detail_holds();
  out["leanest"] = std::move(leanest);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cusp::scenarios
