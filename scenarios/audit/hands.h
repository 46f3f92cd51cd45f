/// Whom an audit lets drill, and what came of it. Plain values.
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

/// A scripted hand (scenarios/operators/faults.h, hand_by_name) and the seed of its tremor.
struct AuditHand {
  std::string hand = "expert";
  std::uint64_t seed = 1;
  friend bool operator==(const AuditHand&, const AuditHand&) = default;
};

/// What a model takes. CPU time is the thread's own.
struct ModelCost {
  double us_a_tick = 0;                        // median over blocks of ticks of 1 ms, from the first touch on
  double us_more = 0;                          // than the first model of the same run: median over the pairs of blocks
  std::optional<double> instructions_a_tick;   // nullopt: this machine does not count them
  double start_s = 0;                          // growing, building, reserving: CPU time
  std::uint64_t bytes = 0;                     // of the heap, specimen and one state
};

/// A go at a model: the device goes where the hand's went in the exercise as it is, or where the hand leads it as it feels
/// this model (AuditRun::felt).
struct ModelGo {
  AuditHand hand;
  Grade grade;
  double seconds = 0;      // of the exercise, by its own clock
  std::uint64_t lost = 0;  // ticks that ran out of room or found no pose: tests want none
};

struct ModelResult {
  ModelCost cost;             // with costs alone
  /// Likewise: how the forces differ from the first model's, before the guard, when the device goes where an expert's went
  /// in the first; over the ticks where either touches.
  double force_rms_n = 0, force_most_n = 0;
  std::vector<ModelGo> goes;  // in the order of the hands
};

enum class AuditError : std::uint8_t {
  cancelled,
  unplayable,   // the exercise as it stands cannot be played; where: what the runner said
};
using AuditFailure = Failure<AuditError>;

/// Called with a share in [0, 1] that rises within one run; false: stop.
using AuditWatch = std::function<bool(double share)>;

/// What a run is asked for. Costs are compared with the first model's.
struct AuditRun {
  Scenario home;                  // the exercise as it is, in which the hands find their paths
  std::vector<Model> models;
  std::vector<AuditHand> hands;
  bool costs = true;
  bool felt = false;              // the hands feel each model: their paths part, as two goes of one hand do
};

/// Plays, and measures. Of a model that cannot be played nothing comes back (its place is empty).
using AuditRunner =
    std::function<Result<std::vector<std::optional<ModelResult>>, AuditFailure>(const AuditRun& run, const AuditWatch& watch)>;

}  // namespace cusp::scenarios
