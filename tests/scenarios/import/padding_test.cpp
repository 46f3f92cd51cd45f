// What fills up the pictures of a CT beside what was measured.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/import/foreign_images.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"

namespace cusp::test {
namespace {

/// Two slices that are alike; CT numbers are the values less 1000.
Result<DicomSeries, ImportFailure> two_slices(DicomWish wish) {
  const TempFolder folder;
  wish.columns = 3;
  wish.rows = 2;
  wish.intercept = -1000.0;
  for (int n = 0; n < 2; ++n) {
    wish.position = {0.0, 0.0, static_cast<double>(n)};
    wish.number = n + 1;
    write_text(folder / std::to_string(n), dicom_file(wish));
  }
  return read_dicom(folder.path(), {});
}

TEST(DicomPadding, IsNothingHoweverDenseItsValueWouldBe) {
  DicomWish wish;
  wish.values = {3000, 100, 200, 300, 2999, 3000};
  const auto dense = two_slices(wish);
  ASSERT_TRUE(dense) << dense.error().where;
  EXPECT_EQ(std::ranges::max(dense->image.value), 2000.0f) << "no padding is named";
  wish.padding = 3000;
  const auto padded = two_slices(wish);
  ASSERT_TRUE(padded) << padded.error().where;
  const auto [least, most] = std::ranges::minmax(padded->image.value);
  EXPECT_EQ(most, 1999.0f);
  EXPECT_EQ(std::ranges::count(padded->image.value, least), 4);
  EXPECT_GT(padded->image.measured_from, static_cast<double>(least));
  EXPECT_LT(padded->image.measured_from, -900.0) << "the least that was measured";
}

TEST(DicomPadding, ReachesFromItsValueToItsLimit) {
  DicomWish wish;
  wish.values = {-2000, -2500, -3000, -1999, -3001, 500};
  wish.padding = -3000;
  wish.padding_limit = -2000;
  const auto padded = two_slices(wish);
  ASSERT_TRUE(padded) << padded.error().where;
  const auto measured = [&](float v) { return static_cast<double>(v) >= padded->image.measured_from; };
  EXPECT_EQ(std::ranges::count_if(padded->image.value, measured), 6);
  EXPECT_EQ(std::ranges::count(padded->image.value, -2999.0f), 2);
  EXPECT_EQ(std::ranges::count(padded->image.value, -4001.0f), 2);
}

}  // namespace
}  // namespace cusp::test
