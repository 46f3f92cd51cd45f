// What is asked before a page with a half-filled form, or at work, is left.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/station_page.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/session/background_task.h"
#include "ui/settings/settings.h"
#include "ui/signin/sign_in.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

/// The form of the people's page.
struct LeftForm : ::testing::Test {
  LeftForm() {
    ports.ask = [this](QWidget*, const Question& question, const std::function<void(bool)>& then) {
      asked += question.what;
      then(answer);
    };
    desktop = std::make_unique<Desktop>(settings, ports, records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(records.administrator());
    desktop->shell()->show_page(QStringLiteral("people"));
  }
  void type_name() {
    for (QLineEdit* field : desktop->shell()->page()->findChildren<QLineEdit*>())
      if (field->accessibleName() == QStringLiteral("Name")) field->setText(QStringLiteral("Mia Falk"));
  }
  QPushButton* in_sidebar(const char* name) {
    for (QPushButton* button : desktop->shell()->findChildren<QPushButton*>())
      if (button->isCheckable() && button->accessibleName() == QLatin1String(name)) return button;
    return nullptr;
  }
  std::string page() const { return desktop->shell()->page_key().toStdString(); }

  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  QStringList asked;
  bool answer = false;
  std::unique_ptr<Desktop> desktop;
};

TEST_F(LeftForm, is_asked_about_before_the_sidebar_leads_away) {
  QPushButton *people = in_sidebar("People"), *log = in_sidebar("Audit log");
  ASSERT_TRUE(people && log);
  type_name();
  log->click();
  EXPECT_EQ(asked, QStringList{QStringLiteral("Leave without saving the form?")});
  EXPECT_EQ(page(), "people");
  EXPECT_TRUE(people->isChecked()) << "it names the page that is shown";
  answer = true;
  log->click();
  EXPECT_EQ(page(), "audit");
  EXPECT_TRUE(log->isChecked());
  people->click();
  EXPECT_EQ(page(), "people");
  EXPECT_EQ(asked.size(), 2) << "the log has no form";
}

TEST_F(LeftForm, is_asked_about_before_its_author_signs_out) {
  auto* account = desktop->shell()->findChild<QPushButton*>(QStringLiteral("account"));
  ASSERT_NE(account, nullptr);
  QAction* sign_out = account->menu()->actions().constLast();
  type_name();
  sign_out->trigger();
  EXPECT_EQ(asked, QStringList{QStringLiteral("Leave without saving the form?")});
  EXPECT_TRUE(desktop->account());
  answer = true;
  sign_out->trigger();
  EXPECT_FALSE(desktop->account());
}

TEST_F(LeftForm, is_asked_about_before_another_look_makes_its_page_anew) {
  apply_theme(*qApp, ColourScheme::light, 100);
  const QWidget* shown = desktop->shell()->page();
  QAction* larger = nullptr;
  for (QAction* size : desktop->shell()->findChild<QPushButton*>(QStringLiteral("account"))->menu()->findChildren<QAction*>())
    if (size->data() == 150) larger = size;
  ASSERT_NE(larger, nullptr);
  type_name();
  larger->trigger();
  desktop->set_scheme(ColourScheme::dark);
  desktop->set_language(QStringLiteral("de"));
  desktop->set_exercise_language(QStringLiteral("de"));
  EXPECT_EQ(asked, QStringList(4, QStringLiteral("Leave without saving the form?")));
  EXPECT_EQ(desktop->shell()->page(), shown);
  EXPECT_EQ(scale_percent(), 100);
  EXPECT_FALSE(larger->isChecked()) << "the menu names the size that is shown";
  EXPECT_FALSE(tokens().dark);
  EXPECT_NE(settings.language(), QStringLiteral("de"));
  EXPECT_NE(settings.exercise_language(), QStringLiteral("de"));
  answer = true;
  larger->trigger();
  EXPECT_EQ(scale_percent(), 150);
  EXPECT_EQ(page(), "people");
  EXPECT_NE(desktop->shell()->page(), shown);
  EXPECT_EQ(asked.size(), 5);
  desktop->set_scheme(ColourScheme::dark);
  EXPECT_EQ(asked.size(), 5) << "the new page has an empty form";
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST_F(LeftForm, and_work_whose_outcome_its_page_alone_shows_are_asked_about) {
  desktop->shell()->show_page(QStringLiteral("station"));
  auto* station = qobject_cast<StationPage*>(desktop->shell()->page());
  ASSERT_NE(station, nullptr);
  station->back_up();
  ASSERT_TRUE(station->working());
  in_sidebar("Audit log")->click();
  desktop->set_scale(150);
  EXPECT_EQ(asked, QStringList(2, QStringLiteral("Leave before the work has ended?")));
  ASSERT_EQ(desktop->shell()->page(), station);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !station->working(); }, 60'000));
  EXPECT_FALSE(station->message().isEmpty());
  in_sidebar("Audit log")->click();
  EXPECT_EQ(page(), "audit");
  EXPECT_EQ(asked.size(), 2) << "the work has ended";
}

TEST_F(LeftForm, and_work_that_still_ran_are_named_where_the_station_is_locked) {
  desktop->shell()->show_page(QStringLiteral("station"));
  auto* station = qobject_cast<StationPage*>(desktop->shell()->page());
  ASSERT_NE(station, nullptr);
  station->back_up();
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  const auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(page->message().contains(QStringLiteral("but for the outcome of work"))) << page->message().toStdString();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the station's page
  wait_for_dropped_tasks();
}

}  // namespace
}  // namespace cusp::test
