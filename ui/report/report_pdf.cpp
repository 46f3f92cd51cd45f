#include "ui/report/report_pdf.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/landmarks/landmarks.h"
#include "ui/report/paper_closeups.h"
#include "ui/report/paper_criteria.h"
#include "ui/report/paper_remarks.h"
#include "ui/report/paper_sides.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/paper.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

struct PdfText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Report)
};

// Pixels of the screen at 100 %; `unit` of the paper to each.
constexpr double kToothHigh = 300, kToothLeast = 130;  // of the picture: usual, and beside the legend where a table is long
constexpr double kToothRatio = 1.35;                    // how much wider than high it is
constexpr double kAboveFoot = 14, kFootType = 8.5;      // between the advice and the foot; size of its type
constexpr int kFootFlags = static_cast<int>(Qt::AlignLeft | Qt::AlignBottom) | Qt::TextWordWrap;
constexpr double kBelowTooth = 14;                      // between the picture and the table
constexpr double kBeside = 22.6;                        // from a place to the middle of its number
constexpr std::size_t kAdviceShown = 4;                 // entries of "Next time" that fit one page

void write_head(Paper& paper, const ReportData& d, const Tokens& t) {
  const double x = paper.page().left(), w = paper.page().width();
  paper.write(u"Cusp"_qs, {x, w}, {12, Weight::bold, t.accent}, Qt::AlignTrailing, Paper::Then::stay);
  paper.write(d.title, {x, w * 0.8}, {22, Weight::bold, t.text});
  paper.skip(2);
  QString line = occasion_text(d, Medium::paper);
  if (!d.student.isEmpty()) line = d.student + u" · "_qs + line;
  paper.write(line, {x, w}, {11, Weight::regular, t.text2});
  paper.skip(10);
  paper.rule(t.line);
  paper.skip(10);
}

void write_score(Paper& paper, const ReportData& d, const Tokens& t) {
  const Grade& g = d.result.grade;
  const double x = paper.page().left(), w = paper.page().width();
  const QString score = format_points(g.score);
  paper.painter().setFont(paper.font(40, Weight::bold));
  const double width = paper.painter().fontMetrics().horizontalAdvance(score);
  paper.write(score, {x, w}, {40, Weight::bold, t.text}, Qt::AlignLeft, Paper::Then::stay);
  const double right = x + width + paper.u(14);
  paper.skip(8);
  paper.write((g.passed ? PdfText::tr("Passed") : PdfText::tr("Not passed")) + u" · "_qs +
                  PdfText::tr("%1 of %2 points, pass mark %3")
                      .arg(score, format_points(g.score_max), format_points(g.pass_mark)), {right, w - width}, {12, Weight::bold, g.passed ? t.good : t.bad});
  paper.skip(2);
  paper.write(circumstances_text(d), {right, w - width}, {11, Weight::regular, t.text2});
  if (const QString own = own_assessment_text(d); !own.isEmpty()) paper.write(own, {right, w - width}, {11, Weight::regular, t.text2});
  for (const QString& used : burs_used_text(d)) paper.write(used, {right, w - width}, {11, Weight::regular, t.text2});
  paper.skip(14);
  if (d.result.interrupted) {
    paper.write(d.result.state == SessionState::interrupted ? PdfText::tr("This attempt broke off. It is not graded yet; the points show how it stands now.")
                                                            : PdfText::tr("This attempt broke off. It is marked as it stands."), {x, w}, {12, Weight::bold, t.look});
    paper.skip(4);
  }
  for (const CriticalEvent& event : d.critical) {
    paper.write(PdfText::tr("%1: this fails the attempt, whatever its points.").arg(critical_text(event, d.result.scenario.specimen)), {x, w}, {12, Weight::bold, t.bad});
    if (const QString how = critical_circumstances(d, event); !how.isEmpty()) paper.write(how + u'.', {x, w}, {11, Weight::regular, t.text2});
    paper.skip(4);
  }
}

/// One entry of "Next time" on paper, with its number on the picture; 0 if the picture does not show its place.
struct PaperAdvice {
  Advice advice;
  std::optional<QPointF> at_px;
  int number = 0;
};

std::vector<PaperAdvice> advice_on_paper(const ReportData& data, const DrawnTooth& tooth) {
  std::vector<PaperAdvice> out;
  std::size_t place = 0;
  int number = 0;
  for (Advice& advice : next_time(data)) {
    if (out.size() == kAdviceShown) break;
    PaperAdvice& one = out.emplace_back();
    if (advice.place_mm) {
      if (tooth && place < tooth->places_px.size()) one.at_px = tooth->places_px[place];
      ++place;
    }
    if (one.at_px) one.number = ++number;
    one.advice = std::move(advice);
  }
  return out;
}

void write_tooth(Paper& paper, const DrawnTooth& tooth, const std::vector<PaperAdvice>& marked, double high, int fdi, const Tokens& t) {
  const QRectF page = paper.page();
  const QRectF where(page.left(), paper.y(), paper.u(high * kToothRatio), paper.u(high));
  QPainter& p = paper.painter();
  if (!tooth) {
    p.fillRect(where, t.sunken);
    p.setFont(paper.font(11));
    p.setPen(t.text2);
    p.drawText(where.adjusted(paper.u(12), 0, -paper.u(12), 0), Qt::AlignCenter | Qt::TextWordWrap, picture_failure_text(tooth.error()));
    return;
  }
  const QImage& image = tooth->image;
  const QRectF part(0, image.height() * (1 - 1 / kToothRatio) / 2, image.width(), image.width() / kToothRatio);
  p.drawImage(where, image, part);
  const double scale = where.width() / part.width();
  p.save();
  p.setClipRect(where);
  std::vector<QPointF> taken;
  for (const PaperAdvice& mark : marked) {
    if (mark.number == 0) continue;
    const QPointF at = where.topLeft() + (*mark.at_px - part.topLeft()) * scale;
    const QPointF beside = number_spot(at, where.center(), paper.u(1), taken);
    taken.push_back(beside);
    p.setPen(QPen(t.text, paper.u(1)));
    p.drawLine(at, beside);
    p.setBrush(t.text);
    p.drawEllipse(at, paper.u(1.6), paper.u(1.6));
    paper.number(beside, mark.number);
  }
  write_sides(paper, where, fdi);
  p.restore();
}

void write_next_time(Paper& paper, const ReportData& d, const std::vector<PaperAdvice>& shown, const Tokens& t, const MakeRoom& make_room) {
  const double x = paper.page().left(), w = paper.page().width(), indent = paper.u(20);
  const Paper::Type bold{11, Weight::bold, t.text}, plain{11, Weight::regular, t.text};
  const auto text_of = [](const Advice& advice) { return (advice.why + u' ' + advice.what_to_do).trimmed(); };
  const auto height = [&](const Advice& advice) { return paper.height_of(advice.head, w - indent, bold) + paper.height_of(text_of(advice), w - indent, plain); };
  make_room(paper.u(20) + (shown.empty() ? 0.0 : height(shown.front().advice)));
  paper.write(PdfText::tr("Next time"), {x, w}, {13, Weight::bold, t.text});
  paper.skip(4);
  for (const auto& [advice, at, number] : shown) {
    make_room(height(advice));
    if (number > 0) paper.number({x + paper.u(kNumberRing), paper.y() + paper.u(8)}, number);
    paper.write(advice.head, {x + indent, w - indent}, {11, Weight::bold, advice.grave ? t.bad : t.text});
    paper.write(text_of(advice), {x + indent, w - indent}, plain);
    paper.skip(4);
  }
  QString counted = counted_text(d.result.grade, d.result.scenario.rubric);
  if (shown.empty() && counted.isEmpty()) counted = no_advice_text(d);
  if (!counted.isEmpty()) make_room(paper.height_of(counted, w, plain));
  if (!counted.isEmpty()) paper.write(counted, {x, w}, plain);
  if (d.before) {
    make_room(paper.u(8 + kCriteriaRow));
    paper.skip(8);
    const double apart = std::round(10 * (shown_points(d.result.grade.score) - shown_points(d.before->score))) / 10;  // as both are shown
    paper.write(PdfText::tr("Best before: %1 point(s) on %2; this attempt %3.", nullptr, point_forms(d.before->score))
                    .arg(format_points(d.before->score), format_date(d.before_when),
                         (apart > 0 ? u"+"_qs : QString()) + format_points(std::abs(apart) < kShownPoint / 2 ? 0 : apart)), {x, w}, {11, Weight::regular, t.text2});
  }
}

/// Legend of the difference map, at the right of the tooth.
void write_legend(Paper& paper, double high, const Tokens& t) {
  QPainter& painter = paper.painter();
  const QRectF page = paper.page();
  const double x = page.left() + paper.u(high * kToothRatio + 20), w = page.right() - x;
  const ToothColours& c = ToothColours::get();
  const std::pair<QString, QColor> lines[] = {{PdfText::tr("uncut remainder, 0.5 mm and more"), c.map[0]},
                                              {PdfText::tr("uncut remainder, 0.3 mm"), c.map[1]},
                                              {PdfText::tr("on target, within 0.1 mm"), c.map[2]},
                                              {PdfText::tr("over-cut, 0.3 mm"), c.map[3]},
                                              {PdfText::tr("over-cut, 0.5 mm and more"), c.map[4]}};
  double y = paper.y();
  for (const auto& [text, colour] : lines) {
    painter.setPen(QPen(t.border, paper.u(0.7)));
    painter.setBrush(colour);
    painter.drawRect(QRectF(x, y + paper.u(3), paper.u(12), paper.u(12)));
    painter.setFont(paper.font(11));
    painter.setPen(t.text);
    const QRectF area(x + paper.u(20), y, w - paper.u(20), paper.u(60));
    const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
    painter.drawText(area, flags, text);
    y += std::max(paper.u(22), painter.boundingRect(area, flags, text).height() + paper.u(6));
  }
}

/// How high table and advice are, px at 100 %. Draws them beyond a picture of one pixel.
double height_of_rest(const QRectF& page, double unit, const ReportData& d, const std::vector<PaperAdvice>& advice, const Tokens& t) {
  QImage nothing(1, 1, QImage::Format_RGB32);
  QPainter painter(&nothing);
  Paper paper(painter, QRectF(page.left(), page.top(), page.width(), 10 * page.height()), unit);
  const MakeRoom endless = [](double) { return false; };
  write_criteria(paper, d, t, endless);
  write_next_time(paper, d, advice, t, endless);
  return (paper.y() - page.top()) / unit;
}

/// What identifies the attempt, at the page's foot.
QString foot_text(const ReportData& d) {
  QString foot = PdfText::tr("Engine %1, marking %2").arg(d.result.engine_version).arg(QString::fromStdString(d.result.grade.evaluator));
  if (!d.result.session.is_nil()) foot += u" · "_qs + QString::fromStdString(d.result.session.text());
  if (d.result.changes) foot = changes_text(*d.result.changes, &d.result.scenario.target, tissue_names_of(d.result)) + u'\n' + foot;
  return foot;
}

/// What identifies the attempt, and the page, at its foot.
void write_foot(Paper& paper, const ReportData& d, int page, const Tokens& t) {
  QPainter& p = paper.painter();
  p.setFont(paper.font(kFootType));
  p.setPen(t.text3);
  p.drawText(paper.page(), kFootFlags, foot_text(d));
  p.drawText(paper.page(), static_cast<int>(Qt::AlignRight | Qt::AlignBottom), PdfText::tr("Page %1").arg(page));
}

/// Of each advice with a place its number on the picture of the whole; 0: none.
std::vector<int> numbers_of(const std::vector<PaperAdvice>& advice) {
  std::vector<int> out;
  for (const PaperAdvice& one : advice)
    if (one.advice.place_mm) out.push_back(one.number);
  return out;
}

/// Above the foot, in the painter's units.
double bottom_of(Paper& paper, const ReportData& d) {
  paper.painter().setFont(paper.font(kFootType));
  return paper.page().bottom() - paper.painter().boundingRect(paper.page(), kFootFlags, foot_text(d)).height() - paper.u(kAboveFoot);
}

/// How high the picture may be. Leaves out the last advice where the page would else be too short, none where it stays so.
double fit_to_page(Paper& paper, const ReportData& d, std::vector<PaperAdvice>& advice, const Tokens& t) {
  const double unit = paper.u(1), room = (bottom_of(paper, d) - paper.y()) / unit - kBelowTooth;
  const std::vector<PaperAdvice> all = advice;
  double high = room - height_of_rest(paper.page(), unit, d, advice, t);
  while (high < kToothLeast && advice.size() > 1) {
    advice.pop_back();
    high = room - height_of_rest(paper.page(), unit, d, advice, t);
  }
  if (high < kToothLeast) advice = all;
  return std::clamp(high, kToothLeast, kToothHigh);
}

}  // namespace

QPointF number_spot(QPointF at, QPointF middle, double unit, const std::vector<QPointF>& taken) {
  const double first = at.x() < middle.x() ? 225 : 315;  // degrees: up and away from the picture's middle
  const auto spot = [&](double degrees, double far) {
    const double a = degrees * std::numbers::pi / 180;
    return at + QPointF(std::cos(a), std::sin(a)) * far * unit;
  };
  for (const double far : {kBeside, kBeside + 2 * kNumberRing + 2}) {
    for (const double turn : {0, 60, -60, 120, -120, 180}) {
      const QPointF here = spot(first + turn, far);
      const auto clear_of = [&](QPointF other) {
        return std::hypot(here.x() - other.x(), here.y() - other.y()) >= (2 * kNumberRing + 1) * unit;
      };
      if (std::ranges::all_of(taken, clear_of)) return here;
    }
  }
  return spot(first, kBeside);
}

DrawingOrder order_for_paper(const ReportData& data, int side_px) {
  static_assert(kAdviceShown <= kCloseupsShown);  // what is numbered has a picture of its own
  DrawingOrder out{.side_px = side_px};
  std::size_t shown = 0;
  for (const Advice& advice : next_time(data)) {
    const bool numbered = shown++ < kAdviceShown;
    if (!advice.place_mm || out.places.size() == kCloseupsShown) continue;
    out.places.push_back({*advice.place_mm, advice.metric});
    if (numbered) ++out.numbered;
  }
  return out;
}

void paint_report(QPainter& painter, const QRectF& page, double unit, const ReportData& data, const DrawnTooth& tooth,
                  const std::function<void()>& new_page) {
  const Tokens& t = Tokens::light();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  Paper paper(painter, page, unit);
  write_head(paper, data, t);
  write_score(paper, data, t);
  std::vector<PaperAdvice> advice = advice_on_paper(data, tooth);
  const double high = fit_to_page(paper, data, advice, t);
  write_tooth(paper, tooth, advice, high, sided_fdi(data.result.scenario.specimen), t);
  write_legend(paper, high, t);
  paper.skip(high + kBelowTooth);
  int sheet = 1;
  const double bottom = bottom_of(paper, data) + paper.u(kAboveFoot / 2);  // fit_to_page() measures fonts of another device
  const MakeRoom make_room = [&](double needed) {
    if (paper.y() + needed <= bottom) return false;
    write_foot(paper, data, sheet++, t);
    new_page();
    paper.skip((page.top() - paper.y()) / unit);
    write_head(paper, data, t);
    return true;
  };
  write_criteria(paper, data, t, make_room);
  write_next_time(paper, data, advice, t, make_room);
  write_foot(paper, data, sheet, t);
  if (tooth && !tooth->closeups.empty()) {
    new_page();
    Paper second(painter, page, unit);
    write_head(second, data, t);
    write_closeups(second, data, tooth->closeups, numbers_of(advice));
    write_foot(second, data, ++sheet, t);
  }
  write_remarks(data.remarks, bottom, [&] {
    new_page();
    Paper further(painter, page, unit);
    write_foot(further, data, ++sheet, t);
    write_head(further, data, t);
    return further;
  });
}

Result<void, PdfFailure> write_report_pdf(const std::filesystem::path& file, const ReportData& data,
                                          const DrawnTooth& tooth, const std::optional<QPageLayout>& layout) {
  return write_pdf(file, {.title = data.title, .layout = layout}, [&](QPainter& painter, QPdfWriter& writer) {
    paint_report(painter, QRectF(QPointF(0, 0), QSizeF(writer.width(), writer.height())), kPdfUnit, data, tooth,
                 [&writer] { writer.newPage(); });
  });
}

}  // namespace cusp::ui
