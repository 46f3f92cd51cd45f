// A whole attempt on the emulated Falcon in real time: bytes, loop, mirror, recorder, a device that falls silent, proof. The
// ten minutes of the same stand in tests/README.md. Nothing is judged by the clock: progress is waited for.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/replay.h"
#include "ui/session/session_device.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;

DeviceChoice kind(const std::string& key) {
  DeviceChoice out;
  out.kind = key;
  return out;
}

TEST(EmulatedFalconSession, a_device_that_falls_silent_holds_the_attempt_and_the_session_is_stored_whole) {
  const test::Workplace place;
  std::atomic<bool> mute{false};
  SessionDevice device;
  double t = 0;
  const EmulatedHand hand = [&](const Feedback&, double dt_s) noexcept {
    t += std::min(dt_s, 0.004);
    device.emulated->falcon().fall_mute(mute.load());
    const double depth = t < 0.3 ? 1.0 - 3.0 * t : std::max(0.1 - 0.3 * (t - 0.3), -0.6);
    return EmulatedHandPose{{0.5 * std::sin(3.0 * t), 0.6, depth}, t > 0.2, 0};
  };
  auto made = make_session_device(kind("emulated-falcon"), Vec3(0.0, 0.6, 1.0), 2, hand);
  ASSERT_TRUE(made);
  device = std::move(*made);
  auto started = ExerciseSession::start(place.plan(), *device.port);
  ASSERT_TRUE(started) << started.error().where;
  ExerciseSession& session = **started;
  // Somebody resumes whenever the device is there again.
  const auto until = [&session](auto reached) {
    while (!reached(session.view())) {
      const LiveView view = session.view();
      if (view.phase == LoopPhase::held && view.device == Sample::Status::fresh) session.resume();
      std::this_thread::sleep_for(1ms);
    }
  };
  until([](const LiveView& view) { return view.output.tick > 600; });
  mute.store(true);
  until([](const LiveView& view) { return view.phase == LoopPhase::held && view.device == Sample::Status::gone; });
  EXPECT_EQ(session.view().fault, Fault::gone);
  const std::uint64_t held_at = session.view().output.tick;
  mute.store(false);
  until([held_at](const LiveView& view) { return view.output.tick > held_at + 900; });

  const auto result = session.finish();
  ASSERT_TRUE(result) << result.error().where;
  EXPECT_FALSE(result->interrupted);
  EXPECT_EQ(result->device.device_class, "emulated-falcon");
  EXPECT_GE(device.view()->session.silences, 1u);
  double removed = 0;
  for (const Measure& m : result->measures) removed += m.metric == "target_removed" ? m.value : 0.0;
  EXPECT_GT(removed, 0.0);

  const auto store = place.store();
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->volume_equal);
  EXPECT_TRUE(proof->grade_equal);
  EXPECT_FALSE(proof->differs_at_tick);
  EXPECT_EQ(proof->volume_hash, result->volume_hash);
}

TEST(SessionDevice, names_why_there_is_none) {
  EXPECT_EQ(make_session_device(kind("trackball"), Vec3(0.0), 1).error().code, PortError::not_found);
  const auto scripted = make_session_device(kind("scripted"), Vec3(0.0), 1);
  ASSERT_FALSE(scripted);
  EXPECT_EQ(scripted.error().detail, "needs_file");
  const auto file = read_firmware({"/nowhere/firmware.bin", "00"});
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, PortError::bad_file);
  EXPECT_EQ(file.error().detail, "unreadable");
}

TEST(SessionDevice, a_falcon_is_asked_before_its_firmware_file_is_missed) {
  DeviceChoice falcon = kind("falcon");
  falcon.firmware = {"/nowhere/firmware.bin", "00"};
  EXPECT_TRUE(make_session_device(falcon, Vec3(0.0), 1));
}

TEST(SessionDevice, the_mouse_leads_the_emulated_falcon_over_the_place_that_it_shows) {
  auto made = make_session_device(kind("emulated-falcon"), Vec3(0.0, 0.0, 5.0), 1);
  ASSERT_TRUE(made);
  ASSERT_TRUE(made->hand);
  ASSERT_TRUE(made->port->open());
  made->hand->move_to({2.0, 0.0, 2.0});
  Sample sample;
  double best = 1e9;
  for (int i = 0; i < 3000 && best > 0.1; ++i) {
    sample = made->port->wait(std::chrono::steady_clock::now() + 2ms);
    made->port->write({.proxy_mm = sample.position_mm});
    if (sample.status == Sample::Status::fresh) best = std::min(best, std::abs(sample.position_mm.x - 2.0));
  }
  EXPECT_LT(best, 0.1);
  made->port->close();
}

}  // namespace
}  // namespace cusp::test
