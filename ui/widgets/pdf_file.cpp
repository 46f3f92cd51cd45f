#include "ui/widgets/pdf_file.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace cusp::ui {
namespace {

constexpr int kDotsPerInch = 300;

bool draw_pdf(QByteArray& bytes, const PdfSheet& sheet, const std::function<void(QPainter&, QPdfWriter&)>& draw) {
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly)) return false;
  QPdfWriter writer(&buffer);
  writer.setPageLayout(sheet.layout.value_or(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, sheet.margins_mm, QPageLayout::Millimeter)));
  writer.setResolution(kDotsPerInch);
  writer.setTitle(sheet.title);
  writer.setCreator(QStringLiteral("Cusp"));
  QPainter painter;
  if (!painter.begin(&writer)) return false;
  draw(painter, writer);
  return painter.end();
}

}  // namespace

/// QPdfWriter draws into memory: it prints a warning for a file that it cannot open, and reports no full disk.
Result<void, PdfFailure> write_pdf(const std::filesystem::path& file, const PdfSheet& sheet,
                                   const std::function<void(QPainter& painter, QPdfWriter& writer)>& draw) {
  QByteArray bytes;
  if (!draw_pdf(bytes, sheet, draw)) return fail(PdfError::cannot_write, file.string(), "QPdfWriter");
  if (const auto written = save_bytes(QString::fromStdString(file.string()), bytes, sheet.readers); !written) {
    return fail(PdfError::cannot_write, file.string(), written.error().toStdString());
  }
  return {};
}

}  // namespace cusp::ui
