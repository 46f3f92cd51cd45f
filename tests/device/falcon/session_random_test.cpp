// Whatever bytes and events come: no crash, and no torque before eight answers in a row told of three homed arms.
// CUSP_RANDOM_STREAMS=1000000 for the whole million; ./check runs the first 20,000.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

#include "device/falcon/session.h"
#include "tests/device/falcon/images.h"

namespace cusp::device::falcon {
namespace {

using namespace std::chrono_literals;

/// What a stream is made of: noise, the letters of frames, hellos and echoes, whole frames and pieces of them.
void add_bytes(std::mt19937& random, std::vector<std::uint8_t>& out, std::span<const std::uint8_t> image,
               const SessionState& state, int mood) {
  switch (random() % 8) {
    case 0:
      out.push_back(static_cast<std::uint8_t>(random()));
      break;
    case 1:
      out.push_back(static_cast<std::uint8_t>("<>APQ@\r\n"[random() % 8]));
      break;
    case 2:
      for (const char c : {'\n', 'D', ',', '\r'}) out.push_back(static_cast<std::uint8_t>(c));
      break;
    case 3:
      for (std::size_t i = 0; i < 20 && state.uploaded + i < image.size(); ++i)
        out.push_back(image[state.uploaded + i]);
      break;
    default: {
      Frame frame;
      for (auto& word : frame.words) word = static_cast<std::int16_t>(random());
      frame.bits = static_cast<std::uint8_t>(random() & 0x7F);
      if (mood == 0) frame.bits |= status::kHomed;  // a stream that means well, so that torque does come about
      const auto bytes = encode(frame);
      const std::size_t size = mood == 0 || random() % 3 != 0 ? bytes.size() : random() % (bytes.size() + 1);
      out.insert(out.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    }
  }
}

/// Goes the straight way to a phase that random bytes alone would seldom come to.
void lead_to(Session& session, Phase phase, std::span<const std::uint8_t> image, LinkTime& now) {
  const std::uint8_t hello[] = {0x01, 0x60, 0x0A, 0x44, 0x2C, 0x0D}, lock[] = {0x01, 0x60, 0x41};
  for (int i = 0; i < 200 && session.phase() != phase; ++i) {
    LinkEvent event;
    const Phase at = session.phase();
    if (at == Phase::opening) event.kind = LinkEvent::Kind::opened;
    if (at == Phase::settling || at == Phase::arming || at == Phase::locking)
      event.kind = LinkEvent::Kind::control_done;
    if (at == Phase::greeting) event = {.kind = LinkEvent::Kind::received, .bytes = hello};
    if (at == Phase::locking && i % 4 == 3) event = {.kind = LinkEvent::Kind::received, .bytes = lock};
    std::array<std::uint8_t, kPacketBytes> echo = {0x01, 0x60};
    if (at == Phase::uploading) {
      const auto left = image.subspan(session.state().uploaded);
      const auto chunk = left.first(std::min(left.size(), kPayloadBytes));
      std::copy(chunk.begin(), chunk.end(), echo.begin() + 2);
      event = {.kind = LinkEvent::Kind::received, .bytes = std::span(echo).first(2 + chunk.size())};
    }
    while (session.next_ask()) continue;
    if (at == Phase::probing || at == Phase::unplugged || at == Phase::needs_image) now = std::max(now, session.due());
    session.advance(event, now);
  }
}

TEST(FalconSession, no_stream_of_bytes_brings_force_before_homing) {
  const char* wanted = std::getenv("CUSP_RANDOM_STREAMS");
  const long streams = wanted != nullptr ? std::strtol(wanted, nullptr, 10) : 20'000;
  const auto made = FirmwareImage::from_bytes(test::boot_image());
  ASSERT_TRUE(made);
  const auto image = made->bytes();
  long forced = 0, packets = 0;
  std::array<long, 14> phases{};
  for (long stream = 0; stream < streams; ++stream) {
    std::mt19937 random(static_cast<std::uint32_t>(stream));
    Session session({.event_character = random() % 4 == 0});
    if (random() % 2 == 0) session.give_image(*made);
    LinkTime now = 0ms;
    int homed_in_a_row = 0;  // by a reading of its own: a parser fed with the same bytes
    FrameParser parser;
    const int mood = static_cast<int>(random() % 3);
    bool open = false;
    constexpr Phase kFrom[] = {Phase::unplugged, Phase::settling, Phase::probing,   Phase::needs_image, Phase::arming,
                               Phase::greeting,  Phase::locking,  Phase::uploading, Phase::switching};
    lead_to(session, kFrom[random() % 9], image, now);
    const auto look = [&] {
      while (const auto ask = session.next_ask()) {
        if (ask->kind == LinkAsk::Kind::open) open = true;
        if (ask->kind != LinkAsk::Kind::send || ask->size != kFrameBytes) continue;
        const auto frame = decode(std::span<const std::uint8_t, kFrameBytes>(ask->bytes.data(), kFrameBytes));
        if (!frame || frame->words == std::array<std::int16_t, 3>{}) continue;
        ++forced;
        ASSERT_EQ(session.phase(), Phase::ready) << "stream " << stream;
        ASSERT_GE(homed_in_a_row, 8) << "stream " << stream;
      }
    };
    const int steps = 20 + static_cast<int>(random() % 40);
    for (int step = 0; step < steps; ++step) {
      LinkEvent event;
      std::vector<std::uint8_t> transfer;
      const unsigned what = random() % 64;
      if (what == 0) {
        event.kind = static_cast<LinkEvent::Kind>(random() % 9);  // anything, out of turn
        if (event.kind == LinkEvent::Kind::received) event.kind = LinkEvent::Kind::time;
      } else if (session.phase() == Phase::opening && open) {
        event.kind = LinkEvent::Kind::opened;
        open = false;
      } else if (what < 24 && session.phase() >= Phase::settling && session.phase() <= Phase::switching) {
        event.kind = LinkEvent::Kind::control_done;
      } else if (what < 56) {
        std::vector<std::uint8_t> payload;
        while (payload.size() < 1 + random() % 62) add_bytes(random, payload, image, session.state(), mood);
        payload.resize(std::min<std::size_t>(payload.size(), kPayloadBytes));
        for (const std::uint8_t byte : payload) {
          const auto frame = parser.push(byte);
          if (!frame) continue;
          homed_in_a_row = (frame->bits & status::kHomed) == status::kHomed ? homed_in_a_row + 1 : 0;
        }
        transfer = {0x01, static_cast<std::uint8_t>(random() % 8 == 0 ? random() : 0x60)};
        transfer.insert(transfer.end(), payload.begin(), payload.end());
        event = {.kind = LinkEvent::Kind::received, .bytes = transfer};
        ++packets;
      }
      session.advance(event, now);
      session.command({4095, -4095, 4095});
      look();
      session.exchange(now);
      look();
      ++phases[static_cast<std::size_t>(session.phase())];
      const LinkTime next = now + std::chrono::microseconds(random() % (what % 16 == 7 ? 700'000 : 900));
      // Now and then the host goes on looking, and hears nothing for a while.
      for (LinkTime at = now + 2ms; at < std::min(next, now + 30ms); at += 2ms) session.advance({}, at);
      look();
      now = next;
    }
  }
  std::cout << streams << " streams, " << packets << " packets, " << forced << " packets with torque\n";
  for (std::size_t i = 0; i < phases.size(); ++i) {
    std::cout << "  " << key_of(static_cast<Phase>(i)) << ": " << phases[i] << "\n";
  }
  EXPECT_GT(forced, streams / 1000);  // the streams do come as far as torque: the test can fail
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (static_cast<Phase>(i) == Phase::failed) continue;  // ten attempts are longer than a stream
    EXPECT_GT(phases[i], 0) << key_of(static_cast<Phase>(i));
  }
}

}  // namespace
}  // namespace cusp::device::falcon
