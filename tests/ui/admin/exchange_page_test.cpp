// The page for files between stations: two stations in folders of their own, each with its own administrator.
#include <gtest/gtest.h>

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <functional>

#include "tests/modules.h"
#include "tests/ui/admin/one_station.h"
#include "tests/ui/looks.h"
#include "ui/admin/exchange_cards.h"
#include "ui/admin/exchange_page.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

constexpr int kWorkMs = 60'000;

class FilesBetweenStations : public testing::Test {
 protected:
  FilesBetweenStations() {
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(10, 0)); };
    ports.pick_file = [this](QWidget*, const FileWish& wish, std::function<void(const QString&)> then) {
      suggested = wish.name;
      wished = wish.what;
      then(chosen);
    };
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked = question.what;
      then(true);
    };
  }
  std::unique_ptr<ExchangePage> page(OneStation& station) {
    return std::make_unique<ExchangePage>(*station.store, station.admin.actor(), station.settings, ports);
  }
  void wait_for(const ExchangePage& shown) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.working(); }, kWorkMs));
  }
  static void press(const QWidget& shown, const QString& text) {
    for (QPushButton* button : shown.findChildren<QPushButton*>()) {
      if (button->accessibleName() == text && button->isVisibleTo(&shown)) return button->click();
    }
    ADD_FAILURE() << "no button " << text.toStdString();
  }
  /// The act of a step, in any language.
  static void act(const QWidget* step) {
    ASSERT_NE(step, nullptr);
    for (QPushButton* button : step->findChildren<QPushButton*>()) {
      if (button->property("kind").toString() == QStringLiteral("primary")) return button->click();
    }
  }
  static bool says(const QWidget& shown, const QString& part) {
    for (const QLabel* label : shown.findChildren<QLabel*>()) {
      if (label->isVisibleTo(&shown) && label->text().contains(part)) return true;
    }
    return false;
  }
  /// A new file of `from`, as another page gives it out.
  QString file_of(OneStation& from, ExchangeKind kind) {
    const QString path = stick.filePath(QStringLiteral("file-%1").arg(++files));
    EXPECT_TRUE(give_out(from.store->context(), from.admin.actor(), kind, path.toStdString()));
    return path;
  }
  void trust_directly(OneStation& here, OneStation& there, KeyRole role) {
    ASSERT_TRUE(trust(here.store->context(), here.admin.actor(), there.public_key(), role));
  }
  void choose(ExchangePage& shown, const QString& path) {
    chosen = path;
    shown.choose_file();
    wait_for(shown);
  }
  void read_whole(ExchangePage& shown, const QString& path) {
    choose(shown, path);
    ASSERT_EQ(shown.step(), ExchangePage::Step::file) << shown.message().toStdString();
    press(shown, QStringLiteral("Read it in"));
    wait_for(shown);
  }

  OneStation office{"office-keeper"}, clinic{"clinic-keeper"};
  QTemporaryDir stick;
  Ports ports;
  QString chosen, suggested, asked;
  FileWish::What wished = FileWish::What::file;
  int files = 0;
};

TEST_F(FilesBetweenStations, WithoutOthersItSaysWhyAndOffersToMakeOneKnown) {
  const auto shown = page(clinic);
  EXPECT_TRUE(says(*shown, QStringLiteral("No other station is known yet")));
  EXPECT_TRUE(says(*shown, fingerprint(clinic.key()))) << "its own fingerprint stands there";
}

TEST_F(FilesBetweenStations, AKeySavedHereIsComparedAndMadeKnownThere) {
  clinic.settings.set_station_name(QString::fromStdString(clinic.store->context().station.text()), QStringLiteral("Room 2"));
  const auto there = page(clinic);
  chosen = stick.filePath(QStringLiteral("room.cuspkey"));
  there->save_key();
  EXPECT_EQ(suggested, QStringLiteral("cusp-key-Room-2.cuspkey"));
  there->copy_fingerprint();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), fingerprint(clinic.key()));

  const auto here = page(office);
  here->choose_key();
  ASSERT_EQ(here->step(), ExchangePage::Step::key);
  EXPECT_TRUE(says(*here, fingerprint(clinic.key())));
  EXPECT_TRUE(office.known().empty()) << "nothing is known before it was compared";
  here->findChild<TrustCard*>()->findChild<QLineEdit*>()->setText(QStringLiteral("Room 2"));
  press(*here, QStringLiteral("It is the same: make it known"));
  ASSERT_EQ(office.known().size(), 1u);
  EXPECT_EQ(office.known().front().key, clinic.key());
  EXPECT_EQ(office.known().front().role, KeyRole::station);
  EXPECT_EQ(here->step(), ExchangePage::Step::stations);
  EXPECT_EQ(here->findChild<Table*>()->model()->index(0, 0).data().toString(), QStringLiteral("Room 2"));
}

TEST_F(FilesBetweenStations, AFileThatIsNoKeyIsRefused) {
  chosen = stick.filePath(QStringLiteral("letter.txt"));
  QFile letter(chosen);
  ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
  letter.write("Dear colleagues,\nthe key comes tomorrow.\n");
  letter.close();
  const auto shown = page(clinic);
  shown->choose_key();
  EXPECT_EQ(shown->step(), ExchangePage::Step::stations);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("no station’s key"))) << shown->message().toStdString();
}

TEST_F(FilesBetweenStations, PeopleGivenOutByTheOfficeArriveAfterALook) {
  office.student("4711", "Lena Brandt");
  trust_directly(clinic, office, KeyRole::office);
  chosen = stick.filePath(QStringLiteral("people.cuspexchange"));
  const auto there = page(office);
  there->give_out_office();
  wait_for(*there);
  EXPECT_TRUE(there->message().contains(QStringLiteral("File 1 of this station is written"))) << there->message().toStdString();
  EXPECT_TRUE(there->message().contains(chosen));

  const auto here = page(clinic);
  here->choose_file();
  wait_for(*here);
  ASSERT_EQ(here->step(), ExchangePage::Step::file) << here->message().toStdString();
  EXPECT_TRUE(says(*here, fingerprint(office.key())));
  EXPECT_EQ(clinic.people(), 1u) << "a look changes nothing";
  press(*here, QStringLiteral("Read it in"));
  wait_for(*here);
  EXPECT_EQ(clinic.people(), 3u) << here->message().toStdString();
  EXPECT_TRUE(here->message().contains(QStringLiteral("The file is read."))) << here->message().toStdString();
  EXPECT_TRUE(here->findChild<Table*>()->model()->index(0, StationsModel::kNewest).data().toString().startsWith(QStringLiteral("file 1, ")));
}

TEST_F(FilesBetweenStations, AFileOfAnUnknownStationIsReadAfterItsKeyWasMadeKnown) {
  office.student("4711", "Lena Brandt");
  const auto shown = page(clinic);
  choose(*shown, file_of(office, ExchangeKind::office));
  ASSERT_EQ(shown->step(), ExchangePage::Step::key);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("not known here"))) << shown->message().toStdString();
  EXPECT_TRUE(says(*shown, fingerprint(office.key())));
  press(*shown, QStringLiteral("It is the same: make it known"));
  ASSERT_EQ(clinic.known().size(), 1u);
  EXPECT_EQ(clinic.known().front().role, KeyRole::office) << "the file brings people";
  ASSERT_EQ(shown->step(), ExchangePage::Step::file) << "and goes on with the file";
  press(*shown, QStringLiteral("Read it in"));
  wait_for(*shown);
  EXPECT_EQ(clinic.people(), 3u) << shown->message().toStdString();
}

TEST_F(FilesBetweenStations, AKeyThatAnotherWindowRevokedMeanwhileStaysRevoked) {
  trust_directly(office, clinic, KeyRole::station);
  const auto shown = page(office);
  shown->open_station();
  ASSERT_EQ(shown->step(), ExchangePage::Step::key);
  ASSERT_TRUE(revoke(office.store->context(), office.admin.actor(), clinic.key()));
  shown->findChild<TrustCard*>()->findChild<Segments*>()->choose(1);
  press(*shown, QStringLiteral("Save"));
  EXPECT_EQ(office.known().front().role, KeyRole::revoked);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("in another window meanwhile"))) << shown->message().toStdString();
  EXPECT_EQ(shown->step(), ExchangePage::Step::stations);
  shown->open_station();
  press(*shown, QStringLiteral("It is the same: make it known"));
  EXPECT_EQ(office.known().front().role, KeyRole::station) << "as its card shows it now";
}

TEST_F(FilesBetweenStations, GoingBackFromAnUnknownKeyChangesNothing) {
  const auto shown = page(clinic);
  choose(*shown, file_of(office, ExchangeKind::office));
  press(*shown, QStringLiteral("Back"));
  EXPECT_EQ(shown->step(), ExchangePage::Step::stations);
  EXPECT_TRUE(clinic.known().empty());
  EXPECT_EQ(clinic.people(), 1u);
}

TEST_F(FilesBetweenStations, AnOlderFileIsNamedWithWhatToDo) {
  trust_directly(clinic, office, KeyRole::office);
  const QString first = file_of(office, ExchangeKind::office), second = file_of(office, ExchangeKind::office);
  const auto shown = page(clinic);
  read_whole(*shown, second);
  choose(*shown, first);
  EXPECT_TRUE(says(*shown, QStringLiteral("File 2 of this station was read in already, and this one is older")));
  press(*shown, QStringLiteral("Read it in"));
  wait_for(*shown);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("ask that station for a new file"))) << shown->message().toStdString();
}

TEST_F(FilesBetweenStations, ANumberThatSomebodyElseHasHereRefusesTheWholeFile) {
  office.student("4711", "Lena Brandt");
  clinic.student("4711", "Omar Haddad");
  trust_directly(clinic, office, KeyRole::office);
  const auto shown = page(clinic);
  read_whole(*shown, file_of(office, ExchangeKind::office));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("4711"))) << shown->message().toStdString();
  EXPECT_TRUE(shown->message().contains(QStringLiteral("somebody else"))) << shown->message().toStdString();
  EXPECT_EQ(clinic.people(), 2u);
}

TEST_F(FilesBetweenStations, WhatTheOfficeAndTheStationBothChangedIsNamed) {
  const Account lena = office.student("4711", "Lena Brandt");
  trust_directly(clinic, office, KeyRole::office);
  const auto shown = page(clinic);
  read_whole(*shown, file_of(office, ExchangeKind::office));
  ASSERT_TRUE(office.store->accounts.rename(office.admin.actor(), lena.id, "4711", "Lena Brandt-Weber"));
  ASSERT_TRUE(clinic.store->accounts.rename(clinic.admin.actor(), lena.id, "4711", "Lena B."));
  read_whole(*shown, file_of(office, ExchangeKind::office));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("was changed here too"))) << shown->message().toStdString();
}

TEST_F(FilesBetweenStations, AFileThatIsNotAsSignedOrNoneAtAllIsRefusedByName) {
  trust_directly(clinic, office, KeyRole::office);
  const QString signed_file = file_of(office, ExchangeKind::office);
  {
    auto db = Database::open(signed_file.toStdString(), {});
    ASSERT_TRUE(db);
    ASSERT_TRUE(db->run("UPDATE people SET name = 'Nobody'"));
  }
  const QString picture = stick.filePath(QStringLiteral("tooth.png"));
  QFile file(picture);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray(4096, 'p'));
  file.close();
  const auto shown = page(clinic);
  for (const QString& bad : {signed_file, picture}) {
    choose(*shown, bad);
    EXPECT_EQ(shown->step(), ExchangePage::Step::stations);
    EXPECT_TRUE(shown->message().contains(QStringLiteral("not as its station signed it"))) << shown->message().toStdString();
  }
  EXPECT_EQ(clinic.people(), 1u);
}

TEST_F(FilesBetweenStations, AFileThatIsCutShortIsNamedWithWhatIsThereOfIt) {
  const QString file = file_of(office, ExchangeKind::office);
  const qint64 whole = QFile(file).size();
  ASSERT_TRUE(QFile::resize(file, whole - 1));
  const auto shown = page(clinic);
  choose(*shown, file);
  const QString there = QStringLiteral("%1 of the %2 bytes").arg(installed_locale().toString(whole - 1), installed_locale().toString(whole));
  EXPECT_TRUE(shown->message().contains(there)) << shown->message().toStdString();
}

TEST_F(FilesBetweenStations, ARevokedKeyIsNoLongerReadAndCanBeMadeKnownAgain) {
  trust_directly(clinic, office, KeyRole::office);
  const auto shown = page(clinic);
  shown->revoke_station();
  EXPECT_TRUE(asked.contains(QStringLiteral("Revoke the key of")));
  EXPECT_EQ(clinic.known().front().role, KeyRole::revoked);
  choose(*shown, file_of(office, ExchangeKind::office));
  EXPECT_EQ(shown->step(), ExchangePage::Step::stations);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("was revoked here"))) << shown->message().toStdString();
  shown->open_station();
  press(*shown, QStringLiteral("It is the same: make it known"));
  EXPECT_EQ(clinic.known().front().role, KeyRole::station);
}

TEST_F(FilesBetweenStations, AFileGivenOutMeanwhileIsNotTheOneThatIsReadIn) {
  office.student("4711", "Lena Brandt");
  trust_directly(clinic, office, KeyRole::office);
  const auto shown = page(clinic);
  choose(*shown, file_of(office, ExchangeKind::office));
  ASSERT_EQ(shown->step(), ExchangePage::Step::file) << shown->message().toStdString();
  chosen = stick.filePath(QStringLiteral("own.cuspexchange"));
  shown->give_out_results();
  wait_for(*shown);
  ASSERT_EQ(shown->step(), ExchangePage::Step::file);
  press(*shown, QStringLiteral("Read it in"));
  wait_for(*shown);
  EXPECT_EQ(clinic.people(), 3u) << shown->message().toStdString();
}

TEST_F(FilesBetweenStations, AFileThatIsThereIsNotOverwritten) {
  chosen = file_of(clinic, ExchangeKind::results);
  const qint64 before = QFileInfo(chosen).size();
  const auto shown = page(clinic);
  shown->give_out_results();
  wait_for(*shown);
  EXPECT_TRUE(shown->message().contains(QStringLiteral("is there already"))) << shown->message().toStdString();
  EXPECT_EQ(QFileInfo(chosen).size(), before);
  EXPECT_EQ(wished, FileWish::What::new_file) << "else the picker asks whether to replace it";
}

TEST_F(FilesBetweenStations, WhatIsStoppedIsNotDoneAndCanBeBegunAnew) {
  office.student("4711", "Lena Brandt");
  trust_directly(clinic, office, KeyRole::office);
  const QString people = file_of(office, ExchangeKind::office);
  const auto shown = page(clinic);
  const auto begin_and_cancel = [&](const std::function<void()>& begin) {
    {
      const Transaction writes(clinic.store->database());  // the task waits for it where it opens the records
      begin();
      Q_EMIT shown->findChild<Busy*>()->cancelled();
    }
    wait_for(*shown);
    return shown->message().toStdString();
  };
  chosen = stick.filePath(QStringLiteral("results.cuspexchange"));
  EXPECT_EQ(begin_and_cancel([&] { shown->give_out_results(); }).find("No file was given out."), 0u);
  EXPECT_FALSE(QFile::exists(chosen));
  chosen = people;
  EXPECT_EQ(begin_and_cancel([&] { shown->choose_file(); }).find("The file was not checked."), 0u);
  EXPECT_EQ(shown->step(), ExchangePage::Step::stations);
  choose(*shown, people);
  EXPECT_EQ(begin_and_cancel([&] { press(*shown, QStringLiteral("Read it in")); }).find("The file was not read."), 0u);
  EXPECT_EQ(clinic.people(), 1u);
  ASSERT_EQ(shown->step(), ExchangePage::Step::file) << "it is still shown";
  press(*shown, QStringLiteral("Read it in"));
  wait_for(*shown);
  EXPECT_EQ(clinic.people(), 3u) << shown->message().toStdString();
}

/// No button cuts its text, and nothing lies beside the window.
void expect_texts_fit(const QWidget& shown) {
  expect_buttons_fit(shown);
  EXPECT_EQ(shown.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
}

TEST_F(FilesBetweenStations, StandsInEveryLookAndSize) {
  office.student("4711", "Lena Brandt");
  office.student("4712", "Omar Haddad");
  std::vector<std::unique_ptr<OneStation>> others;
  for (int i = 0; i < 8; ++i) others.push_back(std::make_unique<OneStation>("other"));
  const auto look = [&](ColourScheme scheme, const char* language, int percent, QSize size, const QString& name) {
    install_language(*qApp, QLatin1String(language));
    apply_theme(*qApp, scheme, percent);
    OneStation here("k" + name.toStdString());
    const auto shown = page(here);
    shown->resize(size);
    shown->show();
    const auto picture = [&](const char* state) {
      QApplication::processEvents();
      expect_texts_fit(*shown);
      leave_picture(*shown, name + QLatin1String(state));
    };
    picture("-empty");
    choose(*shown, file_of(office, ExchangeKind::office));
    picture("-key");
    act(shown->findChild<TrustCard*>());
    picture("-file");
    act(shown->findChild<FileCard*>());
    wait_for(*shown);
    trust_directly(here, clinic, KeyRole::station);
    for (auto& other : others) trust_directly(here, *other, KeyRole::station);
    picture("-read");
    const auto full = page(here);
    full->resize(shown->size());
    full->show();
    QApplication::processEvents();
    expect_texts_fit(*full);
    leave_picture(*full, name + QStringLiteral("-full"));
  };
  look(ColourScheme::light, "en", 100, {1080, 752}, QStringLiteral("en-light"));
  look(ColourScheme::dark, "de", 200, {1520, 984}, QStringLiteral("de-dark-200"));
  look(ColourScheme::light, "de", 200, {880, 704}, QStringLiteral("de-light-narrow"));
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST_F(FilesBetweenStations, EveryControlHasANameAndIsReachedByTab) {
  trust_directly(clinic, office, KeyRole::office);
  const auto shown = page(clinic);
  for (const QWidget* part : shown->findChildren<QWidget*>()) {
    if (!part->isVisibleTo(shown.get()) || part->focusPolicy() == Qt::NoFocus || !(part->focusPolicy() & Qt::TabFocus)) continue;
    if (part->inherits("QPushButton") || part->inherits("QLabel")) continue;
    if (part->inherits("QScrollArea")) continue;
    EXPECT_FALSE(part->accessibleName().isEmpty()) << part->metaObject()->className();
  }
}

}  // namespace
}  // namespace cusp::test
