#include <gtest/gtest.h>
#include <sodium.h>

#include <limits>
#include <random>

#include "storage/records/trace_codec.h"
#include "tests/modules.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

using test::code_of;
using test::must;

/// Any value of any field, the extremes often.
template <class T>
T any(std::mt19937_64& random) {
  switch (random() % 4) {
    case 0:
      return std::numeric_limits<T>::min();
    case 1:
      return std::numeric_limits<T>::max();
    default:
      return static_cast<T>(random());
  }
}

StepInput any_input(std::mt19937_64& random) {
  StepInput in;
  in.x = any<std::int32_t>(random);
  in.y = any<std::int32_t>(random);
  in.z = any<std::int32_t>(random);
  in.qx = any<std::int16_t>(random);
  in.qy = any<std::int16_t>(random);
  in.qz = any<std::int16_t>(random);
  in.qw = any<std::int16_t>(random);
  in.buttons = any<std::uint16_t>(random);
  in.pedal = any<std::uint16_t>(random);
  in.bur = any<std::uint16_t>(random);
  in.fragment = any<std::uint16_t>(random);
  in.elapsed_us = any<std::uint32_t>(random);
  return in;
}

/// A hand's movement at 1 kHz: 0.1 µm steps of a slow wander with tremor.
std::vector<StepInput> movement(std::mt19937_64& random, std::size_t count) {
  std::vector<StepInput> inputs(count);
  double x = 0, v = 0;
  for (std::size_t i = 0; i < count; ++i) {
    v += std::normal_distribution<double>(0.0, 0.4)(random);
    x += v;
    inputs[i].x = static_cast<std::int32_t>(x);
    inputs[i].z = static_cast<std::int32_t>(40'000 - x / 3);
    inputs[i].buttons = StepInput::kCut;
    inputs[i].elapsed_us = 1000 + static_cast<std::uint32_t>(random() % 3);
  }
  return inputs;
}

TEST(TraceCodec, any_inputs_come_back_as_they_were) {
  const std::uint64_t seed = 20261120;
  RecordProperty("seed", std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int round = 0; round < 300; ++round) {
    std::vector<StepInput> inputs(random() % 200);
    for (StepInput& input : inputs) input = any_input(random);
    EXPECT_EQ(must(decode_trace(encode_trace(inputs))), inputs) << "round " << round << ", seed " << seed;
  }
}

TEST(TraceCodec, no_inputs_come_back_as_none) { EXPECT_TRUE(must(decode_trace(encode_trace({}))).empty()); }

TEST(TraceCodec, the_longest_chunk_comes_back) {
  std::mt19937_64 random(1);
  const auto inputs = movement(random, kMostInputsPerChunk);
  EXPECT_EQ(must(decode_trace(encode_trace(inputs))), inputs);
}

TEST(TraceCodec, a_second_of_a_hand_takes_a_tenth_of_its_32_bytes_an_input) {
  std::mt19937_64 random(2);
  const auto bytes = encode_trace(movement(random, 1000));
  RecordProperty("bytes", static_cast<int>(bytes.size()));
  EXPECT_LT(bytes.size(), 3200u);  // measured: 2,056 of 32,000
}

TEST(TraceCodec, one_changed_bit_anywhere_is_refused) {
  std::mt19937_64 random(3);
  const auto good = encode_trace(movement(random, 50));
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      auto bad = good;
      bad[at] ^= static_cast<std::byte>(1 << bit);
      EXPECT_EQ(code_of(decode_trace(bad)), StorageError::bad_trace) << "byte " << at << " bit " << bit;
    }
  }
}

TEST(TraceCodec, cut_off_or_lengthened_bytes_are_refused) {
  std::mt19937_64 random(4);
  const auto good = encode_trace(movement(random, 50));
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_EQ(code_of(decode_trace(std::span{good}.first(size))), StorageError::bad_trace) << size;
  }
  auto longer = good;
  longer.push_back(std::byte{0});
  EXPECT_EQ(code_of(decode_trace(longer)), StorageError::bad_trace);
}

TEST(TraceCodec, random_bytes_are_refused) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::byte> bytes(random() % 300);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    EXPECT_FALSE(decode_trace(bytes)) << round;
    EXPECT_FALSE(unpack(bytes)) << round;
  }
}

/// Content under a seal that is right, as only a forger makes it: the seal is BLAKE2b of 16 bytes, the format 1.
std::vector<std::byte> sealed(const std::vector<std::byte>& content) {
  std::vector<std::byte> body = pack(content), out(16);
  body.insert(body.begin(), std::byte{1});
  crypto_generichash(reinterpret_cast<unsigned char*>(out.data()), out.size(), reinterpret_cast<const unsigned char*>(body.data()),
                     body.size(), nullptr, 0);
  out.insert(out.end(), body.begin(), body.end());
  return out;
}

TEST(TraceCodec, forged_content_under_a_right_seal_is_refused) {
  const std::byte zero{0}, goes_on{0x80};
  std::vector<std::byte> one(13, zero);  // an input of twelve fields
  one[0] = std::byte{1};
  EXPECT_EQ(must(decode_trace(sealed(one))).size(), 1u);
  std::vector<std::byte> endless = one;
  endless.back() = goes_on;
  EXPECT_EQ(code_of(decode_trace(sealed(endless))), StorageError::bad_trace);
  EXPECT_EQ(code_of(decode_trace(sealed(std::vector<std::byte>(3, goes_on)))), StorageError::bad_trace);
  EXPECT_EQ(code_of(decode_trace(sealed({}))), StorageError::bad_trace);
  std::vector<std::byte> huge(9, std::byte{0xFF});  // x is the least of 64 bits
  huge.insert(huge.begin(), std::byte{1});
  huge.resize(huge.size() + 12);
  huge[10] = std::byte{1};
  EXPECT_EQ(code_of(decode_trace(sealed(huge))), StorageError::bad_trace);
}

TEST(Packing, bytes_come_back_and_a_changed_content_is_refused) {
  std::mt19937_64 random(6);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{5000}, std::size_t{300000}}) {
    std::vector<std::byte> bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() % 17);
    const auto packed = pack(bytes);
    EXPECT_EQ(must(unpack(packed)), bytes);
    auto bad = packed;
    bad.back() ^= std::byte{1};  // the checksum stands last
    EXPECT_EQ(code_of(unpack(bad)), StorageError::bad_trace);
    bad = packed;
    bad.insert(bad.end(), packed.begin(), packed.end());  // two frames
    EXPECT_EQ(code_of(unpack(bad)), StorageError::bad_trace);
  }
}

}  // namespace
}  // namespace cusp::test
