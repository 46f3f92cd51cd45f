/// The operators of an audit, their attempts and what a run asks for. Plain values.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "scenarios/audit/model.h"
#include "scenarios/grading/grade.h"

namespace cusp::scenarios {

/// A scripted operator (scenarios/operators/faults.h, operator_by_name) and the seed of its tremor.
struct AuditOperator {
  std::string name = "expert";
  std::uint64_t seed = 1;
  friend bool operator==(const AuditOperator&, const AuditOperator&) = default;
};

/// Cost of one model. CPU time is the thread's own.
struct ModelCost {
  double us_a_tick = 0;                        // median over blocks of ticks of 1 ms, from the first touch on
  double us_more = 0;                          // than the first model of the same run: median over the pairs of blocks
  std::optional<double> instructions_a_tick;   // nullopt: this machine does not count them
  double start_s = 0;                          // growing, building, reserving: CPU time
  std::uint64_t bytes = 0;                     // of the heap, specimen and one state
};

/// One attempt at a model. The device repeats the operator's path in AuditRun::home, or, if AuditRun::felt is set, the
/// operator feels this model.
struct ModelAttempt {
  AuditOperator by;
  Grade grade;
  double seconds = 0;      // of the exercise, by its own clock
  std::uint64_t lost = 0;  // ticks with an overflow or without a pose: tests expect none
};

struct ModelResult {
  ModelCost cost;             // with costs alone
  /// With costs alone: difference to the first model's forces, before the guard, on the expert's path in the first model;
  /// over the ticks where either touches.
  double force_rms_n = 0, force_most_n = 0;
  std::vector<ModelAttempt> attempts;  // in the order of AuditRun::operators
};

enum class AuditError : std::uint8_t {
  cancelled,
  unplayable,   // the exercise as it stands cannot be played; where: the runner's reason
  no_path,      // an operator has no path to the target, or touches nothing along it; where: the operator
};
using AuditFailure = Failure<AuditError>;

/// Called with a share in [0, 1] that rises within one run; false: stop.
using AuditWatch = std::function<bool(double share)>;

/// What a runner plays. Costs are compared with the first model's.
struct AuditRun {
  Scenario home;                  // the exercise as it is, in which the operators find their paths
  std::vector<Model> models;
  std::vector<AuditOperator> operators;
  bool costs = true;
  bool felt = false;              // each operator feels each model, so that paths differ from model to model
};

/// Plays and measures. The result of a model that cannot be played is nullopt.
using AuditRunner =
    std::function<Result<std::vector<std::optional<ModelResult>>, AuditFailure>(const AuditRun& run, const AuditWatch& watch)>;

}  // namespace cusp::scenarios
