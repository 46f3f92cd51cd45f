// A foot pedal drives the handpiece of an attempt, and one that was lost is up: read over HID devices in memory.
#include <gtest/gtest.h>

#include "device/hid/pedal_reader.h"
#include "tests/device/hid/desk.h"
#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

using test::eventually;
using test::Workplace;
using test::Desk;

/// Presses the bur into the block and never cuts by itself.
class PressingPort final : public HapticPort {
 public:
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    std::this_thread::sleep_until(deadline);
    Sample sample;
    sample.status = Sample::Status::fresh;
    sample.position_mm = {0.0, 0.6, 0.7 - std::min(0.0004 * static_cast<double>(ticks_++), 0.6)};
    return sample;
  }
  void write(const Feedback&) noexcept override {}
  DeviceLimits limits() const override {
    DeviceLimits limits;
    limits.device_class = "scripted";
    return limits;
  }
  void close() noexcept override {}

 private:
  std::uint64_t ticks_ = 0;
};

TEST(Pedal, DrivesTheHandpieceAndUnpluggedItIsUp) {
  Desk desk;
  auto plugged = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  auto pedal = std::make_shared<hid::PedalReader>(test::bus_of(desk));
  pedal->start();
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.pedal = pedal;
  PressingPort port;
  auto started = ExerciseSession::start(plan, port);
  ASSERT_TRUE(started) << key_of(started.error().code) << ' ' << started.error().where;
  ASSERT_TRUE(eventually([&] { return (*started)->view().output.contact; }));
  const auto removed = [&] { return (*started)->view().removed_mm3[index_of(Tissue::plastic)]; };
  EXPECT_EQ(removed(), 0.0);  // pressed, but nobody stands on the pedal
  desk.send(plugged, {0x01, 0x00});
  ASSERT_TRUE(eventually([&] { return (*started)->view().output.cutting && removed() > 0.0; }));
  desk.unplug(plugged);
  EXPECT_TRUE(eventually([&] { return !(*started)->view().output.cutting; }));
  const auto result = (*started)->finish();
  ASSERT_TRUE(result) << key_of(result.error().code);
  started->reset();
  // The record has the pedal: the replay drills the same.
  const auto store = work.store();
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->holds());
}

}  // namespace
}  // namespace cusp::test
