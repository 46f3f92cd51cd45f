// What assistive technology can do with the window: every button answers to its action, and what it does is done wholly.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/accessible_parts.h"
#include "ui/app/desktop.h"
#include "ui/app/quick_open.h"
#include "ui/app/quick_start.h"
#include "ui/settings/device_settings.h"
#include "ui/app/shell.h"
#include "ui/drill/bur_tray.h"
#include "ui/drill/drill_screen.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_records.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;  // waits for progress, never decides

QAccessibleActionInterface* actions_of(QObject* object) {
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(object);
  return face ? face->actionInterface() : nullptr;
}

/// What a screen reader does to act on a thing: the first of its actions.
void act_on(QObject* object) {
  QAccessibleActionInterface* act = actions_of(object);
  ASSERT_NE(act, nullptr);
  ASSERT_FALSE(act->actionNames().isEmpty());
  act->doAction(act->actionNames().first());
}

/// A window that lasts as long as the program: what is installed for accessibility stays.
struct Accessible : ::testing::Test {
  test::DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  std::unique_ptr<Desktop> desktop;

  static void SetUpTestSuite() {
    [[maybe_unused]] static const bool once = (install_accessible_parts(), true);
  }
  void open(const Account& account) {
    desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(account);
  }
  bool shows(const QString& part) const {
    for (const QLabel* label : desktop->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(part)) return true;
    return false;
  }
};

TEST_F(Accessible, every_kind_of_button_is_pressed_as_by_a_click) {
  QWidget window;
  auto* plain = new QPushButton(QStringLiteral("plain"), &window);
  auto* down = new QPushButton(QStringLiteral("down"), &window);
  down->setCheckable(true);
  auto* tool = new QToolButton(&window);
  tool->setCheckable(true);
  auto* radio = new QRadioButton(QStringLiteral("radio"), &window);
  Segments segments({QStringLiteral("one"), QStringLiteral("two")}, &window);
  window.show();
  for (QAbstractButton* button : {static_cast<QAbstractButton*>(plain), static_cast<QAbstractButton*>(down),
                                  static_cast<QAbstractButton*>(tool), static_cast<QAbstractButton*>(radio), segments.button(1)}) {
    QSignalSpy clicked(button, &QAbstractButton::clicked);
    act_on(button);
    EXPECT_TRUE(clicked.count() == 1 || clicked.wait(kPatienceMs)) << button->text().toStdString();
    EXPECT_EQ(button->isChecked(), button->isCheckable());
  }
  EXPECT_EQ(segments.chosen(), 1);
}

TEST_F(Accessible, a_bur_is_taken_from_the_tray_without_a_mouse) {
  BurTray tray;
  tray.set_burs(load_builtin("channel-1")->instruments);
  tray.show();
  QSignalSpy chosen(&tray, &BurTray::bur_chosen);
  const auto buttons = tray.findChildren<QAbstractButton*>();
  ASSERT_GE(buttons.size(), 2);
  EXPECT_EQ(QAccessible::queryAccessibleInterface(buttons[1])->role(), QAccessible::RadioButton);
  act_on(buttons[1]);
  ASSERT_TRUE(chosen.count() == 1 || chosen.wait(kPatienceMs));
  EXPECT_EQ(chosen[0][0].toInt(), 1);
  EXPECT_EQ(tray.chosen(), 1);
  tray.choose(0);  // the bur that the attempt reports is no choice
  EXPECT_EQ(chosen.count(), 1);
  buttons[1]->setChecked(true);  // as Qt's own accessibility does it
  EXPECT_EQ(chosen.count(), 2);
}

/// Page Down on whatever part of the page takes the focus by Tab.
void expect_keys_scroll(QWidget& page) {
  auto* area = page.findChild<QScrollArea*>();
  ASSERT_NE(area, nullptr);
  ASSERT_TRUE(QTest::qWaitFor([&] { return area->verticalScrollBar()->maximum() > 0; }, kPatienceMs));
  QWidget* inside = area->focusPolicy() & Qt::TabFocus ? static_cast<QWidget*>(area) : nullptr;
  for (QWidget* part : area->widget()->findChildren<QWidget*>())
    if (inside == nullptr && part->isVisible() && (part->focusPolicy() & Qt::TabFocus)) inside = part;
  ASSERT_NE(inside, nullptr) << "no key reaches what scrolls";
  QTest::keyClick(inside, Qt::Key_PageDown);
  EXPECT_GT(area->verticalScrollBar()->value(), 0);
}

TEST_F(Accessible, help_and_quick_start_are_read_to_their_end_by_the_keyboard) {
  open(records.student("1", "Lena Brandt"));
  desktop->showNormal();
  desktop->resize(960, 540);
  desktop->shell()->show_page(QStringLiteral("help"));
  expect_keys_scroll(*desktop->shell()->page());
  desktop->push(new QuickStart);
  expect_keys_scroll(*desktop->page());
}

TEST_F(Accessible, a_click_that_activates_too_goes_to_a_place_once) {
  QWidget window;
  int times = 0;
  auto* dialog = new QuickOpen({{QStringLiteral("Help"), QStringLiteral("page"), QStringLiteral("book"), [&times] { ++times; }}}, &window);
  dialog->open();
  auto* list = dialog->findChild<QListWidget*>();
  Q_EMIT list->itemClicked(list->item(0));
  Q_EMIT list->itemActivated(list->item(0));
  EXPECT_EQ(times, 1);
}

TEST_F(Accessible, exercises_are_offered_by_name_to_whoever_has_a_page_of_them) {
  const auto offers_exercises = [this](const Account& who) {
    open(who);
    for (QShortcut* keys : desktop->findChildren<QShortcut*>())
      if (keys->key() == QKeySequence(Qt::CTRL | Qt::Key_K)) Q_EMIT keys->activated();
    const auto* dialog = desktop->findChild<QuickOpen*>();
    if (dialog == nullptr) return false;
    const auto* list = dialog->findChild<QListWidget*>();
    EXPECT_FALSE(list->findItems(QStringLiteral("Help, page"), Qt::MatchExactly).isEmpty());
    return !list->findItems(QStringLiteral(", exercise"), Qt::MatchEndsWith).isEmpty();
  };
  EXPECT_TRUE(offers_exercises(records.student("1", "Lena Brandt")));
  EXPECT_FALSE(offers_exercises(records.administrator())) << "an administrator keeps the records and drills nothing";
}

TEST_F(Accessible, a_place_that_the_arrows_choose_is_spoken) {
  QWidget window;
  const auto nothing = [] {};
  auto* dialog = new QuickOpen({{QStringLiteral("Help"), QStringLiteral("page"), QStringLiteral("book"), nothing},
                                {QStringLiteral("Device"), QStringLiteral("page"), QStringLiteral("device"), nothing}},
                               &window);
  dialog->open();
  auto* line = dialog->findChild<QLineEdit*>();
  QTest::keyClick(line, Qt::Key_Down);
  EXPECT_EQ(line->accessibleDescription().toStdString(), "Device, page");
  line->setText(QStringLiteral("hel"));
  EXPECT_EQ(line->accessibleDescription().toStdString(), "Help, page");
}

TEST_F(Accessible, every_button_on_every_page_can_be_acted_on) {
  open(records.administrator());
  for (const NavEntry& entry : desktop->shell()->entries()) {
    desktop->shell()->show_page(entry.key);
    for (QAbstractButton* button : desktop->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || !button->isEnabled() || button->objectName().startsWith(u"qt_")) continue;
      QAccessibleActionInterface* act = actions_of(button);
      ASSERT_NE(act, nullptr) << button->accessibleName().toStdString();
      const QString first = act->actionNames().value(0);
      EXPECT_TRUE(first == QAccessibleActionInterface::pressAction() || first == QAccessibleActionInterface::toggleAction() ||
                  first == QAccessibleActionInterface::showMenuAction())
          << entry.key.toStdString() << ": " << button->accessibleName().toStdString();
    }
  }
}

TEST_F(Accessible, a_device_that_is_chosen_stands_in_the_sidebar_at_once) {
  open(records.administrator());
  EXPECT_TRUE(shows(QStringLiteral("Mouse and keys")));
  desktop->shell()->show_page(QStringLiteral("device"));
  QRadioButton* emulated = nullptr;
  for (QRadioButton* one : desktop->findChildren<QRadioButton*>())
    if (one->text().contains(QStringLiteral("Emulated"))) emulated = one;
  ASSERT_NE(emulated, nullptr);
  act_on(emulated);
  const auto sidebar = [&] { return shows(QStringLiteral("Emulated Falcon, driven by mouse")); };
  EXPECT_TRUE(QTest::qWaitFor(sidebar, kPatienceMs));
  EXPECT_FALSE(shows(QStringLiteral("Mouse and keys")));
}

TEST_F(Accessible, a_try_out_is_drilled_on_the_station_s_device) {
  DeviceSettings(settings.file()).choose("emulated-falcon", {});
  open(records.administrator());
  EditorStart start;
  start.published = *load_builtin("channel-1");
  start.published->specimen.voxel_mm = 0.4;  // so that it grows at once
  start.draft = *start.published;
  start.draft.version = 2;
  start.folder = drafts_folder(records.file(), start.draft.id).string();
  desktop->edit(start);
  auto* editor = qobject_cast<EditorPage*>(desktop->page());
  ASSERT_NE(editor, nullptr);
  ASSERT_TRUE(QTest::qWaitFor([&] { return editor->grown() != nullptr; }, kPatienceMs));
  editor->try_out();
  auto* screen = qobject_cast<DrillScreen*>(desktop->page());
  ASSERT_NE(screen, nullptr);
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kPatienceMs));
  EXPECT_TRUE(shows(QStringLiteral("Emulated Falcon")));
  screen->ask_leave();
}

}  // namespace
}  // namespace cusp::test
