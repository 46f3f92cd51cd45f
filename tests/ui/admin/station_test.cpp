// The station's page: backups and verification in the background.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <future>

#include "tests/modules.h"
#include "tests/refused_rows.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/looks.h"
#include "tests/ui/whole_texts.h"
#include "tests/unremovable.h"
#include "ui/admin/recordings_card.h"
#include "ui/admin/station_page.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;

class Station : public testing::Test {
 protected:
  Station() : Station(kMorning) {}
  explicit Station(std::int64_t opened_utc_us) : records(opened_utc_us) {
    admin = records.administrator();
    if (opened_utc_us < kMorning) {
      old_attempt = records.attempt(records.student("4712", "Omar Haddad"), "channel-1", 81, 60);
      records.use_until(kMorning - 21 * std::int64_t{86'400'000'000});
      records.student("4713", "Sana Ito");
      records.now_us = kMorning;
    }
    records.attempt(records.student("4711", "Lena Brandt"), "channel-1", 81, 60);
    ports.pick_file = [this](QWidget*, const FileWish& wish, std::function<void(const QString&)> then) {
      asked_for_folder = wish.what == FileWish::What::folder;
      then(chosen);
    };
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked = question;
      then(answer);
    };
  }
  /// Until its card has counted what ended before 5,000 days: since 2015, until 2040.
  static RecordingsCard& counted(StationPage& page) {
    RecordingsCard& card = page.recordings();
    card.choose_days(5000);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !card.found().isEmpty(); }, kPatienceMs));
    return card;
  }
  void thin(RecordingsCard& card) {
    card.thin();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !card.working(); }, kPatienceMs));
  }
  std::int64_t recordings() {
    const auto count = records.store().database().first("SELECT count(DISTINCT session) FROM trace_chunks", [](Row row) { return row.integer(0); });
    return count ? count->value_or(-1) : -1;
  }
  static bool shows(const StationPage& shown, const char* part) {
    return std::ranges::any_of(shown.findChildren<QLabel*>(), [&](const QLabel* label) { return label->text().contains(QLatin1String(part)); });
  }
  std::unique_ptr<StationPage> page() {
    return std::make_unique<StationPage>(records.store(), admin.actor(), settings, ports);
  }
  /// Begins what takes long and presses Cancel before its task has opened the records: it waits for whoever writes.
  void begin_and_cancel(StationPage& page, void (StationPage::*work)()) {
    const Transaction writes(records.store().database());
    (page.*work)();
    for (Busy* busy : page.findChildren<Busy*>())
      if (busy->running()) Q_EMIT busy->cancelled();
  }
  /// As after Busy::kDelayMs.
  static void show_progress(const StationPage& page) {
    const auto all = page.findChildren<Busy*>();
    Busy& busy = **std::ranges::find_if(all, &Busy::running);
    busy.show();
    Q_EMIT busy.shown();
  }
  static bool waited(const StationPage& page) {
    return QTest::qWaitFor([&] { return !page.working(); }, kPatienceMs);
  }
  static bool listed(const StationPage& page) {
    return QTest::qWaitFor([&] { return !shows(page, "The folder is being read."); }, kPatienceMs);
  }

  DeskRecords records;
  SessionId old_attempt;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Account admin;
  Ports ports;
  QString chosen = folder.filePath(QStringLiteral("stick"));
  bool asked_for_folder = false, answer = true;
  std::optional<Question> asked;
};

/// With an attempt of September 2001; the other one is of November 2026, three weeks after an account.
class OldStation : public Station {
 protected:
  OldStation() : Station(1'000'000'000'000'000) {}
};

TEST_F(Station, MakesABackupWhereItWasAskedTo) {
  const auto shown = page();
  shown->choose_folder();
  EXPECT_TRUE(asked_for_folder);
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("made and checked"))) << shown->message().toStdString();
  const auto all = backups_in(chosen.toStdString(), records.store().context().station);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 1u);
  EXPECT_EQ(all->front().sessions, 1u);
}

TEST_F(Station, ShowsNoNumberOfSessionsThatCouldNotBeRead) {
  const auto read = page();
  EXPECT_TRUE(shows(*read, "1 session"));
  ASSERT_TRUE(records.store().database().run("ALTER TABLE session_summaries RENAME TO lost_summaries"));
  const auto unread = page();
  EXPECT_TRUE(shows(*unread, "How much the records hold could not be read."));
  EXPECT_FALSE(shows(*unread, "0 session"));
}

TEST_F(Station, TakesAFolderThatCannotBeReachedForNoEmptyOne) {
  const std::filesystem::path loop = folder.filePath(QStringLiteral("loop")).toStdString();
  std::filesystem::create_symlink("loop", loop);  // nobody reaches it, root neither
  const auto empty = page();
  ASSERT_TRUE(listed(*empty));
  EXPECT_TRUE(shows(*empty, "There is no backup yet."));
  ASSERT_TRUE(settings.set_backup_folder(QString::fromStdString(loop.string())));
  const auto unreached = page();
  ASSERT_TRUE(listed(*unreached));
  EXPECT_TRUE(shows(*unreached, "The folder cannot be read: "));
}

TEST_F(Station, ReadsTheFolderInTheBackgroundAndAnotherOneMeanwhile) {
  ASSERT_TRUE(make_backup(records.store().context(), admin.actor(), chosen.toStdString()));
  const auto shown = page();
  EXPECT_TRUE(shows(*shown, "The folder is being read.")) << "a drive that does not answer would hold the window up";
  shown->choose_folder();
  EXPECT_TRUE(shows(*shown, "The folder is being read."));
  ASSERT_TRUE(listed(*shown));
  EXPECT_EQ(shown->findChild<Table*>()->model()->rowCount(), 1) << "of the folder that was chosen last";
}

TEST_F(Station, NamesTheKindOfEachBackup) {
  const std::filesystem::path into = chosen.toStdString();
  ASSERT_TRUE(make_backup(records.store().context(), std::nullopt, into));
  records.now_us += 1'000'000;
  ASSERT_TRUE(make_backup(records.store().context(), admin.actor(), into));
  const auto shown = page();
  shown->choose_folder();
  ASSERT_TRUE(listed(*shown));
  const QAbstractItemModel* list = shown->findChild<Table*>()->model();
  ASSERT_EQ(list->rowCount(), 2);
  EXPECT_EQ(list->index(0, 1).data().toString(), QStringLiteral("By hand")) << "the newest first";
  EXPECT_EQ(list->index(1, 1).data().toString(), QStringLiteral("Daily"));
}

TEST_F(Station, PutsTheNumbersOfBackupsAtTheRight) {
  const auto shown = page();
  shown->choose_folder();
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  ASSERT_TRUE(listed(*shown));
  const QAbstractItemModel* list = shown->findChild<Table*>()->model();
  ASSERT_EQ(list->rowCount(), 1);
  for (const int column : {2, 3}) {  // sessions and size
    EXPECT_TRUE(list->index(0, column).data(Qt::TextAlignmentRole).toInt() & (Qt::AlignTrailing | Qt::AlignRight)) << column;
    EXPECT_TRUE(list->headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt() & (Qt::AlignTrailing | Qt::AlignRight)) << column;
  }
}

TEST_F(Station, ReportsAFolderThatTheNextStartDoesNotKnow) {
  QFile file(folder.filePath(QStringLiteral("a file")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  Settings lost(folder.filePath(QStringLiteral("a file/Cusp.ini")));  // root may write a read-only folder, and nobody this one
  StationPage shown(records.store(), admin.actor(), lost, ports);
  shown.choose_folder();
  EXPECT_TRUE(shown.message().contains(QStringLiteral("until Cusp is closed"))) << shown.message().toStdString();
  const auto kept = page();
  kept->choose_folder();
  EXPECT_EQ(kept->message(), QString());
}

TEST_F(Station, ReportsMinutesUntilTheSigningOutThatTheNextStartDoesNotKnow) {
  QFile file(folder.filePath(QStringLiteral("a file")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  Settings lost(folder.filePath(QStringLiteral("a file/Cusp.ini")));
  const auto choose = [&](StationPage& shown, int minutes) {
    for (NumberField* field : shown.findChildren<NumberField*>())
      if (field->accessibleName() == QStringLiteral("After so many minutes without input")) field->setValue(minutes);
  };
  StationPage shown(records.store(), admin.actor(), lost, ports);
  choose(shown, 5);
  EXPECT_TRUE(shown.message().contains(QStringLiteral("The minutes hold until Cusp is closed."))) << shown.message().toStdString();
  const auto kept = page();
  choose(*kept, 5);
  EXPECT_EQ(kept->message(), QString());
  EXPECT_EQ(Settings(settings.file()).idle_minutes(), 5);
}

TEST_F(Station, SaysWhyNoBackupWasMadeUntilOtherWorkBegins) {
  chosen = folder.filePath(QStringLiteral("a file/backups"));
  QFile file(folder.filePath(QStringLiteral("a file")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const auto shown = page();
  shown->choose_folder();
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("No backup was made"))) << shown->message().toStdString();
  shown->verify();
  EXPECT_EQ(shown->message(), QString());
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("whole"))) << shown->message().toStdString();
}

TEST_F(Station, SaysWhichOldBackupCannotBeRemoved) {
  const auto into = std::filesystem::path(chosen.toStdString());
  std::optional<Backup> oldest;
  for (std::size_t i = 0; i < kBackupsKept; ++i) {
    auto made = make_backup(records.store().context(), admin.actor(), into);
    ASSERT_TRUE(made);
    if (!oldest) oldest = std::move(*made);
    records.now_us += kBackupEveryUs;
  }
  const Unremovable held(oldest->folder);
  if (!held.holds()) GTEST_SKIP() << "root may remove every file here";
  const auto shown = page();
  shown->choose_folder();
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("An old one could not be removed"))) << shown->message().toStdString();
  EXPECT_TRUE(shown->message().contains(QString::fromStdString(oldest->folder.filename().string()))) << shown->message().toStdString();
  EXPECT_FALSE(shown->message().contains(QStringLiteral("database"))) << shown->message().toStdString();
}

TEST_F(Station, KeepsTheDailyBackupsHoweverManyAreMadeBesideThem) {
  const auto into = std::filesystem::path(chosen.toStdString());
  const auto daily = make_backup(records.store().context(), std::nullopt, into);
  ASSERT_TRUE(daily);
  std::optional<Backup> oldest;
  for (std::size_t i = 0; i < kBackupsKept; ++i) {
    records.now_us += 1'000'000;
    auto made = make_backup(records.store().context(), admin.actor(), into);
    ASSERT_TRUE(made);
    if (!oldest) oldest = std::move(*made);
  }
  records.now_us += 1'000'000;
  const auto shown = page();
  shown->choose_folder();
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("made and checked"))) << shown->message().toStdString();
  EXPECT_TRUE(std::filesystem::exists(daily->folder));
  EXPECT_FALSE(std::filesystem::exists(oldest->folder)) << "of its kind there are more than are kept";
}

TEST_F(Station, VerifiesAndNamesWhatWasChanged) {
  const auto shown = page();
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("whole"))) << shown->message().toStdString();
  ASSERT_TRUE(records.store().database().run("UPDATE grades SET score = 100"));
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("grades"))) << shown->message().toStdString();
}

TEST_F(Station, ReportsAStoppedVerificationAsSuchAndNotAllAsWhole) {
  const auto shown = page();
  begin_and_cancel(*shown, &StationPage::verify);
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().startsWith(QStringLiteral("The verification was stopped."))) << shown->message().toStdString();
  EXPECT_TRUE(shown->message().contains(QStringLiteral("whole: 0. The others were not verified."))) << shown->message().toStdString();
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("and the audit log are whole"))) << shown->message().toStdString();
}

TEST_F(Station, LeavesNothingOfABackupThatWasStopped) {
  const auto shown = page();
  shown->choose_folder();
  begin_and_cancel(*shown, &StationPage::back_up);
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().startsWith(QStringLiteral("The backup was stopped."))) << shown->message().toStdString();
  EXPECT_FALSE(QDir(chosen).exists());
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("made and checked"))) << shown->message().toStdString();
}

TEST_F(Station, PutsTheFocusOnCancelWhileItVerifiesAndGivesItBack) {
  const auto shown = page();
  shown->show();
  QPushButton* verify = nullptr;
  for (QPushButton* one : shown->findChildren<QPushButton*>())
    if (one->accessibleName() == QStringLiteral("Verify now")) verify = one;
  ASSERT_NE(verify, nullptr);
  verify->setFocus();
  verify->click();
  ASSERT_TRUE(shown->working());
  show_progress(*shown);
  const auto* focused = qobject_cast<QPushButton*>(shown->focusWidget());
  ASSERT_NE(focused, nullptr);
  EXPECT_EQ(focused->text(), QStringLiteral("Cancel"));
  ASSERT_TRUE(waited(*shown));
  EXPECT_EQ(shown->focusWidget(), verify);
}

TEST_F(OldStation, CountsOldRecordingsAndThinsThemAfterAQuestion) {
  const auto shown = page();
  RecordingsCard& card = counted(*shown);
  EXPECT_TRUE(card.found().startsWith(QStringLiteral("1 recording"))) << card.found().toStdString();
  answer = false;
  thin(card);
  ASSERT_TRUE(asked);
  EXPECT_TRUE(asked->what.contains(QStringLiteral("Thin 1 recording"))) << asked->what.toStdString();
  EXPECT_TRUE(asked->more.contains(QStringLiteral("cannot be undone"))) << asked->more.toStdString();
  EXPECT_TRUE(asked->erases);
  EXPECT_EQ(recordings(), 2);
  answer = true;
  thin(card);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("thinned"))) << shown->message().toStdString();
  EXPECT_EQ(recordings(), 1) << "the young one";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.found().isEmpty(); }, kPatienceMs));
  EXPECT_EQ(card.found().toStdString(), "No recording is that old.");
}

TEST_F(OldStation, SaysWhyARecordingWasNotThinned) {
  const auto shown = page();
  RecordingsCard& card = counted(*shown);
  ASSERT_TRUE(refuse_rows(records.store().database(), "thinned_traces"));
  thin(card);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.working() && !shown->message().isEmpty(); }, kPatienceMs));
  EXPECT_TRUE(shown->message().startsWith(QStringLiteral("No recording was thinned. "))) << shown->message().toStdString();
  EXPECT_TRUE(shown->message().contains(QStringLiteral("The other recordings are whole"))) << shown->message().toStdString();
  EXPECT_EQ(recordings(), 2);
}

TEST_F(OldStation, AsksNothingIfNoOldRecordingVerifies) {
  ASSERT_TRUE(records.store().database().run("UPDATE grades SET score = 100 WHERE session = ?1", old_attempt));
  const auto shown = page();
  thin(counted(*shown));
  EXPECT_FALSE(asked);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("cannot be verified"))) << shown->message().toStdString();
  EXPECT_EQ(recordings(), 2);
}

TEST_F(OldStation, StopsThinningBeforeTheNextAttempt) {
  const auto progress = std::make_shared<WorkProgress>();
  progress->stop = true;
  std::promise<Stored<ThinningReport>> promise;
  const auto task = thin_in_background(records_of(records.store()), admin.actor(), {5000, ThinningMode::carry_out}, progress,
                                       [&promise](Stored<ThinningReport> report) { promise.set_value(std::move(report)); });
  const auto report = promise.get_future().get();
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->stopped);
  EXPECT_EQ(report->attempts, 0u);
  EXPECT_EQ(recordings(), 2);
}

TEST_F(Station, StandsInEachLook) {
  in_each_look([&](const QString& name) {
    StationPage shown(records.store(), admin.actor(), settings, ports);
    shown.resize(px(1040), px(740));
    shown.show();
    counted(shown);
    QApplication::processEvents();
    expect_buttons_fit(shown, name);
    leave_picture(shown, QStringLiteral("station-") + name);
  });
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST_F(Station, NeedsNoMoreWidthThanHalfOfFullHdLeavesItInGerman) {
  install_language(*qApp, QStringLiteral("de"));
  StationPage shown(records.store(), admin.actor(), settings, ports);
  shown.resize(kPageAtHalfOfFullHd);
  shown.show();
  QApplication::processEvents();
  counted(shown);
  const auto* area = shown.findChild<QScrollArea*>();
  EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width());
  expect_nothing_clipped(shown, "station");
  install_language(*qApp, QStringLiteral("en"));
}

}  // namespace
}  // namespace cusp::test
