// The panel over a service in miniature: it asks only when asked to, and shows the answer.
#include "tests/modules.h"
#include "ui/device/inverse_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <numbers>

#include "tests/device/inverse/fake_service.h"
#include "tests/ui/device/eventually.h"
#include "tests/ui/device/unwritable_settings.h"
#include "tests/ui/session/gate.h"
#include "ui/settings/device_settings.h"
#include "ui/settings/settings.h"
#include "ui/session/background_task.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

using test::eventually;
using test::FakeService;

class InversePanelTest : public ::testing::Test {
 protected:
  static bool shows(QWidget& panel, const QString& text) {
    for (QLabel* label : panel.findChildren<QLabel*>()) {
      if (label->text().contains(text) && label->isVisibleTo(&panel)) return true;
    }
    return false;
  }
  QTemporaryDir folder;
  Settings settings{folder.filePath("Cusp.ini")};
};

TEST_F(InversePanelTest, follows_the_hand_once_it_was_asked_for) {
  FakeService service;
  service.set_hand({0.0125, 0, 0.1});
  InversePanel panel(&settings);
  panel.show();
  panel.findChildren<NumberField*>().last()->setValue(service.port());
  EXPECT_EQ(service.connections(), 0u);
  EXPECT_TRUE(panel.summary().contains("not asked"));
  panel.connect_to_it();
  ASSERT_TRUE(eventually([&] { return panel.summary().contains("answers"); }));
  EXPECT_TRUE(eventually([&] { return shows(panel, "12.5"); }));
  EXPECT_TRUE(shows(panel, "keeps its axis"));
  service.set_handle(FakeHandle{.a = true, .c = true});
  EXPECT_TRUE(eventually([&] { return shows(panel, "A, C"); }));
  service.set_handle(std::nullopt);
  EXPECT_TRUE(eventually([&] { return shows(panel, "Switch the handle on"); }));
  EXPECT_TRUE(shows(panel, "Does not report"));
  service.set_handle(FakeHandle{});
  EXPECT_TRUE(eventually([&] { return shows(panel, "Reports how it is turned"); }));
  service.set_way(FakeService::Way::silent);
  EXPECT_TRUE(eventually([&] { return panel.summary().contains("silent"); }));
  EXPECT_EQ(service.most_force_n(), 0.0);  // it only looks
  panel.release();
  EXPECT_TRUE(panel.summary().contains("not asked"));
}

TEST_F(InversePanelTest, shows_what_is_missing) {
  FakeService service;
  service.set_way(FakeService::Way::no_device);
  InversePanel panel(&settings);
  panel.show();
  panel.findChildren<NumberField*>().last()->setValue(service.port());
  panel.connect_to_it();
  EXPECT_TRUE(eventually([&] { return shows(panel, "knows of no Inverse3"); }));
  std::uint16_t nobody = 0;
  {
    FakeService gone;
    nobody = gone.port();
  }
  panel.findChildren<NumberField*>().last()->setValue(nobody);
  panel.connect_to_it();
  EXPECT_TRUE(eventually([&] { return shows(panel, "No service answers"); }));
}

/// A service that neither answers nor refuses: wait() hangs until the gate opens.
class HangingLink final : public inverse::InverseLink {
 public:
  explicit HangingLink(std::shared_ptr<test::Gate> gate) : gate_(std::move(gate)) {}
  inverse::LinkTime now() const noexcept override { return std::chrono::steady_clock::now(); }
  void open() override {}
  void send(std::string) override {}
  inverse::LinkEvent wait(inverse::LinkTime) override {
    gate_->pass();
    return {};
  }
  void close() noexcept override {}

 private:
  std::shared_ptr<test::Gate> gate_;
};

TEST_F(InversePanelTest, a_service_that_hangs_holds_the_window_neither_while_it_is_asked_nor_cancelled_nor_left) {
  auto gate = std::make_shared<test::Gate>();
  const auto make = [gate](const InverseSettings& wanted) {
    return std::make_unique<InversePort>(std::make_unique<HangingLink>(gate), wanted);
  };
  {
    InversePanel panel(&settings, make);
    panel.show();
    panel.connect_to_it();
    EXPECT_TRUE(panel.summary().contains("asking"));
    QPushButton* cancel = nullptr;
    for (QPushButton* b : panel.findChildren<QPushButton*>())
      if (b->text() == "Cancel") cancel = b;
    ASSERT_TRUE(cancel && cancel->isVisibleTo(&panel));
    cancel->click();
    EXPECT_TRUE(panel.summary().contains("not asked"));
    EXPECT_FALSE(cancel->isVisibleTo(&panel));
    panel.connect_to_it();  // and again at once, while the first is still being closed
    EXPECT_TRUE(panel.summary().contains("asking"));
    panel.hide();
    EXPECT_TRUE(panel.summary().contains("not asked"));
    panel.show();
    panel.connect_to_it();
  }
  EXPECT_FALSE(gate->gave_up());
  gate->open();
  wait_for_dropped_tasks();
  EXPECT_FALSE(gate->gave_up());
}

TEST_F(InversePanelTest, the_keyboard_goes_from_asking_to_cancelling_and_back) {
  auto gate = std::make_shared<test::Gate>();
  {
    InversePanel panel(&settings, [gate](const InverseSettings& wanted) {
      return std::make_unique<InversePort>(std::make_unique<HangingLink>(gate), wanted);
    });
    panel.show();
    panel.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
    const auto button = [&panel](const QString& text) -> QPushButton* {
      for (QPushButton* b : panel.findChildren<QPushButton*>())
        if (b->text().trimmed() == text) return b;
      return nullptr;
    };
    QPushButton *ask = button(QStringLiteral("Look for it")), *cancel = button(QStringLiteral("Cancel"));
    ASSERT_TRUE(ask != nullptr && cancel != nullptr);
    ask->setFocus();
    QTest::keyClick(ask, Qt::Key_Space);
    EXPECT_EQ(QApplication::focusWidget(), cancel);
    QTest::keyClick(cancel, Qt::Key_Space);
    EXPECT_EQ(QApplication::focusWidget(), ask);
  }
  gate->open();
  wait_for_dropped_tasks();
}

TEST_F(InversePanelTest, a_silent_service_is_asked_until_the_limit_and_the_bar_shows_how_long_it_may_last) {
  FakeService service;
  service.set_way(FakeService::Way::silent);
  InversePanel panel(&settings);
  panel.show();
  panel.findChildren<NumberField*>().last()->setValue(service.port());
  panel.connect_to_it();
  const auto* bar = panel.findChild<QProgressBar*>();
  EXPECT_TRUE(bar->isVisibleTo(&panel));
  EXPECT_TRUE(eventually([&] { return 2 * bar->value() > bar->maximum(); }));
  EXPECT_TRUE(eventually([&] { return panel.summary().contains("not found"); }));
  EXPECT_FALSE(bar->isVisibleTo(&panel));
  EXPECT_TRUE(shows(panel, "not as an Inverse3's service does"));
}

TEST_F(InversePanelTest, the_one_that_was_chosen_is_what_an_attempt_is_drilled_with) {
  FakeService service;
  DeviceSettings kept(settings.file());
  kept.choose("inverse3", "");
  InverseSettings stands = kept.inverse();
  stands.service.port = service.port();
  kept.set_inverse(stands);
  auto device = make_session_device(kept.choice(), {1, 2, 3}, 2);
  ASSERT_TRUE(device);
  EXPECT_FALSE(device->hand);
  ASSERT_TRUE(device->port->open());
  EXPECT_EQ(device->port->limits().device_class, "inverse3");
  Sample sample;
  for (int i = 0; i < 1000 && sample.status != Sample::Status::fresh; ++i) {
    sample = device->port->wait(std::chrono::steady_clock::now() + std::chrono::milliseconds(20));
    device->port->write({});
  }
  EXPECT_LT(glm::length(sample.position_mm - Vec3(1, 2, 3)), 1e-9);  // where the attempt begins
  device->port->close();
}

TEST_F(InversePanelTest, how_it_stands_is_kept_and_rubbish_is_the_usual) {
  InversePanel panel(&settings);
  panel.findChild<QComboBox*>()->setCurrentIndex(3);
  panel.findChildren<NumberField*>().first()->setValue(80);
  const InverseSettings kept = DeviceSettings(settings.file()).inverse();
  EXPECT_DOUBLE_EQ(kept.yaw_rad, 1.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(kept.scale, 0.8);
  EXPECT_EQ(kept.service.port, 10001);
  {
    QSettings store(settings.file(), QSettings::IniFormat);
    store.setValue("inverse/port", 70000);
    store.setValue("inverse/turned_deg", 17);
    store.setValue("inverse/scale_percent", "much");
  }
  const InverseSettings usual = DeviceSettings(settings.file()).inverse();
  EXPECT_EQ(usual.service.port, 10001);
  EXPECT_EQ(usual.yaw_rad, 0.0);
  EXPECT_EQ(usual.scale, 0.5);
}

TEST_F(InversePanelTest, how_it_stands_is_reported_where_no_file_takes_it) {
  Settings lost(unwritable_settings(folder));
  for (Settings* over : {&settings, &lost}) {
    InversePanel panel(over);
    panel.findChild<QComboBox*>()->setCurrentIndex(3);
    EXPECT_EQ(band_text(panel).startsWith(kUnkept), over == &lost) << band_text(panel).toStdString();
    EXPECT_DOUBLE_EQ(DeviceSettings(over->file()).inverse().yaw_rad, 1.5 * std::numbers::pi);
  }
}

}  // namespace
}  // namespace cusp::test
