/// What a scripted operator's cuts come to when they are made at once (scenarios/operators/fast_cut.h): measured and graded.
/// Nothing is kept. Time, force and heat are not measured. Thread: any but the haptic; seconds.
#pragma once

#include <memory>
#include <string>

#include "engine/base/result.h"
#include "scenarios/operators/plan.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"

namespace cusp::ui {

enum class OperatorCutError : std::uint8_t {
  no_path,       // no bur of the exercise reaches its target, the name is of no operator that cuts at once, or it is cancelled
  too_much_cut,  // more than a volume of the exercise can keep
};

/// `name`: "reference", "competent" or "novice". Pre: the specimen is the scenario's, in its method's reading.
[[nodiscard]] Result<SessionResult, OperatorCutError> cut_by_operator(const std::string& name, const Scenario& scenario,
                                                                      const std::shared_ptr<const Specimen>& specimen,
                                                                      PlanCancel cancel = nullptr);

/// The result is of cut_by_operator(): its seconds and its device mean nothing.
[[nodiscard]] bool cut_at_once(const SessionResult& result);
/// Whether the volume comes from a file: nobody cut it here, and nothing of the way is known.
[[nodiscard]] bool of_a_file(const SessionResult& result);

}  // namespace cusp::ui
