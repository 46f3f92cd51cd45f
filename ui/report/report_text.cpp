#include "ui/report/report_text.h"

#include <cstdio>

#include "ui/report/report_data.h"
#include "ui/text/grade_text.h"
#include "ui/text/plain.h"

namespace cusp::ui {
namespace {

std::string hex(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

}  // namespace

ReportTexts report_texts(const SessionResult& result) {
  ReportTexts out;
  out.label = [&result](const CriterionGrade& c) {
    return plain(metric_name(c.id, &result.scenario.target, tissue_names_of(result)));
  };
  out.reason = [](const CriterionGrade& c) { return plain(reason_text(c)); };
  return out;
}

std::string report_text(const SessionResult& result, Store& store, const Account& student) {
  ReportHead head;
  head.session = result.session.text();
  head.scenario_id = result.scenario.id.text();
  head.scenario_version = result.scenario.version;
  if (const auto session = store.sessions.find(result.session)) {
    head.scenario_hash = storage::hex(session->version_hash);
    if (const auto version = store.scenarios.version(session->version)) head.scenario_version = version->number;
  }
  head.student = student.number;
  head.operator_name = result.operator_name == kUserOperator ? std::string() : result.operator_name;
  head.engine = result.engine_version;
  head.device = result.device.name;
  head.duration_s = result.seconds;
  head.state = result.interrupted ? "interrupted" : "finished";
  head.volume_hash = hex(result.volume_hash);
  return report_json(head, result.grade, report_texts(result));
}

}  // namespace cusp::ui
