/// The report on paper, always in the light colours: one A4 page, further ones if the criteria are many, and one with a picture
/// of each place where points were lost.
#pragma once

#include <QRectF>
#include <filesystem>
#include <functional>

#include "ui/report/report_data.h"
#include "ui/widgets/pdf_file.h"

class QPainter;

namespace cusp::ui {

/// Middle of the number of the place `at`: beside the place, so that what happened there is seen, and clear of the numbers
/// whose middles are `taken`. `middle`: of the picture; `unit`: of the paper to a pixel of the screen at 100 %.
QPointF number_spot(QPointF at, QPointF middle, double unit, const std::vector<QPointF>& taken);

/// Places marked on the paper's tooth, those of the first entries of next_time(), and a close-up of each entry's place; both in
/// the order of next_time().
DrawingOrder order_for_paper(const ReportData& data, int side_px);

/// `tooth` is of order_for_paper(). If it failed, its place on the page gives the cause. `layout`: of PdfSheet.
Result<void, PdfFailure> write_report_pdf(const std::filesystem::path& file, const ReportData& data,
                                          const DrawnTooth& tooth, const std::optional<QPageLayout>& layout = std::nullopt);

/// Onto any paper: `page` in the painter's units, `unit` of them to a pixel of the screen. `new_page` begins another sheet.
void paint_report(QPainter& painter, const QRectF& page, double unit, const ReportData& data, const DrawnTooth& tooth,
                  const std::function<void()>& new_page);

}  // namespace cusp::ui
