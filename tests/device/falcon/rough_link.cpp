#include "tests/device/falcon/rough_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cusp::test {

namespace {

using namespace std::chrono_literals;
using falcon::LinkAsk;
using falcon::LinkEvent;
using falcon::LinkTime;

constexpr std::uint8_t kModem = 0x01, kLine = 0x60, kErrors[] = {0x02, 0x04, 0x08, 0x10};
constexpr LinkTime kDeviceTakes = 170us;  // the line's 107 us and the firmware's 60 us
constexpr std::size_t kTruths = 4096;

}  // namespace

Vec3 RoughLink::grip_at(LinkTime time) {
  // Ever in motion, so that no two answers of some seconds are alike: at most 0.9 m/s.
  const double s = std::chrono::duration<double>(time).count();
  return {0.021 * std::sin(22.1 * s), 0.019 * std::sin(25.7 * s + 1.0), 0.125 + 0.017 * std::sin(29.3 * s + 2.0)};
}

void RoughLink::set_weather(const Weather& weather, LinkTime lasts) {
  weather_ = weather;
  weather_from_ = now_;
  weather_to_ = now_ + lasts;
}

LinkTime RoughLink::way_back() const {
  const double share = std::clamp(std::chrono::duration<double>(now_ - weather_from_) /
                                      std::chrono::duration<double>(std::max<LinkTime>(weather_to_ - weather_from_, 1ns)),
                                  0.0, 1.0);
  return weather_.in +
         LinkTime(static_cast<std::int64_t>(share * static_cast<double>((weather_.in_later - weather_.in).count())));
}

LinkTime RoughLink::settled() const { return std::max({reached_, sent_, came_, device_stands_until_, line_stands_until_}); }

const Truth* RoughLink::truth_of(const std::array<std::int16_t, 3>& words) const {
  // Answers that follow each other at once may have the same words: one that may be used goes before.
  const Truth* out = nullptr;
  for (auto truth = truths_.rbegin(); truth != truths_.rend(); ++truth) {
    if (truth->words != words || truth->sent > now_) continue;
    if (!truth->reported) return &*truth;
    if (out == nullptr) out = &*truth;
  }
  return out;
}

void RoughLink::start(const LinkAsk& ask) noexcept {
  switch (ask.kind) {
    case LinkAsk::Kind::open:
      open_ = true;
      events_.push_back(LinkEvent::Kind::opened);
      break;
    case LinkAsk::Kind::close:
      open_ = false;
      events_.clear();
      packets_in_.clear();
      break;
    case LinkAsk::Kind::control:
      events_.push_back(LinkEvent::Kind::control_done);
      break;
    case LinkAsk::Kind::send: {
      if (!open_ || ask.size != falcon::kFrameBytes) break;
      const auto frame = falcon::decode(std::span<const std::uint8_t, falcon::kFrameBytes>(ask.bytes.data(), ask.size));
      if (!frame) break;
      ++packets_;
      if (on_packet_) on_packet_(frame->words);
      if (!happens(weather_.lost_packet)) answer(*frame);
      break;
    }
  }
}

void RoughLink::answer(const falcon::Frame& asked) {
  reached_ = std::max(reached_, now_ + weather_.out + some(weather_.jitter));
  sent_ = std::max({sent_, reached_, device_stands_until_}) + kDeviceTakes;
  if (happens(weather_.lost_answer)) return;
  const Vec3 grip = grip_at(sent_);
  const Vec3 ticks = falcon::ticks_of_arm_rad({}, {}, falcon::inverse({}, grip)->arm_rad);
  falcon::Frame frame;
  for (int i = 0; i < 3; ++i) frame.words[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(ticks[i]));
  frame.bits = (asked.bits & falcon::control::kHoming) != 0 ? falcon::status::kHomed : 0;
  const auto bytes = falcon::encode(frame);
  std::vector<std::uint8_t> payload(bytes.begin(), bytes.end());
  std::uint8_t line = kLine;
  Truth truth{.sent = sent_, .grip_m = grip};
  if (happens(weather_.reported)) {
    payload[1 + random_() % 12] = static_cast<std::uint8_t>('A' + random_() % 16);
    truth.reported = true;
  }
  truth.reported = truth.reported || happens(weather_.false_alarm);
  if (truth.reported) line |= kErrors[random_() % 4];
  if (!truth.reported && now_ - flipped_ > kFlipsApart && happens(weather_.flipped)) {
    payload[random_() % payload.size()] ^= static_cast<std::uint8_t>(1u << (random_() % 8));
    flipped_ = now_;
  }
  if (const auto got = falcon::decode(std::span<const std::uint8_t, falcon::kFrameBytes>(payload.data(), 16))) {
    truth.words = got->words;
    truths_.push_back(truth);
    if (truths_.size() > kTruths) truths_.pop_front();
  }
  came_ = std::max({came_, sent_ + way_back() + some(weather_.jitter), line_stands_until_});
  if (happens(weather_.cut)) payload.resize(random_() % payload.size());
  deliver(std::move(payload), line, came_);
}

void RoughLink::deliver(std::vector<std::uint8_t> payload, std::uint8_t line, LinkTime at) {
  payload.insert(payload.begin(), held_.begin(), held_.end());
  line |= held_line_;
  held_.clear();
  held_line_ = 0;
  if (payload.size() < 40 && happens(weather_.together)) {
    held_ = std::move(payload);
    held_line_ = line;
    return;
  }
  const auto push = [this](std::span<const std::uint8_t> part, std::uint8_t status, LinkTime when) {
    Packet packet{.at = when, .bytes = {kModem, status}};
    packet.bytes.insert(packet.bytes.end(), part.begin(), part.end());
    packets_in_.push_back(std::move(packet));
  };
  const std::span<const std::uint8_t> all(payload);
  if (happens(weather_.parts) && all.size() > 1) {
    const std::size_t cut = 1 + random_() % (all.size() - 1);
    push(all.first(cut), line, at);
    if (random_() % 2 == 0) push({}, kLine, at);
    came_ = at + some(1500us);
    push(all.subspan(cut), line, came_);
  } else {
    push(all, line, at);
  }
  if (happens(weather_.twice)) {
    came_ += some(2ms);
    push(all, line, came_);
  }
  if (random_() % 8 == 0) push({}, kLine, came_);
}

LinkEvent RoughLink::wait(LinkTime until) noexcept {
  now_ += std::exchange(stall_in_wait_, LinkTime(0));
  if (!events_.empty()) {
    const auto kind = events_.front();
    events_.pop_front();
    return {.kind = kind};
  }
  if (packets_in_.empty() || packets_in_.front().at > std::max(until, now_)) {
    now_ = std::max(now_, until);
    return {};
  }
  now_ = std::max(now_, packets_in_.front().at);
  given_ = std::move(packets_in_.front().bytes);
  packets_in_.pop_front();
  return {.kind = LinkEvent::Kind::received, .bytes = given_};
}

}  // namespace cusp::test
