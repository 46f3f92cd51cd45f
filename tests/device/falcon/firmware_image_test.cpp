#include "device/falcon/firmware_image.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/device/falcon/images.h"

namespace cusp::device::falcon {
namespace {

using test::boot_image;

ImageError error_of(std::vector<std::uint8_t> bytes) {
  const auto image = FirmwareImage::from_bytes(std::move(bytes));
  EXPECT_FALSE(image);
  return image ? ImageError::unreadable : image.error().code;
}

TEST(FirmwareImage, a_sound_image_is_taken) {
  const auto bytes = boot_image({100, 1500, 900});
  const auto image = FirmwareImage::from_bytes(bytes);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->blocks(), 3);
  EXPECT_EQ(image->entry(), 0x3F8002u);
  EXPECT_EQ(image->bytes().size(), 2u * (1 + 8 + 2 + 3 * 3 + 2500 + 1));
  EXPECT_EQ(image->sha256().size(), 64u);
  EXPECT_TRUE(image->known_as().empty());
}

TEST(FirmwareImage, another_image_has_another_hash) {
  const auto one = FirmwareImage::from_bytes(boot_image({2500}));
  const auto two = FirmwareImage::from_bytes(boot_image({2501}));
  ASSERT_TRUE(one && two);
  EXPECT_NE(one->sha256(), two->sha256());
}

TEST(FirmwareImage, is_refused_wherever_it_is_cut) {
  const auto whole = boot_image();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto cut = FirmwareImage::from_bytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    ASSERT_FALSE(cut) << size;
    const ImageError code = cut.error().code;
    ASSERT_EQ(code, size < FirmwareImage::kMinBytes ? ImageError::too_small
                    : size % 2 != 0                 ? ImageError::odd_size
                                                    : ImageError::truncated)
        << size;
  }
}

TEST(FirmwareImage, what_is_not_one_is_refused_with_its_reason) {
  auto bytes = boot_image();
  bytes[0] = 0x55;
  EXPECT_EQ(error_of(bytes), ImageError::not_a_boot_image);
  bytes = boot_image();
  bytes[9] = 1;
  EXPECT_EQ(error_of(bytes), ImageError::not_a_boot_image);
  bytes = boot_image();
  bytes.resize(bytes.size() + 2);
  EXPECT_EQ(error_of(bytes), ImageError::trailing_bytes);
  bytes = boot_image();
  bytes[24] = 0x40;  // the first block's destination, high word: 0x0040xxxx
  EXPECT_EQ(error_of(bytes), ImageError::bad_address);
  bytes = boot_image();
  bytes[18] = 0x40;  // the entry point
  EXPECT_EQ(error_of(bytes), ImageError::bad_address);
  EXPECT_EQ(error_of(std::vector<std::uint8_t>(6000, 0xFF)), ImageError::not_a_boot_image);
  EXPECT_EQ(error_of(boot_image({19000})), ImageError::too_large);
  EXPECT_EQ(error_of(boot_image({4})), ImageError::too_small);
}

TEST(FirmwareImage, reads_a_file_and_names_it_when_it_is_no_good) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "cusp-falcon-images";
  std::filesystem::create_directories(folder);
  const auto file = folder / "image.bin";
  const auto bytes = boot_image();
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  EXPECT_TRUE(FirmwareImage::from_file(file));
  std::ofstream(file, std::ios::binary) << "no image";
  const auto bad = FirmwareImage::from_file(file);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().where, file.string());
  EXPECT_EQ(FirmwareImage::from_file(folder / "none.bin").error().code, ImageError::unreadable);
  EXPECT_EQ(FirmwareImage::from_file(folder).error().code, ImageError::unreadable);
  std::filesystem::remove_all(folder);
}

TEST(FirmwareImage, a_disk_that_fails_while_it_is_read_is_unreadable) {
  // Of this process: reading at address 0 fails with EIO.
  EXPECT_EQ(FirmwareImage::from_file("/proc/self/mem").error().code, ImageError::unreadable);
}

}  // namespace
}  // namespace cusp::device::falcon
