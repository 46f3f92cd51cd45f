#include "ui/session/specimen_blob.h"

#include <gtest/gtest.h>

#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(SpecimenBlob, ReadsBackWhatItWroteAndRefusesAnythingElse) {
  const VoxelVolume volume = test::block_volume();
  auto bytes = specimen_bytes(volume);
  const auto back = specimen_from_bytes(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->grid, volume.grid);
  EXPECT_EQ(back->s, volume.s);
  EXPECT_EQ(back->tissue, volume.tissue);
  EXPECT_EQ(Specimen::build(*back, Reading::banded)->hash(), Specimen::build(volume, Reading::banded)->hash());
  EXPECT_FALSE(specimen_from_bytes({}));
  EXPECT_FALSE(specimen_from_bytes(std::span(bytes).first(bytes.size() - 1)));
  auto huge = bytes;
  huge[14] = std::byte{0xFF};  // a size of 2^54 voxels
  EXPECT_FALSE(specimen_from_bytes(huge));
  auto tissue = bytes;
  tissue[bytes.size() - volume.grid.voxels() * 3] = std::byte{200};
  EXPECT_FALSE(specimen_from_bytes(tissue));
}

}  // namespace
}  // namespace cusp::test
