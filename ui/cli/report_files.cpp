#include "ui/cli/report_files.h"

#include <QBuffer>

#include "scenarios/grading/maxima.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/report/report_data.h"
#include "ui/text/grade_text.h"
#include "ui/report/report_pdf.h"

namespace cusp::ui {

namespace {

constexpr int kPictureSidePx = 1200;

Result<void, Message> write_picture(const std::filesystem::path& file, const DrawnTooth& tooth) {
  if (!tooth) return std::unexpected(Message{picture_failure_text(tooth.error()), CliText::tr("The record and the report are kept.")});
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (!tooth->image.save(&buffer, "PNG") || !write_whole(file, png.toStdString())) return std::unexpected(cannot_write(file));
  return {};
}

}  // namespace

Message cannot_write(const std::filesystem::path& file) {
  return {CliText::tr("%1 cannot be written.").arg(QString::fromStdString(file.string())), {}};
}

void print_criteria(const Grade& grade, const std::string& indent, const Region* whole) {
  const std::vector<ScaledPoints> scaled = scaled_points(grade);
  for (std::size_t i = 0; i < grade.criteria.size(); ++i) {
    const CriterionGrade& c = grade.criteria[i];
    print_line(indent + plain(QStringLiteral("%1/%2  %3: %4")
                           .arg(scaled[i].points, 5, 'f', 1)
                           .arg(scaled[i].points_max, 0, 'f', 1)
                           .arg(metric_name(c.id, whole), reason_text(c))));
  }
}

void print_grade(const Grade& g, const Region& whole) {
  print_line(plain(CliText::tr("%1 of %2 points: %3")
                .arg(g.score, 0, 'f', 1)
                .arg(g.score_max, 0, 'f', 0)
                .arg(g.passed ? CliText::tr("passed") : CliText::tr("not passed"))));
  for (const std::string& critical : g.critical) print_line("! " + plain(critical_name(critical)));
  print_criteria(g, {}, &whole);
}

std::vector<std::filesystem::path> report_files_in(const std::filesystem::path& folder) {
  return {folder / "report.json", folder / "report.pdf", folder / "tooth.png"};
}

Result<void, Message> write_report_files(const std::filesystem::path& folder, const SessionResult& result, Store& store,
                                         const Account& student) {
  if (!write_whole(folder / "report.json", report_text(result, store, student))) {
    return std::unexpected(cannot_write(folder / "report.json"));
  }
  const Actor reader = student.actor();
  return write_paper(folder, gather_report(result, &store, &reader));
}

Result<void, Message> write_paper(const std::filesystem::path& folder, const ReportData& data) {
  const DrawnTooth tooth = draw_report_tooth(data.result, order_for_paper(data, kPictureSidePx));
  const auto pdf = write_report_pdf(folder / "report.pdf", data, tooth);
  if (!pdf) return std::unexpected(cannot_write(folder / "report.pdf"));
  return write_picture(folder / "tooth.png", tooth);
}

}  // namespace cusp::ui
