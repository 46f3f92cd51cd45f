/// What an exercise's model costs and what each part of it changes; then the cheapest model that grades the same within
/// the exercise's own tolerance. The playing is handed in: this room plans, compares and searches.
/// Deterministic but for the times, which only decide in which order the search tries. Any thread; minutes.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/audit/hands.h"

namespace cusp::scenarios {

/// What came of a choice.
enum class Verdict : std::uint8_t {
  needed,      // without it a grade changes by more than the tolerance, a pass or a critical event does, or a criterion
               // can no longer be measured
  not_needed,
  shown,       // within the tolerance, but measured only: what a person should see or feel, or what no exercise can say
  unplayable,  // the exercise cannot be played without it
  unresolved,  // within the tolerance, but a check of the exercise (scenarios/format/validate.h) warns of it
};
std::string_view key_of(Verdict verdict) noexcept;

/// How far two models' grades lie apart over all hands: go by go, or, where single goes part by chance, in the mean over
/// several goes of each hand.
struct GradeChange {
  double score = 0;                        // the change of the hand that it changes most, with its sign
  int goes_a_hand = 1;
  double standard_error = 0;               // of `score` as a mean; 0: of single goes
  std::map<std::string, double> values;    // by metric: likewise, in its unit
  std::map<std::string, double> points;    // by metric: likewise
  bool passes_alike = true;                // every hand passes or fails as before, with the same critical events
  bool measures_alike = true;              // every criterion that was measured still is
  bool within(double tolerance_points) const noexcept {
    return passes_alike && measures_alike && score + standard_error <= tolerance_points &&
           score - standard_error >= -tolerance_points;
  }
  /// Twice the standard error leaves no doubt on which side of the tolerance the mean lies.
  bool decided(double tolerance_points) const noexcept {
    return std::abs(std::abs(score) - tolerance_points) >= 2.0 * standard_error;
  }
};
[[nodiscard]] GradeChange change_between(const ModelResult& from, const ModelResult& to);
/// In the mean over the goes of each hand; passes and critical events are alike when most of its goes have them alike.
[[nodiscard]] GradeChange mean_change_between(const ModelResult& from, const ModelResult& to);
/// The hands of which a single go changes by more than the tolerance.
[[nodiscard]] std::vector<std::string> hands_beyond(const ModelResult& from, const ModelResult& to, double tolerance_points);
/// How many goes a hand needs until its mean's standard error is a quarter of the tolerance (that of those it has had says
/// how many: Stein's two stages); 0 where those it has had decide, either way.
[[nodiscard]] int goes_to_decide(const ModelResult& from, const ModelResult& to, const std::string& hand, double tolerance_points);
/// The means of those hands together with the single goes of all others: what comes nearest to a tolerance's edge is told.
[[nodiscard]] GradeChange joined(const GradeChange& means, const ModelResult& from, const ModelResult& to,
                                 const std::vector<std::string>& hands);

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
  std::vector<AuditHand> hands;
  ModelResult as_set;
  std::vector<AuditRow> rows;
  std::vector<AuditStep> steps;      // a greedy search: what it has taken it keeps, so a better set may exist
  Scenario leanest;                  // the exercise with what was taken; its version is the old one's
  std::optional<ModelResult> leanest_result;  // measured in combination, beside as_set; nullopt: nothing was taken
  GradeChange leanest_change;        // against as_set
  std::vector<ModelGo> leanest_goes;  // the hands' own at the leanest: each passes or fails as it did, else nothing is taken
  /// The leanest at half its voxels' edge; nullopt where its specimen has one size only or the half is too small.
  std::optional<GradeChange> at_half_voxel;
  bool detail_holds() const noexcept { return !at_half_voxel || at_half_voxel->within(tolerance_points); }
  bool changed() const { return !(leanest == scenario); }
};

struct AuditSettings {
  std::vector<AuditHand> hands = {{"expert", 1}, {"expert", 2}, {"fair", 1}, {"fair", 2}, {"novice", 1}, {"novice", 2}};
  /// Where half the voxels grade a hand's go otherwise by more than the tolerance, that hand has this many goes in both,
  /// feeling them, and their mean is told instead: in a narrow slot two goes part by chance. Where those cannot tell on
  /// which side of the tolerance the mean lies, as many as are needed for that, up to the second number.
  int goes_for_means = 8, most_goes_for_means = 96;
  bool detail_alone = false;  // the size of the voxels, and no other choice
};

/// What is measured of an exercise: each choice halved or left out, in the order of a table.
[[nodiscard]] std::vector<Choice> choices_of(const Scenario& scenario);

/// Voxel sizes that the search may choose from beside `voxel_mm`: coarser ones up to twice it, coarsest first; finer ones
/// down to half of it, coarsest first. Empty where the specimen comes in one size.
[[nodiscard]] std::vector<double> coarser_voxels(const Scenario& scenario);
[[nodiscard]] std::vector<double> finer_voxels(const Scenario& scenario);

/// `watch` is told shares of the whole.
[[nodiscard]] Result<AuditReport, AuditFailure> audit(const Scenario& scenario, const AuditSettings& settings,
                                                      const AuditRunner& runner, const AuditWatch& watch);

}  // namespace cusp::scenarios
