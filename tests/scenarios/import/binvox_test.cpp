#include "scenarios/import/binvox.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "scenarios/blocks/blocks.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {

using test::read_text;
using test::TempFolder;
using test::write_text;

Result<Binvox, ImportFailure> read(const std::string& bytes, const VolumeLimits& limits = {}) {
  std::istringstream in(bytes);
  return read_binvox(in, bytes.size(), "v.binvox", limits);
}

TEST(Binvox, WritingThenReadingIsIdentity) {
  const TempFolder folder;
  std::mt19937 random(7);
  for (const IVec3 size : {IVec3(1, 1, 1), IVec3(5, 7, 11), IVec3(40, 3, 1), IVec3(16, 16, 16)}) {
    Binvox what;
    what.size = size;
    what.translate = Vec3(-12.345678901234567, 1e-17, 3.0);
    what.scale = 0.1 * 7;
    what.value.resize(static_cast<std::size_t>(size.x * size.y * size.z));
    bool on = false;
    for (auto& v : what.value) {
      if (random() % 40 == 0) on = !on;  // runs longer than 255 in the last one, and short ones
      v = on ? 1 : 0;
    }
    ASSERT_TRUE(write_binvox(what, folder / "v.binvox"));
    const auto back = read_binvox(folder / "v.binvox");
    ASSERT_TRUE(back) << key_of(back.error().code);
    EXPECT_EQ(*back, what);
    const std::string once = read_text(folder / "v.binvox");
    ASSERT_TRUE(write_binvox(*back, folder / "w.binvox"));
    EXPECT_EQ(read_text(folder / "w.binvox"), once);
  }
}

TEST(Binvox, TheAxesAreThoseOfTheFormat) {
  // dim 2 3 4 is depth (x), height (z), width (y); y runs fastest, then z, then x.
  std::string data;
  for (int i = 0; i < 24; ++i) data += std::string(1, i == 1 ? '\1' : i == 4 ? '\2' : i == 12 ? '\3' : '\0') + '\1';
  const auto v = read("#binvox 1\ndim 2 3 4\ntranslate 0 0 0\nscale 1\ndata\n" + data);
  ASSERT_TRUE(v);
  EXPECT_EQ(v->size, IVec3(2, 4, 3));
  const auto at = [&](int x, int y, int z) { return v->value[static_cast<std::size_t>(x + 2 * (y + 4 * z))]; };
  EXPECT_EQ(at(0, 1, 0), 1);
  EXPECT_EQ(at(0, 0, 1), 2);
  EXPECT_EQ(at(1, 0, 0), 3);
}

TEST(Binvox, TranslateAndScaleAreThePlaceOfTheVoxels) {
  Binvox what;
  what.size = {10, 5, 20};
  what.translate = {3.0, -2.0, 1.0};
  what.scale = 4.0;  // the longest side, so 0.2 a voxel
  what.value.assign(1000, 1);
  const auto image = image_of(what, "v", {});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->layout.size, IVec3(10, 5, 20));
  EXPECT_NEAR(image->layout.spacing_mm.y, 0.2, 1e-15);
  EXPECT_NEAR(image->layout.origin_mm.x, 3.1, 1e-12);
  EXPECT_NEAR(image->layout.origin_mm.z, 1.1, 1e-12);
  EXPECT_FALSE(image->spacing_known);
}

TEST(Binvox, WritesASpecimensOccupiedVoxelsAndReadsThemBackInPlace) {
  const VoxelVolume block = dexterity_block(0.5);
  const Binvox out = binvox_of(block);
  const auto image = image_of(out, "v", {});
  ASSERT_TRUE(image);
  EXPECT_LT(glm::length(image->layout.origin_mm - block.grid.origin_mm), 1e-9);
  EXPECT_NEAR(image->layout.spacing_mm.x, 0.5, 1e-12);
  for (std::size_t i = 0; i < block.s.size(); ++i) ASSERT_EQ(image->value[i] > 0.0f, block.s[i] >= kHalf);
}

TEST(Binvox, BrokenFilesAreRefusedByTheirCode) {
  using enum ImportError;
  const std::string head = "#binvox 1\ndim 2 2 2\ntranslate 0 0 0\nscale 1\ndata\n";
  const std::string good(std::string("\1\10", 2));
  ASSERT_TRUE(read(head + good));
  const struct {
    std::string bytes;
    ImportError code;
  } cases[] = {
      {"", unknown_format},
      {"#binvux 1\n", unknown_format},
      {"#binvox 2\ndim 2 2 2\ndata\n" + good, unsupported},
      {"#binvox 1\ndim 2 2\ndata\n" + good, bad_header},
      {"#binvox 1\ndim 0 2 2\ndata\n" + good, bad_sizes},
      {"#binvox 1\ndim 2.5 2 2\ndata\n" + good, bad_sizes},
      {"#binvox 1\ndim 4000 2 2\ndata\n" + good, too_large},
      {"#binvox 1\ndim 2000 2000 2000\ndata\n" + good, too_large},
      {"#binvox 1\ndim 512 512 512\ndata\n" + good, truncated},  // before 134 MB are taken
      {"#binvox 1\ndata\n" + good, bad_sizes},
      {"#binvox 1\ndim 2 2 2\nscale 0\ndata\n" + good, bad_spacing},
      {"#binvox 1\ndim 2 2 2\nscale nan\ndata\n" + good, bad_header},
      {"#binvox 1\ndim 2 2 2\ncolour 1\ndata\n" + good, bad_header},
      {"#binvox 1\ndim 2 2 2\ndim 2 2 2\ndata\n" + good, bad_header},
      {"#binvox 1\ndim 2 2 2\nscale 1\nscale 10\ndata\n" + good, bad_header},
      {"#binvox 1\ndim 2 2 2\n", truncated},
      {head + std::string("\1\7", 2), truncated},
      {head + std::string("\1\7\0", 3), truncated},
      {head + std::string("\1\11", 2), corrupt},
  };
  for (const auto& c : cases) {
    const auto r = read(c.bytes);
    ASSERT_FALSE(r) << c.bytes;
    EXPECT_EQ(key_of(r.error().code), key_of(c.code)) << c.bytes;
  }
}

TEST(Binvox, AFileThatCannotBeWrittenLeavesNothing) {
  Binvox what;
  what.size = {1, 1, 1};
  what.value = {1};
  EXPECT_EQ(write_binvox(what, "/no/such/folder/v.binvox").error().code, ImportError::io);
  what.value.clear();
  const TempFolder folder;
  EXPECT_EQ(write_binvox(what, folder / "v.binvox").error().code, ImportError::bad_sizes);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace cusp::test
