// The report on a printer or in a file that takes no more.

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QTemporaryDir>

#include "tests/file_limit.h"
#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/report_page.h"

namespace cusp::test {
namespace {

/// What the page says after its report was printed to a file.
QString printed_to(ReportPage& page, const QString& file) {
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->accessibleName() == u"Print") b->click();
  auto* dialog = page.findChild<QPrintDialog*>();
  dialog->printer()->setOutputFormat(QPrinter::PdfFormat);
  dialog->printer()->setOutputFileName(file);
  Q_EMIT dialog->accepted(dialog->printer());
  delete dialog;
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->isVisible() ? label->text() : QString();
  return all;
}

TEST(ReportPage, reports_a_print_that_was_not_begun) {
  const QTemporaryDir folder;
  const Ports ports = Ports::of_the_system();
  ReportPage page(sample(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  page.show();
  EXPECT_TRUE(printed_to(page, folder.filePath(QStringLiteral("missing/r.pdf"))).contains(QStringLiteral("The report was not printed.")));
  EXPECT_FALSE(printed_to(page, folder.filePath(QStringLiteral("r.pdf"))).contains(QStringLiteral("The report was not printed.")));
}

TEST(ReportPage, reports_a_file_that_the_disk_does_not_take_whole_and_leaves_the_old_one) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("r.pdf"));
  Ports ports = Ports::of_the_system();
  ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(file); };
  ReportPage page(sample(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  page.show();
  printed_to(page, file);
  const qint64 whole = QFile(file).size();
  ASSERT_GT(whole, 4096);
  const QString printed = with_files_up_to(4096, [&] { return printed_to(page, file); });
  EXPECT_TRUE(printed.contains(QStringLiteral("The report was not printed."))) << printed.toStdString();
  EXPECT_TRUE(printed.contains(QStringLiteral("r.pdf cannot be written: File too large."))) << printed.toStdString();
  EXPECT_EQ(QFile(file).size(), whole);
  with_files_up_to(4096, [&] {
    for (QPushButton* b : page.findChildren<QPushButton*>())
      if (b->accessibleName() == u"Save as PDF") b->click();
    return 0;
  });
  QString saved;
  for (const QLabel* label : page.findChildren<QLabel*>()) saved += label->isVisible() ? label->text() : QString();
  EXPECT_TRUE(saved.contains(QStringLiteral("The report was not saved."))) << saved.toStdString();
  EXPECT_TRUE(saved.contains(QStringLiteral("File too large"))) << saved.toStdString();
}

}  // namespace
}  // namespace cusp::test
