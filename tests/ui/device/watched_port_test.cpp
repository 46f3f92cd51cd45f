// What the device page looks at: the port of the Inverse3's service, and what comes while the keyboard is in its list; what it reports
// of a choice that no file takes; the key that stops a test; and the keyboard at Try again.
#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>
#include <QRadioButton>
#include <QTemporaryDir>
#include <QTest>

#include "device/catalogue.h"
#include "tests/modules.h"
#include "tests/ui/device/eventually.h"
#include "tests/ui/device/unwritable_settings.h"
#include "ui/device/device_page.h"
#include "ui/device/falcon_panel.h"
#include "ui/device/inverse_panel.h"
#include "ui/device/trim_form.h"
#include "ui/settings/device_settings.h"
#include "ui/settings/settings.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"

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

/// A Falcon that is plugged in later.
class LateWatch final : public DeviceWatch {
 public:
  explicit LateWatch(const bool& plugged) : plugged_(plugged) {}
  std::vector<FoundDevice> list() override {
    return plugged_ ? with_software_devices({{.kind = "falcon", .name = "FT000001", .port = "1-1"}}) : with_software_devices({});
  }
  bool changed() noexcept override { return true; }

 private:
  const bool& plugged_;
};

TEST(DevicePage, the_keyboard_stays_in_the_list_when_a_device_comes) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  bool plugged = false;
  DevicePage page(settings, Ports::of_the_system(), Role::instructor, nullptr, [&plugged] { return std::make_unique<LateWatch>(plugged); });
  page.show();
  page.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  const auto chosen = [&page]() -> QRadioButton* {
    for (QRadioButton* one : page.findChildren<QRadioButton*>())
      if (one->isChecked()) return one;
    return nullptr;
  };
  ASSERT_NE(chosen(), nullptr);
  const auto before = page.listed().size();
  chosen()->setFocus();
  ASSERT_EQ(QApplication::focusWidget(), chosen());
  plugged = true;
  page.look();
  ASSERT_GT(page.listed().size(), before);
  EXPECT_EQ(QApplication::focusWidget(), chosen());
}

TEST(DevicePage, a_screen_reader_on_a_device_hears_whether_it_is_there) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  DeviceSettings(settings.file()).choose("falcon", "FT000001");
  bool plugged = false;
  DevicePage page(settings, Ports::of_the_system(), Role::instructor, nullptr, [&plugged] { return std::make_unique<LateWatch>(plugged); });
  const auto beside = [&page] { return page.findChildren<QRadioButton*>().first()->accessibleDescription(); };
  EXPECT_EQ(beside(), QStringLiteral("not plugged in"));
  plugged = true;
  page.look();
  EXPECT_EQ(beside(), QStringLiteral("plugged in, Socket 1-1"));
}

/// Chooses the emulated Falcon on a page over these settings. The page's own band, before its panels have one.
QString band_after_choice(Settings& settings) {
  DevicePage page(settings, Ports::of_the_system(), Role::instructor, nullptr, [] { return std::make_unique<EmptyWatch>(); });
  for (QRadioButton* one : page.findChildren<QRadioButton*>())
    if (!one->isChecked() && one->text().contains(QStringLiteral("Emulated"))) one->click();
  const Band* band = page.findChild<Band*>();
  return band->isVisibleTo(&page) ? band->text() : QString();
}

TEST(DevicePage, a_choice_that_the_next_start_does_not_know_holds_until_the_program_ends_and_is_reported) {
  const QTemporaryDir folder;
  Settings lost(unwritable_settings(folder));
  EXPECT_TRUE(band_after_choice(lost).startsWith(QStringLiteral("The device holds until Cusp is closed.")));
  EXPECT_EQ(DeviceSettings(lost.file()).choice().kind, "emulated-falcon");
  Settings kept(folder.filePath(QStringLiteral("Cusp.ini")));
  EXPECT_EQ(band_after_choice(kept), QString());
  EXPECT_EQ(DeviceSettings(kept.file()).choice().kind, "emulated-falcon");
}

TEST(DevicePage, a_trim_that_no_file_takes_holds_until_the_program_ends_and_is_reported) {
  const QTemporaryDir folder;
  Settings kept(folder.filePath(QStringLiteral("Cusp.ini"))), lost(unwritable_settings(folder));
  for (Settings* over : {&kept, &lost}) {
    DeviceSettings(over->file()).choose("falcon", "FT000001");
    const bool plugged = true;
    DevicePage page(*over, Ports::of_the_system(), Role::instructor, nullptr, [&plugged] { return std::make_unique<LateWatch>(plugged); });
    EXPECT_EQ(band_text(*page.falcon()), QString());
    page.findChild<TrimForm*>()->findChildren<NumberField*>().at(3)->setValue(80);  // of the hand's way
    EXPECT_EQ(band_text(*page.falcon()).startsWith(kUnkept), over == &lost) << band_text(*page.falcon()).toStdString();
    EXPECT_DOUBLE_EQ(DeviceSettings(over->file()).profile("FT000001").scale, 0.8);
  }
}

TEST(DevicePage, stop_has_the_keyboard_while_the_grip_pushes_and_gives_it_back) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  DeviceSettings(settings.file()).choose("emulated-falcon", {});
  Ports ports = Ports::of_the_system();
  ports.ask = [](QWidget*, const Question&, const std::function<void(bool)>& then) { then(true); };
  DevicePage page(settings, ports, Role::student, nullptr, [] { return std::make_unique<EmptyWatch>(); });
  page.show();
  page.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  FalconPanel& panel = *page.falcon();
  const auto button = [&panel](const QString& text) -> QPushButton* {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
      if (one->text().trimmed() == text) return one;
    return nullptr;
  };
  QPushButton *force = button(QStringLiteral("Feel the force")), *stop = button(QStringLiteral("Stop"));
  ASSERT_TRUE(force != nullptr && stop != nullptr);
  const auto is_ready = [&] {
    panel.look();
    return force->isEnabled();
  };
  ASSERT_TRUE(eventually(is_ready));
  force->setFocus();
  force->click();
  panel.look();
  EXPECT_EQ(QApplication::focusWidget(), stop);
  QTest::keyClick(stop, Qt::Key_Space);
  ASSERT_TRUE(eventually(is_ready));
  EXPECT_EQ(QApplication::focusWidget(), force);
}

TEST(DevicePage, try_again_has_the_keyboard_once_more_where_the_falcon_is_still_away) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  DeviceSettings(settings.file()).choose("falcon", "FT000001");
  const bool plugged = true;  // so the list has it; no test has one on its bus
  DevicePage page(settings, Ports::of_the_system(), Role::student, nullptr, [&plugged] { return std::make_unique<LateWatch>(plugged); });
  page.show();
  page.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  QPushButton* again = nullptr;
  for (QPushButton* one : page.falcon()->findChildren<QPushButton*>())
    if (one->text().trimmed() == QStringLiteral("Try again")) again = one;
  ASSERT_NE(again, nullptr);
  const auto is_offered = [&] {
    page.falcon()->look();
    return again->isVisible();
  };
  ASSERT_TRUE(eventually(is_offered));
  again->setFocus();
  again->click();
  ASSERT_FALSE(again->isVisible());
  ASSERT_TRUE(eventually(is_offered));
  EXPECT_EQ(QApplication::focusWidget(), again);
}

}  // namespace
}  // namespace cusp::test
