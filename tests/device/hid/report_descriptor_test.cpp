// Expected places and ranges follow from the descriptors' own bytes (HID 1.11, section 6.2.2).
#include "device/hid/report_descriptor.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "device/hid/pedal.h"
#include "tests/device/hid/descriptors.h"

namespace cusp::device::hid {
namespace {

using test::Bytes;

TEST(ReportDescriptor, three_buttons_of_a_foot_pedal_are_the_lowest_bits) {
  const auto parsed = parse_report_descriptor(test::vec_descriptor());
  ASSERT_TRUE(parsed);
  EXPECT_FALSE(parsed->numbered);
  EXPECT_EQ(parsed->bytes[0], 2);
  ASSERT_EQ(parsed->inputs.size(), 3u);
  for (std::uint16_t i = 0; i < 3; ++i) {
    const InputField& field = parsed->inputs[i];
    EXPECT_EQ(field.page, usage::kButtonPage);
    EXPECT_EQ(field.usage, i + 1);
    EXPECT_EQ(field.bit, i);
    EXPECT_EQ(field.bits, 1);
  }
  const Bytes middle = {0x02, 0x00};
  EXPECT_EQ(value_in(parsed->inputs[0], middle), 0);
  EXPECT_EQ(value_in(parsed->inputs[1], middle), 1);
}

TEST(ReportDescriptor, a_keyboard_has_eight_switches_and_a_list_of_six_keys) {
  const auto parsed = parse_report_descriptor(test::keyboard_descriptor());
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->page, usage::kDesktopPage);
  EXPECT_EQ(parsed->usage, usage::kKeyboard);
  EXPECT_EQ(parsed->bytes[0], 8);
  ASSERT_EQ(parsed->inputs.size(), 9u);
  const InputField& keys = parsed->inputs[8];
  EXPECT_TRUE(keys.list);
  EXPECT_EQ(keys.bit, 16u);
  EXPECT_EQ(keys.count, 6);
  EXPECT_EQ(keys.most, 255);  // 25 FF is -1 to the letter
  const Bytes report = {0, 0, 0x68, 0, 0, 0, 0, 0xE1};
  EXPECT_EQ(value_in(keys, report, 0), 0x68);
  EXPECT_EQ(value_in(keys, report, 5), 0xE1);
  EXPECT_EQ(value_in(keys, report, 6), std::nullopt);
}

TEST(ReportDescriptor, axes_lie_across_bytes_and_keep_their_ranges) {
  const auto parsed = parse_report_descriptor(test::rudder_descriptor());
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->bytes[0], 3);
  ASSERT_EQ(parsed->inputs.size(), 3u);
  // rudder 0x155 in bits 0 to 8, X 0x2A in 9 to 15, Y 0x7F in 16 to 22
  const std::uint32_t bits = 0x155u | 0x2Au << 9 | 0x7Fu << 16;
  const Bytes report = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                        static_cast<std::uint8_t>(bits >> 16)};
  EXPECT_EQ(value_in(parsed->inputs[0], report), 0x155);
  EXPECT_EQ(value_in(parsed->inputs[1], report), 0x2A);
  EXPECT_EQ(value_in(parsed->inputs[2], report), 0x7F);
  EXPECT_EQ(parsed->inputs[0].most, 511);
  EXPECT_EQ(parsed->inputs[1].usage, 0x30);
  EXPECT_EQ(parsed->inputs[2].usage, 0x31);
}

TEST(ReportDescriptor, numbered_reports_have_their_own_places_and_signs_are_kept) {
  const auto parsed = parse_report_descriptor(test::signed_axis_descriptor());
  ASSERT_TRUE(parsed);
  EXPECT_TRUE(parsed->numbered);
  EXPECT_EQ(parsed->bytes[4], 2);
  EXPECT_EQ(parsed->bytes[5], 1);
  EXPECT_EQ(parsed->bytes[0], 0);
  ASSERT_EQ(parsed->inputs.size(), 2u);
  EXPECT_EQ(value_in(parsed->inputs[0], Bytes{0x00, 0x80}), -32768);
  EXPECT_EQ(value_in(parsed->inputs[0], Bytes{0xFE, 0xFF}), -2);
  EXPECT_EQ(parsed->inputs[1].bit, 0u);
}

TEST(ReportDescriptor, values_beyond_the_range_and_short_reports_are_none) {
  const auto parsed = parse_report_descriptor(test::space_mouse_descriptor());
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->usage, usage::kMultiAxis);
  const InputField& x = parsed->inputs[0];
  EXPECT_EQ(x.least, -350);
  EXPECT_EQ(x.most, 350);
  EXPECT_EQ(value_in(x, Bytes{0x5E, 0x01}), 350);
  EXPECT_EQ(value_in(x, Bytes{0x5F, 0x01}), std::nullopt);
  EXPECT_EQ(value_in(x, Bytes{0x5E}), std::nullopt);
}

TEST(ReportDescriptor, damage_is_refused_with_its_kind_and_place) {
  const auto code = [](const Bytes& bytes) { return parse_report_descriptor(bytes).error().code; };
  EXPECT_EQ(code({0x05}), DescriptorError::cut_off);
  EXPECT_EQ(code({0xFE, 0x05, 0x00, 1, 2}), DescriptorError::cut_off);                // a long item of five bytes
  EXPECT_EQ(code({0xC0}), DescriptorError::nesting);                                  // closes what nobody opened
  EXPECT_EQ(code({0xA1, 0x01}), DescriptorError::nesting);                            // never closed
  EXPECT_EQ(code({0xB4}), DescriptorError::nesting);                                  // pops what nobody pushed
  EXPECT_EQ(code(Bytes(100, 0xA4)), DescriptorError::nesting);
  EXPECT_EQ(code({0x85, 0x00}), DescriptorError::report_number);
  EXPECT_EQ(code({0x75, 0x21, 0x95, 0x01, 0x81, 0x02}), DescriptorError::size);       // 33 bits
  EXPECT_EQ(code({0x75, 0x01, 0x97, 0xFF, 0xFF, 0xFF, 0xFF, 0x81, 0x02}), DescriptorError::size);
  EXPECT_EQ(parse_report_descriptor(Bytes{0x75, 0x01, 0xC0}).error().at, 2u);
  EXPECT_TRUE(parse_report_descriptor(Bytes{}));  // empty: no fields
}

TEST(ReportDescriptor, every_cut_and_every_changed_byte_of_real_ones_is_parsed_or_refused) {
  int parsed = 0, refused = 0;
  for (const Bytes& whole : {test::vec_descriptor(), test::keyboard_descriptor(), test::rudder_descriptor(),
                             test::signed_axis_descriptor(), test::space_mouse_descriptor()}) {
    for (std::size_t cut = 0; cut < whole.size(); ++cut) {
      const auto result = parse_report_descriptor(std::span(whole).first(cut));
      ++(result ? parsed : refused);
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (int value = 0; value < 256; ++value) {
        Bytes damaged = whole;
        damaged[at] = static_cast<std::uint8_t>(value);
        const auto result = parse_report_descriptor(damaged);
        ++(result ? parsed : refused);
        if (!result) continue;
        PedalState state(*result);
        state.take(Bytes(64, 0xA5));
        static_cast<void>(state.any_switch());
      }
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(parsed, 1000);
}

/// Items of a right form in any order, closed at the end: these get through, and describe what no device would.
void fill_with_items(Bytes& bytes, std::mt19937_64& random) {
  constexpr std::uint8_t kHeads[] = {0x05, 0x09, 0x15, 0x25, 0x26, 0x75, 0x95, 0x81, 0x85, 0x19, 0x29, 0xA4, 0x16, 0x91};
  bytes.assign({0xA1, 0x01, 0x75, 0x08, 0x95, 0x02, 0x25, 0x7F, 0x05, 0x09, 0x19, 0x01});
  for (std::uint64_t left = random() % 12; left > 0; --left) {
    const std::uint8_t head = kHeads[random() % std::size(kHeads)];
    bytes.push_back(head);
    for (int i = 0; i < (head & 3); ++i) bytes.push_back(static_cast<std::uint8_t>(random() % 3 == 0 ? random() : random() % 16));
  }
  bytes.insert(bytes.end(), {0x81, 0x02, 0xC0});
}

TEST(ReportDescriptor, a_million_random_byte_strings_are_parsed_or_refused) {
  const char* asked = std::getenv("CUSP_RANDOM_SEED");
  const std::uint64_t seed = asked != nullptr ? std::strtoull(asked, nullptr, 10) : 7;
  std::mt19937_64 random(seed);
  const Bytes real[] = {test::vec_descriptor(), test::keyboard_descriptor(), test::rudder_descriptor(),
                        test::signed_axis_descriptor(), test::space_mouse_descriptor()};
  Bytes bytes, report(80);
  std::uint64_t parsed = 0, with_fields = 0, taken = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    if (i % 3 == 0) {
      bytes.resize(random() % 64);
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    } else if (i % 3 == 1) {
      fill_with_items(bytes, random);
    } else {
      bytes = real[random() % std::size(real)];
      for (int n = 0; n < 3; ++n) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    }
  const auto result = parse_report_descriptor(bytes);
    if (!result) continue;
    ++parsed;
    if (result->inputs.empty()) continue;
    ++with_fields;
    for (const InputField& field : result->inputs) {
      ASSERT_GE(field.bits, 1) << "seed " << seed << ", string " << i;
      ASSERT_LE(field.bits, 32);
      ASSERT_LE(field.bit + static_cast<std::size_t>(field.count) * field.bits, 8u * result->bytes[field.report]);
    }
    PedalState state(*result);
    for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random());
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, random() % 80}) {
      taken += state.take(std::span(report).first(size));
      for (const Control& control : state.controls()) {
        ASSERT_GE(control.value, control.least);
        ASSERT_LE(control.value, control.most);
      }
    }
  }
  // Far fewer would mean that nothing behind the first bytes was tried.
  EXPECT_GT(parsed, 200'000u);
  EXPECT_GT(with_fields, 200'000u);
  EXPECT_GT(taken, 100'000u);
}

}  // namespace
}  // namespace cusp::device::hid
