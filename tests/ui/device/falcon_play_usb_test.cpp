// The real program drills over the real libusb, and somebody pulls the plug: `cusp play --device falcon` as a child of
// the umockdev testbed, whose Falcon is emulated here. Nothing is judged by the clock: progress is waited for.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/device/falcon/images.h"
#include "tests/device/falcon/mock_usb.h"

namespace cusp::test {
namespace {

using falcon::Emulator;
using test::MockBus;
using test::MockFalcon;
namespace fs = std::filesystem;

const char* program = nullptr;

struct Child {
  GPid pid = 0;
  explicit Child(std::vector<std::string> arguments) {
    std::vector<char*> argv;
    for (std::string& one : arguments) argv.push_back(one.data());
    argv.push_back(nullptr);
    GError* error = nullptr;
    EXPECT_TRUE(g_spawn_async(nullptr, argv.data(), nullptr, G_SPAWN_DO_NOT_REAP_CHILD, nullptr, nullptr, &pid, &error))
        << (error != nullptr ? error->message : "");
  }
  /// Its exit status once it is over.
  std::optional<int> over() {
    int status = 0;
    if (waitpid(pid, &status, WNOHANG) != pid) return std::nullopt;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int wait() {
    for (;;) {
      if (const auto status = over()) return *status;
      g_usleep(1000);
    }
  }
};

/// The hand at its millisecond `i`: homes the device, then presses the bur to `y` and slides to and fro, cutting. Its frames.
std::uint64_t move_hand(MockFalcon& device, std::uint64_t i, double y) {
  return device.with([&](Emulator& falcon) {
    if (falcon.homed() != falcon::status::kHomed) {
      const auto turn = static_cast<double>(i % 400);
      falcon.set_grip({0.0, 0.0, 0.09 + 0.00035 * (turn < 200 ? turn : 400 - turn)});
    } else {
      const double x = 0.004 * static_cast<double>(i % 1000 < 500 ? i % 500 : 500 - i % 500) / 500.0;
      falcon.set_grip({x, y, 0.125});
      falcon.set_buttons(falcon::status::kCentre);
    }
    return falcon.frames();
  });
}

bool homed(MockFalcon& device) {
  return device.with([](Emulator& falcon) { return falcon.homed() == falcon::status::kHomed; });
}

TEST(FalconPlayUsb, unplugged_while_drilling_it_holds_resumes_and_keeps_the_session_whole) {
  const fs::path folder = fs::temp_directory_path() / ("falcon-play-" + std::to_string(getpid()));
  fs::create_directories(folder);
  MockBus bus;
  // Two of them: the program takes the one that was named.
  MockFalcon other(bus, 2, "1-1", "FT000001", {.firmware_running = true, .at_once = true});
  MockFalcon device(bus, 3, "1-2", "FT000002", {.firmware_running = true, .at_once = true});
  other.plug();
  device.plug();
  const std::string out = (folder / "out").string(), json = (folder / "report.json").string();
  Child child({program, "play", "channel-1", "--device", "falcon:FT000002", "--seconds", "8", "--out", out, "--json", json});

  enum class Plug { in_first, pulled, in_again } plug = Plug::in_first;
  double y = 0.0;
  std::uint64_t at_unplug = 0, since = 0;
  std::optional<int> status;
  for (std::uint64_t i = 0; !status; ++i) {
    if (homed(device) && plug != Plug::pulled) y = std::max(y - 0.00001, -0.012);
    const std::uint64_t frames = move_hand(device, i, y);
    if (plug == Plug::in_first && y < -0.008 && frames > 500) {
      plug = Plug::pulled;
      at_unplug = frames;
      since = i;
      device.unplug();
    } else if (plug == Plug::pulled && i > since + 200) {
      plug = Plug::in_again;
      device.plug();
    }
    g_usleep(1000);
    status = child.over();
  }
  EXPECT_EQ(*status, 0);
  EXPECT_EQ(plug, Plug::in_again);
  EXPECT_EQ(other.with([](Emulator& falcon) { return falcon.frames(); }), 0u);

  std::ifstream in(json);
  const auto report = nlohmann::json::parse(in, nullptr, false);
  ASSERT_FALSE(report.is_discarded());
  EXPECT_NE(report["state"], "interrupted");
  EXPECT_GE(report["duration_s"].get<double>(), 8.0);
  EXPECT_GE(report["live"]["holds"].get<int>(), 1);
  const std::uint64_t answers = report["live"]["answers"];
  const std::uint64_t after = device.with([](Emulator& falcon) { return falcon.frames(); }) - at_unplug;
  EXPECT_GT(after, 500u);  // it was drilled with again
  std::cout << answers << " answers, " << after << " of them after it was plugged in again, " << report["live"].dump() << '\n';

  Child proof({program, "replay", "--verify", out + "/cusp.db", report["session"]});
  EXPECT_EQ(proof.wait(), 0);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (argc != 2) return 2;
  cusp::test::program = argv[1];
  return RUN_ALL_TESTS();
}
