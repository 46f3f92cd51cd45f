// What is kept, and what is asked, before the station is locked or the window closes.
#include <gtest/gtest.h>

#include <QDialog>
#include <QFile>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "scenarios/library/library.h"
#include "storage/sqlite/database.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/people_import.h"
#include "ui/app/desktop.h"
#include "ui/app/password_dialog.h"
#include "ui/app/quick_open.h"
#include "ui/editor/audit_page.h"
#include "ui/instructor/import_page.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

constexpr int kPatientMs = 60'000;  // waits for progress, never decides

struct Locking : ::testing::Test {
  Locking() {
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked.push_back(question.what);
      answer = std::move(then);
    };
    ports.pick_file = [this](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(folder.filePath(QStringLiteral("list.csv"))); };
  }
  void sign_in(const Account& who) {
    desktop = std::make_unique<Desktop>(settings, ports, records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(who);
  }
  /// Signs an instructor in and opens the editor with a draft that is not saved yet.
  Account edit_a_draft() {
    const Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
    sign_in(berg);
    EditorStart start;
    start.draft = *load_builtin("channel-1");
    start.draft.id = ScenarioId::make();
    start.draft.key.clear();
    desktop->edit(start);
    return berg;
  }
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
    EXPECT_TRUE(QTest::qWaitFor([&] { return !page->working(); }, kPatientMs));
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
  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  QStringList asked;
  std::function<void(bool)> answer;
  std::unique_ptr<Desktop> desktop;
};

TEST_F(Locking, waits_for_pin_slips_that_are_not_saved) {
  sign_in(records.administrator());
  PeopleImport* page = make_accounts();
  ASSERT_NE(page, nullptr);
  ASSERT_EQ(page->slips().size(), 2u);
  desktop->lock_idle();
  EXPECT_TRUE(desktop->account()) << "the PINs stand nowhere else";
  desktop->close();
  ASSERT_EQ(asked.size(), 1);
  EXPECT_TRUE(desktop->isVisible());
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  desktop->close();
  answer(true);
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(Locking, keeps_a_comment_for_whoever_wrote_it) {
  Store& store = records.store();
  const Account berg = *store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  const Account other = *store.accounts.create(records.administrator().actor(), {"holm", "Dr Holm", Role::instructor, "correct horse", ""});
  const SessionId session = records.attempt(records.student("1", "Lena Brandt"), "channel-1", 66, 90);
  sign_in(berg);
  MarkingCard* card = open_report(session);
  ASSERT_NE(card, nullptr);
  card->write(QStringLiteral("The floor\nis uneven."));
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

TEST_F(Locking, waits_for_a_draft_that_cannot_be_saved) {
  const Account berg = edit_a_draft();
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  // Refused as on a full disk, but at once.
  ASSERT_TRUE(database->run("CREATE TRIGGER refused BEFORE INSERT ON scenario_drafts BEGIN SELECT RAISE(FAIL, 'refused'); END"));
  desktop->lock_idle();
  EXPECT_TRUE(desktop->account()) << "the draft stands nowhere else";
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without the last edits?")});
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  ASSERT_TRUE(database->run("DROP TRIGGER refused"));
  desktop->lock_idle();
  EXPECT_FALSE(desktop->account());
  EXPECT_EQ(records.store().scenarios.drafts(berg.actor())->size(), 1u);
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
  QString text;
  for (const Band* band : desktop->page()->findChildren<Band*>()) text += band->text();
  EXPECT_TRUE(text.contains(QStringLiteral("but for the audit"))) << text.toStdString();
}

TEST_F(Locking, does_not_say_that_an_import_is_kept) {
  sign_in(records.administrator());
  desktop->import_specimen();
  auto* page = desktop->findChild<ImportPage*>();
  ASSERT_NE(page, nullptr);
  FileLook look;
  MeshInfo crown;
  crown.name = "crown";
  crown.high = Vec3(10.0);
  crown.closed = crown.oriented = true;
  look.meshes.push_back(crown);
  page->show_look(std::move(look));
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  QString text;
  for (const Band* band : desktop->page()->findChildren<Band*>()) text += band->text();
  EXPECT_TRUE(text.contains(QStringLiteral("but for the import"))) << text.toStdString();
}

}  // namespace
}  // namespace cusp::test
