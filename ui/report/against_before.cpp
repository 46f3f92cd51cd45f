#include "ui/report/against_before.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "scenarios/grading/maxima.h"
#include "ui/modules.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kRow = 23, kNumber = 44;  // px at 100 %: height of a row, width of its number
constexpr int kLeastLine = 36;          // px at 100 %: length of a line; the names take the rest at most
constexpr int kGaps = 14;               // px at 100 %: about a line

QString with_sign(double points, int decimals) {
  if (std::abs(points) < 0.05) return isolate(format_points_to(0, decimals));
  return isolate((points > 0 ? u"+"_qs : QString()) + format_points_to(points, decimals));
}

}  // namespace

AgainstBefore::AgainstBefore(const Grade& now, const Grade& before, const Region* whole, const TissueNames& own, QWidget* parent) : QWidget(parent) {
  QStringList spoken;
  const std::vector<ScaledPoints> points_now = scaled_points(now), points_before = scaled_points(before);
  for (std::size_t i = 0; i < now.criteria.size(); ++i) {
    const CriterionGrade& c = now.criteria[i];
    if (!(c.points_max > 0)) continue;
    for (std::size_t j = 0; j < before.criteria.size(); ++j) {
      const CriterionGrade& b = before.criteria[j];
      if (b.id != c.id || !(b.points_max > 0)) continue;
      // Another rubric gives the criterion other points: its share before then counts in the points of now.
      const double most = points_now[i].points_max;
      const double earlier = points_before[j].points_max == most ? points_before[j].points : most * b.points / b.points_max;
      rows_ += {metric_name(c.id, whole, own), b.points / b.points_max, c.points / c.points_max, points_now[i].points - earlier};
    }
  }
  std::vector<double> gained;
  for (const Row& row : rows_) gained.push_back(row.points);
  decimals_ = points_decimals(gained);
  for (const Row& row : rows_) spoken += tr("%1 %2").arg(row.name, with_sign(row.points, decimals_));
  setAccessibleName(tr("Against the best before"));
  setAccessibleDescription(spoken.join(u", "_qs));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize AgainstBefore::sizeHint() const { return {px(250), px(kRow) * std::max<int>(1, static_cast<int>(rows_.size()))}; }

int AgainstBefore::longest_name() const {
  const QFontMetrics metrics(font_of(TextRole::body));
  int widest = 0;
  for (const Row& r : rows_) widest = std::max(widest, metrics.horizontalAdvance(r.name));
  return widest + px(9);
}

double AgainstBefore::names_width() const { return std::min<double>(longest_name(), width() - px(kLeastLine + kNumber + kGaps)); }

int AgainstBefore::whole_width() const { return longest_name() + px(kLeastLine + kNumber + kGaps); }

bool AgainstBefore::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int row = help->pos().y() / px(kRow);
    if (row >= 0 && row < rows_.size()) {
      QToolTip::showText(help->globalPos(), rows_[row].name, this);
      return true;
    }
  }
  return QWidget::event(event);
}

void AgainstBefore::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double name = names_width(), number = px(kNumber);
  for (int i = 0; i < rows_.size(); ++i) {
    const Row& r = rows_[i];
    const double y = px(kRow) * (i + 0.5);
    p.setFont(font_of(TextRole::body));
    p.setPen(t.text);
    const QFontMetrics metrics(p.font());
    p.drawText(QRectF(0, y - px(10), name - px(8), px(20)), Qt::AlignLeading | Qt::AlignVCenter,
               metrics.elidedText(r.name, Qt::ElideMiddle, static_cast<int>(name) - px(8)));
    const double x0 = name + px(6), x1 = width() - number - px(8);
    p.setPen(QPen(t.line, px(2)));
    p.drawLine(QPointF(x0, y), QPointF(x1, y));
    const double xb = x0 + r.before * (x1 - x0), xn = x0 + r.now * (x1 - x0);
    p.setPen(QPen(t.text2, px(2)));
    p.drawLine(QPointF(xb, y), QPointF(xn, y));
    p.setPen(QPen(t.text2, px(2)));
    p.setBrush(t.surface);
    p.drawEllipse(QPointF(xb, y), px(4.0), px(4.0));
    p.setPen(Qt::NoPen);
    p.setBrush(t.accent);
    p.drawEllipse(QPointF(xn, y), px(4.6), px(4.6));
    p.setFont(font_of(TextRole::body, Weight::bold));
    p.setPen(t.text);
    p.drawText(QRectF(width() - number, y - px(10), number, px(20)), Qt::AlignRight | Qt::AlignVCenter, with_sign(r.points, decimals_));
  }
}

}  // namespace cusp::ui
