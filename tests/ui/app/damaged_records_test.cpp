// Records that cannot be read whole: what is whole is read, a backup takes their place, and nothing is overwritten.

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "storage/backup/backup.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/way_back.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/signin/sign_in.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct DamagedRecords : ::testing::Test {
  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  std::unique_ptr<Desktop> desktop;

  QStringList pages() const {
    QStringList keys;
    for (const NavEntry& e : desktop->shell()->entries()) keys += e.key;
    return keys;
  }
  QString bands() const {
    QStringList out;
    for (const Band* band : desktop->page()->findChildren<Band*>())
      if (!band->isHidden()) out += band->text();
    return out.join(u' ');
  }
};

/// Waits until the page has found a backup.
bool found(const WayBack& page) {
  return QTest::qWaitFor([&page] { return page.act()->isEnabled(); }, 60'000);
}

/// Ports whose every question is answered with its act.
Ports agreeing() {
  Ports ports = Ports::of_the_system();
  ports.ask = [](QWidget*, const Question&, const std::function<void(bool)>& then) { then(true); };
  return ports;
}

TEST_F(DamagedRecords, offer_a_way_back_to_a_backup_and_stay_beside_it) {
  const Account lena = records.student("1", "Lena Brandt", "271828");
  const SessionId session = records.attempt(lena, "channel-1", 78, 426);
  settings.set_backup_folder(folder.filePath(QStringLiteral("backups")));
  const auto backup = make_backup(records.store().context(), records.administrator().actor(), settings.backup_folder(records.file()));
  ASSERT_TRUE(backup);
  const auto file = std::filesystem::path(folder.filePath(QStringLiteral("school.db")).toStdString());
  ASSERT_TRUE(restore_backup(*backup, file));
  std::filesystem::resize_file(file, 5000);
  const Ports ports = agreeing();
  desktop = std::make_unique<Desktop>(settings, ports, file);
  desktop->start();
  desktop->show();
  auto* page = qobject_cast<WayBack*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(std::filesystem::file_size(file), 5000u) << "looking changes nothing";
  ASSERT_TRUE(found(*page));
  page->act()->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return qobject_cast<SignIn*>(desktop->page()) != nullptr; }, 60'000));
  EXPECT_TRUE(bands().contains(QStringLiteral("What stood there before is kept in")));
  const auto again = desktop->store()->accounts.sign_in_with_pin("1", "271828");
  ASSERT_TRUE(again);
  EXPECT_TRUE(desktop->store()->history.details(again->actor(), session));
  bool kept = false;
  for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
    kept = kept || (entry.path().filename().string().starts_with("school.db-damaged-") && std::filesystem::file_size(entry.path() / "school.db") == 5000);
  EXPECT_TRUE(kept);
}

TEST_F(DamagedRecords, behind_a_link_offer_the_same_way_back) {
  settings.set_backup_folder(folder.filePath(QStringLiteral("backups")));
  const auto backup = make_backup(records.store().context(), records.administrator().actor(), settings.backup_folder(records.file()));
  ASSERT_TRUE(backup);
  const std::filesystem::path link = folder.filePath(QStringLiteral("school.db")).toStdString();
  const std::filesystem::path file = link.parent_path() / "disk" / "school.db";
  std::filesystem::create_directory(file.parent_path());
  ASSERT_TRUE(restore_backup(*backup, file));
  std::filesystem::create_symlink("disk/school.db", link);
  std::fstream(file, std::ios::binary | std::ios::in | std::ios::out) << std::string(100, 'x');  // the whole header of an SQLite file
  const Ports ports = agreeing();
  for (const std::filesystem::path& name : {file, link}) {
    desktop.reset();
    desktop = std::make_unique<Desktop>(settings, ports, name);
    desktop->start();
    desktop->show();
    ASSERT_NE(qobject_cast<WayBack*>(desktop->page()), nullptr) << name;
  }
  auto* page = qobject_cast<WayBack*>(desktop->page());
  ASSERT_TRUE(found(*page));
  page->act()->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return qobject_cast<SignIn*>(desktop->page()) != nullptr; }, 60'000));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  bool kept = false;
  for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
    kept = kept || entry.path().filename().string().starts_with("school.db-damaged-");
  EXPECT_TRUE(kept);
}

TEST_F(DamagedRecords, that_are_no_database_and_have_no_key_are_refused) {
  const std::filesystem::path file = folder.filePath(QStringLiteral("notes.db")).toStdString(), link = folder.filePath(QStringLiteral("link.db")).toStdString();
  std::ofstream(file) << std::string(5000, 'x');
  std::filesystem::create_symlink("notes.db", link);
  for (const std::filesystem::path& name : {file, link}) {
    desktop.reset();
    desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), name);
    desktop->start();
    EXPECT_EQ(qobject_cast<WayBack*>(desktop->page()), nullptr) << name;
  }
}

TEST_F(DamagedRecords, stay_where_they_are_if_the_backup_is_damaged_too) {
  settings.set_backup_folder(folder.filePath(QStringLiteral("backups")));
  const auto backup = make_backup(records.store().context(), records.administrator().actor(), settings.backup_folder(records.file()));
  ASSERT_TRUE(backup);
  const auto file = std::filesystem::path(folder.filePath(QStringLiteral("school.db")).toStdString());
  ASSERT_TRUE(restore_backup(*backup, file));
  std::filesystem::resize_file(file, 5000);
  std::filesystem::resize_file(backup->folder / "station.db", 5000);
  const Ports ports = agreeing();
  WayBack page(file, backup->folder.parent_path(), {QStringLiteral("Damaged"), {}}, ports);
  page.show();
  ASSERT_TRUE(found(page));
  page.act()->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.message().isEmpty(); }, 60'000));
  EXPECT_TRUE(page.message().contains(QStringLiteral("The backup was not put in place."))) << page.message().toStdString();
  EXPECT_EQ(std::filesystem::file_size(file), 5000u);
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".key"));
  for (const auto& entry : std::filesystem::directory_iterator(file.parent_path())) EXPECT_FALSE(entry.path().filename().string().starts_with("school.db-damaged-"));
}

TEST_F(DamagedRecords, are_offered_the_newest_backup_first_though_a_wrong_clock_dated_it) {
  const std::filesystem::path into = folder.filePath(QStringLiteral("backups")).toStdString();
  const auto early = make_backup(records.store().context(), std::nullopt, into);
  ASSERT_TRUE(early);
  records.now_us -= 3000 * std::int64_t{86'400'000'000};
  const auto newest = make_backup(records.store().context(), std::nullopt, into);
  ASSERT_TRUE(newest);
  const auto file = std::filesystem::path(folder.filePath(QStringLiteral("school.db")).toStdString());
  ASSERT_TRUE(restore_backup(*early, file));
  std::filesystem::resize_file(file, 5000);
  const Ports ports = Ports::of_the_system();
  WayBack page(file, into, {QStringLiteral("Damaged"), {}}, ports);
  page.show();
  ASSERT_TRUE(found(page));
  const auto* table = page.findChild<Table*>();
  EXPECT_EQ(table->model()->index(0, 4).data().toString().toStdString(), newest->folder.filename().string());
  const QList<QLabel*> labels = page.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("the newest backup stands first")); }));
}

TEST_F(DamagedRecords, are_offered_their_own_stations_backups_before_newer_ones_of_another) {
  const std::filesystem::path into = folder.filePath(QStringLiteral("shared")).toStdString();
  const auto own = make_backup(records.store().context(), records.administrator().actor(), into);
  DeskRecords other(kMorning + 86'400'000'000);
  const auto newer = make_backup(other.store().context(), std::nullopt, into);
  ASSERT_TRUE(own && newer);
  ASSERT_GT(newer->made_utc_us, own->made_utc_us);
  const auto file = std::filesystem::path(folder.filePath(QStringLiteral("school.db")).toStdString());
  ASSERT_TRUE(restore_backup(*own, file));
  std::filesystem::resize_file(file, 5000);
  EXPECT_EQ(station_beside(file), own->station);
  QString asked;
  Ports ports = Ports::of_the_system();
  ports.ask = [&asked](QWidget*, const Question& question, const std::function<void(bool)>&) { asked = question.more; };
  WayBack page(file, into, {QStringLiteral("Damaged"), {}}, ports);
  page.show();
  ASSERT_TRUE(found(page));
  page.act()->click();
  EXPECT_FALSE(asked.isEmpty());
  EXPECT_FALSE(asked.contains(QStringLiteral("another station"))) << asked.toStdString();
  page.findChild<Table*>()->choose_row(1);
  page.act()->click();
  EXPECT_TRUE(asked.contains(QStringLiteral("another station"))) << asked.toStdString();
}

TEST_F(DamagedRecords, offer_another_folder_while_that_of_the_backups_is_read) {
  const std::filesystem::path into = folder.filePath(QStringLiteral("backups")).toStdString(), empty = folder.filePath(QStringLiteral("nothing")).toStdString();
  ASSERT_TRUE(make_backup(records.store().context(), records.administrator().actor(), into));
  Ports ports = Ports::of_the_system();
  ports.pick_file = [&into](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(QString::fromStdString(into.string())); };
  WayBack page(records.file(), empty, {QStringLiteral("Damaged"), {}}, ports);
  page.show();
  EXPECT_FALSE(page.act()->isEnabled()) << "a drive that does not answer would hold the window up";
  page.choose_folder();
  ASSERT_TRUE(found(page));
  EXPECT_EQ(page.findChild<Table*>()->model()->rowCount(), 1);
}

TEST_F(DamagedRecords, are_not_needed_to_go_back_to_a_backup_on_a_new_computer) {
  const SessionId session = records.attempt(records.student("1", "Lena Brandt", "271828"), "channel-1", 78, 426);
  const std::filesystem::path stick = folder.filePath(QStringLiteral("stick")).toStdString();
  ASSERT_TRUE(make_backup(records.store().context(), records.administrator().actor(), stick));
  Ports ports = agreeing();
  ports.pick_file = [&stick](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(QString::fromStdString(stick.string())); };
  desktop = std::make_unique<Desktop>(settings, ports, folder.filePath(QStringLiteral("new.db")).toStdString());
  desktop->start();
  desktop->show();
  QPushButton* back = nullptr;
  for (QPushButton* button : desktop->page()->findChildren<QPushButton*>())
    if (button->isVisibleTo(desktop->page()) && button->text() == QStringLiteral("Go back to a backup")) back = button;
  ASSERT_NE(back, nullptr);
  back->click();
  auto* page = qobject_cast<WayBack*>(desktop->page());
  ASSERT_NE(page, nullptr);
  page->choose_folder();
  ASSERT_TRUE(found(*page));
  page->act()->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return qobject_cast<SignIn*>(desktop->page()) != nullptr; }, 60'000)) << page->message().toStdString();
  const auto lena = desktop->store()->accounts.sign_in_with_pin("1", "271828");
  ASSERT_TRUE(lena);
  EXPECT_TRUE(desktop->store()->history.details(lena->actor(), session));
}

TEST_F(DamagedRecords, that_can_be_read_in_part_are_read_and_offer_the_way_back) {
  const Account lena = records.student("1", "Lena Brandt", "271828");
  records.attempt(lena, "channel-1", 78, 426);
  desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file(),
                                      [](const std::filesystem::path& file, const StoreOptions& options) -> Stored<std::unique_ptr<Store>> {
                                        if (options.database.access != DatabaseOptions::Access::read_only) return fail(StorageError::corrupt, file.string());
                                        return Store::open(file, options);
                                      });
  desktop->start();
  desktop->show();
  ASSERT_NE(qobject_cast<SignIn*>(desktop->page()), nullptr);
  EXPECT_TRUE(bands().contains(QStringLiteral("What is whole can be read and exported.")));
  desktop->sign_in(records.administrator());
  EXPECT_TRUE(pages().contains(QStringLiteral("performance")));
  EXPECT_FALSE(pages().contains(QStringLiteral("cohorts")));
  desktop->sign_out();
  Q_EMIT qobject_cast<SignIn*>(desktop->page())->way_back_wanted();
  EXPECT_NE(qobject_cast<WayBack*>(desktop->page()), nullptr);
  EXPECT_EQ(desktop->store(), nullptr) << "nothing holds the file that is to be moved";
}

TEST_F(DamagedRecords, are_not_those_whose_key_alone_is_damaged) {
  desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file(),
                                      [](const std::filesystem::path& file, const StoreOptions& options) -> Stored<std::unique_ptr<Store>> {
                                        if (options.database.access != DatabaseOptions::Access::read_only) return fail(StorageError::corrupt, file.string() + ".key", "key");
                                        return Store::open(file, options);
                                      });
  desktop->start();
  desktop->show();
  ASSERT_NE(qobject_cast<SignIn*>(desktop->page()), nullptr);
  EXPECT_TRUE(bands().contains(QStringLiteral("Results and reports can be read."))) << bands().toStdString();
  EXPECT_FALSE(bands().contains(QStringLiteral("until a backup takes their place"))) << "later records would go with it";
}

TEST_F(DamagedRecords, have_the_keyboard_on_the_next_act_at_each_try) {
  StorageError error = StorageError::newer_schema;
  desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file(),
                                      [&](const std::filesystem::path& file, const StoreOptions&) -> Stored<std::unique_ptr<Store>> {
                                        return fail(error, file.string());
                                      });
  desktop->start();
  desktop->show();
  desktop->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(desktop.get()));
  const auto press = [&] { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space); };
  for (const StorageError next : {StorageError::newer_schema, StorageError::corrupt}) {
    QWidget* before = desktop->page();
    ASSERT_NE(qobject_cast<QPushButton*>(QApplication::focusWidget()), nullptr);
    error = next;
    press();
    ASSERT_NE(desktop->page(), before) << "it tries again";
    EXPECT_TRUE(desktop->page()->isAncestorOf(QApplication::focusWidget())) << "the next key goes to what is shown";
  }
  EXPECT_NE(qobject_cast<WayBack*>(desktop->page()), nullptr);
}

}  // namespace
}  // namespace cusp::test
