// Fitted shapes that are kept for who asks next.

#include "scenarios/teeth/shared_shape.h"

#include <gtest/gtest.h>

#include "scenarios/teeth/find_landmarks.h"
#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(SharedShape, HasTheLandmarksOfOneThatWasFittedAnew) {
  const auto shared = tooth_landmarks({36, 2, 0.2});
  const ToothLandmarks anew = find_landmarks(ToothShape(*table_for(36)->table, 2, 0.2));
  ASSERT_TRUE(shared.has_value());
  EXPECT_EQ(shared->central, anew.central);
  EXPECT_EQ(shared->mesial_contact, anew.mesial_contact);
  EXPECT_EQ(shared->dims.crown_length, anew.dims.crown_length);
}

TEST(SharedShape, IsFittedOnceWhileItIsOfTheLastFew) {
  const ToothTable& table = *table_for(35)->table;
  constexpr double kCoarse = 0.4;
  const ToothShape* const first = shared_shape(table, 1, kCoarse).get();
  EXPECT_EQ(shared_shape(table, 1, kCoarse).get(), first) << "nobody held it meanwhile";
  const auto held = shared_shape(table, 1, kCoarse);
  for (std::uint64_t seed = 2; seed < 2 + kKeptShapes; ++seed) EXPECT_NE(shared_shape(table, seed, kCoarse), held);
  EXPECT_EQ(shared_shape(table, 1, kCoarse), held) << "somebody holds it";
  const std::weak_ptr<const ToothShape> left = shared_shape(table, 2 + kKeptShapes, kCoarse);
  for (std::uint64_t seed = 100; seed < 100 + kKeptShapes; ++seed) static_cast<void>(shared_shape(table, seed, kCoarse));
  EXPECT_TRUE(left.expired()) << "kept for ever";
}

}  // namespace
}  // namespace cusp::test
