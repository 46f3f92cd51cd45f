// The table of criteria on paper, read back by pdftotext with the place of each word.

#include <gtest/gtest.h>

#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <algorithm>

#include "tests/ui/report/sample_report.h"
#include "ui/report/report_pdf.h"

namespace cusp::test {
namespace {

/// How far below the sheet's top the first word stands that holds a text, points; below 0 where there is none.
double word_at(const QString& file, const QString& part) {
  QProcess words;
  words.start(QStringLiteral("pdftotext"), {QStringLiteral("-bbox"), file, QStringLiteral("-")});
  if (!words.waitForFinished(60'000)) return -1.0;
  static const QRegularExpression kWord(QStringLiteral("<word [^>]*yMin=\"([0-9.]+)\"[^>]*>([^<]*)</word>"));
  QRegularExpressionMatchIterator all = kWord.globalMatch(QString::fromUtf8(words.readAllStandardOutput()));
  while (all.hasNext()) {
    const QRegularExpressionMatch word = all.next();
    if (word.captured(2).contains(part)) return word.captured(1).toDouble();
  }
  return -1.0;
}

TEST(PaperCriteria, give_a_text_that_is_wider_than_its_column_a_second_line) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("r.pdf"));
  ReportData data = sample();
  data.own = SelfAssessment{{{"depth_most", OwnRating::partly}}};
  auto& criteria = data.result.scenario.rubric.criteria;
  std::ranges::find(criteria, "depth_most", &Criterion::metric)->bands = {0, 100.125, 123.456, 987.654, 990.125, 999.125};
  ASSERT_TRUE(write_report_pdf(file.toStdString(), data, no_picture()).has_value());
  const double from = word_at(file, QStringLiteral("123.456")), to = word_at(file, QStringLiteral("987.654"));
  ASSERT_GT(from, 0.0);
  EXPECT_GT(to, from + 5.0) << "on one line its end was cut off";
}

}  // namespace
}  // namespace cusp::test
