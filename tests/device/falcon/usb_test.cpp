// The whole driver over the real libusb, with emulated Falcons as usbfs nodes of a umockdev testbed. Nothing here is
// judged by the clock: exchanges are counted, and what is waited for is progress.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "device/falcon/falcon_port.h"
#include "device/falcon/permissions.h"
#include "device/falcon/transport_libusb.h"
#include "device/falcon/transport_watch.h"
#include "tests/device/falcon/images.h"
#include "tests/device/falcon/mock_usb.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using falcon::Emulator;
using test::MockBus;
using test::MockFalcon;

MockBus& bus() {
  static MockBus made;
  return made;
}

/// The emulated line has no speed here: what is tried is libusb, not the time that bytes take.
falcon::EmulatorSettings quick() { return {.at_once = true}; }
falcon::EmulatorSettings quick_running() { return {.firmware_running = true, .at_once = true}; }

std::unique_ptr<FalconPort> port_to(const std::string& name) {
  auto link = falcon::make_usb_link(name);
  EXPECT_TRUE(link);
  FalconSettings settings;
  // A loaded test machine must not be taken for a silent or a slow device.
  settings.session.times.silence = 5s;
  settings.session.times.fresh = 5s;
  settings.session.times.late = 4s;
  settings.session.times.check = 4s;
  settings.session.times.slow = 5s;
  settings.session.times.give_up = 20s;
  settings.session.times.probe = 100ms;
  auto port = std::make_unique<FalconPort>(std::move(*link), settings);
  port->give_image(*falcon::FirmwareImage::from_bytes(test::boot_image()));
  return port;
}

Sample tick(FalconPort& port, const Feedback& feedback = {}, std::chrono::milliseconds patience = 20ms) {
  const Sample sample = port.wait(std::chrono::steady_clock::now() + patience);
  port.write(feedback);
  return sample;
}

bool home(FalconPort& port, MockFalcon& device) {
  for (int i = 0; i < 3000; ++i) {
    const double z = 0.10 + 0.07 * (i % 100 < 50 ? i % 50 : 50 - i % 50) / 50.0;
    device.with([z](Emulator& falcon) { falcon.set_grip({0, 0, z}); });
    if (tick(port).status == Sample::Status::fresh) return true;
  }
  return false;
}

TEST(FalconUsb, is_found_claimed_from_a_kernel_driver_loaded_homed_and_exchanged_with) {
  MockFalcon device(bus(), 2, "1-1", "", quick());
  device.set_kernel_driver(true);
  device.plug();
  auto port = port_to("");
  const auto opened = port->open();
  ASSERT_TRUE(opened) << opened.error().detail;
  EXPECT_FALSE(device.kernel_driver());
  EXPECT_TRUE(device.with([](Emulator& falcon) { return falcon.firmware_running(); }));
  EXPECT_EQ(device.with([](Emulator& falcon) { return falcon.loaded_words(); }), 2500u);
  ASSERT_TRUE(home(*port, device));

  const auto before = port->view().session;
  const auto requests = device.requests();
  const auto began = std::chrono::steady_clock::now();
  const char* wanted = std::getenv("CUSP_USB_EXCHANGES");  // 10000 for the whole; ./check makes the first 1,500
  const int exchanges = wanted != nullptr ? std::atoi(wanted) : 1500;
  // A tick that the machine stalls in is late. Twice as many ticks end the loop of a port that stays late.
  int fresh = 0, ticks = 0;
  for (; fresh < exchanges && ticks < 2 * exchanges; ++ticks) {
    fresh += tick(*port, {.force_n = Vec3(0.5)}, 2s).status == Sample::Status::fresh;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const auto after = port->view().session;
  std::cout << ticks << " ticks, " << fresh << " fresh, " << after.replies - before.replies << " answers, "
            << after.lost - before.lost << " lost, " << ticks / seconds << " a second\n";
  EXPECT_GE(after.replies - before.replies + 2, after.sent - before.sent);  // two may be under way
  EXPECT_EQ(fresh, exchanges);
  EXPECT_EQ(after.lost, before.lost);
  EXPECT_EQ(after.dropped_bytes, before.dropped_bytes);
  EXPECT_EQ(device.requests(), requests);  // none in the loop
  EXPECT_NE(device.with([](Emulator& falcon) { return falcon.frames(); }), 0u);
  port->close();
  EXPECT_TRUE(device.kernel_driver());  // given back
}

TEST(FalconUsb, one_that_runs_already_is_left_running) {
  MockFalcon device(bus(), 2, "1-1", "", quick_running());
  device.plug();
  auto port = port_to("");
  ASSERT_TRUE(port->open());
  EXPECT_EQ(port->view().session.upload_size, 0u);
}

TEST(FalconUsb, reports_why_it_cannot_be_opened) {
  MockFalcon device(bus(), 2, "1-1", "", quick_running());
  auto port = port_to("");
  const auto nobody = port->open();
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().code, PortError::not_found);
  device.set_claimed_elsewhere(true);
  device.plug();
  const auto taken = port->open();
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, PortError::busy);
  device.set_claimed_elsewhere(false);
  EXPECT_TRUE(port->open());
}

TEST(FalconUsb, unplugged_while_drilling_it_is_gone_and_found_again) {
  MockFalcon device(bus(), 2, "1-1", "", quick_running());
  device.plug();
  auto port = port_to("");
  ASSERT_TRUE(port->open());
  ASSERT_TRUE(home(*port, device));
  for (int i = 0; i < 300; ++i) tick(*port, {.force_n = Vec3(1)});
  device.unplug();
  int ticks = 0;
  while (tick(*port, {.force_n = Vec3(1)}).status != Sample::Status::gone && ++ticks < 1000) continue;
  EXPECT_LT(ticks, 1000);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(tick(*port).status, Sample::Status::gone);
  device.plug();
  ticks = 0;
  while (tick(*port).status != Sample::Status::fresh && ++ticks < 1000) continue;
  EXPECT_LT(ticks, 1000);
}

TEST(FalconUsb, an_endpoint_that_stalls_is_cleared_and_the_device_found_again) {
  MockFalcon device(bus(), 2, "1-1", "", quick_running());
  device.plug();
  auto port = port_to("");
  ASSERT_TRUE(port->open());
  ASSERT_TRUE(home(*port, device));
  device.stall(falcon::kOutEndpoint);
  int ticks = 0;
  while (tick(*port, {.force_n = Vec3(1)}).status != Sample::Status::gone && ++ticks < 1000) continue;
  ASSERT_LT(ticks, 1000);
  EXPECT_TRUE(home(*port, device));
}

TEST(FalconUsb, unplugged_while_loading_it_is_loaded_again) {
  MockFalcon device(bus(), 2, "1-1", "", quick());
  device.with([](Emulator& falcon) { falcon.swallow_echo_at(2000); });  // the upload stands still here
  device.plug();
  auto link = falcon::make_usb_link("");
  ASSERT_TRUE(link);
  falcon::Session session;
  session.give_image(*falcon::FirmwareImage::from_bytes(test::boot_image()));
  const auto once = [&] {
    while (const auto ask = session.next_ask()) (*link)->start(*ask);
    const auto event = (*link)->wait(std::min((*link)->now() + 10ms, std::max(session.due(), (*link)->now())));
    session.advance(event, (*link)->now());
  };
  for (int i = 0; i < 20000 && session.state().uploaded < 1900; ++i) once();
  ASSERT_EQ(session.phase(), falcon::Phase::uploading);
  device.unplug();
  for (int i = 0; i < 20000 && session.phase() != falcon::Phase::unplugged; ++i) once();
  EXPECT_EQ(session.phase(), falcon::Phase::unplugged);
  device.plug();
  for (int i = 0; i < 200000 && session.phase() != falcon::Phase::homing; ++i) once();
  EXPECT_EQ(session.phase(), falcon::Phase::homing);
}

TEST(FalconUsb, two_are_distinguished_by_serial_number_or_socket) {
  MockFalcon left(bus(), 2, "1-1", "FT000001", quick_running()), right(bus(), 3, "1-2", "FT000002", quick_running());
  left.plug();
  right.plug();
  left.with([](Emulator& falcon) { falcon.set_buttons(falcon::status::kPlus); });
  right.with([](Emulator& falcon) { falcon.set_buttons(falcon::status::kMinus); });
  auto watch = falcon::watch_usb_falcons();
  ASSERT_TRUE(watch);
  const auto there = (*watch)->list();
  ASSERT_EQ(there.size(), 2u);
  EXPECT_EQ(there[0], (falcon::FalconOnBus{"FT000001", "1-1", "FT000001", false}));
  EXPECT_EQ(there[1], (falcon::FalconOnBus{"FT000002", "1-2", "FT000002", false}));
  auto first = port_to(there[0].name), second = port_to(there[1].port);
  ASSERT_TRUE(first->open());
  ASSERT_TRUE(second->open());
  for (int i = 0; i < 20; ++i) {
    tick(*first);
    tick(*second);
  }
  EXPECT_EQ(first->view().session.buttons, falcon::status::kPlus);
  EXPECT_EQ(second->view().session.buttons, falcon::status::kMinus);
  EXPECT_EQ(port_to("FT000003")->open().error().code, PortError::not_found);
}

TEST(FalconUsb, two_with_the_same_number_go_by_their_sockets) {
  MockFalcon left(bus(), 2, "1-1", "00000000", quick_running()), right(bus(), 3, "1-2", "00000000", quick_running());
  left.plug();
  right.plug();
  auto watch = falcon::watch_usb_falcons();
  ASSERT_TRUE(watch);
  const auto there = (*watch)->list();
  ASSERT_EQ(there.size(), 2u);
  EXPECT_EQ(there[0].name, "1-1");
  EXPECT_EQ(there[1].name, "1-2");
}

/// Opens the first Falcon, unplugs it while another is there, and plugs it in at `again`.
void expect_no_other_is_taken(const std::string& serial, const std::string& of_other, const std::string& again) {
  MockFalcon other(bus(), 2, "1-1", of_other, quick_running());
  const auto first = std::make_unique<MockFalcon>(bus(), 3, "1-2", serial, quick_running());  // libusb lists the last socket first
  other.plug();
  first->plug();
  auto link = falcon::make_usb_link("");
  ASSERT_TRUE(link);
  const auto open = [&] {
    (*link)->start({.kind = falcon::LinkAsk::Kind::open});
    return (*link)->wait((*link)->now() + 10s).kind;
  };
  ASSERT_EQ(open(), falcon::LinkEvent::Kind::opened);
  ASSERT_EQ((*link)->name(), serial.empty() ? "1-2" : serial);
  EXPECT_EQ((*link)->known_by_port(), serial.empty() || serial == of_other);
  (*link)->start({.kind = falcon::LinkAsk::Kind::close});
  first->unplug();
  falcon::LinkEvent::Kind without = open();
  for (int i = 0; i < 1000 && without == falcon::LinkEvent::Kind::opened; ++i, without = open()) {
    (*link)->start({.kind = falcon::LinkAsk::Kind::close});
    g_usleep(1000);  // libusb hears of it later
  }
  EXPECT_EQ(without, falcon::LinkEvent::Kind::absent) << "the other is there: " << (*link)->name();
  MockFalcon replugged(bus(), 4, again, serial, quick_running());
  replugged.plug();
  falcon::LinkEvent::Kind last = open();
  for (int i = 0; i < 5000 && last != falcon::LinkEvent::Kind::opened; ++i, last = open()) g_usleep(1000);  // libusb hears of it later
  EXPECT_EQ(last, falcon::LinkEvent::Kind::opened) << again;
  (*link)->start({.kind = falcon::LinkAsk::Kind::close});
}

TEST(FalconUsb, unplugged_beside_another_it_alone_is_found_again) {
  expect_no_other_is_taken("FT000001", "FT000002", "1-3");  // its serial number shows it anywhere
  expect_no_other_is_taken("", "", "1-2");
  expect_no_other_is_taken("00000000", "00000000", "1-2");
}

TEST(FalconUsb, a_serial_number_that_was_not_given_is_asked_for_again) {
  MockFalcon device(bus(), 2, "1-1", "FT000001", quick_running());
  device.hide_serial(true);
  device.plug();
  auto watch = falcon::watch_usb_falcons();
  ASSERT_TRUE(watch);
  EXPECT_TRUE((*watch)->changed());
  const auto without = (*watch)->list();
  ASSERT_EQ(without.size(), 1u);
  EXPECT_EQ(without[0].name, "1-1");
  device.hide_serial(false);
  EXPECT_TRUE((*watch)->changed());
  const auto with = (*watch)->list();
  ASSERT_EQ(with.size(), 1u);
  EXPECT_EQ(with[0].name, "FT000001");
}

TEST(FalconUsb, coming_and_going_is_noticed) {
  auto watch = falcon::watch_usb_falcons();
  ASSERT_TRUE(watch);
  EXPECT_TRUE((*watch)->changed());
  EXPECT_FALSE((*watch)->changed());
  const auto notices = [&watch] {
    for (int i = 0; i < 5000; ++i) {
      if ((*watch)->changed()) return true;
      g_usleep(1000);
    }
    return false;
  };
  {
    MockFalcon device(bus(), 2, "1-1", "FT1", quick_running());
    device.plug();
    EXPECT_TRUE(notices());
    EXPECT_EQ((*watch)->list().size(), 1u);
    device.unplug();
    EXPECT_TRUE(notices());
  }
  EXPECT_TRUE((*watch)->list().empty());
}

}  // namespace
}  // namespace cusp::test
