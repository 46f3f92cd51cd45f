#include "ui/drill/bur_tray.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QSignalSpy>

#include "scenarios/library/library.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

bool asks_to_lift(const BurTray& tray) {
  for (const QLabel* label : tray.findChildren<QLabel*>())
    if (label->text().contains("Lift") && !label->isHidden()) return true;
  return false;
}

TEST(BurTray, says_what_to_do_while_the_wanted_bur_waits_for_the_air) {
  BurTray tray;
  tray.set_burs(load_builtin("class-1-36")->instruments);
  tray.show_burs(0, 0);
  EXPECT_FALSE(asks_to_lift(tray));
  tray.show_burs(0, 1);
  EXPECT_TRUE(asks_to_lift(tray));
  EXPECT_EQ(tray.chosen(), 1) << "the next one is counted from the wanted one";
  tray.show_burs(1, 1);
  EXPECT_FALSE(asks_to_lift(tray));
}

TEST(BurTray, reads_out_the_bur_that_a_key_or_the_device_has_chosen) {
  BurTray tray;
  tray.set_burs(load_builtin("class-1-36")->instruments);
  tray.show_burs(0, 0);
  const auto name = [&tray](int index) { return tray.findChildren<QAbstractButton*>().at(index)->accessibleName(); };
  EXPECT_TRUE(tray.accessibleDescription().isEmpty());
  tray.step(1);
  EXPECT_EQ(tray.accessibleDescription(), name(1));
  tray.show_burs(1, 1);
  tray.show_burs(0, 0);
  EXPECT_EQ(tray.accessibleDescription(), name(0));
}

TEST(BurTray, takes_no_key_while_it_is_disabled) {
  BurTray tray;
  tray.set_burs(load_builtin("class-1-36")->instruments);
  tray.show_burs(0, 0);
  QSignalSpy chosen(&tray, &BurTray::bur_chosen);
  tray.setEnabled(false);
  tray.step(1);
  EXPECT_EQ(tray.chosen(), 0);
  EXPECT_EQ(chosen.count(), 0);
  tray.setEnabled(true);
  tray.step(1);
  EXPECT_EQ(tray.chosen(), 1);
  EXPECT_EQ(chosen.count(), 1);
}

}  // namespace
}  // namespace cusp::test
