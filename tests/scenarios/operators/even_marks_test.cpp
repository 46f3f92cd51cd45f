// The same fault earns about the same mark on every tooth: the bands of over-cut grow with the floor and wall that they are about.
// The pulpal floor's depth decides a class II too, although its box holds most of the target.

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/grading/grader.h"
#include "scenarios/library/library.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/operators/fault_cut.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// An exercise of the library, cut at once. Coarse by default: a third of the time.
class Cavity {
 public:
  explicit Cavity(const char* key) : scenario_(*load_builtin(key)) {
    if (!full_run()) scenario_.specimen.voxel_mm = 0.2;
    specimen_ = Specimen::build(*make_specimen(scenario_.specimen, {}), reading_of(scenario_.method));
    reference_ = std::make_unique<Reference>(scenario_, specimen_);
    plan_ = plan_target(scenario_, *specimen_);
  }
  Grade of(SizedFault fault) const {
    const auto cut = fault_cut(fault, scenario_, *specimen_, plan_);
    Volume volume(specimen_);
    if (!cut || !cut_along(*cut, volume)) return {};
    return grade(scenario_, measure(*reference_, volume, Process::lasting(1.0, 0.0)));
  }

 private:
  Scenario scenario_;
  std::shared_ptr<const Specimen> specimen_;
  std::unique_ptr<Reference> reference_;
  Plan plan_;
};

struct Row {
  SizedFault fault;
  bool passes;
};

/// Marks of a fault, one for each cavity; each passes or fails as its row has it.
std::vector<double> marks_of(const Row& row, const std::vector<Cavity>& cavities) {
  std::vector<double> marks;
  for (const Cavity& one : cavities) {
    const Grade grade = one.of(row.fault);
    marks.push_back(grade.score);
    EXPECT_EQ(grade.passed, row.passes) << scenarios::key_of(row.fault) << " " << grade.score;
  }
  return marks;
}

/// Floors of 2.9 to 12.4 mm2: the least and the largest; in full also a molar's and two targets beside the oblique ridge.
TEST(EvenMarks, OfOneFaultLieWithinTenPointsOnEveryClassOne) {
  std::vector<Row> rows = {{{SingleFault::too_deep, FaultSize::medium}, false},
                           {{SingleFault::too_shallow, FaultSize::small}, true},
                           {{SingleFault::too_wide, FaultSize::large}, false}};
  std::vector<const char*> keys = {"class-1-25", "class-1-36"};
  if (full_run()) {
    rows.insert(rows.end(), {{{SingleFault::too_deep, FaultSize::small}, true},
                             {{SingleFault::too_deep, FaultSize::large}, false},
                             {{SingleFault::too_shallow, FaultSize::large}, false},
                             {{SingleFault::too_wide, FaultSize::small}, true}});
    keys.insert(keys.end(), {"class-1-46", "class-1-16"});
  }
  const std::vector<Cavity> cavities(keys.begin(), keys.end());
  for (const Row& row : rows) {
    const std::vector<double> marks = marks_of(row, cavities);
    const auto [least, most] = std::ranges::minmax(marks);
    EXPECT_LT(most - least, 10.0) << scenarios::key_of(row.fault) << " " << least << " " << most;
  }
}

/// A floor 0.65 mm too shallow leaves 6 % of the target, for the box holds most of it.
TEST(EvenMarks, OfAPulpalFloorDecideAClassTwo) {
  std::vector<Row> rows = {{{SingleFault::too_shallow, FaultSize::large}, false}};
  std::vector<const char*> keys = {"class-2-36-do"};
  if (full_run()) {
    rows.insert(rows.end(), {{{SingleFault::too_shallow, FaultSize::small}, true},
                             {{SingleFault::too_deep, FaultSize::small}, true},
                             {{SingleFault::too_deep, FaultSize::medium}, false}});
    keys.insert(keys.end(), {"class-2-46-mo", "class-2-25-mod"});
  }
  const std::vector<Cavity> cavities(keys.begin(), keys.end());
  for (const Row& row : rows) marks_of(row, cavities);
}

}  // namespace
}  // namespace cusp::test
