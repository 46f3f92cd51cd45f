#include "ui/admin/pin_slips.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>

#include "ui/widgets/format.h"
#include "ui/widgets/paper.h"

namespace cusp::ui {
namespace {

struct SlipText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::PinSlips)
};

constexpr int kAcross = 2, kDown = 5;
constexpr int kWholeNumber = 18;  // characters: a line holds as many of the widest
const QMarginsF kMarginsMm(12, 12, 12, 12);

}  // namespace

void draw_slip(QPainter& painter, const QRectF& box, const PinSlip& slip, double unit) {
  const Tokens& t = Tokens::light();
  painter.setPen(QPen(t.border, unit * 0.7, Qt::DashLine));
  painter.drawRect(box);
  const QRectF inside = box.adjusted(14 * unit, 12 * unit, -14 * unit, -10 * unit);
  struct Line {
    QString text;
    Paper::Type type;
    double before;  // px at 100 %, above it
  };
  const Line sign_in[] = {{SlipText::tr("Sign in to Cusp with"), {11, Weight::regular, t.text2}, 8},
                          {SlipText::tr("Number %1").arg(breakable(slip.number, kWholeNumber)), {14, Weight::bold, t.text}, 4},
                          {SlipText::tr("PIN %1").arg(slip.pin.left(3) + QChar(0x2009) + slip.pin.mid(3)), {18, Weight::bold, t.text}, 2}};
  // A long name gives way: the PIN stands nowhere else.
  double latest = inside.bottom();
  Paper whole(painter, inside, unit);
  for (const Line& line : sign_in) latest -= whole.u(line.before) + whole.height_of(line.text, inside.width(), line.type);
  const Paper::Column column{inside.left(), inside.width()};
  Paper about(painter, QRectF(inside.topLeft(), QPointF(inside.right(), latest)), unit);
  about.write(slip.name, column, {14, Weight::bold, t.text});
  if (about.y() < latest) about.write(slip.cohort, column, {11, Weight::regular, t.text2});
  Paper below(painter, QRectF(QPointF(inside.left(), std::min(about.y(), latest)), inside.bottomRight()), unit);
  for (const Line& line : sign_in) {
    below.skip(line.before);
    below.write(line.text, column, line.type);
  }
}

Result<void, PdfFailure> write_pin_slips(const std::filesystem::path& file, const std::vector<PinSlip>& slips) {
  return write_pdf(file, {.margins_mm = kMarginsMm, .readers = Readers::owner}, [&slips](QPainter& painter, QPdfWriter& writer) {
    const QSizeF box(writer.width() / static_cast<double>(kAcross), writer.height() / static_cast<double>(kDown));
    int on_page = 0;
    for (const PinSlip& slip : slips) {
      if (on_page == kAcross * kDown) {
        writer.newPage();
        on_page = 0;
      }
      draw_slip(painter, QRectF(QPointF(on_page % kAcross * box.width(), on_page / kAcross * box.height()), box), slip, kPdfUnit);
      ++on_page;
    }
  });
}

}  // namespace cusp::ui
