// The window: who sees which pages, and what survives a change of language, colours and size.

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <limits>
#include <algorithm>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/exercise_file.h"
#include "scenarios/library/library.h"
#include "ui/app/desktop.h"
#include "ui/app/help_page.h"
#include "ui/app/quick_start.h"
#include "ui/device/device_page.h"
#include "ui/editor/editor_page.h"
#include "ui/text/language.h"
#include "ui/text/names.h"
#include "ui/app/shell.h"
#include "ui/signin/sign_in.h"
#include "ui/student/briefing.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

struct DesktopTest : ::testing::Test {
  test::DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  std::unique_ptr<Desktop> desktop;
  void open(const std::filesystem::path& file) {
    desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), file);
    desktop->start();
    desktop->show();
  }
  void TearDown() override {
    desktop.reset();
    install_language(*qApp, QStringLiteral("en"));
    choose_exercise_language({});
    apply_theme(*qApp, ColourScheme::light, 100);
  }
  QStringList pages() const {
    QStringList keys;
    for (const NavEntry& e : desktop->shell()->entries()) keys += e.key;
    return keys;
  }
};

TEST_F(DesktopTest, the_accounts_menu_puts_the_handpiece_into_the_other_hand) {
  const Account instructor = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  open(records.file());
  desktop->sign_in(instructor);
  const auto hands = desktop->shell()->findChild<QPushButton*>(QStringLiteral("account"))->menu()->findChildren<QAction*>();
  const auto left = std::ranges::find(hands, QStringLiteral("In the left hand"), &QAction::text);
  ASSERT_NE(left, hands.end());
  EXPECT_FALSE((*left)->isChecked());
  (*left)->trigger();
  EXPECT_TRUE(settings.left_handed());
}

TEST_F(DesktopTest, a_self_test_on_the_device_page_is_kept_with_its_tester) {
  const Account instructor = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  open(records.file());
  desktop->sign_in(instructor);
  desktop->shell()->show_page(QStringLiteral("device"));
  Q_EMIT desktop->shell()->findChild<DevicePage*>()->tested({.device_class = "falcon", .device = "FT1", .outcome = TestOutcome::failed});
  records.now_us = std::numeric_limits<std::int64_t>::max();  // the desktop's clock is the system's
  const auto kept = *records.store().device_tests.newest("falcon");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->device, "FT1");
  EXPECT_EQ(kept->outcome, TestOutcome::failed);
  EXPECT_EQ(kept->tester, instructor.id);
}

TEST_F(DesktopTest, who_leaves_the_desktop_is_signed_out_and_reads_why) {
  const Account lena = records.student("1", "Lena Brandt");
  settings.set_idle_minutes(20);
  open(records.file());
  desktop->sign_in(lena);
  desktop->lock_idle();
  EXPECT_FALSE(desktop->account());
  const auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(page->message().contains(QStringLiteral("20 minute"))) << page->message().toStdString();
  desktop->lock_idle();
  EXPECT_FALSE(desktop->account());
}

TEST_F(DesktopTest, each_role_has_its_pages) {
  const Account lena = records.student("1", "Lena Brandt");
  open(records.file());
  desktop->sign_in(lena);
  EXPECT_EQ(pages(), QStringList({QStringLiteral("start"), QStringLiteral("exercises"), QStringLiteral("results"), QStringLiteral("device"),
                                  QStringLiteral("help")}));
  desktop->sign_out();
  EXPECT_EQ(desktop->shell(), nullptr);
  desktop->sign_in(records.administrator());
  EXPECT_TRUE(pages().contains(QStringLiteral("people")));
  EXPECT_TRUE(pages().contains(QStringLiteral("performance")));
  EXPECT_FALSE(pages().contains(QStringLiteral("results")));
}

TEST_F(DesktopTest, who_makes_the_first_administrator_sees_five_pictures_and_finds_them_again_under_help) {
  open(folder.filePath(QStringLiteral("new.db")).toStdString());
  const QList<QLineEdit*> fields = desktop->page()->findChildren<QLineEdit*>();
  ASSERT_EQ(fields.size(), 4);
  const char* const typed[] = {"Anna Weber", "anna", "correct horse", "correct horse"};
  for (int i = 0; i < 4; ++i) fields[i]->setText(QLatin1String(typed[i]));
  QTest::keyClick(fields[3], Qt::Key_Return);
  const QuickStart* quick = nullptr;
  ASSERT_TRUE(QTest::qWaitFor([&] { return (quick = qobject_cast<QuickStart*>(desktop->page())) != nullptr; }, 60'000));
  int pictures = 0;
  for (const QLabel* label : quick->findChildren<QLabel*>()) pictures += !label->pixmap().isNull();
  EXPECT_EQ(pictures, 5);
  desktop->back();
  EXPECT_EQ(desktop->shell()->page_key().toStdString(), "people");
  desktop->shell()->show_page(QStringLiteral("help"));
  Q_EMIT desktop->shell()->findChild<HelpPage*>()->quick_start_wanted();
  EXPECT_NE(qobject_cast<QuickStart*>(desktop->page()), nullptr);
}

TEST_F(DesktopTest, help_names_a_page_that_the_role_has) {
  for (const Role role : {Role::student, Role::instructor, Role::administrator}) {
    const HelpPage help(role);
    QString all;
    for (const QLabel* label : help.findChildren<QLabel*>()) all += label->text() + u'\n';
    EXPECT_EQ(all.contains(QStringLiteral("under My results")), role == Role::student) << all.toStdString();
    EXPECT_EQ(all.contains(QStringLiteral("under Performance")), role != Role::student) << all.toStdString();
  }
}

TEST_F(DesktopTest, a_page_pushed_over_the_shell_is_left_by_going_back) {
  const Account lena = records.student("1", "Lena Brandt");
  open(records.file());
  desktop->sign_in(lena);
  desktop->shell()->show_page(QStringLiteral("exercises"));
  auto* over = new QWidget;
  desktop->push(over);
  EXPECT_EQ(desktop->page(), over);
  desktop->back();
  EXPECT_EQ(desktop->page(), desktop->shell());
  EXPECT_EQ(desktop->shell()->page_key().toStdString(), "exercises");
  desktop->back();  // nothing left to close
  EXPECT_EQ(desktop->page(), desktop->shell());
}

TEST_F(DesktopTest, a_page_of_an_attempt_with_large_text_is_larger_until_it_is_left) {
  const Account lena = records.student("1", "Lena Brandt");
  Store& store = records.store();
  const Actor examiner = store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
  const CohortId cohort = store.cohorts.create(examiner, "Year 3")->id;
  ASSERT_TRUE(store.cohorts.add(examiner, cohort, lena.id));
  const Scenario scenario = *load_builtin("channel-1");
  const VersionId version = store.scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes)->id;
  const Assignment exam = *store.assignments.create(examiner, {.version = version, .cohort = cohort, .kind = SessionKind::assessment}, "4711");
  NewSession wanted{.student = lena.id, .version = version, .assignment = exam.id, .start_code = "4711"};
  wanted.header.scene = "{}";
  const auto handed_in = [&](const SessionId& session) { return store.sessions.finish(session, {}, "student") ? session : SessionId{}; };
  const SessionId usual = handed_in(store.sessions.start(lena.actor(), wanted)->id);
  ASSERT_TRUE(store.assignments.adjust(examiner, exam.id, lena.id, {.large_text = true}));
  const SessionId large = handed_in(store.sessions.start(lena.actor(), wanted)->id);
  open(records.file());
  desktop->sign_in(lena);
  const auto size_of = [&](const SessionId& session) {
    desktop->open_report(session);
    const int size = scale_percent();
    desktop->back();
    return std::pair{size, scale_percent()};
  };
  desktop->set_scale(125);
  EXPECT_EQ(size_of(usual), std::pair(125, 125));
  EXPECT_EQ(size_of(large), std::pair(kLargeTextPercent, 125));
  desktop->open_report(large);
  desktop->set_scheme(ColourScheme::dark);
  EXPECT_EQ(scale_percent(), kLargeTextPercent) << "also in other colours";
  desktop->sign_out();
  EXPECT_EQ(scale_percent(), 125);
  desktop->set_scale(200);
  desktop->sign_in(lena);
  EXPECT_EQ(size_of(large), std::pair(200, 200)) << "whoever sees them larger keeps that";
}

TEST_F(DesktopTest, language_and_colours_change_at_once_and_keep_the_page) {
  const Account lena = records.student("1", "Lena Brandt");
  open(records.file());
  desktop->sign_in(lena);
  desktop->shell()->show_page(QStringLiteral("exercises"));
  desktop->set_language(QStringLiteral("de"));
  EXPECT_EQ(desktop->shell()->page_key().toStdString(), "exercises");
  EXPECT_EQ(desktop->shell()->entries()[1].name.toStdString(), "Übungen");
  EXPECT_EQ(settings.language().toStdString(), "de");
  desktop->set_scheme(ColourScheme::dark);
  EXPECT_TRUE(tokens().dark);
  desktop->set_scale(150);
  EXPECT_EQ(scale_percent(), 150);
  EXPECT_EQ(desktop->shell()->page_key().toStdString(), "exercises");
}

TEST_F(DesktopTest, exercises_in_a_language_that_the_program_does_not_speak_can_be_chosen_and_stay_so) {
  const Account instructor = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  open(records.file());
  desktop->sign_in(instructor);
  const auto choice = [&](const QString& name) -> QAction* {
    for (QMenu* menu : desktop->shell()->findChildren<QMenu*>())
      for (QAction* action : menu->title() == QStringLiteral("Exercises in") ? menu->actions() : QList<QAction*>())
        if (action->text() == name) return action;
    return nullptr;
  };
  EXPECT_EQ(choice(QStringLiteral("As the program")), nullptr) << "there is nothing to choose";
  Scenario french = *load_builtin("channel-1");
  ++french.version;
  french.title["fr"] = "Canal droit";
  ASSERT_TRUE(records.store().scenarios.publish(instructor.actor(), french, canonical_json(french), content_hash(french).bytes));
  desktop->set_scale(100);  // makes the pages anew
  QAction* chosen = choice(QStringLiteral("Français"));
  ASSERT_NE(chosen, nullptr);
  chosen->trigger();
  EXPECT_EQ(settings.exercise_language(), QStringLiteral("fr"));
  EXPECT_EQ(local(french.title), QStringLiteral("Canal droit"));
  EXPECT_EQ(local({{"en", "Channel"}}), QStringLiteral("Channel"));
  EXPECT_TRUE(choice(QStringLiteral("Français"))->isChecked());
  choice(QStringLiteral("As the program"))->trigger();
  EXPECT_EQ(local(french.title), QString::fromStdString(french.title.at("en")));
}

TEST_F(DesktopTest, what_was_typed_at_sign_in_survives_a_change_of_language) {
  records.administrator();
  open(records.file());
  auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  page->set_typed_number(QStringLiteral("20267314"), SignIn::Who::student);
  desktop->set_language(QStringLiteral("de"));
  page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(page->typed_number().toStdString(), "20267314");
}

TEST_F(DesktopTest, a_file_that_is_no_database_is_refused_with_a_message_and_left_alone) {
  const QString name = folder.filePath(QStringLiteral("letter.txt"));
  QFile letter(name);
  ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
  letter.write(QByteArray(4096, 'a'));
  letter.close();
  open(name.toStdString());
  QString all;
  for (const QLabel* label : desktop->findChildren<QLabel*>()) all += label->text() + u'\n';
  EXPECT_TRUE(all.contains(QStringLiteral("This file is not a Cusp database."))) << all.toStdString();
  ASSERT_TRUE(letter.open(QIODevice::ReadOnly));
  EXPECT_EQ(letter.readAll(), QByteArray(4096, 'a'));
}

TEST_F(DesktopTest, every_control_on_every_page_has_a_name) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 426);
  open(records.file());
  for (const Account& who : {records.administrator(), lena}) {
    desktop->sign_in(who);
    for (const NavEntry& entry : desktop->shell()->entries()) {
      desktop->shell()->show_page(entry.key);
      for (const QWidget* w : desktop->findChildren<QWidget*>()) {
        const bool control = w->inherits("QAbstractButton") || w->inherits("QLineEdit") || w->inherits("QComboBox") ||
                             w->inherits("QTableView");
        if (!control || !w->isVisible() || w->objectName().startsWith(u"qt_") || w->inherits("QHeaderView") ||
            w->parentWidget()->inherits("QTableView") || w->parentWidget()->inherits("QLineEdit")) {
          continue;
        }
        EXPECT_FALSE(w->accessibleName().isEmpty())
            << entry.key.toStdString() << ": " << w->metaObject()->className() << " " << w->objectName().toStdString();
      }
    }
  }
}

QStringList bands_of(QWidget& page) {
  QStringList shown;
  for (const Band* band : page.findChildren<Band*>()) {
    if (band->isVisibleTo(&page)) shown += band->text();
  }
  return shown;
}

TEST_F(DesktopTest, an_incident_of_the_records_is_named_to_staff_and_not_to_students) {
  const Account lena = records.student("1", "Lena Brandt");
  const Account chief = records.administrator();
  std::filesystem::remove(records.file().string() + ".key-counter");
  open(records.file());
  auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(bands_of(*page).isEmpty()) << "where students sign in";
  page->set_typed_number({}, SignIn::Who::staff);
  const QString command = QStringLiteral("verify");
  ASSERT_EQ(bands_of(*page).size(), 1);
  EXPECT_TRUE(bands_of(*page).first().contains(QStringLiteral("The counter beside the records’ key is missing."))) << bands_of(*page).first().toStdString();
  EXPECT_TRUE(bands_of(*page).first().contains(command));
  page->set_typed_number({}, SignIn::Who::student);
  EXPECT_TRUE(bands_of(*page).isEmpty());
  desktop->sign_in(lena);
  EXPECT_FALSE(bands_of(*desktop->shell()).join(u' ').contains(command));
  desktop->sign_in(chief);
  EXPECT_TRUE(bands_of(*desktop->shell()).join(u' ').contains(command));
}

TEST_F(DesktopTest, on_a_full_disk_results_are_read_and_nothing_is_drilled) {
  const Account lena = records.student("1", "Lena Brandt", "271828");
  records.attempt(lena, "channel-1", 78, 426);
  bool full = true;
  const auto access = [](const StoreOptions& options) { return options.database.access; };
  desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file(),
                                      [&](const std::filesystem::path& file, const StoreOptions& options) -> Stored<std::unique_ptr<Store>> {
                                        if (full && access(options) != DatabaseOptions::Access::read_only) {
                                          return fail(StorageError::disk_full, file.string());
                                        }
                                        return Store::open(file, options);
                                      });
  desktop->start();
  desktop->show();
  auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  ASSERT_EQ(bands_of(*page).size(), 1);
  EXPECT_TRUE(bands_of(*page).first().startsWith(QStringLiteral("The disk is full."))) << bands_of(*page).first().toStdString();
  const auto account = desktop->store()->accounts.sign_in_with_pin("1", "271828");
  ASSERT_TRUE(account);
  desktop->sign_in(*account);
  EXPECT_EQ(pages(), QStringList({QStringLiteral("results"), QStringLiteral("device"), QStringLiteral("help")}));
  EXPECT_TRUE(bands_of(*desktop->shell()).join(u' ').contains(QStringLiteral("The disk is full.")));
  desktop->sign_in(records.administrator());
  EXPECT_EQ(pages(), QStringList({QStringLiteral("people"), QStringLiteral("performance"), QStringLiteral("audit"), QStringLiteral("device"),
                                  QStringLiteral("help")}));
  desktop->sign_out();
  full = false;
  Q_EMIT qobject_cast<SignIn*>(desktop->page())->try_again();
  EXPECT_TRUE(bands_of(*desktop->page()).isEmpty());
  desktop->sign_in(lena);
  EXPECT_EQ(pages().first(), QStringLiteral("start"));
}

TEST_F(DesktopTest, a_waiting_exercise_file_opens_for_an_instructor_and_names_who_may_open_it_to_others) {
  const Account lena = records.student("1", "Lena Brandt");
  const Account mara = *records.store().accounts.create(records.administrator().actor(),
                                                        {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  Scenario sent = *load_builtin("channel-1");
  sent.id = ScenarioId{Uuid::v7()};
  const QString file = folder.filePath(QStringLiteral("shallow.cusp"));
  ASSERT_TRUE(write_exercise_file({sent, {}}, file.toStdString()));
  desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file());
  desktop->open_after_sign_in(file);
  desktop->start();
  desktop->show();
  for (const Account& who : {lena, records.administrator()}) {
    desktop->sign_in(who);
    QString all;
    for (const QLabel* label : desktop->page()->findChildren<QLabel*>()) all += label->text() + u'\n';
    EXPECT_TRUE(all.contains(QStringLiteral("shallow.cusp is not open."))) << all.toStdString();
    EXPECT_TRUE(all.contains(QStringLiteral("sign in as an instructor"))) << all.toStdString();
    desktop->back();
    EXPECT_EQ(desktop->page(), desktop->shell());
    desktop->sign_out();
  }
  EXPECT_TRUE(desktop->store()->scenarios.drafts(mara.actor())->empty());
  desktop->sign_in(mara);
  EXPECT_TRUE(QTest::qWaitFor([&] { return qobject_cast<EditorPage*>(desktop->page()) != nullptr; }, 60'000));
  EXPECT_EQ(desktop->store()->scenarios.drafts(mara.actor())->size(), 1u);
  desktop->sign_out();
  desktop->sign_in(mara);
  EXPECT_EQ(desktop->page(), desktop->shell()) << "it opens once";
}

TEST_F(DesktopTest, f6_walks_through_the_panes) {
  const Account lena = records.student("1", "Lena Brandt");
  open(records.file());
  desktop->sign_in(lena);
  desktop->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(desktop.get()));
  QSet<QWidget*> met;
  for (int i = 0; i < 3; ++i) {
    desktop->shell()->next_pane();
    met.insert(QApplication::focusWidget());
  }
  EXPECT_EQ(met.size(), 3);
}

}  // namespace
}  // namespace cusp::test
