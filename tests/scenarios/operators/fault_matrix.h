// The fault matrix: what each single fault costs in each criterion of an exercise, beside the reference. A fault belongs to
// criteria of its own; with others it may move together (cross-talk); any other is not to lose points by it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/operators/fault_cut.h"
#include "tests/modules.h"

namespace cusp::test {

// Keys, or their starts where a star ends them.
struct FaultRules {
  SingleFault fault;
  std::vector<std::string_view> own;
  std::vector<std::string_view> cross_talk;
  std::string_view reason;  // of the cross-talk
};
std::span<const FaultRules> fault_rules();

// Violations whose cause is known. `what`: a foreign criterion, or one of these. `exercise`: a key or its start with a star.
inline constexpr std::string_view kNotFound = "not found", kNotInOrder = "not in order";
std::optional<std::string_view> reason_known(SingleFault fault, std::string_view exercise, std::string_view what);

inline constexpr double kForeignLoss = 0.1;  // of a criterion's points, that no fault may cost in another's criteria
inline constexpr double kFoundLoss = 0.02;   // less is not found

struct CriterionShare {
  double value = 0;
  double share = 0;      // of its points by its bands alone, 0 to 1
  bool of_rubric = false;  // of the exercise's own rubric; else by default_bands()
};

struct Graded {
  std::map<std::string, CriterionShare, std::less<>> criteria;  // measured ones
  double score = 0;                                            // by the exercise's own rubric
};

struct Loss {
  std::string metric;
  double loss = 0;
  FaultSize size = FaultSize::small;
};

// One fault on one exercise.
struct FaultRow {
  std::array<Graded, 3> sizes;        // by FaultSize
  std::array<double, 3> own{};        // loss of its own criteria: the mean of those that lose anything
  std::string own_metric;             // that loses most
  bool by_rubric = false;             // the exercise's own rubric has a criterion that finds it
  std::vector<Loss> foreign;          // beyond the cross-talk: the largest of each criterion
  bool in_order() const noexcept { return own[0] <= own[1] + 1e-6 && own[1] <= own[2] + 1e-6; }
  bool found() const noexcept { return own[1] >= kFoundLoss && own[2] >= kFoundLoss; }  // medium and large
};

FaultRow judge(SingleFault fault, const Graded& reference, std::array<Graded, 3> sizes);

class FaultMatrix {
 public:
  // Seconds. Pre: a built-in exercise's, or one that validates.
  FaultMatrix(Scenario scenario, std::shared_ptr<const Specimen> specimen);
  const Graded& reference() const noexcept { return reference_; }
  // nullopt: the exercise cannot have it. Seconds.
  std::optional<FaultRow> row(SingleFault fault) const;

 private:
  Graded graded(const FaultCut& cut) const;

  Scenario scenario_;
  std::shared_ptr<const Specimen> specimen_;
  std::vector<Criterion> criteria_;  // the rubric's, then the default ones
  std::unique_ptr<Reference> against_;
  Plan plan_;
  Graded reference_;
};

}  // namespace cusp::test
