// Single faults: names, what an exercise can have, and that a grade finds each one by size and by its own criteria alone.

#include <gtest/gtest.h>


#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/scenarios/operators/fault_matrix.h"

namespace cusp::test {
namespace {

FaultMatrix matrix_of(Scenario scenario) {
  const auto dense = make_specimen(scenario.specimen, {});
  auto specimen = Specimen::build(*dense, reading_of(scenario.method));
  return {std::move(scenario), std::move(specimen)};
}

std::string_view name_of(SingleFault fault) { return single_faults()[static_cast<std::size_t>(fault)].key; }

// Found, in order of size, and costing nothing of another's; but for what is known.
void expect_single(const FaultRow& row, SingleFault fault, const std::string& exercise) {
  const auto known = [&](std::string_view what) { return reason_known(fault, exercise, what).has_value(); };
  const std::string of = exercise + " " + std::string(name_of(fault)) + " ";
  EXPECT_TRUE(row.found() || known(kNotFound)) << of << row.own[0] << " " << row.own[1] << " " << row.own[2];
  EXPECT_TRUE(row.in_order() || known(kNotInOrder)) << of << row.own[0] << " " << row.own[1] << " " << row.own[2];
  for (const Loss& loss : row.foreign) EXPECT_TRUE(known(loss.metric)) << of << loss.metric << " " << loss.loss;
}

TEST(SingleFaults, HaveNamesAndGrowingSizes) {
  for (std::size_t i = 0; i < single_faults().size(); ++i) {
    const SingleFaultRow& row = single_faults()[i];
    EXPECT_EQ(static_cast<std::size_t>(row.fault), i) << row.key;
    EXPECT_EQ(fault_rules()[i].fault, row.fault) << row.key;
    EXPECT_LT(0.0, row.sizes[0]) << row.key;
    EXPECT_LT(row.sizes[0], row.sizes[1]) << row.key;
    EXPECT_LT(row.sizes[1], row.sizes[2]) << row.key;
    for (std::size_t size = 0; size < kFaultSizeKeys.size(); ++size) {
      const SizedFault fault{row.fault, static_cast<FaultSize>(size)};
      const auto read = sized_fault_by_name(scenarios::key_of(fault));
      ASSERT_TRUE(read) << row.key;
      EXPECT_EQ(read->fault, fault.fault);
      EXPECT_EQ(read->size, fault.size);
    }
  }
  for (const char* none : {"too_deep", "too_deep:", ":small", "too_deep:huge", "reference:small", ""})
    EXPECT_FALSE(sized_fault_by_name(none)) << none;
}

TEST(SingleFaults, AreFoundOnABlockWhichCannotHaveThoseOfATooth) {
  const FaultMatrix matrix = matrix_of(*load_builtin("channel-1"));
  for (const SingleFault fault : {SingleFault::too_deep, SingleFault::too_wide}) {
    const auto row = matrix.row(fault);
    ASSERT_TRUE(row) << name_of(fault);
    expect_single(*row, fault, "channel-1");
    EXPECT_TRUE(row->by_rubric) << name_of(fault);
    EXPECT_GT(matrix.reference().score, row->sizes[2].score) << name_of(fault);
  }
  // No tooth: nothing is cut.
  for (const SingleFault fault : {SingleFault::undermined, SingleFault::thin_ridge, SingleFault::exposed_pulp, SingleFault::nicked_neighbour,
                                  SingleFault::contact_closed, SingleFault::caries_left, SingleFault::over_excavated, SingleFault::dry_cutting})
    EXPECT_FALSE(matrix.row(fault)) << name_of(fault);
}

// A carious lesion below the central pit, to be removed with the access to it. Coarse: a third of the time.
Scenario caries_exercise() {
  Scenario out = *load_builtin("class-1-46");
  out.specimen.voxel_mm = 0.2;
  out.specimen.lesions = {{"fissure", "central", 0.8, 1.0, 0.7}};
  Region lesion, target;
  lesion.kind = RegionKind::lesion;
  target.kind = RegionKind::joined;
  target.parts = {out.target, lesion};
  out.target = target;
  return out;
}

TEST(SingleFaults, FindTheRimOfALesionThatIsLeft) {
  const FaultMatrix matrix = matrix_of(caries_exercise());
  const auto row = matrix.row(SingleFault::caries_left);
  ASSERT_TRUE(row);
  expect_single(*row, SingleFault::caries_left, "caries");
}

TEST(SingleFaults, FindWallsThatAreHollowed) {
  Scenario coarse = *load_builtin("class-1-46");
  coarse.specimen.voxel_mm = 0.2;
  const FaultMatrix matrix = matrix_of(std::move(coarse));
  const auto row = matrix.row(SingleFault::undermined);
  ASSERT_TRUE(row);
  expect_single(*row, SingleFault::undermined, "class-1-46");
  EXPECT_TRUE(row->by_rubric);
}

// One of each class; fault_matrix.py covers all exercises.
TEST(FaultMatrix, FindsEachFaultByItsOwnCriteria) {
  if (!full_run()) GTEST_SKIP() << "seven minutes; ./check --full sets CUSP_FULL";
  for (const char* key : {"channel-1", "class-1-36-wet", "class-1-25", "class-2-46-mo"}) {
    const FaultMatrix matrix = matrix_of(*load_builtin(key));
    for (const SingleFaultRow& fault : single_faults())
      if (const auto row = matrix.row(fault.fault)) expect_single(*row, fault.fault, key);
  }
}

}  // namespace
}  // namespace cusp::test
