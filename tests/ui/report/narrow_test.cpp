// The report in a narrow window. With CUSP_PICTURES=FOLDER it leaves pictures of itself there.

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/looks.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/against_before.h"
#include "ui/report/criteria_model.h"
#include "ui/report/report_page.h"
#include "ui/text/grade_text.h"
#include "ui/text/language.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

TEST(CriteriaModel, gives_up_bars_and_uncertainty_in_a_narrow_table_and_never_points) {
  CriteriaModel model(test::sample_grade(81), {});
  model.set_detail(CriteriaModel::Detail::narrow);
  const auto at = [&](int column, int role = Qt::DisplayRole) { return model.index(1, column).data(role); };
  EXPECT_TRUE(at(CriteriaModel::kMeasured).toString().contains(QStringLiteral("2.41")));
  EXPECT_FALSE(at(CriteriaModel::kMeasured, SecondRole).isValid());
  EXPECT_TRUE(at(CriteriaModel::kMeasured, Qt::AccessibleTextRole).toString().contains(QStringLiteral("0.03")));
  EXPECT_FALSE(at(CriteriaModel::kPoints, ShareRole).isValid());
  EXPECT_EQ(at(CriteriaModel::kPoints, SecondRole).toString().toStdString(), "/ 33.3");
}

TEST(ReportPage, a_narrow_window_cuts_nothing_off_at_the_side) {
  ReportData data;
  data.result.scenario = *load_builtin("channel-1");
  data.result.grade = test::sample_grade(81);
  data.title = QStringLiteral("Straight channel");
  data.when = QDateTime(QDate(2026, 11, 20), QTime(10, 14));
  data.before = test::sample_grade(95);
  data.before_when = data.when;
  data.result.grade.criteria[1].id = "overcut_leeway_side";
  const Ports ports = Ports::of_the_system();
  ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  page.resize(853, 533);  // 1280x800 at 150 %
  page.show();
  QTest::qWait(0);
  EXPECT_EQ(page.table()->horizontalScrollBar()->maximum(), 0);
  EXPECT_EQ(page.table()->verticalScrollBar()->maximum(), 0);
  const auto* scroll = page.findChild<QScrollArea*>();
  ASSERT_NE(scroll, nullptr);
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0);
  int named = 0;
  for (const QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() != u"Print" && b->accessibleName() != u"Save as PDF") continue;
    ++named;
    EXPECT_TRUE(b->text().isEmpty());
    EXPECT_FALSE(b->shortcut().isEmpty()) << b->toolTip().toStdString();
    EXPECT_TRUE(b->toolTip().startsWith(b->accessibleName()));
  }
  EXPECT_EQ(named, 2);
  page.resize(1280, 800);
  QTest::qWait(0);
  for (const QPushButton* b : page.findChildren<QPushButton*>()) EXPECT_FALSE(b->text().isEmpty()) << b->accessibleName().toStdString();
}

/// A report of a built-in exercise with every criterion measured, one attempt before it.
ReportData whole_report(std::string_view key) {
  ReportData data;
  data.result.scenario = *load_builtin(key);
  for (const Criterion& asked : data.result.scenario.rubric.criteria) {
    CriterionGrade c;
    c.id = asked.metric;
    c.measure = {asked.metric, true, 12.34, 0.05, metric_unit(asked.metric).toStdString(), Vec3(0.0)};
    c.points = 6.5;
    c.points_max = 10;
    c.reason_code = "too_much";
    c.reason_args = {{"value", 12.34}, {"limit", 0.5}};
    data.result.grade.criteria.push_back(c);
  }
  data.title = QStringLiteral("A");
  data.when = data.before_when = QDateTime(QDate(2026, 11, 20), QTime(10, 14));
  data.before = data.result.grade;
  return data;
}

/// Texts of the criteria that are cut in the page.
QStringList cut_names(const ReportPage& page) {
  QStringList out;
  const Table* table = page.table();
  const QFontMetrics metrics(font_of(TextRole::body));
  for (int row = 0; row < table->model()->rowCount(); ++row) {
    const QString name = table->model()->index(row, CriteriaModel::kName).data().toString();
    const int width = table->columnWidth(CriteriaModel::kName) - px(16);
    if (cell_lines(name, metrics, width, Qt::ElideMiddle).join(u' ') != name) out += name;
  }
  for (const AgainstBefore* against : page.findChildren<AgainstBefore*>()) {
    if (against->width() < against->whole_width()) out += against->accessibleName();
  }
  return out;
}

TEST(ReportPage, ShowsEveryCriterionsNameWholeInEachLanguage) {
  const Ports ports = Ports::of_the_system();
  in_each_look([&](const QString& look) {
    for (const char* key : {"channel-1", "class-1-36-wet"}) {  // criteria of a block and of a tooth
      const QString name = QLatin1String(key) + u'-' + look;
      SCOPED_TRACE(name.toStdString());
      ReportPage page(whole_report(key), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
      page.resize(1280, 800);
      page.show();
      QTest::qWait(0);
      EXPECT_EQ(cut_names(page).join(u"; ").toStdString(), "");
      EXPECT_GE(page.table()->viewport()->width(), page.table()->whole_width());  // each in one line
      leave_picture(page, name + QStringLiteral("-1280"));
      page.resize(853, 533);  // 1280x800 at 150 %
      QTest::qWait(0);
      EXPECT_EQ(cut_names(page).join(u"; ").toStdString(), "");
      leave_picture(page, name + QStringLiteral("-853"));
    }
  });
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

/// Texts of several lines that lose one of them.
QStringList cut_texts(const QWidget& shown) {
  QStringList out;
  for (const QLabel* label : shown.findChildren<QLabel*>())
    if (label->isVisible() && label->wordWrap() && label->height() < label->heightForWidth(label->width())) out += label->text();
  return out;
}

TEST(ReportPage, on_a_small_screen_at_200_percent_shows_every_point_and_the_pass_mark) {
  const Ports ports = Ports::of_the_system();
  ReportData data = whole_report("class-1-36-wet");
  data.title = QStringLiteral("Class I cavity on tooth 36, with coolant and a dam");
  data.kind = SessionKind::practice;
  data.attempt = 12;
  data.result.session = SessionId{Uuid::v7()};
  data.result.seconds = 1234;
  data.result.device.device_class = "pointer";
  data.peak_push_n = 2.1;
  for (const std::uint64_t minute : {0, 5, 10, 15}) data.burs.push_back({static_cast<std::uint16_t>(minute % 2), minute * 60'000'000, (minute + 5) * 60'000'000, 1});
  for (const char* language : {"de", "en"}) {
    SCOPED_TRACE(language);
    install_language(*qApp, QLatin1String(language));
    apply_theme(*qApp, ColourScheme::dark, 200);
    ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
    page.offer_pack();
    QWidget window;  // of the screen's size, whatever the page would like
    window.resize(1280, 720);
    page.setParent(&window);
    page.setGeometry(window.rect());
    page.show();
    window.show();
    QTest::qWait(0);
    leave_picture(page, QLatin1String(language) + QStringLiteral("-200"));
    EXPECT_EQ(page.table()->horizontalScrollBar()->maximum(), 0);
    EXPECT_EQ(page.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
    EXPECT_EQ(cut_texts(page).join(u"; ").toStdString(), "");
    expect_buttons_fit(page);
    page.setParent(nullptr);
  }
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST(CellLines, BreakAtABlankAndElideWhatFitsInNoLine) {
  const QFontMetrics metrics(font_of(TextRole::body));
  const auto lines = [&metrics](const char* text, const char* as_wide_as) {
    return cell_lines(QString::fromUtf8(text), metrics, metrics.horizontalAdvance(QString::fromUtf8(as_wide_as)) + 2, Qt::ElideRight).join(u'|').toStdString();
  };
  EXPECT_EQ(lines("over-cut, floor", "over-cut, floor"), "over-cut, floor");
  EXPECT_EQ(lines("over-cut, floor", "over-cut, floo"), "over-cut,|floor");
  EXPECT_EQ(lines("a b c d", "a b c"), "a b c|d");
  EXPECT_EQ(lines("overcut", "over…"), "over…");
  EXPECT_EQ(lines("ab overcut", "over…"), "ab|over…");
}

TEST(ReportPage, scrolls_as_a_whole_with_the_criteria_of_a_long_rubric) {
  const Ports ports = Ports::of_the_system();
  ReportData data = sample();
  for (int um = 101; um <= 130; ++um) {
    data.result.grade.criteria.push_back(data.result.grade.criteria.at(1));
    data.result.grade.criteria.back().id = "surface_within_" + std::to_string(um);
  }
  ReportPage page(std::move(data), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  page.resize(1280, 720);
  page.show();
  QTest::qWait(0);
  EXPECT_EQ(page.table()->verticalScrollBar()->maximum(), 0);
}

}  // namespace
}  // namespace cusp::test
