// What is kept, and what is asked, before the station is locked or the window closes.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDateTime>
#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <chrono>

#include "scenarios/library/library.h"
#include "storage/sqlite/database.h"
#include "tests/modules.h"
#include "tests/refused_rows.h"
#include "tests/ui/app/asking_desktop.h"
#include "ui/admin/people_import.h"
#include "ui/app/password_dialog.h"
#include "ui/app/quick_open.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/editor/audit_page.h"
#include "ui/editor/editor_page.h"
#include "ui/instructor/cohorts_page.h"
#include "ui/instructor/import_page.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/session/background_task.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

constexpr int kPatientMs = 60'000;  // waits for progress, never decides

struct Locking : AskingDesktop {
  Locking() {
    ports.pick_file = [this](QWidget*, const FileWish& wish, const std::function<void(const QString&)>& then) {
      then(folder.filePath(wish.saving ? QStringLiteral("slips.pdf") : QStringLiteral("list.csv")));
    };
  }
  /// Signs an instructor in and opens the editor with a draft that is not saved yet.
  Account edit_a_draft() {
    const Account berg = instructor();
    sign_in(berg);
    EditorStart start;
    start.draft = *load_builtin("channel-1");
    start.draft.id = ScenarioId::make();
    start.draft.key.clear();
    desktop->edit(start);
    return berg;
  }
  /// The page whose accounts are being made. nullptr: there is none.
  PeopleImport* make_accounts() {
    QFile list(folder.filePath(QStringLiteral("list.csv")));
    EXPECT_TRUE(list.open(QIODevice::WriteOnly));
    list.write("Number,Name\n11,Lena Brandt\n12,Jonas Weber\n");
    list.close();
    desktop->import_people();
    auto* page = desktop->findChild<PeopleImport*>();
    if (page == nullptr) return nullptr;
    page->choose_file();
    page->start();
    return page;
  }
  MarkingCard* open_report(const SessionId& session) {
    auto result = std::make_shared<SessionResult>();
    result->session = session;
    result->scenario = *load_builtin("channel-1");
    result->grade = (*records.store().grades.newest(session))->grade;
    desktop->end_attempt(result, std::nullopt);
    const auto card = [&] { return desktop->page()->findChild<MarkingCard*>(); };
    EXPECT_TRUE(QTest::qWaitFor([&] { return card() != nullptr; }, kPatientMs));
    return card();
  }
  /// Signs in, and writes on the report of an attempt. nullptr: there is none to write on.
  MarkingCard* write_comment(const Account& author, const SessionId& session, const QString& text) {
    sign_in(author);
    MarkingCard* card = open_report(session);
    if (card != nullptr) card->write(text);
    return card;
  }
  /// The name in the form of the shell's page. nullptr: it has none.
  QLineEdit* name_field() const {
    for (QLineEdit* field : desktop->shell()->page()->findChildren<QLineEdit*>())
      if (field->accessibleName() == QStringLiteral("Name")) return field;
    return nullptr;
  }
  /// An import with a mesh that was read. nullptr: no page is open.
  ImportPage* begin_import() {
    desktop->import_specimen();
    auto* page = desktop->findChild<ImportPage*>();
    FileLook look;
    MeshInfo crown;
    crown.name = "crown";
    crown.high = Vec3(10.0);
    crown.closed = crown.oriented = true;
    look.meshes.push_back(crown);
    if (page != nullptr) page->show_look(std::move(look));
    return page;
  }
  /// What the bands of the page say.
  QString bands() const {
    QString text;
    for (const Band* band : desktop->page()->findChildren<Band*>()) text += band->text();
    return text;
  }
};

TEST_F(Locking, counts_its_time_from_the_end_of_an_attempt_for_a_device_moves_without_mouse_and_keys) {
  const auto now = std::make_shared<std::chrono::milliseconds>(0);
  ports.since_boot = [now] { return *now; };
  ASSERT_TRUE(settings.set_idle_minutes(15));
  sign_in(instructor());
  desktop->push(new DrillScreen(ports));
  QLineEdit field;
  *now += std::chrono::minutes(40);
  QTest::keyClick(&field, Qt::Key_A);
  EXPECT_EQ(field.text(), QStringLiteral("a")) << "the first key after a while is for the attempt";
  *now += std::chrono::minutes(15) - std::chrono::seconds(1);
  desktop->back();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  *now += std::chrono::seconds(2);
  QTest::keyClick(&field, Qt::Key_B);
  QTest::qWait(1);  // the lock comes in a turn of its own
  EXPECT_TRUE(desktop->account());
  *now += std::chrono::minutes(15);
  QTest::keyClick(&field, Qt::Key_B);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !desktop->account(); }, kPatientMs));
}

TEST_F(Locking, leaves_the_pin_slips_of_accounts_that_were_being_made_or_neither) {
  sign_in(records.administrator());
  const QPointer<PeopleImport> page = make_accounts();
  ASSERT_TRUE(page);
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(page);
  wait_for_dropped_tasks();
  const bool made = records.store().accounts.find_number("11").has_value();
  EXPECT_EQ(QFile::exists(folder.filePath(QStringLiteral("slips.pdf"))), made);
}

TEST_F(Locking, asks_before_it_closes_while_accounts_are_being_made) {
  sign_in(records.administrator());
  const PeopleImport* page = make_accounts();
  ASSERT_NE(page, nullptr);
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close before the work has ended?")});
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page->working(); }, kPatientMs));
  desktop->close();
  EXPECT_EQ(asked.size(), 1) << "the slips are written";
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(Locking, keeps_a_comment_for_whoever_wrote_it) {
  Store& store = records.store();
  const Account berg = *store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  const Account other = *store.accounts.create(records.administrator().actor(), {"holm", "Dr Holm", Role::instructor, "correct horse", ""});
  const SessionId session = records.attempt(records.student("1", "Lena Brandt"), "channel-1", 66, 90);
  ASSERT_NE(write_comment(berg, session, QStringLiteral("The floor\nis uneven.")), nullptr);
  desktop->close();
  EXPECT_EQ(asked.size(), 1) << "closing asks";
  answer(false);
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  const auto written_by = [&](const Account& who) {
    desktop->sign_in(who);
    MarkingCard* fresh = open_report(session);
    return fresh == nullptr ? QString() : fresh->written();
  };
  EXPECT_EQ(written_by(other), QString());
  desktop->lock_idle();
  EXPECT_EQ(written_by(berg), QStringLiteral("The floor\nis uneven."));
}

TEST_F(Locking, asks_before_it_closes_over_a_comment_that_waits_for_its_author) {
  const Account berg = instructor();
  const SessionId session = records.attempt(records.student("1", "Lena Brandt"), "channel-1", 66, 90);
  ASSERT_NE(write_comment(berg, session, QStringLiteral("The floor is uneven.")), nullptr);
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the report that it was written on
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without the comment?")});
  EXPECT_TRUE(more.contains(QStringLiteral("Dr Berg"))) << more.toStdString();
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  desktop->sign_in(berg);
  MarkingCard* card = open_report(session);
  ASSERT_NE(card, nullptr);
  EXPECT_TRUE(card->unsaved());
  card->write({});
  desktop->close();
  EXPECT_EQ(asked.size(), 1);
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(Locking, puts_a_draft_that_cannot_be_saved_behind_the_lock_for_its_owner) {
  const Account berg = edit_a_draft();
  const Account lena = records.student("1", "Lena Brandt");
  const QPointer<EditorPage> editor = desktop->findChild<EditorPage*>();
  ASSERT_TRUE(editor);
  ASSERT_TRUE(editor->model().set_title("en", QStringLiteral("Fresh title")));
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  // Refused as on a full disk, but at once.
  ASSERT_TRUE(refuse_rows(*database, "scenario_drafts"));
  auto* dialog = new QDialog(editor);
  dialog->show();
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  EXPECT_FALSE(editor->isVisible());
  EXPECT_EQ(editor->findChild<QDialog*>(), nullptr) << "a dialog would stay in sight";
  EXPECT_TRUE(bands().contains(QStringLiteral("Not saved yet: the work of Dr Berg"))) << bands().toStdString();
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without the last edits?")});
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  desktop->sign_in(lena);
  EXPECT_FALSE(editor->isVisible());
  Q_EMIT editor->back_wanted();
  EXPECT_EQ(desktop->page(), desktop->shell());
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account()) << "the student’s desk locks too";
  EXPECT_TRUE(bands().contains(QStringLiteral("What you did is kept"))) << bands().toStdString();
  desktop->sign_in(berg);
  ASSERT_EQ(desktop->page(), editor);
  EXPECT_EQ(editor->model().scenario().title.at("en"), "Fresh title");
  ASSERT_TRUE(take_rows(*database, "scenario_drafts"));
  desktop->lock_idle();
  EXPECT_FALSE(desktop->account());
  EXPECT_EQ(records.store().scenarios.drafts(berg.actor())->size(), 1u);
}

TEST_F(Locking, gives_the_keyboard_to_a_control_of_the_page_that_was_behind_the_lock) {
  apply_theme(*qApp, ColourScheme::light, 100);
  const Account berg = edit_a_draft();
  desktop->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(desktop.get()));
  const QPointer<EditorPage> editor = desktop->findChild<EditorPage*>();
  ASSERT_TRUE(editor);
  ASSERT_TRUE(editor->isAncestorOf(QApplication::focusWidget()));
  ASSERT_TRUE(editor->model().set_title("en", QStringLiteral("Fresh title")));
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(refuse_rows(*database, "scenario_drafts"));
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  desktop->sign_in(berg);
  ASSERT_EQ(desktop->page(), editor);
  EXPECT_TRUE(editor->isAncestorOf(QApplication::focusWidget()));
  EXPECT_NE(QApplication::focusWidget(), editor) << "the page itself answers no keys";
  ASSERT_TRUE(take_rows(*database, "scenario_drafts"));
}

TEST_F(Locking, saves_a_draft_behind_the_lock_when_the_next_person_signs_in) {
  const Account berg = edit_a_draft();
  const Account lena = records.student("1", "Lena Brandt");
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(refuse_rows(*database, "scenario_drafts"));
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  ASSERT_TRUE(take_rows(*database, "scenario_drafts"));
  desktop->sign_in(lena);
  EXPECT_EQ(records.store().scenarios.drafts(berg.actor())->size(), 1u);
  EXPECT_EQ(desktop->findChild<EditorPage*>(), nullptr);
  desktop->close();
  EXPECT_TRUE(asked.isEmpty());
}

TEST_F(Locking, gives_no_page_back_to_whoever_has_another_role_by_then) {
  const Account berg = edit_a_draft();
  const QPointer<EditorPage> editor = desktop->findChild<EditorPage*>();
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(refuse_rows(*database, "scenario_drafts"));
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  Accounts& accounts = records.store().accounts;
  const Actor administrator = records.administrator().actor();
  ASSERT_TRUE(accounts.set_role(administrator, berg.id, Role::student));
  desktop->sign_in(*accounts.find(berg.id));
  EXPECT_EQ(desktop->page(), desktop->shell()) << "the editor acts as an instructor";
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  ASSERT_TRUE(accounts.set_role(administrator, berg.id, Role::instructor));
  desktop->sign_in(*accounts.find(berg.id));
  ASSERT_TRUE(editor);
  EXPECT_EQ(desktop->page(), editor);
}

TEST_F(Locking, closes_the_dialogs_of_whoever_was_signed_out) {
  const Account lena = records.student("1", "Lena Brandt");
  sign_in(lena);
  (new QuickOpen({}, desktop.get()))->open();
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  EXPECT_EQ(desktop->findChild<QDialog*>(), nullptr) << "what it offers needs an account";
  desktop->sign_in(lena);
  (new PasswordDialog(records.store(), lena, desktop.get()))->open();
  desktop->lock_idle();
  EXPECT_EQ(desktop->findChild<QDialog*>(), nullptr);
}

TEST_F(Locking, does_not_say_that_a_running_audit_is_kept) {
  edit_a_draft();
  ASSERT_TRUE(QTest::qWaitFor([&] { return desktop->findChild<AuditPage*>() != nullptr; }, kPatientMs));
  for (QPushButton* one : desktop->findChild<AuditPage*>()->findChildren<QPushButton*>())
    if (one->text().trimmed() == QStringLiteral("Measure")) one->click();
  ASSERT_TRUE(desktop->findChild<AuditPage*>()->measuring());
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  EXPECT_TRUE(bands().contains(QStringLiteral("but for the audit"))) << bands().toStdString();
}

TEST_F(Locking, does_not_say_that_a_half_filled_form_is_kept) {
  const Account berg = instructor();
  const auto note_after = [this](const Account& who, const char* key, const std::function<void(QWidget&)>& fill) {
    desktop ? desktop->sign_in(who) : sign_in(who);
    desktop->shell()->show_page(QLatin1String(key));
    fill(*desktop->shell()->page());
    desktop->lock_idle();
    EXPECT_FALSE(desktop->account());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the pages of who was signed in
    return bands();
  };
  const QString lost = QStringLiteral("but for the form that was not saved"), kept = QStringLiteral("What you did is kept.");
  EXPECT_TRUE(note_after(records.administrator(), "people", [](QWidget&) {}).contains(kept)) << bands().toStdString();
  EXPECT_TRUE(note_after(records.administrator(), "people", [&](QWidget&) { name_field()->setText(QStringLiteral("Mia Falk")); }).contains(lost)) << bands().toStdString();
  EXPECT_TRUE(note_after(berg, "cohorts", [](QWidget&) {}).contains(kept)) << bands().toStdString();
  EXPECT_TRUE(note_after(berg, "cohorts", [](QWidget& page) {
                dynamic_cast<CohortsPage&>(page).form()->choose_due(QDateTime(QDate(2099, 1, 1), QTime(9, 0)));
              }).contains(lost))
      << bands().toStdString();
}

TEST_F(Locking, does_not_say_that_an_import_is_kept) {
  sign_in(records.administrator());
  ASSERT_NE(begin_import(), nullptr);
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  EXPECT_TRUE(bands().contains(QStringLiteral("but for the import"))) << bands().toStdString();
}

TEST_F(Locking, asks_before_it_closes_over_an_import_that_is_begun) {
  sign_in(records.administrator());
  ASSERT_NE(begin_import(), nullptr);
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without the import?")});
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  desktop->close();
  answer(true);
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(Locking, asks_before_it_closes_over_a_half_filled_form) {
  sign_in(records.administrator());
  desktop->shell()->show_page(QStringLiteral("people"));
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the page that was shown first
  QLineEdit* name = name_field();
  ASSERT_NE(name, nullptr);
  const QString saved = name->text();
  name->setText(QStringLiteral("Mia Falk"));
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without saving the form?")});
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  EXPECT_EQ(name->text(), QStringLiteral("Mia Falk"));
  name->setText(saved);
  desktop->close();
  EXPECT_EQ(asked.size(), 1) << "nothing is lost";
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(Locking, asks_one_question_before_it_closes_over_an_import_and_a_form) {
  sign_in(records.administrator());
  desktop->shell()->show_page(QStringLiteral("people"));
  ASSERT_NE(name_field(), nullptr);
  name_field()->setText(QStringLiteral("Mia Falk"));
  ASSERT_NE(begin_import(), nullptr);
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without the import?")});
  EXPECT_TRUE(more.contains(QStringLiteral("What was filled in and not saved"))) << more.toStdString();
  answer(true);
  EXPECT_EQ(asked.size(), 1);
  EXPECT_FALSE(desktop->isVisible());
}

}  // namespace
}  // namespace cusp::test
