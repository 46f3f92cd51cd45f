// Names of stations on the page for files between them, where the settings keep none.
#include <gtest/gtest.h>

#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/exchange_cards.h"
#include "ui/admin/exchange_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct StationNames : ::testing::Test {
  StationNames() {
    EXPECT_TRUE(in_the_way.open(QIODevice::WriteOnly));
    EXPECT_TRUE(trust(records.store().context(), admin.actor(), *public_key_from(*own_key(other.store().context(), other.administrator().actor())),
                      KeyRole::station));
    ports.pick_file = [this](QWidget*, const FileWish& wish, const std::function<void(const QString&)>&) { suggested = wish.name; };
  }
  static bool is_not_kept(const ExchangePage& page) { return page.message().contains(QStringLiteral("the next start does not know the name")); }

  DeskRecords records, other;
  QTemporaryDir folder;
  QFile in_the_way{folder.filePath(QStringLiteral("a file"))};
  Settings settings{folder.filePath(QStringLiteral("a file/Cusp.ini"))};  // root may write a read-only folder, and nobody this one
  Account admin = records.administrator();
  Ports ports;
  QString suggested;
};

TEST_F(StationNames, OfThisOneThatIsNotKeptIsReportedAndHoldsUntilTheEnd) {
  ExchangePage page(records.store(), admin.actor(), settings, ports);
  auto* own = page.findChild<QLineEdit*>();
  ASSERT_NE(own, nullptr);
  own->setText(QStringLiteral("Room 2"));
  Q_EMIT own->editingFinished();
  EXPECT_TRUE(is_not_kept(page)) << page.message().toStdString();
  EXPECT_EQ(own->text(), QStringLiteral("Room 2"));
  page.save_key();
  EXPECT_EQ(suggested, QStringLiteral("cusp-key-Room-2.cuspkey"));
}

TEST_F(StationNames, OfAnotherOneThatIsNotKeptIsReportedAndStandsInTheList) {
  ExchangePage page(records.store(), admin.actor(), settings, ports);
  page.open_station();
  auto* card = page.findChild<TrustCard*>();
  ASSERT_NE(card, nullptr);
  card->findChild<QLineEdit*>()->setText(QStringLiteral("The office"));
  for (QPushButton* button : card->findChildren<QPushButton*>()) {
    if (button->property("kind").toString() == QStringLiteral("primary")) button->click();
  }
  EXPECT_TRUE(is_not_kept(page)) << page.message().toStdString();
  EXPECT_EQ(page.findChild<Table*>()->model()->index(0, 0).data().toString(), QStringLiteral("The office"));
}

}  // namespace
}  // namespace cusp::test
