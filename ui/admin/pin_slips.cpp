#include "ui/admin/pin_slips.h"

#include <QCoreApplication>
#include <QFile>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>
#include <cmath>

#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

struct SlipText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::PinSlips)
};

constexpr int kAcross = 2, kDown = 5;
constexpr double kUnit = 300.0 / 84.0;  // of the paper to a pixel of the screen, as on reports

void draw_slip(QPainter& painter, const QRectF& box, const PinSlip& slip) {
  const Tokens& t = Tokens::light();
  QPen cut(t.border, kUnit * 0.7, Qt::DashLine);
  painter.setPen(cut);
  painter.drawRect(box);
  const QRectF inner = box.adjusted(14 * kUnit, 12 * kUnit, -14 * kUnit, -10 * kUnit);
  const auto line = [&](double top, double size, Weight weight, const QColor& ink, const QString& text) {
    QFont font = font_of(TextRole::body, weight);
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(size * kUnit))));
    painter.setFont(font);
    painter.setPen(ink);
    const QString fitted = painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(inner.width()));
    painter.drawText(QRectF(inner.left(), inner.top() + top * kUnit, inner.width(), 2 * size * kUnit), Qt::AlignLeading | Qt::AlignTop, fitted);
  };
  line(0, 14, Weight::bold, t.text, slip.name);
  line(20, 11, Weight::regular, t.text2, slip.cohort);
  line(44, 11, Weight::regular, t.text2, SlipText::tr("Sign in to Cusp with"));
  line(62, 14, Weight::bold, t.text, SlipText::tr("Number %1").arg(slip.number));
  line(84, 18, Weight::bold, t.text, SlipText::tr("PIN %1").arg(slip.pin.left(3) + QChar(0x2009) + slip.pin.mid(3)));
}

}  // namespace

SlipsWritten write_pin_slips(const std::filesystem::path& file, const std::vector<PinSlip>& slips) {
  const QString name = QString::fromStdString(file.string());
  QFile::remove(name);
  QPdfWriter writer(name);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(12, 12, 12, 12), QPageLayout::Millimeter);
  writer.setResolution(300);
  writer.setCreator(u"Cusp"_qs);
  QPainter painter;
  if (!painter.begin(&writer)) return SlipsWritten::no;
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
  if (!painter.end()) return SlipsWritten::no;
  // QPdfWriter reports no full disk; a whole PDF ends in %%EOF.
  QFile written(name);
  if (!written.open(QIODevice::ReadOnly) || written.size() < 16) return SlipsWritten::no;
  written.seek(written.size() - 16);
  return written.readAll().contains("%%EOF") ? SlipsWritten::yes : SlipsWritten::no;
}

}  // namespace cusp::ui
