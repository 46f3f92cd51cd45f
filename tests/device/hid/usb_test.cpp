// The real hidapi over hidraw nodes of a umockdev testbed. Reports are counted; what is waited for is progress.
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "device/hid/hid_station.h"
#include "device/hid/transport_hidapi.h"
#include "tests/device/hid/mock_hid.h"
#include "tests/eventually.h"

namespace cusp::device::hid {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::eventually;
using test::MockHid;
using test::MockHidBus;

MockHidBus& bus() {
  static MockHidBus made;
  return made;
}

PedalReading latest(const PedalReader& reader) { return reader.latest(std::chrono::steady_clock::now()); }

TEST(HidUsb, lists_what_is_plugged_in_with_its_descriptor) {
  MockHid pedal(bus(), 1, 0x05f3, 0x00ff, "VEC USB Footpedal", test::vec_descriptor());
  MockHid mouse(bus(), 2, 0x256f, 0xc635, "SpaceMouse Compact", test::space_mouse_descriptor());
  pedal.plug();
  mouse.plug();
  const auto hidapi = make_hidapi_bus();
  ASSERT_TRUE(hidapi);
  const auto devices = hidapi->list();
  ASSERT_EQ(devices.size(), 2u);
  EXPECT_EQ(devices[0].path, pedal.path());
  EXPECT_EQ(devices[0].vendor, 0x05f3);
  EXPECT_EQ(devices[0].product, 0x00ff);
  EXPECT_EQ(devices[0].name, "VEC USB Footpedal");
  EXPECT_EQ(devices[0].serial, "S1");
  EXPECT_EQ(devices[0].interface_number, 0);
  EXPECT_EQ(devices[0].descriptor, test::vec_descriptor());
  EXPECT_EQ(devices[1].descriptor, test::space_mouse_descriptor());
}

TEST(HidUsb, a_device_whose_descriptor_cannot_be_read_is_listed_without_it) {
  MockHid pedal(bus(), 1, 0x05f3, 0x00ff, "VEC USB Footpedal", test::vec_descriptor());
  pedal.plug();
  gchar* const sys = umockdev_testbed_get_sys_dir(bus().testbed());
  const std::filesystem::path file = std::filesystem::path(sys) / "class/hidraw/hidraw1/device/report_descriptor";
  g_free(sys);
  ASSERT_TRUE(std::filesystem::remove(file));
  // Reading it fails with EIO, as the kernel's own file fails with ENODEV once the device is unplugged.
  std::filesystem::create_symlink("/proc/self/mem", file);
  const auto hidapi = make_hidapi_bus();
  ASSERT_TRUE(hidapi);
  const auto devices = hidapi->list();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_EQ(devices[0].path, pedal.path());
  EXPECT_TRUE(devices[0].descriptor.empty());
}

TEST(HidUsb, every_report_of_ten_thousand_arrives_whole_and_in_order) {
  MockHid mouse(bus(), 1, 0x256f, 0xc635, "SpaceMouse Compact", test::space_mouse_descriptor());
  mouse.plug();
  const auto hidapi = make_hidapi_bus();
  ASSERT_TRUE(hidapi);
  auto reader = hidapi->open(mouse.path());
  ASSERT_TRUE(reader);
  constexpr int kReports = 10'000;
  for (int i = 0; i < kReports; ++i) mouse.send(test::words(1, {i % 350, -(i % 350), i % 7}));
  std::array<std::uint8_t, 64> bytes{};
  SpaceMouseState state;
  for (int i = 0; i < kReports; ++i) {
    HidRead read;
    do {
      read = (*reader)->read(bytes, 20ms);
    } while (read.kind == HidRead::Kind::nothing);
    ASSERT_EQ(read.kind, HidRead::Kind::report);
    ASSERT_EQ(read.size, 7u);
    ASSERT_TRUE(state.take(std::span(bytes).first(read.size), {}));
    ASSERT_EQ(state.raw(), (std::array<std::int16_t, 6>{static_cast<std::int16_t>(i % 350), static_cast<std::int16_t>(-(i % 350)),
                                                        static_cast<std::int16_t>(i % 7), 0, 0, 0}));
  }
  EXPECT_EQ((*reader)->read(bytes, 20ms).kind, HidRead::Kind::nothing);
}

TEST(HidUsb, a_pedal_drills_and_unplugged_it_is_released_and_found_again) {
  MockHid pedal(bus(), 1, 0x05f3, 0x00ff, "VEC USB Footpedal", test::vec_descriptor());
  PedalReader reader(make_hidapi_bus);
  reader.start();
  pedal.plug();
  reader.set_settings({});  // lists the devices at once
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  for (int round = 0; round < 2; ++round) {
    pedal.send({0x02, 0x00});
    EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
    pedal.send({0x00, 0x00});
    EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 0; }));
    pedal.send({0x01, 0x00});
    EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
    pedal.unplug();
    EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 0; }));
    EXPECT_TRUE(eventually([&] { return !reader.view().connected; }));
    pedal.plug();
    ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
    EXPECT_EQ(latest(reader).pressed, 0);
  }
}

TEST(HidUsb, a_rheostat_is_read_by_its_descriptor_and_calibrated) {
  MockHid rudder(bus(), 1, 0x06a3, 0x0763, "Rudder Pedals", test::rudder_descriptor());
  rudder.plug();
  PedalSettings settings;
  settings.vendor = 0x06a3;
  settings.product = 0x0763;
  settings.drill = ControlId{usage::kDesktopPage, 0x31, 0};  // the right toe brake, in bits 16 to 22
  settings.calibration = *PedalCalibration::from(127, 27, 0.0);
  PedalReader reader(make_hidapi_bus, settings);
  reader.start();
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  EXPECT_EQ(latest(reader).pressed, 0);
  rudder.send({0x00, 0x00, 77});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 32768; }));  // half of the way
  rudder.send({0x00, 0x00, 127});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 0; }));
}

TEST(HidUsb, pedal_and_space_mouse_are_read_side_by_side) {
  MockHid pedal(bus(), 1, 0x05f3, 0x00ff, "VEC USB Footpedal", test::vec_descriptor());
  MockHid mouse(bus(), 2, 0x256f, 0xc635, "SpaceMouse Compact", test::space_mouse_descriptor());
  pedal.plug();
  mouse.plug();
  HidStation station(make_hidapi_bus);
  station.start();
  const auto view = [&] { return station.space_mouse().view(std::chrono::steady_clock::now()); };
  ASSERT_TRUE(eventually([&] { return station.pedal().view().connected && view().connected; }));
  pedal.send({0x04, 0x00});
  ASSERT_TRUE(eventually([&] {
    if (mouse.waiting() == 0) mouse.send(test::words(2, {0, 0, -350}));
    return view().motion.turn[1] > 0.99 && latest(station.pedal()).pressed == 65535;
  }));
  mouse.send({3, 0x02, 0x00});
  EXPECT_TRUE(eventually([&] { return view().motion.buttons == 2; }));
  mouse.unplug();
  EXPECT_TRUE(eventually([&] { return !view().connected && view().motion == SpaceMouseMotion{}; }));
  EXPECT_TRUE(eventually([&] { return latest(station.pedal()).pressed == 65535; })) << "the pedal is still down";
}

TEST(HidUsb, a_path_that_is_not_there_is_not_found) {
  const auto hidapi = make_hidapi_bus();
  ASSERT_TRUE(hidapi);
  const auto none = hidapi->open("/dev/hidraw9");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, PortError::not_found);
}

}  // namespace
}  // namespace cusp::device::hid
