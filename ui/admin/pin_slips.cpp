#include "ui/admin/pin_slips.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>

#include "ui/widgets/paper.h"

namespace cusp::ui {
namespace {

struct SlipText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::PinSlips)
};

constexpr int kAcross = 2, kDown = 5;
const QMarginsF kMarginsMm(12, 12, 12, 12);

void draw_slip(QPainter& painter, const QRectF& box, const PinSlip& slip) {
  const Tokens& t = Tokens::light();
  painter.setPen(QPen(t.border, kPdfUnit * 0.7, Qt::DashLine));
  painter.drawRect(box);
  Paper paper(painter, box.adjusted(14 * kPdfUnit, 12 * kPdfUnit, -14 * kPdfUnit, -10 * kPdfUnit), kPdfUnit);
  const Paper::Column column{paper.page().left(), paper.page().width()};
  paper.write(slip.name, column, {14, Weight::bold, t.text});
  paper.write(slip.cohort, column, {11, Weight::regular, t.text2});
  paper.skip(8);
  paper.write(SlipText::tr("Sign in to Cusp with"), column, {11, Weight::regular, t.text2});
  paper.skip(4);
  paper.write(SlipText::tr("Number %1").arg(slip.number), column, {14, Weight::bold, t.text});
  paper.skip(2);
  paper.write(SlipText::tr("PIN %1").arg(slip.pin.left(3) + QChar(0x2009) + slip.pin.mid(3)), column, {18, Weight::bold, t.text});
}

}  // namespace

Result<void, PdfFailure> write_pin_slips(const std::filesystem::path& file, const std::vector<PinSlip>& slips) {
  return write_pdf(file, {.margins_mm = kMarginsMm, .readers = Readers::owner}, [&slips](QPainter& painter, QPdfWriter& writer) {
    const QSizeF box(writer.width() / static_cast<double>(kAcross), writer.height() / static_cast<double>(kDown));
    int on_page = 0;
    for (const PinSlip& slip : slips) {
      if (on_page == kAcross * kDown) {
        writer.newPage();
        on_page = 0;
      }
      draw_slip(painter, QRectF(QPointF(on_page % kAcross * box.width(), on_page / kAcross * box.height()), box), slip);
      ++on_page;
    }
  });
}

}  // namespace cusp::ui
