/// A Falcon that is homed and answers, at the end of a line that does what no line should: delays that change, stalls on
/// either side, packets that come twice, in parts or together, errors that the line reports and errors that it does
/// not. It knows of every answer when the device sent it and where the grip was. Its time stands until somebody waits.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <vector>

#include "device/falcon/kinematics.h"
#include "device/falcon/link.h"
#include "device/falcon/protocol.h"
#include "tests/modules.h"

namespace cusp::test {

/// What the line does for a while. Chances are those of one packet.
struct Weather {
  falcon::LinkTime out{100'000}, in{130'000};  // ways there and back
  falcon::LinkTime in_later{130'000};          // at the end of the spell; between, it drifts
  falcon::LinkTime jitter{50'000};             // at most so much more, each way
  double lost_packet = 0, lost_answer = 0, twice = 0, together = 0, parts = 0, cut = 0;
  double reported = 0;     // a letter of the answer is another letter, and the line status reports it
  double false_alarm = 0;  // the line status reports an error, and nothing is wrong
  double flipped = 0;      // a bit is flipped, and nothing reports it; not within kFlipsApart
};

/// An answer as the device meant it and as it was delivered.
struct Truth {
  std::array<std::int16_t, 3> words{};  // delivered
  falcon::LinkTime sent{0};             // by the device
  Vec3 grip_m{0.0};                     // then
  bool reported = false;                // an error stands beside it
};

class RoughLink final : public falcon::FalconLink {
 public:
  explicit RoughLink(std::uint64_t seed) : random_(seed) {}

  falcon::LinkTime now() const noexcept override { return now_; }
  void start(const falcon::LinkAsk& ask) noexcept override;
  falcon::LinkEvent wait(falcon::LinkTime until) noexcept override;
  std::string name() const override { return "rough"; }

  void set_weather(const Weather& weather, falcon::LinkTime lasts);
  /// The host does something else.
  void stall_host(falcon::LinkTime time) { now_ += time; }
  void stall_host_in_wait(falcon::LinkTime time) { stall_in_wait_ = time; }
  void stall_device(falcon::LinkTime time) { device_stands_until_ = now_ + time; }
  void stall_line(falcon::LinkTime time) { line_stands_until_ = now_ + time; }
  /// When the last of what is under way has come.
  falcon::LinkTime settled() const;
  /// The newest answer that was delivered with these words.
  const Truth* truth_of(const std::array<std::int16_t, 3>& words) const;
  /// Called for each packet with its torque.
  void on_packet(std::function<void(const std::array<std::int16_t, 3>&)> f) { on_packet_ = std::move(f); }
  std::uint64_t packets() const { return packets_; }

 private:
  static constexpr falcon::LinkTime kFlipsApart = std::chrono::milliseconds(25);
  struct Packet {
    falcon::LinkTime at{0};
    std::vector<std::uint8_t> bytes;
  };
  bool happens(double chance) { return chance > 0 && unit_(random_) < chance; }
  falcon::LinkTime some(falcon::LinkTime most) {
    return falcon::LinkTime(static_cast<std::int64_t>(unit_(random_) * static_cast<double>(most.count())));
  }
  falcon::LinkTime way_back() const;
  static Vec3 grip_at(falcon::LinkTime time);
  void answer(const falcon::Frame& asked);
  void deliver(std::vector<std::uint8_t> payload, std::uint8_t line, falcon::LinkTime at);

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
  falcon::LinkTime now_{0}, weather_from_{0}, weather_to_{0};
  falcon::LinkTime device_stands_until_{0}, line_stands_until_{0}, stall_in_wait_{0};
  falcon::LinkTime reached_{0}, sent_{0}, came_{0}, flipped_{0};
  Weather weather_;
  bool open_ = false;
  std::deque<falcon::LinkEvent::Kind> events_;
  std::deque<Packet> packets_in_;
  std::vector<std::uint8_t> held_, given_;
  std::uint8_t held_line_ = 0;
  std::deque<Truth> truths_;
  std::function<void(const std::array<std::int16_t, 3>&)> on_packet_;
  std::uint64_t packets_ = 0;
};

}  // namespace cusp::test
