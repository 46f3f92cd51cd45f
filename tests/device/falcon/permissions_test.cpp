#include "device/falcon/permissions.h"
#include "tests/source_dir.h"

#include <gtest/gtest.h>

#include <fstream>

namespace cusp::device::falcon {
namespace {

TEST(FalconPermissions, the_rule_is_the_one_in_the_file) {
  std::ifstream file(test::source_dir() / "device/falcon/51-cusp.rules");
  std::string line, rule;
  while (std::getline(file, line)) {
    if (!line.empty() && line[0] != '#') rule += line;
  }
  EXPECT_EQ(rule, udev_rule());
}

TEST(FalconPermissions, the_rule_comes_before_the_one_that_gives_the_seat_its_devices) {
  const std::string path(udev_rule_path());
  EXPECT_LT(path.substr(path.rfind('/') + 1), "73-seat-late.rules");
  EXPECT_EQ(path.substr(path.rfind('/') + 1), "51-cusp.rules");
}

TEST(FalconPermissions, the_copied_line_quotes_the_rule_whole) {
  // Within single quotes a shell changes nothing: the rule must not hold one.
  EXPECT_EQ(udev_rule().find('\''), std::string_view::npos);
  EXPECT_NE(udev_install_command().find("'" + std::string(udev_rule()) + "'"), std::string::npos);
}

}  // namespace
}  // namespace cusp::device::falcon
