// Whatever bytes and events come: no crash, and no torque before eight answers in a row report three homed arms.
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

/// What a stream is made of: noise, the letters of frames, hellos and echoes, whole frames and fragments of them.
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

struct Counts {
  long forced = 0, packets = 0;
  std::array<long, 14> phases{};
};

/// One session under a stream of random events, and a reading of its own of the bytes: a parser fed with the same.
class Stream {
 public:
  Stream(long number, const FirmwareImage& image, Counts& counts)
      : number_(number), image_(image.bytes()), counts_(counts), random_(static_cast<std::uint32_t>(number)),
        session_({.event_character = random_() % 4 == 0}) {
    if (random_() % 2 == 0) session_.give_image(image);
    mood_ = static_cast<int>(random_() % 3);
    constexpr Phase kFrom[] = {Phase::unplugged, Phase::settling, Phase::probing,   Phase::needs_image, Phase::arming,
                               Phase::greeting,  Phase::locking,  Phase::uploading, Phase::switching};
    lead_to(session_, kFrom[random_() % 9], image_, now_);
  }
  void flow() {
    const int steps = 20 + static_cast<int>(random_() % 40);
    for (int step = 0; step < steps; ++step) {
      const unsigned what = random_() % 64;
      session_.advance(event(what), now_);
      session_.command({4095, -4095, 4095});
      check();
      session_.exchange(now_);
      check();
      ++counts_.phases[static_cast<std::size_t>(session_.phase())];
      const LinkTime next = now_ + std::chrono::microseconds(random_() % (what % 16 == 7 ? 700'000 : 900));
      // Now and then the host polls for a while without an answer.
      for (LinkTime at = now_ + 2ms; at < std::min(next, now_ + 30ms); at += 2ms) session_.advance({}, at);
      check();
      now_ = next;
    }
  }

 private:
  LinkEvent event(unsigned what) {
    LinkEvent out;
    if (what == 0) {
      out.kind = static_cast<LinkEvent::Kind>(random_() % 9);  // anything, out of turn
      if (out.kind == LinkEvent::Kind::received) out.kind = LinkEvent::Kind::time;
    } else if (session_.phase() == Phase::opening && open_) {
      out.kind = LinkEvent::Kind::opened;
      open_ = false;
    } else if (what < 24 && session_.phase() >= Phase::settling && session_.phase() <= Phase::switching) {
      out.kind = LinkEvent::Kind::control_done;
    } else if (what < 56) {
      out = received();
    }
    return out;
  }
  LinkEvent received() {
    std::vector<std::uint8_t> payload;
    while (payload.size() < 1 + random_() % 62) add_bytes(random_, payload, image_, session_.state(), mood_);
    payload.resize(std::min<std::size_t>(payload.size(), kPayloadBytes));
    for (const std::uint8_t byte : payload) {
      const auto frame = parser_.push(byte);
      if (!frame) continue;
      homed_in_a_row_ = (frame->bits & status::kHomed) == status::kHomed ? homed_in_a_row_ + 1 : 0;
    }
    transfer_ = {0x01, static_cast<std::uint8_t>(random_() % 8 == 0 ? random_() : 0x60)};
    transfer_.insert(transfer_.end(), payload.begin(), payload.end());
    ++counts_.packets;
    return {.kind = LinkEvent::Kind::received, .bytes = transfer_};
  }
  void check() {
    while (const auto ask = session_.next_ask()) {
      if (ask->kind == LinkAsk::Kind::open) open_ = true;
      if (ask->kind != LinkAsk::Kind::send || ask->size != kFrameBytes) continue;
      const auto frame = decode(std::span<const std::uint8_t, kFrameBytes>(ask->bytes.data(), kFrameBytes));
      if (!frame || frame->words == std::array<std::int16_t, 3>{}) continue;
      ++counts_.forced;
      ASSERT_EQ(session_.phase(), Phase::ready) << "stream " << number_;
      ASSERT_GE(homed_in_a_row_, 8) << "stream " << number_;
    }
  }

  long number_;
  std::span<const std::uint8_t> image_;
  Counts& counts_;
  std::mt19937 random_;
  Session session_;
  LinkTime now_ = 0ms;
  int homed_in_a_row_ = 0;
  FrameParser parser_;
  int mood_ = 0;
  bool open_ = false;
  std::vector<std::uint8_t> transfer_;  // of the event under way
};

TEST(FalconSession, no_stream_of_bytes_brings_force_before_homing) {
  const char* wanted = std::getenv("CUSP_RANDOM_STREAMS");
  const long streams = wanted != nullptr ? std::strtol(wanted, nullptr, 10) : 20'000;
  const auto image = FirmwareImage::from_bytes(test::boot_image());
  ASSERT_TRUE(image);
  Counts counts;
  for (long stream = 0; stream < streams; ++stream) Stream(stream, *image, counts).flow();
  std::cout << streams << " streams, " << counts.packets << " packets, " << counts.forced << " packets with torque\n";
  for (std::size_t i = 0; i < counts.phases.size(); ++i) {
    std::cout << "  " << key_of(static_cast<Phase>(i)) << ": " << counts.phases[i] << "\n";
  }
  EXPECT_GT(counts.forced, streams / 1000);  // the streams do come as far as torque: the test can fail
  for (std::size_t i = 0; i < counts.phases.size(); ++i) {
    if (static_cast<Phase>(i) == Phase::failed) continue;  // ten attempts are longer than a stream
    EXPECT_GT(counts.phases[i], 0) << key_of(static_cast<Phase>(i));
  }
}

}  // namespace
}  // namespace cusp::device::falcon
