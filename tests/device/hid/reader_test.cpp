// Both readers on their threads, over a bus in memory. What is waited for is progress, never time.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "device/hid/hid_station.h"
#include "device/hid/pedalled_sample.h"
#include "device/hid/permissions.h"
#include "device/hid/settings_text.h"
#include "tests/device/hid/desk.h"
#include "tests/eventually.h"
#include "tests/source_dir.h"

namespace cusp::device::hid {
namespace {

using namespace std::chrono_literals;
using test::eventually;
using test::Bytes;
using test::bus_of;
using test::Desk;

PedalReading latest(const PedalReader& reader) { return reader.latest(std::chrono::steady_clock::now()); }

TEST(PedalReader, follows_a_pedal_and_unplugged_it_is_released_and_found_again) {
  Desk desk;
  PedalReader reader(bus_of(desk));
  reader.start();
  EXPECT_EQ(latest(reader), PedalReading{});
  auto pedal = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  EXPECT_EQ(reader.view().controls.size(), 3u);
  desk.send(pedal, {0x02, 0x00});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
  desk.unplug(pedal);
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 0; }));
  EXPECT_TRUE(eventually([&] { return !reader.view().connected; }));
  pedal = desk.plug("/dev/hidraw2", 0x05f3, 0x00ff, test::vec_descriptor());
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  EXPECT_EQ(latest(reader).pressed, 0);  // nothing is remembered of the time before
  desk.send(pedal, {0x01, 0x00});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
}

TEST(PedalReader, the_pedal_in_use_stays_so_if_another_of_its_kind_is_plugged_in) {
  Desk desk;
  auto used = desk.plug("/dev/hidraw5", 0x05f3, 0x00ff, test::vec_descriptor());
  PedalReader reader(bus_of(desk));
  reader.start();
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  {
    const std::lock_guard lock(desk.mutex);
    std::ranges::reverse(desk.devices);  // by path, as a bus lists them
  }
  reader.set_settings({});  // lists the devices at once
  ASSERT_TRUE(eventually([&] {
    const PedalView view = reader.view();
    return view.devices.size() == 2 && view.devices.front().path == "/dev/hidraw1";
  }));
  desk.send(used, {0x01, 0x00});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
  ASSERT_TRUE(reader.view().device);
  EXPECT_EQ(reader.view().device->path, "/dev/hidraw5");
}

TEST(PedalReader, a_value_older_than_the_limit_is_released) {
  Desk desk;
  auto pedal = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  PedalReader reader(bus_of(desk));
  reader.start();
  desk.send(pedal, {0x01, 0x00});
  ASSERT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
  const auto now = std::chrono::steady_clock::now();
  EXPECT_EQ(reader.latest(now + PedalReader::kStale + 1s).pressed, 0);
  EXPECT_EQ(reader.latest(now - 1h).pressed, 65535);  // polled since
  reader.stop();
  EXPECT_EQ(latest(reader).pressed, 0);
}

TEST(PedalReader, one_that_may_not_be_opened_is_denied_until_it_is_unplugged) {
  Desk desk;
  const auto pedal = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  pedal->denied = true;
  PedalReader reader(bus_of(desk));
  reader.start();
  EXPECT_TRUE(eventually([&] { return reader.view().denied; }));
  EXPECT_FALSE(reader.view().connected);
  EXPECT_TRUE(reader.view().device);
  desk.unplug(pedal);
  EXPECT_TRUE(eventually([&] { return !reader.view().device; }));
}

TEST(PedalReader, a_keyboard_is_offered_and_followed_only_when_chosen) {
  Desk desk;
  auto keyboard = desk.plug("/dev/hidraw1", 0x0c45, 0x7403, test::keyboard_descriptor());
  PedalReader reader(bus_of(desk));
  reader.start();
  ASSERT_TRUE(eventually([&] { return reader.view().devices.size() == 1; }));
  EXPECT_FALSE(reader.view().connected);
  PedalSettings settings;
  settings.vendor = 0x0c45;
  settings.product = 0x7403;
  settings.drill = ControlId{usage::kKeyPage, 0x68, 0};
  reader.set_settings(settings);
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  desk.send(keyboard, {0, 0, 0x68, 0, 0, 0, 0, 0});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
  desk.send(keyboard, {0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(eventually([&] { return latest(reader).pressed == 0; }));
}

TEST(PedalReader, many_goings_and_comings_leave_nothing_pressed) {
  Desk desk;
  PedalReader reader(bus_of(desk));
  reader.start();
  for (int i = 0; i < 30; ++i) {
    auto pedal = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
    reader.set_settings({});  // lists the devices at once
    ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
    for (int n = 0; n < 20; ++n) desk.send(pedal, {static_cast<std::uint8_t>(n % 2 + 1), 0x00});
    ASSERT_TRUE(eventually([&] { return latest(reader).pressed == 65535; }));
    desk.unplug(pedal);
    ASSERT_TRUE(eventually([&] { return !reader.view().connected; }));
    ASSERT_EQ(latest(reader).pressed, 0);
  }
}

TEST(SpaceMouseReader, follows_the_six_axes_of_a_receiver_and_not_its_keyboard) {
  Desk desk;
  desk.plug("/dev/hidraw1", 0x256f, 0xc652, test::keyboard_descriptor());
  auto mouse = desk.plug("/dev/hidraw2", 0x256f, 0xc652, test::space_mouse_descriptor());
  SpaceMouseReader reader(bus_of(desk));
  reader.start();
  const auto view = [&] { return reader.view(std::chrono::steady_clock::now()); };
  ASSERT_TRUE(eventually([&] { return view().connected; }));
  EXPECT_EQ(view().device->path, "/dev/hidraw2");
  ASSERT_TRUE(eventually([&] {
    desk.send(mouse, test::words(1, {350, 0, 0}));
    return view().motion.move[0] > 0.9;
  }));
  desk.unplug(mouse);
  EXPECT_TRUE(eventually([&] { return !view().connected; }));
  EXPECT_TRUE(view().motion.still());
}

struct SetPedal final : PedalSource {
  PedalReading reading;
  PedalReading latest(std::chrono::steady_clock::time_point) const noexcept override { return reading; }
};

TEST(PedalledSample, whichever_is_further_down_counts) {
  SetPedal pedal;
  Sample device;
  device.status = Sample::Status::fresh;
  const auto both = [&] { return pedalled(device, &pedal, {}); };
  EXPECT_EQ(both().buttons, 0);
  pedal.reading = {20000, false};
  EXPECT_EQ(both().pedal, 20000);
  EXPECT_EQ(both().buttons, 1);
  EXPECT_EQ(pedalled(device, nullptr, {}).pedal, 0) << "without a pedal";
  device.pedal = 65535;
  device.buttons = 1;
  EXPECT_EQ(both().pedal, 65535);
  pedal.reading = {0, true};
  EXPECT_EQ(both().buttons, 3);
  device = {};  // gone: nothing is held down
  EXPECT_EQ(both().buttons, 0);
}

TEST(HidSettings, come_back_from_text_as_they_were_and_rubbish_is_the_usual) {
  PedalSettings pedal;
  pedal.on = false;
  pedal.vendor = 0x06a3;
  pedal.product = 0x0763;
  pedal.interface_number = 1;
  pedal.drill = ControlId{1, 0x35, 1};
  pedal.coolant = ControlId{9, 2, 0};
  pedal.calibration = *PedalCalibration::from(511, 3, 0.1);
  EXPECT_EQ(pedal_settings_from(to_text(pedal)), pedal);
  EXPECT_EQ(pedal_settings_from(to_text(PedalSettings{})), PedalSettings{});
  for (const char* rubbish : {"", "{", "[]", "7", R"({"vendor":70000,"released":1,"pressed":1,"dead_zone":0.1})",
                              R"({"drill":{"page":1},"on":"yes","dead_zone":9e99,"vendor":-1})",
                              R"({"released":18446744073709551615,"pressed":9,"dead_zone":0.1})", "\xff\xfe"}) {
    EXPECT_EQ(pedal_settings_from(rubbish), PedalSettings{}) << rubbish;
  }
  SpaceMouseSettings mouse;
  mouse.rest = {1, -2, 3, -4, 5, -6};
  mouse.dead_zone = 0.2;
  mouse.speed = 2.0;
  mouse.moves = false;
  EXPECT_EQ(space_mouse_settings_from(to_text(mouse)), mouse);
  for (const char* rubbish : {"", "null", R"({"dead_zone":0.9,"speed":1e300,"full":0,"rest":[1,2]})",
                              R"({"rest":[18446744073709551615,-9223372036854775808,1001,-1001,0.5,"7"]})"}) {
    EXPECT_EQ(space_mouse_settings_from(rubbish), SpaceMouseSettings{}) << rubbish;
  }
}

TEST(HidPermissions, the_built_in_rules_are_those_of_the_file_and_sort_before_the_seat) {
  std::ifstream file(test::source_dir() / "device/hid/52-cusp-hid.rules");
  std::ostringstream rules;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with('#')) rules << line << '\n';
  }
  EXPECT_EQ(rules.str(), udev_rules());
  const std::string_view name = udev_rules_path().substr(udev_rules_path().rfind('/') + 1);
  EXPECT_LT(name, "73-seat-late.rules");
}

TEST(HidPermissions, the_command_names_a_device_that_the_rules_do_not) {
  EXPECT_EQ(udev_install_command(0x05f3, 0x00ff).find("\"1234\""), std::string::npos);
  const std::string other = udev_install_command(0x1234, 0x00ab);
  EXPECT_NE(other.find(udev_rule_for(0x1234, 0x00ab)), std::string::npos);
  EXPECT_EQ(other.find('\n'), std::string::npos);
  EXPECT_NE(udev_rule_for(0x1234, 0x00ab).find("ATTRS{idProduct}==\"00ab\""), std::string::npos);
}

}  // namespace
}  // namespace cusp::device::hid
