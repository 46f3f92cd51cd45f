// What the speaker's thread reads of the drilling sound.
#include "tests/modules.h"
#include "ui/sound/drill_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace cusp::test {
namespace {

constexpr int kRate = 48000, kChannels = 2;
/// 20 ms, as PulseAudio asks for it.
using Period = std::array<qint16, std::size_t{kRate} / 50 * kChannels>;

Period next_of(DrillSource& source) {
  Period out{};
  const auto bytes = static_cast<qint64>(sizeof out);
  EXPECT_EQ(source.read(reinterpret_cast<char*>(out.data()), bytes), bytes);
  return out;
}
bool silent(const Period& period) {
  return std::ranges::all_of(period, [](qint16 sample) { return sample == 0; });
}

TEST(DrillSource, SoundsInTheNextReadAsWhatWasHeardLast) {
  DrillSource source(kRate, kChannels);
  EXPECT_TRUE(silent(next_of(source)));
  source.heard().write({.turns_per_s = 1000.0, .speed_share = 1.0});
  const Period turning = next_of(source);
  EXPECT_FALSE(silent(turning)) << "what was read before was rendered ahead";
  for (std::size_t i = 0; i < turning.size(); i += kChannels) EXPECT_EQ(turning[i], turning[i + 1]) << i;
}

}  // namespace
}  // namespace cusp::test
