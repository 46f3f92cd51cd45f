#include "ui/cli/report_files.h"

#include <QBuffer>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "scenarios/grading/grader.h"
#include "scenarios/grading/maxima.h"
#include "storage/base/clock.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/report/report_data.h"
#include "ui/text/grade_text.h"
#include "ui/report/report_pdf.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

constexpr int kPictureSidePx = 1200;

Result<void, Message> write_picture(const std::filesystem::path& file, const DrawnTooth& tooth) {
  if (!tooth) return std::unexpected(Message{picture_failure_text(tooth.error()), CliText::tr("The record and the report are kept.")});
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (!tooth->image.save(&buffer, "PNG")) return std::unexpected(cannot_write(file, "PNG"));
  if (const auto written = write_whole(file, png.toStdString()); !written) return std::unexpected(cannot_write(file, written.error().detail));
  return {};
}

QString passed_text(const Grade& g) { return g.passed ? CliText::tr("passed") : CliText::tr("not passed"); }

/// "17.4 of 100 points: not passed", on a line of stdout.
void print_points(const Grade& g) {
  print_line(plain(CliText::tr("%1 of %2 points: %3").arg(format_number(shown_points(g.score), 1), format_number(g.score_max, 0), passed_text(g))));
}

void print_critical_and_criteria(const SessionResult& result) {
  for (const std::string& critical : result.grade.critical) print_line("! " + plain(critical_name(critical)));
  print_criteria(result.grade, {}, &result.scenario.target, tissue_names_of(result));
}

std::string name_of(Store& store, UserId id) {
  const auto account = store.accounts.find(id);
  return account ? account->name : std::string();
}

/// Measured points of the criterion that the statement speaks of.
double points_before(const EffectiveGrade& counts, const SignedStatement& s) {
  const auto& criteria = counts.stored.grade.criteria;
  const auto criterion = std::ranges::find(criteria, s.criterion, &CriterionGrade::id);
  return criterion == criteria.end() ? 0 : criterion->points;
}

QString change_text(const EffectiveGrade& counts, const SignedStatement& s, const SessionResult& measured, Store& store) {
  const QString who = QString::fromStdString(name_of(store, s.author)), why = QString::fromStdString(s.text);
  if (s.kind == StatementKind::override_critical) {
    //: %1: a critical event, %2: an examiner, %3: the reason.
    return CliText::tr("%1: does not count, changed by %2: %3").arg(critical_name(s.criterion), who, why);
  }
  const Grade& stored = counts.stored.grade;
  const double before = points_of_score(stored, s.criterion, points_before(counts, s));
  //: %1: a criterion, %2: points that count, %3: measured points, %4: an examiner, %5: the reason.
  return CliText::tr("%1: %2 instead of %3 point(s), changed by %4: %5", nullptr, point_forms(before))
      .arg(metric_name(s.criterion, &measured.scenario.target, tissue_names_of(measured)),
           format_points(points_of_score(stored, s.criterion, s.points.value_or(0))), format_points(before), who, why);
}

nlohmann::ordered_json effective_json(const EffectiveGrade& counts, Store& store) {
  nlohmann::ordered_json changes = nlohmann::ordered_json::array();
  for (const SignedStatement& s : counts.overrides) {
    const bool of_points = s.kind == StatementKind::override_points;
    changes.push_back({{"kind", std::string(key_of(s.kind))},
                       {"id", s.criterion},
                       {"points", of_points ? nlohmann::ordered_json(s.points.value_or(0)) : nullptr},
                       {"points_measured", of_points ? nlohmann::ordered_json(points_before(counts, s)) : nullptr},
                       {"by", name_of(store, s.author)},
                       {"at", iso_utc(s.at_utc_us)},
                       {"reason", s.text}});
  }
  const Grade& grade = counts.grade;
  return {{"score", grade.score}, {"passed", grade.passed}, {"critical", grade.critical}, {"changes", std::move(changes)}};
}

/// With another rubric the records hold a grade that is not this result's: the page shows the result alone.
void show_as_measured(const SessionResult& result, Store& store, ReportData& data) {
  data.result.grade = result.grade;
  mark_counted_with_target(data.result.grade, result.scenario.rubric);
  data.critical = critical_events(data.result.grade, &store, result.session);
  data.changes.clear();
}

}  // namespace

void print_criteria(const Grade& grade, const std::string& indent, const Region* whole, const TissueNames& own) {
  const std::vector<ScaledPoints> scaled = scaled_points(grade);
  for (std::size_t i = 0; i < grade.criteria.size(); ++i) {
    const CriterionGrade& c = grade.criteria[i];
    print_line(indent + plain(QStringLiteral("%1/%2  %3: %4")
                           .arg(format_number(scaled[i].points, 1), 5)
                           .arg(format_number(scaled[i].points_max, 1), metric_name(c.id, whole, own), reason_text(c))));
  }
}

void print_grade(const SessionResult& result) {
  print_points(result.grade);
  print_critical_and_criteria(result);
}

void print_changed_grade(const EffectiveGrade& counts, const SessionResult& measured, Store& store) {
  print_points(counts.grade);
  for (const SignedStatement& s : counts.overrides) print_line(plain(change_text(counts, s, measured, store)));
  const Grade& grade = measured.grade;
  print_line(plain(CliText::tr("Measured: %1 of %2 points, %3")
                       .arg(format_number(shown_points(grade.score), 1), format_number(grade.score_max, 0), passed_text(grade))));
  print_critical_and_criteria(measured);
}

std::vector<std::filesystem::path> report_files_in(const std::filesystem::path& folder) {
  return {folder / "report.json", folder / "report.pdf", folder / "tooth.png"};
}

std::string report_file_text(const SessionResult& result, Store& store, const ReportOrder& order) {
  std::string text = report_text(result, store, order.student);
  if (!order.changed) return text;
  auto json = nlohmann::ordered_json::parse(text);
  json["effective"] = effective_json(*order.changed, store);
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<void, Message> write_report_files(const std::filesystem::path& folder, const SessionResult& result, Store& store,
                                         const ReportOrder& order) {
  const std::filesystem::path file = folder / "report.json";
  if (const auto written = write_whole(file, report_file_text(result, store, order)); !written) {
    return std::unexpected(cannot_write(file, written.error().detail));
  }
  ReportData data = gather_report(result, &store, &order.reader);
  if (!order.changed) show_as_measured(result, store, data);
  return write_paper(folder, data);
}

Result<void, Message> write_paper(const std::filesystem::path& folder, const ReportData& data) {
  const DrawnTooth tooth = draw_report_tooth(data.result, order_for_paper(data, kPictureSidePx));
  const auto pdf = write_report_pdf(folder / "report.pdf", data, tooth);
  if (!pdf) return std::unexpected(cannot_write(folder / "report.pdf", pdf.error().detail));
  return write_picture(folder / "tooth.png", tooth);
}

}  // namespace cusp::ui
