#include "device/falcon/protocol.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>
#include <vector>

#include "device/falcon/ftdi.h"

namespace cusp::device::falcon {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

std::vector<Frame> parse(FrameParser& parser, std::span<const std::uint8_t> bytes) {
  std::vector<Frame> out;
  for (const std::uint8_t byte : bytes) {
    if (const auto frame = parser.push(byte)) out.push_back(*frame);
  }
  return out;
}

/// The whole frames of a stream by the plainest reading: at each byte either a frame, or one byte dropped.
std::vector<Frame> plainly(std::span<const std::uint8_t> bytes) {
  std::vector<Frame> out;
  while (bytes.size() >= kFrameBytes) {
    if (const auto frame = decode(bytes.first<kFrameBytes>())) {
      out.push_back(*frame);
      bytes = bytes.subspan(kFrameBytes);
    } else {
      bytes = bytes.subspan(1);
    }
  }
  return out;
}

TEST(FalconFrames, the_worked_packet_reads_minus_1447) {
  // facts 1.8: reply bytes 1-4 "JFKP" are nibbles 9 5 A F, least significant first: 0xFA59.
  FrameParser parser;
  const auto frames = parse(parser, bytes_of("<JFKPAAAAAAAAAA>"));
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].words[0], -1447);
  EXPECT_EQ(frames[0].words[1], 0);
  EXPECT_EQ(frames[0].bits, 0);
}

TEST(FalconFrames, torques_are_written_as_the_maker_s_program_wrote_them) {
  // facts 1.14: a packet whose bytes decode to 2481, -669, -1691. By hand: 2481 = 0x09B1, -669 = 0xFD63,
  // -1691 = 0xF965, nibbles least significant first; control 04 = blue.
  const auto bytes = encode({{2481, -669, -1691}, control::kBlue});
  EXPECT_EQ(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), "<BLJADGNPFGJPEA>");
}

TEST(FalconFrames, every_word_and_every_bit_survive_the_wire) {
  FrameParser parser;
  for (int value = -32768; value <= 32767; ++value) {
    const Frame frame{{static_cast<std::int16_t>(value), static_cast<std::int16_t>(-1 - value), 7},
                      static_cast<std::uint8_t>(value & 0x7F)};
    const auto back = parse(parser, encode(frame));
    ASSERT_EQ(back.size(), 1u) << value;
    ASSERT_EQ(back[0], frame) << value;
  }
  EXPECT_EQ(parser.dropped_bytes(), 0u);
}

TEST(FalconFrames, a_status_byte_beyond_ascii_is_read) {
  const auto bytes = encode({{0, 0, 0}, 0x7F});
  EXPECT_EQ(bytes[13], 0xC0);
  EXPECT_EQ(decode(bytes)->bits, 0x7F);
}

TEST(FalconFrames, a_frame_split_anywhere_is_one_frame) {
  const Frame frame{{-1447, 4095, -4096}, status::kHomed | status::kCentre};
  const auto bytes = encode(frame);
  for (std::size_t cut = 0; cut <= kFrameBytes; ++cut) {
    FrameParser parser;
    auto frames = parse(parser, std::span(bytes).first(cut));
    const auto rest = parse(parser, std::span(bytes).subspan(cut));
    frames.insert(frames.end(), rest.begin(), rest.end());
    ASSERT_EQ(frames, std::vector<Frame>{frame}) << cut;
  }
}

TEST(FalconFrames, a_fragment_of_14_bytes_is_no_frame_and_hides_none) {
  // Taken for a frame, such a fragment reads as "all homed, four buttons".
  const Frame frame{{1, 2, 3}, status::kHomed1};
  const auto bytes = encode(frame);
  for (std::size_t lost = 1; lost < kFrameBytes; ++lost) {
    std::vector<std::uint8_t> stream(bytes.begin(), bytes.end() - static_cast<std::ptrdiff_t>(lost));  // tail lost
    stream.insert(stream.end(), bytes.begin(), bytes.end());
    FrameParser tail_lost;
    EXPECT_EQ(parse(tail_lost, stream), std::vector<Frame>{frame}) << lost;
    stream.assign(bytes.begin() + static_cast<std::ptrdiff_t>(lost), bytes.end());  // head lost
    stream.insert(stream.end(), bytes.begin(), bytes.end());
    FrameParser head_lost;
    EXPECT_EQ(parse(head_lost, stream), std::vector<Frame>{frame}) << lost;
    EXPECT_EQ(head_lost.dropped_bytes(), kFrameBytes - lost);
  }
}

TEST(FalconFrames, one_wrong_byte_spoils_one_frame_only) {
  const Frame good{{10, 20, 30}, 5};
  const auto bytes = encode(good);
  for (std::size_t at = 0; at < kFrameBytes; ++at) {
    std::vector<std::uint8_t> stream(bytes.begin(), bytes.end());
    stream[at] = 0x00;
    stream.insert(stream.end(), bytes.begin(), bytes.end());
    FrameParser parser;
    EXPECT_EQ(parse(parser, stream), std::vector<Frame>{good}) << at;
  }
}

TEST(FalconFrames, nothing_begun_survives_a_reset) {
  const auto bytes = encode({{1, 2, 3}, 0});
  FrameParser parser;
  parse(parser, std::span(bytes).first(9));
  parser.reset();
  EXPECT_TRUE(parse(parser, std::span(bytes).subspan(9)).empty());
}

TEST(FalconFrames, random_bytes_give_what_the_plainest_reading_gives) {
  std::mt19937 random(20261120);
  std::uint64_t frames = 0;
  for (int round = 0; round < 20000; ++round) {
    // Bytes that frames are made of are common, and so are whole and cut frames: noise alone would never make one.
    std::vector<std::uint8_t> stream;
    while (stream.size() < 120) {
      switch (random() % 4) {
        case 0:
          stream.push_back(static_cast<std::uint8_t>(random()));
          break;
        case 1:
          stream.push_back("<>ABPQ@"[random() % 7]);
          break;
        default: {
          Frame frame;
          for (auto& word : frame.words) word = static_cast<std::int16_t>(random());
          frame.bits = random() & 0x7F;
          const auto bytes = encode(frame);
          stream.insert(stream.end(), bytes.begin(), bytes.begin() + (random() % 3 == 0 ? random() % 17 : 16));
        }
      }
    }
    FrameParser parser;
    const auto found = parse(parser, stream);
    ASSERT_EQ(found, plainly(stream)) << "round " << round;
    frames += found.size();
  }
  EXPECT_GT(frames, 20000u);
}

TEST(FalconLine, speeds_follow_from_the_divisors) {
  EXPECT_DOUBLE_EQ(baud_of(ftdi::kBaudHello.value), 9600.0);     // 3,000,000 / 312.5
  EXPECT_NEAR(baud_of(ftdi::kBaudUpload.value), 142857.0, 0.5);  // 3,000,000 / 21
  EXPECT_DOUBLE_EQ(baud_of(ftdi::kBaudRun.value), 1500000.0);    // 3,000,000 / 2
  EXPECT_EQ(baud_of(0), 0.0);
}

TEST(FalconLine, status_bytes_are_taken_off_each_packet_not_each_transfer) {
  std::vector<std::uint8_t> transfer;
  std::vector<std::uint8_t> sent;
  for (int packet = 0; packet < 3; ++packet) {
    transfer.push_back(0x01);
    transfer.push_back(packet == 1 ? 0x6A : 0x60);  // the second with overrun (1) and framing (3)
    for (int i = 0; i < (packet == 2 ? 5 : 62); ++i) {
      sent.push_back(static_cast<std::uint8_t>(packet * 62 + i));
      transfer.push_back(sent.back());
    }
  }
  LineErrors errors;
  std::vector<std::uint8_t> got;
  strip_status(transfer, errors, [&got](std::span<const std::uint8_t> payload) {
    got.insert(got.end(), payload.begin(), payload.end());
  });
  EXPECT_EQ(got, sent);
  EXPECT_EQ(errors.overrun, 1u);
  EXPECT_EQ(errors.framing, 1u);
  EXPECT_EQ(errors.parity + errors.broken + errors.short_packets, 0u);
}

TEST(FalconLine, a_packet_of_status_alone_carries_nothing) {
  LineErrors errors;
  int calls = 0;
  const std::uint8_t idle[] = {0x01, 0x60};
  strip_status(idle, errors, [&calls](std::span<const std::uint8_t>) { ++calls; });
  strip_status({}, errors, [&calls](std::span<const std::uint8_t>) { ++calls; });
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(errors.short_packets, 0u);
}

TEST(FalconLine, a_packet_of_one_byte_is_counted_and_not_read_beyond) {
  // On the heap and of exactly that size: ASan reports a read of the second status byte.
  for (const std::size_t whole_packets : {0u, 1u, 2u}) {
    std::vector<std::uint8_t> transfer(whole_packets * kPacketBytes + 1, 0x60);
    transfer.shrink_to_fit();
    LineErrors errors;
    std::size_t calls = 0;
    strip_status(transfer, errors, [&calls](std::span<const std::uint8_t>) { ++calls; });
    EXPECT_EQ(calls, whole_packets);
    EXPECT_EQ(errors.short_packets, 1u);
    EXPECT_EQ(errors.spoilt(), 0u);
  }
}

}  // namespace
}  // namespace cusp::device::falcon
