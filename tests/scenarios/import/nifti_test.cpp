// NIfTI as others write it; the files are made here, byte by byte.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "scenarios/import/foreign_images.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"

namespace cusp::test {
namespace {

float value_at(const Image& image, int x, int y, int z) {
  const IVec3 n = image.layout.size;
  return image.value[static_cast<std::size_t>(x + n.x * (y + n.y * z))];
}

/// The header of a pair, whose voxels begin their own file.
std::string pair_header(const std::string& single) {
  std::string out = single.substr(0, 352);
  out.replace(344, 4, std::string("ni1\0", 4));
  out.replace(108, 4, std::string(4, '\0'));
  return out;
}

/// The same file from a machine whose most significant byte comes first.
std::string turned_bytes(std::string file) {
  struct Numbers {
    std::size_t first, last, bytes;
  };
  // By nifti1.h: what lies between is text or single bytes. From 352 on the voxels follow, of 16 bits.
  const Numbers numbers[] = {{0, 4, 4},     {32, 36, 4},   {36, 38, 2},   {40, 56, 2},   {56, 68, 4},   {68, 76, 2},   {76, 120, 4},
                             {120, 122, 2}, {124, 148, 4}, {252, 256, 2}, {256, 328, 4}, {352, file.size(), 2}};
  for (const auto& [first, last, bytes] : numbers)
    for (std::size_t at = first; at < last; at += bytes)
      std::reverse(file.begin() + static_cast<std::ptrdiff_t>(at), file.begin() + static_cast<std::ptrdiff_t>(at + bytes));
  return file;
}

struct Nifti : ::testing::Test {
  TempFolder folder;
  NiftiWish wish;
  Nifti() {
    wish.size = {2, 3, 4};
    wish.spacing_mm = {0.1, 0.2, 0.5};
    wish.values = values_of(wish.size, [](IVec3 v) { return v.x + 10 * v.y + 100 * v.z; });
  }
  Result<Image, ImportFailure> read(const std::string& bytes) {
    write_text(folder / "v.nii", bytes);
    return read_nifti(folder / "v.nii", {});
  }
};

TEST_F(Nifti, AnAffineWithNegativeAxesIsTurnedNotMirrored) {
  wish.affine = {-0.1f, 0, 0, 5, 0, -0.2f, 0, 6, 0, 0, 0.5f, 7};
  const auto image = read(nifti_file(wish));
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(image->layout.size, IVec3(2, 3, 4));
  EXPECT_LT(glm::length(image->layout.spacing_mm - Vec3(0.1, 0.2, 0.5)), 1e-6);
  EXPECT_LT(glm::length(image->layout.origin_mm - Vec3(4.9, 5.6, 7.0)), 1e-5);
  EXPECT_EQ(value_at(*image, 1, 2, 0), 0.0f);
  EXPECT_EQ(value_at(*image, 0, 0, 3), 321.0f);
  EXPECT_TRUE(image->spacing_known && image->sides_known);
  EXPECT_EQ(image->layout.turned_degrees, 0.0);
}

TEST_F(Nifti, InWhosePlaceAPipeLiesWaitsForNobody) {
  ASSERT_EQ(::mkfifo((folder / "v.nii").c_str(), 0600), 0);
  EXPECT_EQ(read_nifti(folder / "v.nii", {}).error().code, ImportError::io);
}

TEST_F(Nifti, OfAPairTheVoxelsPipeWaitsForNobody) {
  write_text(folder / "v.hdr", pair_header(nifti_file(wish)));
  ASSERT_EQ(::mkfifo((folder / "v.img").c_str(), 0600), 0);
  const auto image = read_nifti(folder / "v.hdr", {});
  ASSERT_FALSE(image);
  EXPECT_EQ(key_of(image.error().code), "io");
  EXPECT_EQ(image.error().where, "v.img");
}

TEST_F(Nifti, OfAPackedFileItsOwnVoxelsAreReadBesideAPlainOneOfItsName) {
  write_text(folder / "v.nii.gz", gzip_stored(nifti_file(wish)));
  wish.values.assign(wish.values.size(), 7);
  write_text(folder / "v.nii", nifti_file(wish));
  const auto packed = read_nifti(folder / "v.nii.gz", {}), plain = read_nifti(folder / "v.nii", {});
  ASSERT_TRUE(packed && plain);
  EXPECT_EQ(value_at(*packed, 1, 2, 3), 321.0f);
  EXPECT_EQ(value_at(*plain, 1, 2, 3), 7.0f);
}

TEST_F(Nifti, BesideAPipeOfItsNameAPackedFileWaitsForNobody) {
  write_text(folder / "v.nii.gz", gzip_stored(nifti_file(wish)));
  ASSERT_EQ(::mkfifo((folder / "v.nii").c_str(), 0600), 0);
  EXPECT_TRUE(read_nifti(folder / "v.nii.gz", {}));
}

TEST_F(Nifti, OfAFileThatWasPackedInPartsAllPartsAreRead) {
  const std::string whole = nifti_file(wish);
  write_text(folder / "v.nii.gz", gzip_stored(whole.substr(0, 361)) + gzip_stored("") + gzip_stored(whole.substr(361)));
  const auto image = read_nifti(folder / "v.nii.gz", {});
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(value_at(*image, 1, 2, 3), 321.0f);
}

TEST_F(Nifti, BytesInTheOtherOrderAreTurned) {
  wish.affine = {0.1f, 0, 0, 5, 0, 0.2f, 0, 6, 0, 0, 0.5f, 7};
  const auto image = read(turned_bytes(nifti_file(wish)));
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_LT(glm::length(image->layout.spacing_mm - Vec3(0.1, 0.2, 0.5)), 1e-6);
  EXPECT_EQ(value_at(*image, 1, 2, 3), 321.0f);
}

TEST_F(Nifti, AVoxelWithoutANumberIsBelowAllThatAreMeasured) {
  std::string file = nifti_file(wish).substr(0, 352);
  file.replace(70, 4, std::string("\x10\0\x20\0", 4));  // DT_FLOAT32, of 32 bits
  for (std::size_t i = 0; i < wish.values.size(); ++i) {
    const float value = i == 0 ? std::numeric_limits<float>::quiet_NaN() : -1000.0f + 0.5f * static_cast<float>(i);
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int byte = 0; byte < 4; ++byte) file += static_cast<char>(bits >> (8 * byte) & 0xff);
  }
  const auto image = read(file);
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(value_at(*image, 1, 0, 0), -999.5f);
  EXPECT_LT(value_at(*image, 0, 0, 0), -1000.0f) << "0 would be the value of water";
}

TEST_F(Nifti, WithoutAnAffineTheSpacingsAloneHoldAndUnitsAreKept) {
  const auto plain = read(nifti_file(wish));
  ASSERT_TRUE(plain);
  EXPECT_LT(glm::length(plain->layout.spacing_mm - Vec3(0.1, 0.2, 0.5)), 1e-6);
  EXPECT_EQ(value_at(*plain, 1, 2, 3), 321.0f);
  EXPECT_FALSE(plain->sides_known);
  wish.units = 3;  // micrometres
  wish.spacing_mm = {100, 100, 100};
  const auto micro = read(nifti_file(wish));
  ASSERT_TRUE(micro);
  EXPECT_LT(glm::length(micro->layout.spacing_mm - Vec3(0.1)), 1e-6);
  wish.units = 0;
  EXPECT_FALSE(read(nifti_file(wish))->spacing_known);
}

TEST_F(Nifti, ALengthThatIsNoneMakesTheSpacingUnknownAlongAllAxes) {
  for (const double length : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    wish.spacing_mm = {0.1, length, 0.5};
    const auto image = read(nifti_file(wish));
    ASSERT_TRUE(image);
    EXPECT_FALSE(image->spacing_known) << length;
    EXPECT_EQ(image->layout.spacing_mm, Vec3(1.0)) << length;
  }
  // An affine holds lengths of its own.
  wish.affine = {0.1f, 0, 0, 0, 0, 0.2f, 0, 0, 0, 0, 0.5f, 0};
  EXPECT_TRUE(read(nifti_file(wish))->spacing_known);
}

TEST_F(Nifti, UnderAQuaternionALengthBelowZeroIsNone) {
  const auto by_quaternion = [&] {
    std::string bytes = nifti_file(wish);
    bytes.replace(252, 2, std::string("\1\0", 2));  // qform_code: the quaternion of zeros turns nothing
    return read(bytes);
  };
  const auto sound = by_quaternion();
  ASSERT_TRUE(sound);
  EXPECT_TRUE(sound->spacing_known && sound->sides_known);
  EXPECT_LT(glm::length(sound->layout.spacing_mm - Vec3(0.1, 0.2, 0.5)), 1e-6);
  for (int axis = 0; axis < 3; ++axis) {
    wish.spacing_mm = {0.1, 0.2, 0.5};
    wish.spacing_mm[axis] *= -1.0;
    const auto image = by_quaternion();
    ASSERT_TRUE(image);
    EXPECT_FALSE(image->spacing_known || image->sides_known) << axis << ": the library takes 1 for it";
    EXPECT_EQ(image->layout.spacing_mm, Vec3(1.0)) << axis;
  }
}

TEST_F(Nifti, ValuesAreScaled) {
  wish.slope = 2.0f;
  wish.intercept = -1000.0f;
  const auto image = read(nifti_file(wish));
  ASSERT_TRUE(image);
  EXPECT_EQ(value_at(*image, 1, 0, 0), -998.0f);
  EXPECT_EQ(image->kind, ImageKind::grey);
}

TEST_F(Nifti, WhatIsCutOffOrTooLargeIsRefusedBeforeItsMemoryIsTaken) {
  const std::string good = nifti_file(wish);
  EXPECT_EQ(key_of(read(good.substr(0, good.size() - 1)).error().code), "truncated");
  EXPECT_FALSE(read(good.substr(0, 200)));
  EXPECT_FALSE(read(""));
  EXPECT_EQ(read_nifti(folder / "none.nii", {}).error().code, ImportError::bad_header);
  std::string huge = good;
  for (const std::size_t at : {42u, 44u, 46u}) huge.replace(at, 2, std::string("\xf4\x01", 2));  // 500 each way
  EXPECT_EQ(key_of(read(huge).error().code), "truncated");
  for (const std::size_t at : {42u, 44u, 46u}) huge.replace(at, 2, std::string("\xff\x7f", 2));
  EXPECT_EQ(key_of(read(huge).error().code), "too_large");
}

TEST_F(Nifti, VoxelsThatWouldBeginWithinTheHeaderAreRefused) {
  const std::string nan("\x00\x00\xc0\x7f", 4), of_0(4, '\0'), of_100("\x00\x00\xc8\x42", 4), of_350("\x00\x00\xaf\x43", 4);
  for (const std::string& offset : {nan, of_0, of_100, of_350}) {
    std::string bytes = nifti_file(wish);
    bytes.replace(108, 4, offset);
    const auto image = read(bytes);
    ASSERT_FALSE(image);
    EXPECT_EQ(key_of(image.error().code), "bad_header");
    EXPECT_EQ(image.error().where, "v.nii vox_offset");
  }
}

TEST_F(Nifti, OfAPairTheFileThatIsMissingOrCutIsNamed) {
  const std::string whole = nifti_file(wish), voxels = whole.substr(352);
  write_text(folder / "v.hdr", pair_header(whole));
  const auto alone = read_nifti(folder / "v.hdr", {});
  ASSERT_FALSE(alone);
  EXPECT_EQ(key_of(alone.error().code), "missing_file");
  EXPECT_EQ(alone.error().where, "v.img");
  write_text(folder / "v.img", voxels.substr(2));
  const auto cut = read_nifti(folder / "v.hdr", {});
  ASSERT_FALSE(cut);
  EXPECT_EQ(key_of(cut.error().code), "truncated");
  EXPECT_EQ(cut.error().where, "v.img");
  write_text(folder / "v.img", voxels);
  const auto image = read_nifti(folder / "v.hdr", {});
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(value_at(*image, 1, 2, 3), 321.0f);
}

}  // namespace
}  // namespace cusp::test
