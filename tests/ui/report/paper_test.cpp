// The report on paper, read back by pdfimages and pdftotext.

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <filesystem>

#include "scenarios/library/library.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/report_pdf.h"
#include "ui/session/scene_builder.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"

namespace cusp::test {
namespace {

TEST(ReportPdf, is_one_whole_page_and_leaves_no_half_file) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ASSERT_TRUE(write_report_pdf(file, sample(), no_picture()).has_value());
  QFile written(QString::fromStdString(file.string()));
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray bytes = written.readAll();
  EXPECT_TRUE(bytes.startsWith("%PDF-"));
  EXPECT_TRUE(bytes.contains("/Count 1"));  // pages
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
  const auto failed = write_report_pdf(file.parent_path() / "no" / "r.pdf", sample(), no_picture());
  ASSERT_FALSE(failed.has_value());
  EXPECT_EQ(failed.error().code, PdfError::cannot_write);
}

/// Collects what Qt would print on stderr.
class QtMessages {
 public:
  QtMessages() : before_{qInstallMessageHandler(keep)} { lines.clear(); }
  ~QtMessages() { qInstallMessageHandler(before_); }
  QtMessages(const QtMessages&) = delete;
  QtMessages& operator=(const QtMessages&) = delete;
  static inline QStringList lines{};

 private:
  static void keep(QtMsgType, const QMessageLogContext&, const QString& line) { lines += line; }
  QtMessageHandler before_;
};

TEST(ReportPdf, that_cannot_be_written_leaves_no_message_of_qt_and_no_file) {
  const QTemporaryDir folder;
  const std::filesystem::path in = folder.path().toStdString();
  const ReportData data = sample();
  {
    const QtMessages messages;
    EXPECT_FALSE(write_report_pdf(in / "no" / "r.pdf", data, no_picture()));
    EXPECT_FALSE(write_report_pdf(in, data, no_picture())) << "a folder";
  }
  EXPECT_TRUE(QtMessages::lines.isEmpty()) << QtMessages::lines.join(u'\n').toStdString();
  EXPECT_TRUE(std::filesystem::is_empty(in));
}

/// What pdfimages lists of a file: one line each, without its two lines of heads.
QStringList images_in(const std::filesystem::path& file) {
  QProcess list;
  list.start(QStringLiteral("pdfimages"), {QStringLiteral("-list"), QString::fromStdString(file.string())});
  if (!list.waitForFinished(60'000)) return {};
  return QString::fromUtf8(list.readAllStandardOutput()).split(u'\n', Qt::SkipEmptyParts).mid(2);
}

/// The text of its pages, in order.
std::string text_in(const std::filesystem::path& file) {
  QProcess text;
  text.start(QStringLiteral("pdftotext"), {QString::fromStdString(file.string()), QStringLiteral("-")});
  if (!text.waitForFinished(60'000)) return {};
  return QString::fromUtf8(text.readAllStandardOutput()).simplified().toStdString();
}

/// The block of the exercise, untouched.
ReportData whole_block() {
  ReportData data = sample();
  const auto volume = build_specimen(data.result.scenario, {});
  if (volume) data.result.volume = std::make_shared<const Volume>(*volume);
  return data;
}

TEST(ReportPdf, names_the_sides_of_a_tooth_on_its_picture_and_the_page_at_its_foot) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  const DrawnTooth drawn = ToothDrawing{QImage(400, 400, QImage::Format_RGB32), {}, {}};
  ASSERT_TRUE(write_report_pdf(file, data, drawn).has_value());
  EXPECT_FALSE(QRegularExpression(QStringLiteral("\\bM\\b")).match(QString::fromStdString(text_in(file))).hasMatch()) << "a block has no sides";
  data.result.scenario = *load_builtin("class-1-36");
  ASSERT_TRUE(write_report_pdf(file, data, drawn).has_value());
  const QString text = QString::fromStdString(text_in(file));
  for (const char16_t letter : {u'M', u'D', u'B', u'L'})
    EXPECT_TRUE(QRegularExpression(QStringLiteral("\\b%1\\b").arg(QChar(letter))).match(text).hasMatch()) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Page 1"))) << text.toStdString();
}

TEST(ReportPdf, has_the_remarks_on_sheets_of_their_own) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  data.remarks.push_back({Uuid::v7(), QStringLiteral("Dr Berg"), data.when, QStringLiteral("Floor depth: 6 instead of 4 points"),
                          QStringLiteral("The block was worn."), std::nullopt});
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const std::string text = text_in(file);
  for (const char* part : {"Remarks", "Dr Berg, Fri 20 Nov 2026, 10:14 UTC", "6 instead of 4 points", "The block was worn."}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  for (int i = 0; i < 60; ++i) data.remarks.push_back(data.remarks.front());
  data.remarks.back().text = QStringLiteral("The last one.");
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  EXPECT_NE(text_in(file).find("The last one."), std::string::npos);
}

TEST(ReportPdf, gives_the_year_of_each_date_and_the_time_zone_of_the_attempt) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  data.when = QDateTime(QDate::currentDate(), QTime(10, 14));  // a screen leaves the year of now out
  data.before = data.result.grade;
  data.before_when = data.when;
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const std::string text = text_in(file), day = format_date(data.when).toStdString();
  EXPECT_TRUE(day.ends_with(std::to_string(data.when.date().year())));
  EXPECT_NE(text.find(day + ", 10:14 UTC"), std::string::npos) << text;
  EXPECT_NE(text.find("points on " + day), std::string::npos) << text;
}

TEST(ReportPdf, compares_with_the_best_before_as_both_are_shown) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample(78.04);  // shown as 78; 81.96 as 81.9
  data.before_when = data.when;
  for (const auto& [before, apart] : {std::pair{81.96, "this attempt -3.9."}, {78.0, "this attempt 0."}, {74.06, "this attempt +3.9."}}) {
    data.before = sample_grade(before);
    ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
    const QString text = QString::fromStdString(text_in(file)).replace(QChar(0x2212), u'-');
    EXPECT_TRUE(text.contains(QLatin1String(apart))) << text.toStdString();
  }
}

TEST(ReportPdf, promises_full_points_of_no_criterion_that_was_not_marked) {
  ReportData data = sample();
  for (CriterionGrade& c : data.result.grade.criteria) {
    c.points = c.points_max = 0;
    c.measure.measured = false;
    c.reason_code = "not_measured";
  }
  ASSERT_TRUE(next_time(data).empty());
  EXPECT_EQ(no_advice_text(data), QStringLiteral("No criterion could be marked."));
  CriterionGrade& first = data.result.grade.criteria.front();
  first.points = first.points_max = 100;
  EXPECT_EQ(no_advice_text(data), QStringLiteral("Every marked criterion has its full points."));
}

TEST(ReportPdf, marks_a_criterion_whose_points_an_examiner_changed_with_the_reason) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  const std::string changed = data.result.grade.criteria.at(1).id;
  data.changes.push_back({changed, QStringLiteral("4 instead of 2 points, changed by Dr Berg: the block was worn")});
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const std::string text = text_in(file);
  EXPECT_NE(text.find(metric_name(changed).toStdString() + " (changed)"), std::string::npos) << text;
  EXPECT_NE(text.find("changed by Dr Berg: the block was worn"), std::string::npos) << text;
}

TEST(ReportPdf, holds_the_picture_of_the_tooth) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = whole_block();
  ASSERT_TRUE(data.result.volume);
  const DrawnTooth tooth = draw_report_tooth(data.result, order_for_paper(data, 300));
  ASSERT_TRUE(tooth) << tooth.error().detail;
  // More than its background: the middle is tooth, the corner is not.
  EXPECT_NE(tooth->image.pixel(150, 150), tooth->image.pixel(2, 2));
  ASSERT_TRUE(write_report_pdf(file, data, tooth));
  EXPECT_GE(images_in(file).size(), 1) << "no image in the PDF";
  EXPECT_EQ(text_in(file).find("could not be drawn"), std::string::npos);
}

constexpr double kA4Points = 842.0, kLeastMarginPoints = 28.0;  // height of the sheet, and what stays free at its foot

/// Lower edges of a page's words, and the upper edge of its first foot's word.
struct Edges {
  double lowest = 0, foot = 0;
};
std::vector<Edges> edges_of_pages(const std::filesystem::path& file) {
  QProcess text;
  text.start(QStringLiteral("pdftotext"), {QStringLiteral("-bbox"), QString::fromStdString(file.string()), QStringLiteral("-")});
  if (!text.waitForFinished(60'000)) return {};
  static const QRegularExpression word(QStringLiteral("yMin=\"([0-9.]+)\" xMax=\"[0-9.]+\" yMax=\"([0-9.]+)\">([^<]*)<"));
  std::vector<Edges> out;
  for (const QString& page : QString::fromUtf8(text.readAllStandardOutput()).split(QStringLiteral("<page ")).mid(1)) {
    Edges& edges = out.emplace_back();
    for (const QRegularExpressionMatch& m : word.globalMatch(page)) {
      if (m.captured(3) == QStringLiteral("Engine")) edges.foot = m.captured(1).toDouble();
      if (edges.foot == 0) edges.lowest = std::max(edges.lowest, m.captured(2).toDouble());
    }
  }
  return out;
}
Edges edges_in(const std::filesystem::path& file) {
  const auto pages = edges_of_pages(file);
  return pages.empty() ? Edges{} : pages.front();
}
std::size_t pages_in(const std::filesystem::path& file) { return edges_of_pages(file).size(); }

TEST(ReportPdf, has_room_for_long_names_and_all_advice_of_the_longest_rubric_above_its_foot) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  CriterionGrade lost = data.result.grade.criteria.at(1);
  lost.id = "gingival_above_cej";
  for (std::size_t i = 2; i < 17; ++i) data.result.grade.criteria.push_back(lost);
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const Edges edges = edges_in(file);
  EXPECT_GT(edges.lowest, 0);
  EXPECT_GT(edges.foot, edges.lowest);
  const std::string text = text_in(file);
  EXPECT_NE(text.find("junction"), std::string::npos) << text;
}

TEST(ReportPdf, continues_a_table_that_is_longer_than_its_page_on_another_one) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  CriterionGrade lost = data.result.grade.criteria.at(1);
  for (int um = 101; um <= 136; ++um) {
    lost.id = "surface_within_" + std::to_string(um);
    data.result.grade.criteria.push_back(lost);
  }
  data.before = data.result.grade;
  data.before_when = data.when;
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const QString text = QString::fromStdString(text_in(file));  // pdftotext leaves out what lies beyond a page
  for (int um = 101; um <= 136; ++um) EXPECT_TRUE(text.contains(QStringLiteral("Target within %1").arg(um))) << um;
  for (const char* part : {"Next time", "Best before", "Page 1", "Page 2"}) EXPECT_TRUE(text.contains(QLatin1String(part))) << part;
  ASSERT_EQ(pages_in(file), 2u);
  for (const Edges& page : edges_of_pages(file)) EXPECT_GT(page.foot, page.lowest);
}

/// The paragraph has more lines than a sheet.
TEST(ReportPdf, cuts_nothing_off_a_remark_that_is_longer_than_its_sheet) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  QStringList words;
  for (int i = 0; i < 1200; ++i) words += QStringLiteral("word%1").arg(i);  // 8,000 of the 10,000 bytes that a comment may have
  const QString said = words.join(u' ');
  for (int i = 0; i < 3; ++i) data.remarks.push_back({Uuid::v7(), QStringLiteral("Dr Berg"), data.when, {}, said, std::nullopt});
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const QString text = QString::fromStdString(text_in(file));
  for (int i : {0, 600, 900, 1199}) EXPECT_EQ(text.count(QStringLiteral("word%1").arg(i)), 3) << i;
  ASSERT_GT(pages_in(file), 3);
  for (const Edges& page : edges_of_pages(file)) {
    EXPECT_LE(page.lowest, kA4Points - kLeastMarginPoints);
    EXPECT_GT(page.foot, page.lowest);
  }
  for (std::size_t page = 1; page <= pages_in(file); ++page)
    EXPECT_EQ(text.count(QRegularExpression(QStringLiteral("Page %1\\b").arg(page))), 1) << page;
}

TEST(ReportPdf, names_an_attempt_that_broke_off) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  EXPECT_EQ(text_in(file).find("This attempt broke"), std::string::npos);
  data.result.interrupted = true;
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  for (const char* part : {"This attempt broke", "It is marked as it stands."})  // the paper joins the letters f
    EXPECT_NE(text_in(file).find(part), std::string::npos) << text_in(file);
  data.result.state = SessionState::interrupted;
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  EXPECT_NE(text_in(file).find("It is not graded yet; the points show how it stands now."), std::string::npos) << text_in(file);
  EXPECT_EQ(text_in(file).find("It is marked as it stands."), std::string::npos);
}

TEST(ReportPdf, has_room_for_a_long_attempt_with_several_burs_above_its_foot) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  data.result.scenario = *load_builtin("class-2-25-mod");
  data.result.grade.criteria.clear();
  for (const Criterion& asked : data.result.scenario.rubric.criteria) {
    CriterionGrade c;
    c.id = asked.metric;
    c.measure = {asked.metric, true, 12.34, 0.05, metric_unit(asked.metric).toStdString(), Vec3(0.0)};
    c.points = 1.5;
    c.points_max = 100.0 / 15;
    c.reason_code = "too_much";
    c.reason_args = {{"value", 12.34}, {"limit", 0.5}};
    data.result.grade.criteria.push_back(c);
  }
  std::uint64_t at = 0;
  for (int i = 0; i < 30; ++i) {
    data.burs.push_back({static_cast<std::uint16_t>(i % data.result.scenario.instruments.size()), at, at + 40'000'000, 1'000'000});
    at += 40'000'000;
  }
  data.result.seconds = 1200;
  data.result.grade.critical = {"pulp_exposure", "protected_damage"};
  data.critical = critical_events(data.result.grade, nullptr, {});
  for (int i = 0; i < 3; ++i) data.changes.push_back({data.result.grade.criteria[static_cast<std::size_t>(i)].id, QStringLiteral("4 instead of 2 points, changed by Dr Berg: the block was worn")});
  data.before = data.result.grade;
  data.before_when = data.when;
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()).has_value());
  const Edges edges = edges_in(file);
  EXPECT_GT(edges.foot, edges.lowest);
}

TEST(ReportPdf, has_a_picture_of_each_lost_place_of_the_longest_rubric_on_its_second_page) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = whole_block();
  ASSERT_TRUE(data.result.volume);
  const CriterionGrade lost = data.result.grade.criteria.at(1);
  ASSERT_TRUE(lost.measure.where_mm);
  constexpr std::size_t kLongest = 17;  // criteria of the template of a classical class II
  for (std::size_t i = 1; i < kLongest; ++i) data.result.grade.criteria.push_back(lost);
  const DrawingOrder order = order_for_paper(data, 120);
  EXPECT_EQ(order.places.size(), kLongest);
  const DrawnTooth tooth = draw_report_tooth(data.result, order);
  ASSERT_TRUE(tooth) << tooth.error().detail;
  ASSERT_TRUE(write_report_pdf(file, data, tooth));
  EXPECT_EQ(images_in(file).filter(QStringLiteral(" image ")).size(), 1 + static_cast<qsizetype>(kLongest));
  QFile written(QString::fromStdString(file.string()));
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  EXPECT_TRUE(written.readAll().contains("/Count 2"));
}

TEST(ReportPdf, has_a_second_page_with_a_picture_of_each_lost_place) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  const ReportData data = whole_block();
  ASSERT_TRUE(data.result.volume);
  const DrawingOrder order = order_for_paper(data, 300);
  ASSERT_FALSE(order.places.empty()) << "the sample lost no points at a place";
  const DrawnTooth tooth = draw_report_tooth(data.result, order);
  ASSERT_TRUE(tooth) << tooth.error().detail;
  ASSERT_EQ(tooth->closeups.size(), order.places.size());
  ASSERT_TRUE(write_report_pdf(file, data, tooth));
  EXPECT_EQ(images_in(file).filter(QStringLiteral(" image ")).size(), 1 + static_cast<qsizetype>(order.places.size()));
  const std::string text = text_in(file);
  const auto second = text.find("Where points were lost");
  ASSERT_NE(second, std::string::npos) << text;
  const Advice first = [&] {
    for (const Advice& advice : next_time(data))
      if (advice.place_mm) return advice;
    return Advice{};
  }();
  EXPECT_NE(text.find(first.head.toStdString(), second), std::string::npos) << text.substr(second);
}

TEST(ReportPdf, has_one_page_if_no_place_lost_points) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = whole_block();
  for (CriterionGrade& c : data.result.grade.criteria) c.measure.where_mm.reset();
  ASSERT_TRUE(write_report_pdf(file, data, draw_report_tooth(data.result, order_for_paper(data, 300))));
  EXPECT_EQ(text_in(file).find("Where points were lost"), std::string::npos);
}

TEST(ReportPdf, gives_the_cause_of_a_missing_picture) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ASSERT_TRUE(write_report_pdf(file, sample(), no_picture()));
  EXPECT_TRUE(images_in(file).isEmpty());
  EXPECT_NE(text_in(file).find("The tooth could not be drawn: OpenGL 3.3 did not start"), std::string::npos) << text_in(file);
}

TEST(ReportPdf, puts_an_opened_pulp_before_every_other_advice) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ReportData data = sample();
  data.result.grade.critical = {"pulp_exposure"};
  data.critical = critical_events(data.result.grade, nullptr, {});
  ASSERT_TRUE(write_report_pdf(file, data, no_picture()));
  const std::string text = text_in(file);
  const auto advice = text.find("Next time"), pulp = text.find("The pulp was exposed", advice);
  ASSERT_NE(pulp, std::string::npos) << text;
  EXPECT_LT(pulp, text.find("points lost", advice));
}

}  // namespace
}  // namespace cusp::test
