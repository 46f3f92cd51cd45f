// At which port the device page looks for the Inverse3's service.
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "device/catalogue.h"
#include "tests/modules.h"
#include "ui/device/device_page.h"
#include "ui/device/inverse_panel.h"
#include "ui/settings/settings.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

class EmptyWatch final : public DeviceWatch {
 public:
  std::vector<FoundDevice> list() override { return with_software_devices({}); }
  bool changed() noexcept override { return false; }
};

TEST(DevicePage, a_port_that_staff_type_is_looked_at_at_once) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  int made = 0;
  DevicePage page(settings, Ports::of_the_system(), Role::instructor, nullptr, [&made] {
    ++made;
    return std::make_unique<EmptyWatch>();
  });
  page.show();
  page.look();
  EXPECT_EQ(made, 1);
  page.findChild<InversePanel*>()->findChildren<NumberField*>().last()->setValue(10002);
  page.look();
  EXPECT_EQ(made, 2);
  page.look();
  EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace cusp::test
