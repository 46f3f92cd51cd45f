#include "ui/report/paper_closeups.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace cusp::ui {
namespace {

struct CloseupsText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Report)
};

// Pixels of the screen at 100 %.
constexpr std::size_t kFewAcross = 3, kManyAcross = 4;  // of up to kFewAcross * kFewAcross pictures, and of more
constexpr double kGap = 14;
constexpr double kTextGap = 4;  // from a picture to its text
constexpr double kFootHigh = 16;  // of the sheet's foot, below the last row
constexpr double kPlaceRing = 9;  // about the place

Paper::Type head_of(const Advice& advice) {
  return {10.5, Weight::bold, advice.grave ? Tokens::light().bad : Tokens::light().text};
}
Paper::Type why_type() { return {9.5, Weight::regular, Tokens::light().text2}; }

void draw_closeup(Paper& paper, const QRectF& where, const CloseUp& closeup) {
  QPainter& p = paper.painter();
  const Tokens& t = Tokens::light();
  p.drawImage(where, closeup.image);
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(t.line, paper.u(0.7)));
  p.drawRect(where);
  if (!closeup.at_px) return;
  const QPointF at = where.topLeft() + *closeup.at_px * (where.width() / closeup.image.width());
  p.setPen(QPen(ToothColours::get().casing, paper.u(3.5)));
  p.drawEllipse(at, paper.u(kPlaceRing), paper.u(kPlaceRing));
  p.setPen(QPen(ToothColours::get().map[2], paper.u(1.5)));
  p.drawEllipse(at, paper.u(kPlaceRing), paper.u(kPlaceRing));
}

}  // namespace

void write_closeups(Paper& paper, const ReportData& data, const std::vector<CloseUp>& closeups, const std::vector<int>& numbers) {
  const Tokens& t = Tokens::light();
  const QRectF page = paper.page();
  paper.write(CloseupsText::tr("Where points were lost"), {page.left(), page.width()}, {13, Weight::bold, t.text});
  paper.write(CloseupsText::tr("Hatched: where the points of each were lost. Numbers and colours as on the first page."), {page.left(), page.width()}, {10, Weight::regular, t.text2});
  paper.skip(8);
  const double top = paper.y(), gap = paper.u(kGap);
  const bool few = closeups.size() <= kFewAcross * kFewAcross;
  const std::size_t across = few ? kFewAcross : kManyAcross;
  const std::size_t down = few ? kFewAcross : (closeups.size() + across - 1) / across;
  const auto columns = static_cast<double>(across), rows = static_cast<double>(down);
  const double text_wide = (page.width() - (columns - 1) * gap) / columns;
  double text_high = 0.0;
  for (const Advice& advice : next_time(data))
    if (advice.place_mm) text_high = std::max(text_high, paper.height_of(advice.head, text_wide, head_of(advice)) + paper.height_of(advice.why, text_wide, why_type()));
  text_high += paper.u(kTextGap + 1);
  const double side = std::min(text_wide, (page.bottom() - paper.u(kFootHigh) - top - rows * (text_high + gap)) / rows);
  std::size_t i = 0;
  for (const Advice& advice : next_time(data)) {
    if (!advice.place_mm) continue;
    if (i == closeups.size()) break;
    const double x = page.left() + static_cast<double>(i % across) * (text_wide + gap);
    const double y = top + static_cast<double>(i / across) * (side + text_high + gap);
    draw_closeup(paper, QRectF(x, y, side, side), closeups[i]);
    if (i < numbers.size() && numbers[i] > 0) paper.number({x + paper.u(kNumberRing + 5), y + paper.u(kNumberRing + 5)}, numbers[i]);
    ++i;
    Paper below(paper.painter(), QRectF(x, y + side + paper.u(kTextGap), text_wide, text_high), paper.u(1));
    below.write(advice.head, {x, text_wide}, head_of(advice));
    below.write(advice.why, {x, text_wide}, why_type());
  }
}

}  // namespace cusp::ui
