// The report's page as a file and on a printer.

#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>

#include "ui/report/report_page.h"
#include "ui/report/report_pdf.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kPictureSide = 1200;  // of the tooth on paper: 140 dots a cm

QString not_written(const PdfFailure& failure) {
  return ReportPage::tr("%1 cannot be written: %2. The attempt and its grade are kept.")
      .arg(QString::fromStdString(failure.where), QString::fromStdString(failure.detail));
}

/// A failure says in a sentence why. A file is written here, whole or not at all: QPrinter reports no full disk.
Result<void, QString> print_report(QPrinter& printer, const ReportData& data, const DrawnTooth& tooth) {
  if (const QString file = printer.outputFileName(); !file.isEmpty()) {
    const auto done = write_report_pdf(file.toStdString(), data, tooth, printer.pageLayout());
    if (!done) return std::unexpected(not_written(done.error()));
    return {};
  }
  QPainter painter;
  bool printed = painter.begin(&printer);
  if (printed) {
    const QRectF page(QPointF(0, 0), printer.pageRect(QPrinter::DevicePixel).size());
    paint_report(painter, page, printer.resolution() / 84.0, data, tooth, [&] { printed = printer.newPage() && printed; });
    printed = painter.end() && printed && printer.printerState() != QPrinter::Error && printer.printerState() != QPrinter::Aborted;
  }
  if (!printed) return std::unexpected(ReportPage::tr("The printer takes nothing. The attempt and its grade are kept."));
  return {};
}

}  // namespace

const DrawnTooth& ReportPage::drawing() {
  if (!drawing_ || !*drawing_) drawing_ = draw_report_tooth(data_.result, order_for_paper(data_, kPictureSide));
  return *drawing_;
}

void ReportPage::save_pdf() {
  FileWish wish;
  wish.title = tr("Save the report");
  wish.name = as_file_name(data_.title + u' ' + data_.when.toString(u"yyyy-MM-dd HH-mm"_qs)) + u".pdf"_qs;
  wish.filter = tr("PDF (*.pdf)");
  ports_.pick_file(this, wish, [this](const QString& path) {
    const DrawnTooth& tooth = drawing();
    const auto done = write_report_pdf(path.toStdString(), data_, tooth);
    if (!done) {
      news_->show_message(Band::Kind::bad, tr("The report was not saved."), not_written(done.error()));
    } else if (!tooth) {
      news_->show_message(Band::Kind::look, tr("The report is saved without the picture of the tooth."),
                          picture_failure_text(tooth.error()) + u' ' + path);
    } else {
      news_->show_message(Band::Kind::good, tr("The report is saved."), path);
    }
  });
}

void ReportPage::print() {
  auto* dialog = new QPrintDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->printer()->setPageSize(QPageSize(QPageSize::A4));
  connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), this, [this](QPrinter* printer) {
    const DrawnTooth& tooth = drawing();
    if (const auto printed = print_report(*printer, data_, tooth); !printed) {
      news_->show_message(Band::Kind::bad, tr("The report was not printed."), printed.error());
    } else if (!tooth) {
      news_->show_message(Band::Kind::look, tr("The report is printed without the picture of the tooth."),
                          picture_failure_text(tooth.error()));
    } else {
      news_->clear();
    }
  });
  dialog->open();
}

}  // namespace cusp::ui
