#include "scenarios/grading/report_json.h"

#include <nlohmann/json.hpp>

#include "scenarios/grading/maxima.h"

namespace cusp::scenarios {

std::string report_json(const ReportHead& head, const Grade& grade, const ReportTexts& texts) {
  using Json = nlohmann::ordered_json;
  Json out;
  out["session"] = head.session;
  out["scenario"] = {{"id", head.scenario_id}, {"version", head.scenario_version}, {"hash", head.scenario_hash}};
  out["student"] = head.student;
  out["hand"] = head.operator_name.empty() ? Json() : Json(head.operator_name);
  out["engine"] = head.engine;
  out["device"] = head.device;
  out["duration_s"] = head.duration_s;
  out["state"] = head.state;
  out["score"] = grade.score;
  out["score_max"] = grade.score_max;
  out["passed"] = grade.passed;
  out["critical"] = grade.critical;
  out["volume_hash"] = head.volume_hash;
  Json criteria = Json::array();
  const std::vector<ScaledPoints> scaled = scaled_points(grade);
  for (std::size_t i = 0; i < grade.criteria.size(); ++i) {
    const CriterionGrade& c = grade.criteria[i];
    const Measure& m = c.measure;
    Json one;
    one["id"] = c.id;
    one["label"] = texts.label ? texts.label(c) : c.id;
    one["value"] = m.measured ? Json(m.value) : Json();
    one["unit"] = m.unit;
    one["uncertainty"] = m.measured ? Json(m.uncertainty) : Json();
    one["measured"] = m.measured;
    one["band"] = c.band;
    one["points"] = scaled[i].points;
    one["points_max"] = scaled[i].points_max;
    one["reason_code"] = c.reason_code;
    one["reason"] = texts.reason ? texts.reason(c) : c.reason_code;
    if (m.measured && m.where_mm)
      one["where"] = {{"kind", "point"}, {"mm", {m.where_mm->x, m.where_mm->y, m.where_mm->z}}};
    else
      one["where"] = Json();
    criteria.push_back(std::move(one));
  }
  out["criteria"] = std::move(criteria);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cusp::scenarios
