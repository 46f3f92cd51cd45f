#include "ui/widgets/pdf_file.h"

#include <QFile>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace cusp::ui {
namespace {

constexpr int kDotsPerInch = 300;

/// QPdfWriter reports no full disk; a whole PDF ends in %%EOF.
bool is_whole(const QString& name) {
  QFile written(name);
  if (!written.open(QIODevice::ReadOnly) || written.size() < 16) return false;
  written.seek(written.size() - 16);
  return written.readAll().contains("%%EOF");
}

bool write_part(const QString& name, const PdfSheet& sheet, const std::function<void(QPainter&, QPdfWriter&)>& draw) {
  QPdfWriter writer(name);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(sheet.margins_mm, QPageLayout::Millimeter);
  writer.setResolution(kDotsPerInch);
  writer.setTitle(sheet.title);
  writer.setCreator(QStringLiteral("Cusp"));
  QPainter painter;
  if (!painter.begin(&writer)) return false;
  draw(painter, writer);
  return painter.end();
}

}  // namespace

Result<void, PdfFailure> write_pdf(const std::filesystem::path& file, const PdfSheet& sheet,
                                   const std::function<void(QPainter& painter, QPdfWriter& writer)>& draw) {
  const QString part = QString::fromStdString(file.string()) + QStringLiteral(".part");
  if (!write_part(part, sheet, draw) || !is_whole(part)) {
    QFile::remove(part);
    return fail(PdfError::cannot_write, file.string());
  }
  std::error_code failed;
  std::filesystem::rename(part.toStdString(), file, failed);
  if (!failed) return {};
  QFile::remove(part);
  return fail(PdfError::cannot_write, file.string(), failed.message());
}

}  // namespace cusp::ui
