// What an attempt's process keeps, tick by tick.
#include "scenarios/metrics/process.h"

#include <gtest/gtest.h>

#include "engine/step/step.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(Process, WeightsForceByTimeInContactAndTakesItBeforeTheGuard) {
  Process p;
  StepOutput o;
  o.elapsed_us = 1000;
  p.add(o);
  EXPECT_FALSE(p.touched());
  o.contact = true;
  o.force_raw_n = {0, 0, 3};
  o.force_n = {0, 0, 1};
  o.proxy_mm = {1, 2, 3};
  o.elapsed_us = 2000;
  p.add(o);
  o.force_raw_n = {0, 1, 0};
  o.elapsed_us = 5000;
  p.add(o);
  EXPECT_NEAR(p.time_s(), 0.005, 1e-12);
  EXPECT_NEAR(p.force_peak_n(), 3.0, 1e-12);
  EXPECT_NEAR(p.force_mean_n(), (3.0 * 1 + 1.0 * 3) / 4.0, 1e-12);  // over the 4 ms in contact
  EXPECT_EQ(p.peak_at_mm(), Vec3(1, 2, 3));
}

TEST(Process, TakesNoForceWhileTheProxyIsStillOnItsWay) {
  Process p;
  StepOutput o;
  o.contact = true;
  o.force_raw_n = {0, 0, 0.2};
  o.elapsed_us = 1000;
  p.add(o);
  o.deferred = true;  // of the spring's 1 mm at 3 N/mm the proxy is yet to go the most
  o.force_raw_n = {0, 0, 3};
  o.elapsed_us = 3000;
  p.add(o);
  EXPECT_NEAR(p.force_peak_n(), 0.2, 1e-12);
  EXPECT_NEAR(p.force_mean_n(), 0.2, 1e-12);
  EXPECT_NEAR(p.time_s(), 0.003, 1e-12);
}

TEST(Process, CountsDryCuttingAndKnowsWhereTheToothWasWarmest) {
  Process p;
  StepOutput o;
  o.contact = true;
  o.elapsed_us = 1000;
  o.heat_k = 2.0f;
  o.proxy_mm = {1, 0, 0};
  o.phenomena = static_cast<std::uint8_t>(PhenomenonSign::dry);
  p.add(o);
  o.elapsed_us = 4000;
  o.heat_k = 5.6f;
  o.proxy_mm = {2, 0, 0};
  o.phenomena = static_cast<std::uint8_t>(PhenomenonSign::dry) | static_cast<std::uint8_t>(PhenomenonSign::overheated);
  p.add(o);
  o.contact = false;
  o.elapsed_us = 9000;
  o.heat_k = 5.0f;
  o.phenomena = static_cast<std::uint8_t>(PhenomenonSign::coolant);
  p.add(o);
  EXPECT_NEAR(p.dry_s(), 0.004, 1e-12);
  EXPECT_EQ(p.overheated(), 1);
  EXPECT_EQ(p.overheated_at_mm(), Vec3(2, 0, 0));
  EXPECT_NEAR(p.heat_peak_k(), 5.6, 1e-6);
  EXPECT_EQ(p.heat_peak_at_mm(), Vec3(2, 0, 0));
}

TEST(Process, ContinuesFromItsBytesBitForBitAndRefusesAnyOthers) {
  const auto output_at = [](int tick) {
    StepOutput o;
    o.contact = o.cutting = true;
    o.phenomena = 0xFF;
    o.elapsed_us = 1001 * static_cast<std::uint64_t>(tick);
    o.heat_k = 12.5F * static_cast<float>(tick);
    o.force_raw_n = {0.1, -0.2 * tick, 1.0 / 3.0};
    o.proxy_mm = {1.1, 2.2, -3.3 * tick};
    return o;
  };
  Process whole, part;
  for (int tick = 1; tick <= 4; ++tick) whole.add(output_at(tick));
  for (int tick = 1; tick <= 2; ++tick) part.add(output_at(tick));
  const auto bytes = part.save();
  auto again = Process::restore(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->save(), bytes);
  EXPECT_NE(whole.save(), bytes);
  for (int tick = 3; tick <= 4; ++tick) again->add(output_at(tick));
  EXPECT_EQ(again->save(), whole.save());
  EXPECT_EQ(again->force_mean_n(), whole.force_mean_n());
  EXPECT_FALSE(Process::restore({}));
  EXPECT_FALSE(Process::restore(std::span(bytes).first(bytes.size() - 1)));
  auto longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(Process::restore(longer));
  auto not_finite = bytes;
  for (std::size_t i = 32; i < 40; ++i) not_finite[i] = std::byte{0xFF};
  EXPECT_FALSE(Process::restore(not_finite));
}

}  // namespace
}  // namespace cusp::test
