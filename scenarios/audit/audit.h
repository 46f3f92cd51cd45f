/// audit() measures what an exercise's model costs and what each part of it changes, then searches the cheapest model that
/// grades the same within the exercise's own tolerance. The caller passes the AuditRunner that plays.
/// Deterministic but for the times, which only order the search. Any thread; takes minutes.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/audit/operators.h"

namespace cusp::scenarios {

/// Result of one choice.
enum class Verdict : std::uint8_t {
  needed,      // without it a grade changes by more than the tolerance, a pass or a critical event does, or a criterion
               // can no longer be measured
  not_needed,
  shown,       // within the tolerance, but never taken: a student sees or feels it, or scenario.json has no key for it
  unplayable,  // the exercise cannot be played without it
  unresolved,  // within the tolerance, but a check of the exercise (scenarios/format/validate.h) warns of it
};
std::string_view key_of(Verdict verdict) noexcept;

/// How far two models' grades differ over all operators: attempt by attempt, or, if single attempts differ by chance, in
/// the mean over several attempts of each operator.
struct GradeChange {
  double score = 0;                        // the change of the operator that it changes most, with its sign
  int attempts_per_operator = 1;
  double standard_error = 0;               // of `score` as a mean; 0: of single attempts
  std::map<std::string, double> values;    // by metric: likewise, in its unit
  std::map<std::string, double> points;    // by metric: likewise
  bool passes_alike = true;                // every operator passes or fails as before, with the same critical events
  bool measures_alike = true;              // every criterion that was measured still is
  bool within(double tolerance_points) const noexcept {
    return passes_alike && measures_alike && score + standard_error <= tolerance_points &&
           score - standard_error >= -tolerance_points;
  }
  /// Twice the standard error decides on which side of the tolerance the mean lies.
  bool decided(double tolerance_points) const noexcept {
    return std::abs(std::abs(score) - tolerance_points) >= 2.0 * standard_error;
  }
};
[[nodiscard]] GradeChange change_between(const ModelResult& from, const ModelResult& to);
/// In the mean over each operator's attempts. Passes and critical events are alike if most of its attempts agree.
[[nodiscard]] GradeChange mean_change_between(const ModelResult& from, const ModelResult& to);
/// The operators of which a single attempt changes by more than the tolerance.
[[nodiscard]] std::vector<std::string> operators_beyond(const ModelResult& from, const ModelResult& to, double tolerance_points);
/// Attempts that an operator needs until its mean's standard error is a quarter of the tolerance; 0 if those it has had
/// decide. Source: Stein's two-stage rule, with the standard error of the attempts so far.
[[nodiscard]] int attempts_to_decide(const ModelResult& from, const ModelResult& to, const std::string& name, double tolerance_points);
/// The means of those operators joined with the single attempts of all others: the change nearest to a tolerance's edge.
[[nodiscard]] GradeChange joined(const GradeChange& means, const ModelResult& from, const ModelResult& to,
                                 const std::vector<std::string>& operators);

struct AuditRow {
  Choice choice;
  Verdict verdict = Verdict::needed;
  std::optional<ModelResult> result;       // with the choice made; nullopt: unplayable
  GradeChange change;
};

/// One step of the search: what was tried on top of what had been taken, and whether it was taken.
struct AuditStep {
  Choice choice;
  bool taken = false;
  GradeChange change;  // against the exercise in the detail that it needs
};

struct AuditReport {
  Scenario scenario;                 // as it was
  double tolerance_points = 0;
  std::vector<AuditOperator> operators;
  ModelResult as_set;
  std::vector<AuditRow> rows;
  std::vector<AuditStep> steps;      // a greedy search: what it has taken it keeps, so a better set may exist
  Scenario leanest;                  // the exercise with what was taken; its version is the old one's
  std::optional<ModelResult> leanest_result;  // measured in combination, beside as_set; nullopt: nothing was taken
  GradeChange leanest_change;        // against as_set
  std::vector<ModelAttempt> leanest_attempts;  // felt at the leanest: each passes or fails as before
  /// The leanest at half its voxels' edge; nullopt where its specimen has one size only or the half is too small.
  std::optional<GradeChange> at_half_voxel;
  bool detail_holds() const noexcept { return !at_half_voxel || at_half_voxel->within(tolerance_points); }
  bool changed() const { return !(leanest == scenario); }
};

struct AuditSettings {
  std::vector<AuditOperator> operators = {{"expert", 1}, {"expert", 2}, {"competent", 1}, {"competent", 2}, {"novice", 1}, {"novice", 2}};
  /// If half the voxel's edge changes an operator's attempt by more than the tolerance, that operator feels both models in
  /// this many attempts, and the report holds their mean: in a narrow slot attempts differ by chance. If the mean stays
  /// undecided, the operator gets as many attempts as decide it, up to the second number.
  int attempts_for_means = 8, max_attempts_for_means = 96;
  bool detail_alone = false;  // the size of the voxels, and no other choice
};

/// The choices that an audit measures: each halved or left out, in the order of a table.
[[nodiscard]] std::vector<Choice> choices_of(const Scenario& scenario);

/// Voxel sizes that the search may choose from beside `voxel_mm`: coarser ones up to twice it, coarsest first; finer ones
/// down to half of it, coarsest first. Empty where the specimen comes in one size.
[[nodiscard]] std::vector<double> coarser_voxels(const Scenario& scenario);
[[nodiscard]] std::vector<double> finer_voxels(const Scenario& scenario);

/// `watch` is called with shares of the whole.
[[nodiscard]] Result<AuditReport, AuditFailure> audit(const Scenario& scenario, const AuditSettings& settings,
                                                      const AuditRunner& runner, const AuditWatch& watch);

}  // namespace cusp::scenarios
