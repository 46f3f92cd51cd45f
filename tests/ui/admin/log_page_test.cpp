// The audit log's page: pages, filters, words for every code, verification, cancelling it, CSV.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDateEdit>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>
#include <future>
#include <regex>
#include <set>
#include <sstream>

#include "tests/modules.h"
#include "tests/source_dir.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/export_work.h"
#include "ui/admin/log_page.h"
#include "ui/text/audit_log_text.h"
#include "ui/text/language.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

constexpr int kLongestMs = 60'000;
constexpr int kMany = 250;  // entries: more than one page of the table

class LogPages : public testing::Test {
 protected:
  LogPages() : admin(records.administrator()), lena(records.student("4711", "Lena Brandt")) {
    records.attempt(lena, "channel-1", 81, 60);
    EXPECT_TRUE(records.store().accounts.disable(admin.actor(), lena.id));
    ports.now = [this] { return QDateTime::fromMSecsSinceEpoch(records.now_us / 1000); };
    ports.pick_file = [this](QWidget*, const FileWish&, std::function<void(const QString&)> then) { then(file); };
  }
  std::unique_ptr<LogPage> page() { return std::make_unique<LogPage>(records.store(), admin.actor(), ports); }
  void add_many() {
    for (int i = 0; i < kMany; ++i) ASSERT_TRUE(records.store().audit.add({.actor = admin.id, .action = "backed_up", .subject = {}, .detail = "1"}));
  }
  static bool waited(const LogPage& page) {
    return QTest::qWaitFor([&] { return !page.verifying(); }, kLongestMs);
  }
  /// The band that offers to read entries again; nullptr while none is shown.
  static Band* unread_band(const LogPage& page) {
    for (Band* band : page.findChildren<Band*>())
      if (band->isVisibleTo(&page) && band->findChild<QPushButton*>() != nullptr) return band;
    return nullptr;
  }
  static QString cell(const LogPage& page, int row, int column) { return page.model().index(row, column).data().toString(); }
  static int choose(QComboBox* box, const QString& text) {
    box->setCurrentIndex(box->findText(text));
    return box->currentIndex();
  }

  DeskRecords records;
  QTemporaryDir folder;
  Account admin, lena;
  Ports ports;
  QString file = folder.filePath(QStringLiteral("log.csv"));
};

TEST_F(LogPages, ShowsWhoDidWhatToWhomNewestFirst) {
  const auto shown = page();
  EXPECT_EQ(cell(*shown, 0, LogModel::kWhat), QStringLiteral("Account disabled"));
  EXPECT_EQ(cell(*shown, 0, LogModel::kWho), QString::fromStdString(admin.name));
  EXPECT_EQ(cell(*shown, 0, LogModel::kAbout), QStringLiteral("Lena Brandt"));
  QStringList all;
  for (int row = 0; row < shown->model().rowCount(); ++row) all += cell(*shown, row, LogModel::kWhat);
  for (const char* what : {"Attempt started", "Attempt finished", "Attempt graded", "Account created", "Key of this station added"}) {
    EXPECT_TRUE(all.contains(QLatin1String(what))) << what << " in " << all.join(u'\n').toStdString();
  }
}

TEST_F(LogPages, KnowsWhoWasAddedOrErasedAtAnotherWindowWhenItReadsAnew) {
  const auto shown = page();
  ASSERT_TRUE(records.store().accounts.erase(admin.actor(), lena.id));
  records.student("4712", "Omar Haddad");
  shown->read();
  EXPECT_EQ(cell(*shown, 0, LogModel::kWhat), QStringLiteral("Account created"));
  EXPECT_EQ(cell(*shown, 0, LogModel::kAbout), QStringLiteral("Omar Haddad"));
  for (int row = 0; row < shown->model().rowCount(); ++row) EXPECT_FALSE(cell(*shown, row, LogModel::kAbout).contains(QStringLiteral("Lena")));
}

TEST_F(LogPages, WritesDaysAsTheLanguageDoes) {
  install_language(*qApp, QStringLiteral("de"));
  const auto shown = page();
  const QString when = cell(*shown, 0, LogModel::kWhen), day = QLocale(QLocale::German).toString(QDateTime::fromMSecsSinceEpoch(records.now_us / 1000).date().day());
  EXPECT_TRUE(when.startsWith(day + QStringLiteral(". "))) << when.toStdString();
  for (const QDateEdit* field : shown->findChildren<QDateEdit*>()) EXPECT_EQ(field->displayFormat().toStdString(), "d. MMM yyyy");
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(LogPages, FetchesAPageAtATime) {
  add_many();
  const auto shown = page();
  EXPECT_EQ(shown->model().rowCount(), 200);
  LogModel& model = const_cast<LogModel&>(shown->model());
  std::set<std::int64_t> numbers;
  while (model.canFetchMore()) model.fetchMore();
  for (int row = 0; row < model.rowCount(); ++row) {
    numbers.insert(model.entry(row).number);
    if (row == 0) continue;
    EXPECT_LT(model.entry(row).number, model.entry(row - 1).number);
  }
  const std::int64_t newest = model.entry(0).number;
  EXPECT_EQ(static_cast<std::int64_t>(numbers.size()), newest + 1) << "every entry once";
  EXPECT_EQ(model.index(model.rowCount() - 1, LogModel::kNumber).data().toString(), QStringLiteral("1")) << "people count from one";
}

TEST_F(LogPages, ReadsThePageThatFailedAgainWhenAsked) {
  add_many();
  const auto shown = page();
  shown->show();
  auto& model = const_cast<LogModel&>(shown->model());
  ASSERT_EQ(model.rowCount(), 200);
  auto& database = records.store().database();
  EXPECT_EQ(unread_band(*shown), nullptr);
  ASSERT_TRUE(database.run("ALTER TABLE audit_log RENAME TO lost_log"));
  model.fetchMore();
  EXPECT_EQ(model.rowCount(), 200) << "those that were read stay";
  EXPECT_FALSE(model.canFetchMore()) << "a list that scrolls asks no more";
  ASSERT_NE(unread_band(*shown), nullptr);
  EXPECT_TRUE(unread_band(*shown)->text().contains(QStringLiteral("Older entries are not shown"))) << unread_band(*shown)->text().toStdString();
  unread_band(*shown)->findChild<QPushButton*>()->click();
  ASSERT_NE(unread_band(*shown), nullptr) << "it failed once more";
  ASSERT_TRUE(database.run("ALTER TABLE lost_log RENAME TO audit_log"));
  unread_band(*shown)->findChild<QPushButton*>()->click();
  EXPECT_EQ(unread_band(*shown), nullptr);
  EXPECT_GT(model.rowCount(), kMany);
}

TEST_F(LogPages, DoesNotTakeALogThatCannotBeReadForAnEmptyOne) {
  const auto shown = page();
  shown->show();
  const int all = shown->model().rowCount();
  ASSERT_TRUE(records.store().database().run("ALTER TABLE audit_log RENAME TO lost_log"));
  shown->read();
  EXPECT_EQ(shown->model().rowCount(), 0);
  EXPECT_FALSE(shown->shows_none());
  ASSERT_NE(unread_band(*shown), nullptr);
  EXPECT_TRUE(unread_band(*shown)->text().contains(QStringLiteral("The entries could not be read"))) << unread_band(*shown)->text().toStdString();
  ASSERT_TRUE(records.store().database().run("ALTER TABLE lost_log RENAME TO audit_log"));
  unread_band(*shown)->findChild<QPushButton*>()->click();
  EXPECT_EQ(unread_band(*shown), nullptr);
  EXPECT_EQ(shown->model().rowCount(), all);
}

TEST_F(LogPages, FiltersByKindPersonAndDate) {
  const auto shown = page();
  const int all = shown->model().rowCount();
  ASSERT_GT(choose(shown->kind(), QStringLiteral("Accounts")), 0);
  EXPECT_EQ(shown->model().rowCount(), 3) << "two made, one disabled";
  ASSERT_GT(choose(shown->person(), QStringLiteral("Lena Brandt")), 0);
  EXPECT_EQ(shown->model().rowCount(), 2);
  records.now_us += 3 * 86'400'000'000;
  choose(shown->period(), QStringLiteral("Last 1 day"));
  shown->period()->setCurrentIndex(1);
  EXPECT_EQ(shown->model().rowCount(), 0);
  EXPECT_TRUE(shown->shows_none());
  shown->show_all();
  EXPECT_EQ(shown->model().rowCount(), all);
  EXPECT_FALSE(shown->shows_none());
  shown->period()->setCurrentIndex(shown->period()->count() - 1);
  const QDate morning = QDateTime::fromMSecsSinceEpoch(kMorning / 1000).date();
  shown->first_day()->setDate(morning);
  shown->last_day()->setDate(morning);
  EXPECT_EQ(shown->model().rowCount(), all);
  shown->first_day()->setDate(morning.addDays(1));
  shown->last_day()->setDate(morning.addDays(1));
  EXPECT_EQ(shown->model().rowCount(), 0);
}

TEST_F(LogPages, VerifiesInTheBackgroundAndNamesTheEntryThatBreaksTheChain) {
  const auto shown = page();
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("The log is whole"))) << shown->message().toStdString();
  EXPECT_EQ(cell(*shown, 0, LogModel::kProof), QStringLiteral("holds"));

  const int row = 2;
  const std::int64_t changed = shown->model().entry(row).number;
  ASSERT_TRUE(records.store().database().run("UPDATE audit_log SET detail = 'changed' WHERE number = ?1", changed));
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("Entry %1 breaks the chain").arg(changed + 1))) << shown->message().toStdString();
  EXPECT_EQ(cell(*shown, row, LogModel::kProof), QStringLiteral("breaks the chain"));
  EXPECT_EQ(cell(*shown, row - 1, LogModel::kProof), QStringLiteral("not proven"));
  EXPECT_EQ(cell(*shown, row + 1, LogModel::kProof), QStringLiteral("holds"));
}

TEST_F(LogPages, NamesAnEndThatWasCutOff) {
  const auto shown = page();
  ASSERT_TRUE(records.store().database().run("DELETE FROM audit_log WHERE number = ?1", shown->model().entry(0).number));
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("The end of the log does not hold"))) << shown->message().toStdString();
}

TEST_F(LogPages, ACancelledVerificationShowsNothing) {
  const auto shown = page();
  shown->verify();
  shown->cancel_verification();
  EXPECT_FALSE(shown->verifying());
  wait_for_dropped_tasks();
  QCoreApplication::processEvents();
  EXPECT_TRUE(shown->message().isEmpty()) << shown->message().toStdString();
  EXPECT_TRUE(cell(*shown, 0, LogModel::kProof).isEmpty());
}

TEST_F(LogPages, PutsTheFocusOnCancelWhileItVerifiesAndGivesItBackAfterwards) {
  const auto shown = page();
  shown->show();
  const auto* before = shown->focusWidget();
  for (QPushButton* one : shown->findChildren<QPushButton*>())
    if (one->accessibleName() == QStringLiteral("Verify now")) one->setFocus();
  ASSERT_NE(shown->focusWidget(), before);
  shown->verify();
  Busy* busy = nullptr;
  for (Busy* one : shown->findChildren<Busy*>())
    if (one->running()) busy = one;
  ASSERT_NE(busy, nullptr);
  busy->show();
  Q_EMIT busy->shown();  // as after Busy::kDelayMs
  auto* cancel = busy->findChild<QPushButton*>();
  ASSERT_EQ(shown->focusWidget(), cancel);
  cancel->click();
  EXPECT_FALSE(shown->verifying());
  const auto* now = qobject_cast<QPushButton*>(shown->focusWidget());
  ASSERT_NE(now, nullptr);
  EXPECT_EQ(now->text().trimmed(), QStringLiteral("Verify now"));
  wait_for_dropped_tasks();
}

TEST_F(LogPages, ExportsWhatTheFiltersLeaveAndLogsThat) {
  add_many();
  const auto shown = page();
  choose(shown->kind(), QStringLiteral("Records and exports"));
  shown->export_csv();
  EXPECT_TRUE(shown->exporting()) << "the window goes on meanwhile";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown->exporting(); }, kLongestMs));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("exported"))) << shown->message().toStdString();
  QFile csv(file);
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = csv.readAll().split('\n');
  EXPECT_EQ(lines.first().trimmed(), "\xEF\xBB\xBFnumber,at,actor,actor_name,action,subject,subject_name,detail");
  EXPECT_GE(lines.size(), kMany + 2);
  for (const QByteArray& line : lines) EXPECT_FALSE(line.contains("account_disabled"));
  shown->read();
  EXPECT_TRUE(cell(*shown, 0, LogModel::kWhat).startsWith(QStringLiteral("Audit log exported"))) << cell(*shown, 0, LogModel::kWhat).toStdString();
}

TEST_F(LogPages, ACancelledExportLeavesTheFileThatWasThereAndNoEntry) {
  QFile old(file);
  ASSERT_TRUE(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
  old.close();
  const auto shown = page();
  const QString newest = cell(*shown, 0, LogModel::kWhat);
  const auto progress = std::make_shared<WorkProgress>();
  progress->stop = true;
  std::promise<Stored<std::optional<std::size_t>>> promise;
  const BackgroundTask task = export_log_in_background(records_of(records.store()), admin.actor(), {file.toStdString(), {}, {}}, progress,
                                                       [&promise](Stored<std::optional<std::size_t>> entries) { promise.set_value(std::move(entries)); });
  const auto entries = promise.get_future().get();
  ASSERT_TRUE(entries);
  EXPECT_FALSE(*entries);
  ASSERT_TRUE(old.open(QIODevice::ReadOnly));
  EXPECT_EQ(old.readAll(), "old");
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList(QStringLiteral("log.csv")));
  shown->read();
  EXPECT_EQ(cell(*shown, 0, LogModel::kWhat), newest);
}

TEST_F(LogPages, LogsNoExportThatAFullDiskCutsOffAtItsEnd) {
  file = QStringLiteral("/dev/full");
  const auto shown = page();
  shown->export_csv();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown->exporting(); }, kLongestMs));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("The file was not written."))) << shown->message().toStdString();
  EXPECT_NE(records.store().audit.list(admin.actor(), 1)->at(0).action, "log_exported");
}

TEST_F(LogPages, NamesWhyAnExportWasNotWritten) {
  file = folder.filePath(QStringLiteral("none/log.csv"));
  const auto shown = page();
  shown->export_csv();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown->exporting(); }, kLongestMs));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("No such file or directory"))) << shown->message().toStdString();
}

TEST_F(LogPages, KeepsWhatWasDoneOnTheScreenBesideLongNames) {
  const std::string name(60, 'W');
  const Account berg = *records.store().accounts.create(admin.actor(), {"berg", name, Role::administrator, "correct horse", ""});
  ASSERT_TRUE(records.store().audit.add({.actor = berg.id, .action = "backed_up", .subject = berg.id.uuid, .detail = "1"}));
  const auto shown = page();
  shown->resize(1080, 752);
  shown->show();
  QApplication::processEvents();
  EXPECT_EQ(shown->width(), 1080) << "the names among the filters widen no page";
  const Table& table = *shown->table();
  EXPECT_LE(table.columnViewportPosition(LogModel::kProof), table.viewport()->width());
  EXPECT_GE(table.columnWidth(LogModel::kWhat), 140);
  EXPECT_TRUE(shown->model().index(0, LogModel::kWho).data(Qt::ToolTipRole).toString().contains(QString::fromStdString(name)));
}

TEST_F(LogPages, ShowsNothingToAnInstructor) {
  LogPage shown(records.store(), {lena.id, Role::instructor}, ports);
  EXPECT_EQ(shown.model().rowCount(), 0);
  EXPECT_FALSE(shown.message().isEmpty());
}

QString words(const std::string& action, const std::string& detail = {}) { return entry_text({0, 0, 0, {}, action, {}, detail}); }

/// Codes that the sources of storage write into the log.
std::set<std::string> codes_in_storage() {
  std::set<std::string> out;
  const std::regex line(R"((\.action = |log_account|log_row|log_event|note\(|baseline_action|actions = |_sealed"))"), code(R"re("([a-z]+(_[a-z]+)+|stated|assigned|restored)")re");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_dir() / "storage")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    for (std::string text; std::getline(in, text);) {
      if (!std::regex_search(text, line)) continue;
      for (std::sregex_iterator it(text.begin(), text.end(), code), end; it != end; ++it) out.insert((*it)[1]);
    }
  }
  return out;
}

TEST(AuditLogText, EveryCodeThatStorageWritesHasWordsAndOneKind) {
  std::set<std::string> known;
  std::set<QString> texts;
  for (int i = 0; i < kLogKinds; ++i) {
    for (const std::string& action : actions_of(static_cast<LogKind>(i))) {
      EXPECT_TRUE(known.insert(action).second) << action << " has two kinds";
      texts.insert(words(action));
    }
  }
  EXPECT_EQ(texts.size(), known.size()) << "two codes have the same words";
  const auto written = codes_in_storage();
  EXPECT_GE(written.size(), 30u);
  for (const std::string& code : written) {
    EXPECT_TRUE(known.contains(code)) << code;
    EXPECT_NE(words(code).toStdString(), code);
  }
  EXPECT_EQ(words("session_sealed", "finished 12 ab").toStdString(), "Attempt finished");
}

}  // namespace
}  // namespace cusp::test
