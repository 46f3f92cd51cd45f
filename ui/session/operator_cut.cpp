#include "ui/session/operator_cut.h"

#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/operators/fast_cut.h"

namespace cusp::ui {

Result<SessionResult, OperatorCutError> cut_by_operator(const std::string& name, const Scenario& scenario,
                                                        const std::shared_ptr<const Specimen>& specimen, PlanCancel cancel) {
  const auto plan = plan_by_name(name, scenario, *specimen, cancel);
  if (!plan || plan->strokes.empty()) return std::unexpected(OperatorCutError::no_path);
  auto volume = std::make_shared<Volume>(specimen);
  if (!cut_along(*plan, scenario, *volume)) return std::unexpected(OperatorCutError::too_much_cut);
  SessionResult out;
  out.scenario = scenario;
  out.operator_name = name;
  out.volume_hash = volume->hash();
  out.measures = measure(Reference(scenario, specimen), *volume, Process::lasting(0.0, 0.0));
  out.grade = grade(scenario, out.measures);
  out.volume = std::move(volume);
  return out;
}

bool cut_at_once(const SessionResult& result) {
  return result.session.is_nil() && result.seconds == 0 && !result.operator_name.empty() && result.operator_name != kUserOperator;
}

bool of_a_file(const SessionResult& result) {
  return result.session.is_nil() && result.seconds == 0 && result.operator_name.empty();
}

}  // namespace cusp::ui
