// The fields of latency rows over a short real time. No figure is judged.
#include "tests/bench/latency.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace cusp::bench {
namespace {

TEST(Latency, ReadsASpreadFromItsHistogram) {
  TimeHistogram times;
  for (int i = 0; i < 995; ++i) times.add_ns(2'000);
  for (int i = 0; i < 5; ++i) times.add_ns(100'000);
  const Spread spread = spread_of(times);
  EXPECT_NEAR(spread.p50, 2.0, 0.11);    // buckets of 0.1 us
  EXPECT_NEAR(spread.p99, 2.0, 0.11);    // 995 of 1000 are
  EXPECT_NEAR(spread.p999, 100.0, 3.2);  // buckets of 3.2 %
  EXPECT_DOUBLE_EQ(spread.max, 100.0);
}

TEST(Latency, TicksOnBothPortsAndAgreesWithTheMirror) {
  for (const char* port : {"clock", "emulated-falcon"}) {
    const LatencyRow row = measure_latency(port, Load::off, 0.3);
    EXPECT_GT(row.ticks, 0u) << port;
    EXPECT_TRUE(row.mirror_equal) << port;
    EXPECT_GT(row.tick_us.max, 0.0) << port;
    EXPECT_LE(row.tick_us.p50, row.tick_us.p99);
    EXPECT_LE(row.late_us.p50, row.late_us.p99);
    EXPECT_LE(row.exchange_us.p50, row.exchange_us.p99);
    EXPECT_GE(row.seconds, 0.3);
  }
}

TEST(Latency, NamesTheLoadInItsJson) {
  LatencyRow quiet, drawn;
  quiet.port = drawn.port = "clock";
  drawn.load = Load::on;
  drawn.frames_per_s = 31.0;
  drawn.grant.level = RealtimeLevel::rtkit;
  const auto json = nlohmann::json::parse(latency_json({quiet, drawn}));
  ASSERT_EQ(json["rows"].size(), 2u);
  EXPECT_EQ(json["rows"][0]["load"], "off");
  EXPECT_FALSE(json["rows"][0].contains("frames_per_s"));
  EXPECT_EQ(json["rows"][1]["load"], "on");
  EXPECT_EQ(json["rows"][1]["realtime"], "rtkit");
  EXPECT_TRUE(json["rows"][1]["exchange_us"].contains("p99"));
  EXPECT_FALSE(json["machine"].get<std::string>().empty());
}

}  // namespace
}  // namespace cusp::bench
