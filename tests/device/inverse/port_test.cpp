// The whole port over a real WebSocket to a service in miniature. What is waited for is progress, never time.
#include "device/inverse/inverse_port.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numbers>
#include <thread>
#include <utility>

#include "device/catalogue.h"
#include "device/inverse/service_probe.h"
#include "engine/loop/tick.h"
#include "tests/device/inverse/fake_service.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using test::FakeService;

InverseSettings settings_for(const FakeService& service) {
  InverseSettings settings;
  settings.service.port = service.port();
  settings.scale = 1.0;
  settings.origin_mm = {1, 2, 3};
  // A loaded test machine must not be taken for a silent service.
  settings.session.answer = 2s;
  settings.session.stale_force = 2s;
  settings.session.give_up = 10s;
  settings.session.ramp = 20ms;
  settings.session.pause = 20ms;
  return settings;
}

Sample tick(InversePort& port, Vec3 force_n = Vec3(0.0)) {
  const Sample sample = port.wait(std::chrono::steady_clock::now() + 20ms);
  port.write({.force_n = force_n});
  return sample;
}

template <class Condition>
bool eventually(InversePort& port, Condition&& condition, Vec3 force_n = Vec3(0.0)) {
  for (int i = 0; i < 3000; ++i) {
    if (condition(tick(port, force_n))) return true;
  }
  return false;
}

bool close_to(Vec3 a, Vec3 b) { return glm::length(a - b) < 1e-6; }

TEST(InversePort, it_may_be_looked_at_while_it_is_opened) {
  FakeService service;
  auto port = make_inverse_port(settings_for(service));
  std::atomic<bool> looked{false}, opened{false};
  std::jthread window([&] {
    while (!opened) {
      static_cast<void>(port->view());
      looked = true;
    }
  });
  while (!looked) std::this_thread::yield();
  EXPECT_TRUE(port->open());
  opened = true;
}

TEST(InversePort, follows_the_hand_and_gives_it_force) {
  FakeService service;
  service.set_hand({0.05, -0.1, 0.2});
  auto port = make_inverse_port(settings_for(service));
  ASSERT_TRUE(port->open());
  // Where the hand is when it is opened is the origin.
  ASSERT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::fresh && close_to(s.position_mm, {1, 2, 3}); }));
  service.set_hand({0.052, -0.097, 0.196});
  EXPECT_TRUE(eventually(*port, [](const Sample& s) { return close_to(s.position_mm, {3, 5, -1}); }));
  EXPECT_TRUE(eventually(*port, [&](const Sample&) { return close_to(service.force_n(), {0.5, -0.25, 1}); }, {0.5, -0.25, 1}));
  // Too much is cut in length and keeps its direction: 6, 8 N become 1.2, 1.6.
  EXPECT_TRUE(eventually(*port, [&](const Sample&) { return close_to(service.force_n(), {1.2, 1.6, 0}); }, {6, 8, 0}));
  EXPECT_LE(service.most_force_n(), 2.0 + 1e-9);
  EXPECT_EQ(port->limits().device_class, "inverse3");
  EXPECT_EQ(port->limits().rotation_axes, 0);
  port->close();
  EXPECT_TRUE(close_to(service.force_n(), {0, 0, 0}));  // its last words
  EXPECT_EQ(tick(*port).status, Sample::Status::gone);
}

TEST(InversePort, two_thousand_exchanges_come_in_order_and_none_is_lost) {
  FakeService service;
  auto port = make_inverse_port(settings_for(service));
  ASSERT_TRUE(port->open());
  int fresh = 0;
  for (int i = 0; i < 6000 && fresh < 2000; ++i) fresh += tick(*port, {0.1, 0, 0}).status == Sample::Status::fresh;
  EXPECT_EQ(fresh, 2000);
  const auto state = port->view().session;
  EXPECT_EQ(state.unread, 0u);
  EXPECT_EQ(state.connections, 1u);
  EXPECT_GE(state.sent + 2, state.readings);
}

TEST(InversePort, a_device_turned_on_its_stand_is_turned_back) {
  FakeService service;
  InverseSettings settings = settings_for(service);
  settings.yaw_rad = std::numbers::pi / 2;  // its x is the specimen's y
  settings.origin_mm = Vec3(0.0);
  service.set_hand({0, 0, 0.1});
  auto port = make_inverse_port(settings);
  ASSERT_TRUE(port->open());
  ASSERT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::fresh; }));
  service.set_hand({0.004, 0, 0.1});
  EXPECT_TRUE(eventually(*port, [](const Sample& s) { return close_to(s.position_mm, {0, 4, 0}); }));
  // Power in is power out: a force along the way stays along it.
  EXPECT_TRUE(eventually(*port, [&](const Sample&) { return close_to(service.force_n(), {1, 0, 0}); }, {0, 1, 0}));
}

TEST(InversePort, the_handle_turns_the_bur_from_where_it_rested_and_its_buttons_count) {
  FakeService service;
  const Quat rest = glm::angleAxis(0.3, Vec3(0, 1, 0));
  service.set_handle(FakeHandle{rest});
  InverseSettings settings = settings_for(service);
  settings.burs = 2;
  auto port = make_inverse_port(settings);
  ASSERT_TRUE(port->open());
  EXPECT_EQ(port->limits().rotation_axes, 3);
  ASSERT_TRUE(eventually(*port, [](const Sample& s) {
    return s.status == Sample::Status::fresh && std::abs(s.orientation.w - 1.0) < 1e-9;
  }));
  const Quat turn = glm::angleAxis(0.5, Vec3(1, 0, 0));
  service.set_handle(FakeHandle{.orientation = turn * rest, .a = true});
  EXPECT_TRUE(eventually(*port, [&](const Sample& s) {
    return s.buttons == 1 && s.pedal == 65535 && std::abs(glm::dot(s.orientation, turn)) > 1 - 1e-9;
  }));
  service.set_handle(FakeHandle{.orientation = turn * rest, .c = true});
  EXPECT_TRUE(eventually(*port, [](const Sample& s) { return s.bur == 1; }));
}

TEST(InversePort, a_handle_that_is_lost_is_the_loss_of_the_device_until_it_reports_again) {
  FakeService service;
  service.set_handle(FakeHandle{.a = true});
  auto port = make_inverse_port(settings_for(service));
  ASSERT_TRUE(port->open());
  ASSERT_TRUE(eventually(*port, [](const Sample& s) { return s.buttons == 1; }));
  ASSERT_TRUE(eventually(*port, [&](const Sample&) { return service.force_n().x > 0.9; }, {1, 0, 0}));
  service.set_handle(std::nullopt);
  ASSERT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::gone && s.buttons == 0; }, {1, 0, 0}));
  EXPECT_EQ(port->view().session.trouble, inverse::Trouble::no_handle);
  EXPECT_TRUE(eventually(*port, [&](const Sample&) { return service.force_n() == Vec3(0.0); }, {1, 0, 0}));
  service.set_handle(FakeHandle{});
  EXPECT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::fresh; }));
}

TEST(InversePort, its_button_counts_from_the_bur_that_the_screen_or_the_session_chose) {
  FakeService service;
  service.set_handle(FakeHandle{});
  InverseSettings settings = settings_for(service);
  settings.burs = 5;
  auto port = make_inverse_port(settings);
  ASSERT_TRUE(port->open());
  ASSERT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::fresh; }));
  StepState state(test::block_scene_with_burs(5));
  StepInput resumed = quantise(tick(*port), 1000, {});
  resumed.bur = 2;
  step(state, resumed);
  HandOver hand_over(1 << 16);
  Ticker ticker(std::move(state), hand_over);
  // Both have the bur, for 30 samples on end: past what a press counts after.
  const auto settles_at = [&](std::uint16_t bur) {
    int same = 0;
    for (int i = 0; i < 3000 && same < 30; ++i) {
      const Sample sample = port->wait(std::chrono::steady_clock::now() + 20ms);
      const Feedback felt = ticker.tick(sample, 1000);
      port->write(felt);
      same = sample.bur != bur || felt.bur != bur ? 0 : same + (sample.status == Sample::Status::fresh ? 1 : 0);
    }
    return same == 30;
  };
  const auto press_gives = [&](std::uint16_t bur) {
    service.set_handle(FakeHandle{.c = true});
    const bool right = settles_at(bur);
    service.set_handle(FakeHandle{});
    return right && settles_at(bur);
  };
  EXPECT_TRUE(settles_at(2));
  EXPECT_TRUE(press_gives(3));
  ticker.change_bur(1);
  EXPECT_TRUE(settles_at(1));
  EXPECT_TRUE(press_gives(2));
  ticker.change_bur(4);
  EXPECT_TRUE(settles_at(4));
  EXPECT_TRUE(press_gives(0));  // after the last comes the first
}

TEST(InversePort, the_clutch_holds_the_bur_and_gives_no_force) {
  FakeService service;
  service.set_handle(FakeHandle{});
  service.set_hand({0, 0, 0.1});
  InverseSettings settings = settings_for(service);
  constexpr double kRampS = 10.0;  // of the 1 N that is asked for
  settings.session.ramp = 10s;
  auto port = make_inverse_port(settings);
  ASSERT_TRUE(port->open());
  ASSERT_TRUE(eventually(*port, [](const Sample& s) { return close_to(s.position_mm, {1, 2, 3}); }));
  const auto pushes = [&service](const Sample&) { return service.force_n().x > 0.1; };
  ASSERT_TRUE(eventually(*port, pushes, {1, 0, 0}));
  service.set_handle(FakeHandle{.b = true});
  ASSERT_TRUE(eventually(*port, [&](const Sample&) { return service.force_n() == Vec3(0.0) && service.messages() > 100; }, {1, 0, 0}));
  service.set_hand({0.03, 0, 0.1});
  const auto before = port->view().session.readings;
  auto ticked = std::chrono::steady_clock::now(), held = ticked;  // before the last write that the clutch held back
  ASSERT_TRUE(eventually(*port, [&](const Sample& s) {
    EXPECT_TRUE(close_to(s.position_mm, {1, 2, 3}));
    held = std::exchange(ticked, std::chrono::steady_clock::now());
    return port->view().session.readings > before + 100;
  }));
  service.set_handle(FakeHandle{});
  double first = 0;
  ASSERT_TRUE(eventually(*port, [&](const Sample&) { return (first = service.force_n().x) > 0; }, {1, 0, 0}));
  // It rises anew: it is what has risen since, however long this machine stalled.
  EXPECT_LE(first, std::chrono::duration<double>(std::chrono::steady_clock::now() - held).count() / kRampS);
  EXPECT_TRUE(eventually(*port, pushes, {1, 0, 0}));
  service.set_hand({0.031, 0, 0.1});
  EXPECT_TRUE(eventually(*port, [](const Sample& s) { return close_to(s.position_mm, {2, 2, 3}); }));
}

/// Degrees between two orientations.
double degrees_between(const Quat& a, const Quat& b) {
  return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))) * 180.0 / std::numbers::pi;
}

TEST(InversePort, after_the_clutch_the_bur_goes_on_from_the_orientation_that_it_had) {
  FakeService service;
  const Quat rest = glm::angleAxis(0.3, Vec3(0, 1, 0)), turn = glm::angleAxis(0.5, Vec3(1, 0, 0)), further = glm::angleAxis(0.2, Vec3(0, 0, 1));
  service.set_handle(FakeHandle{rest});
  auto port = make_inverse_port(settings_for(service));
  ASSERT_TRUE(port->open());
  const auto settles = [&](const FakeHandle& handle) {
    service.set_handle(handle);
    const auto before = port->view().session.readings;
    Quat out(1, 0, 0, 0);
    EXPECT_TRUE(eventually(*port, [&](const Sample& s) {
      out = s.orientation;
      return port->view().session.readings > before + 100;
    }));
    return out;
  };
  EXPECT_LT(degrees_between(settles(FakeHandle{rest}), Quat(1, 0, 0, 0)), 0.1);
  const Quat turned = settles(FakeHandle{turn * rest});
  EXPECT_NEAR(degrees_between(turned, Quat(1, 0, 0, 0)), 0.5 * 180.0 / std::numbers::pi, 0.1);
  EXPECT_LT(degrees_between(settles(FakeHandle{.orientation = turn * rest, .b = true}), turned), 0.1);
  EXPECT_LT(degrees_between(settles(FakeHandle{.orientation = rest, .b = true}), turned), 0.1) << "the hand turns back, the bur stays";
  EXPECT_LT(degrees_between(settles(FakeHandle{rest}), turned), 0.1) << "released, the bur stays";
  EXPECT_NEAR(degrees_between(settles(FakeHandle{further * rest}), turned), 0.2 * 180.0 / std::numbers::pi, 0.1);
}

TEST(InversePort, reports_why_it_cannot_be_opened) {
  std::uint16_t nobody = 0;
  {
    FakeService gone;
    nobody = gone.port();
  }
  InverseSettings settings;
  settings.service.port = nobody;
  auto lonely = make_inverse_port(settings);
  const auto refused = lonely->open();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, PortError::not_found);
  EXPECT_EQ(refused.error().where, "service");

  FakeService service;
  service.set_way(FakeService::Way::no_device);
  const auto without = make_inverse_port(settings_for(service))->open();
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().code, PortError::not_found);
  EXPECT_EQ(without.error().where, "device");

  service.set_way(FakeService::Way::not_a_websocket);
  EXPECT_EQ(make_inverse_port(settings_for(service))->open().error().where, "service");
}

TEST(InversePort, silence_garbage_and_a_service_that_goes_are_loss_and_it_is_found_again) {
  for (const auto way : {FakeService::Way::silent, FakeService::Way::garbage, FakeService::Way::binary,
                         FakeService::Way::huge, FakeService::Way::hangs_up, FakeService::Way::no_device}) {
    FakeService service;
    InverseSettings settings = settings_for(service);
    settings.session.answer = 50ms;
    settings.session.repeat = 60ms;
    settings.session.give_up = 2s;
    auto port = make_inverse_port(settings);
    ASSERT_TRUE(port->open());
    ASSERT_TRUE(eventually(*port, [&](const Sample&) { return glm::length(service.force_n()) > 0.9; }, {1, 0, 0}));
    service.set_way(way);
    ASSERT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::gone && s.buttons == 0; }, {1, 0, 0}))
        << static_cast<int>(way);
    service.set_way(FakeService::Way::answers);
    EXPECT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::fresh; })) << static_cast<int>(way);
  }
}

TEST(InversePort, a_service_is_found_by_whether_it_listens) {
  std::uint16_t port = 0;
  {
    FakeService service;
    port = service.port();
    EXPECT_TRUE(inverse::service_listens({port}));
  }
  EXPECT_FALSE(inverse::service_listens({port}));
}

TEST(InversePort, a_service_at_another_port_is_listed_by_a_watch_of_that_port) {
  FakeService service;
  const auto found = watch_devices_at({service.port()})->list();
  EXPECT_TRUE(std::ranges::any_of(found, [](const FoundDevice& one) { return one.kind == "inverse3"; }));
}

TEST(InversePort, a_service_that_takes_no_connection_is_not_waited_for) {
  const test::FullPort full;
  EXPECT_FALSE(inverse::service_listens({full.port()}));  // by itself connect() tries for two minutes
}

TEST(InversePort, opened_again_it_begins_anew) {
  FakeService service;
  service.set_hand({0, 0, 0.1});
  auto port = make_inverse_port(settings_for(service));
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(port->open());
    service.set_hand({0.001 * i, 0, 0.1});
    EXPECT_TRUE(eventually(*port, [](const Sample& s) { return s.status == Sample::Status::fresh; }));
    port->close();
  }
  EXPECT_EQ(service.connections(), 3u);
}

}  // namespace
}  // namespace cusp::test
