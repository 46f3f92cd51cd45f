// The report's page as a file and on a printer.

#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QRegularExpression>

#include "ui/report/report_page.h"
#include "ui/report/report_pdf.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kPictureSide = 1200;  // of the tooth on paper: 140 dots a cm

/// Without what a path or the file system of a stick reads in another way.
QString file_name(QString text) {
  static const QRegularExpression kSigns(u"[/\\\\:*?\"<>|]"_qs);
  return text.replace(kSigns, u"-"_qs).trimmed();
}

}  // namespace

const DrawnTooth& ReportPage::drawing() {
  if (!drawing_ || !*drawing_) drawing_ = draw_report_tooth(data_.result, order_for_paper(data_, kPictureSide));
  return *drawing_;
}

void ReportPage::save_pdf() {
  FileWish wish;
  wish.title = tr("Save the report");
  wish.name = file_name(data_.title + u' ' + data_.when.toString(u"yyyy-MM-dd HH-mm"_qs)) + u".pdf"_qs;
  wish.filter = tr("PDF (*.pdf)");
  ports_.pick_file(this, wish, [this](const QString& path) {
    const DrawnTooth& tooth = drawing();
    const auto done = write_report_pdf(path.toStdString(), data_, tooth);
    if (!done) {
      news_->show_message(Band::Kind::bad, tr("The report was not saved."),
                          tr("%1 cannot be written. The attempt and its grade are kept.").arg(path));
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
    QPainter painter;
    if (!painter.begin(printer)) {
      return news_->show_message(Band::Kind::bad, tr("The report was not printed."),
                                 tr("The printer or its file takes nothing. The attempt and its grade are kept."));
    }
    const QRectF page(QPointF(0, 0), printer->pageRect(QPrinter::DevicePixel).size());
    const DrawnTooth& tooth = drawing();
    paint_report(painter, page, printer->resolution() / 84.0, data_, tooth, [printer] { printer->newPage(); });
    if (!tooth) {
      news_->show_message(Band::Kind::look, tr("The report is printed without the picture of the tooth."),
                          picture_failure_text(tooth.error()));
    }
  });
  dialog->open();
}

}  // namespace cusp::ui
