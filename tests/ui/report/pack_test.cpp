// What the report of an opened appeal pack says of its signature, files and records. tests/outside/appeal.py opens real ones.
#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/pack_card.h"
#include "ui/report/report_page.h"
#include "ui/text/incident_text.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

std::shared_ptr<OpenedPack> untouched(PackSigner signer) {
  auto pack = std::make_shared<OpenedPack>();
  pack->checked.signature_holds = true;
  pack->checked.key.fill(0xab);
  pack->checked.description.files = {{"records.db", {}}, {"report.pdf", {}}};
  pack->signer = signer;
  return pack;
}

QString found(const PackCard& card) { return card.findChild<Band*>()->text(); }

TEST(PackOnThePage, OfThisStationIsWhole) {
  const PackCard card(untouched(PackSigner::this_station));
  EXPECT_TRUE(found(card).contains(QStringLiteral("Nothing was changed: 2 file"))) << found(card).toStdString();
  EXPECT_TRUE(found(card).contains(QStringLiteral("Signed by this station, key abab abab abab abab")));
}

TEST(PackOnThePage, OfAnotherStationNamesTheKeyToCompare) {
  const PackCard card(untouched(PackSigner::other_station));
  EXPECT_TRUE(found(card).contains(QStringLiteral("abab abab abab abab, which these records do not know")));
}

TEST(PackOnThePage, ThatWasChangedSaysWhat) {
  const auto pack = untouched(PackSigner::this_station);
  pack->checked.signature_holds = false;
  pack->differing = {"report.pdf", "tooth.nrrd"};
  pack->findings = {{.code = FindingCode::row_changed, .table = "grades", .row = 0}};
  EXPECT_FALSE(pack->whole());
  const PackCard card(pack);
  for (const char* said : {"This pack was changed after it was made", "The signature does not belong", "report.pdf, tooth.nrrd", "grades"})
    EXPECT_TRUE(found(card).contains(QString::fromUtf8(said))) << said << ": " << found(card).toStdString();
}

TEST(PackOnThePage, OneFindingAloneMakesItNotWhole) {
  for (int which = 0; which < 3; ++which) {
    const auto pack = untouched(PackSigner::this_station);
    if (which == 0) pack->checked.signature_holds = false;
    if (which == 1) pack->differing = {"log.csv"};
    if (which == 2) pack->findings = {{.code = FindingCode::row_missing, .table = "trace_chunks", .row = 3}};
    EXPECT_FALSE(pack->whole()) << which;
  }
}

TEST(PackOnThePage, KeepsTheKeyboardOnTheButtonThatComputesItAnew) {
  const auto pack = untouched(PackSigner::this_station);
  pack->records = "no such folder/records.db";  // the proof fails at once
  PackCard card(pack);
  card.show();
  QPushButton* prove = nullptr;
  for (QPushButton* button : card.findChildren<QPushButton*>())
    if (button->text().trimmed() == QStringLiteral("Compute the attempt anew")) prove = button;
  ASSERT_NE(prove, nullptr);
  prove->setFocus();
  prove->click();
  EXPECT_EQ(card.focusWidget(), prove);
  Band* proved = card.findChildren<Band*>().at(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return proved->isVisible(); }, 60'000));
  EXPECT_EQ(card.focusWidget(), prove);
}

TEST(PackOnThePage, IsOfferedToWhoMayExport) {
  const Ports ports = Ports::of_the_system();
  ReportPage page(sample(), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  QPushButton* save = nullptr;
  for (QPushButton* button : page.findChildren<QPushButton*>())
    if (button->text().trimmed() == QStringLiteral("Appeal pack")) save = button;
  ASSERT_NE(save, nullptr);
  EXPECT_TRUE(save->isHidden());
  page.offer_pack();
  EXPECT_FALSE(save->isHidden());
  QSignalSpy wanted(&page, &ReportPage::pack_wanted);
  save->click();
  EXPECT_EQ(wanted.count(), 1);
  page.offer_pack(QStringLiteral("The recording was thinned."));
  EXPECT_FALSE(save->isEnabled());
  EXPECT_EQ(save->toolTip(), QStringLiteral("The recording was thinned."));
}

}  // namespace
}  // namespace cusp::test
