#include "ui/student/history_charts.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "ui/text/names.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct ChartText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::HistoryCharts)
};

double minutes_of(const HistoryRow& attempt) { return static_cast<double>(attempt.elapsed_us) * 1e-6 / 60.0; }

QString label_of(const HistoryRow& attempt) {
  return format_day_time(local_time(attempt.started_utc_us));
}

/// A step of 1, 2 or 5 times a power of ten that divides `span` into at most `parts`.
double round_step(double span, int parts) {
  const double raw = span / parts;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0, 10.0}) {
    if (m * power >= raw - 1e-12) return m * power;
  }
  return 10 * power;
}

/// Graded only, oldest first; the sequence orders attempts of one time, as in History::list().
std::vector<HistoryRow> in_order(const std::vector<HistoryRow>& attempts) {
  std::vector<HistoryRow> graded;
  for (const HistoryRow& attempt : attempts) {
    if (attempt.score) graded.push_back(attempt);
  }
  std::ranges::stable_sort(graded, {}, [](const HistoryRow& row) { return std::tuple(row.started_utc_us, row.sequence); });
  return graded;
}

void put_scores(ChartData& d, const std::vector<HistoryRow>& graded) {
  double lowest = graded.empty() ? 100 : graded.back().pass_mark.value_or(100);
  for (const HistoryRow& attempt : graded) lowest = std::min(lowest, *attempt.score);
  const double least = lowest < 40 ? 0 : 40;
  d.y = {ChartText::tr("points"), least, 100, 20, 0};
  if (!graded.empty() && graded.back().pass_mark) {
    d.mark = *graded.back().pass_mark;
    d.mark_text = ChartText::tr("pass %1").arg(format_points(*d.mark));
  }
  d.summary = graded.empty() ? QString()
                             : ChartText::tr("%n attempt(s), the last with %1 points.", nullptr, static_cast<int>(graded.size()))
                                   .arg(format_points(*graded.back().score));
}

}  // namespace

ChartData time_and_score(const std::vector<HistoryRow>& attempts) {
  const std::vector<HistoryRow> graded = in_order(attempts);
  ChartData d;
  d.title = ChartText::tr("Time and score");
  double longest = 0, shortest = 1e9;
  for (const HistoryRow& attempt : graded) {
    longest = std::max(longest, minutes_of(attempt));
    shortest = std::min(shortest, minutes_of(attempt));
  }
  // Below two minutes the axis counts seconds.
  const bool seconds = longest < 2;
  const double factor = seconds ? 60 : 1;
  if (graded.empty()) longest = shortest = 1;
  const double step = round_step(std::max(longest * factor, seconds ? 10.0 : 2.0), 6);
  const double most = step * (std::floor(longest * factor / step) + 1);
  d.x = {seconds ? ChartText::tr("seconds") : ChartText::tr("minutes"), 0, most, step, step < 1 ? 1 : 0};
  put_scores(d, graded);
  ChartSeries own;
  own.name = ChartText::tr("You");
  for (const HistoryRow& attempt : graded) own.points += {minutes_of(attempt) * factor, *attempt.score, label_of(attempt), false};
  if (!own.points.isEmpty()) own.points.last().strong = true;
  d.series += own;
  return d;
}

ChartData score_by_attempt(const std::vector<HistoryRow>& attempts) {
  const std::vector<HistoryRow> graded = in_order(attempts);
  ChartData d;
  d.title = ChartText::tr("Points by attempt");
  int last = 0;
  for (const HistoryRow& attempt : graded) last = std::max(last, attempt.attempt);
  const auto n = static_cast<double>(last);
  const double step = std::max(1.0, round_step(std::max(n, 4.0), 10));
  d.x = {ChartText::tr("attempt"), 0, std::max(4.0, step * std::ceil((n + 0.5) / step)), step, 0};
  put_scores(d, graded);
  ChartSeries own;
  own.name = ChartText::tr("Points");
  for (const HistoryRow& attempt : graded) own.points += {static_cast<double>(attempt.attempt), *attempt.score, label_of(attempt), false};
  if (!own.points.isEmpty()) own.points.last().strong = true;
  d.series += own;
  return d;
}

ChartData own_against_measured(const std::vector<RatedAttempt>& attempts) {
  ChartData d;
  d.title = ChartText::tr("Own assessment");
  double widest = 20;
  int last = 4;
  ChartSeries own;
  own.name = ChartText::tr("Own less measured");
  own.draw = ChartSeries::Draw::line_dots;
  for (const RatedAttempt& a : attempts) {
    if (a.points.criteria == 0) continue;
    const double difference = a.points.own - a.points.measured;
    widest = std::max(widest, std::abs(difference));
    last = std::max(last, a.attempt);
    //: Of an attempt: its date, points by own assessment, measured points.
    const QString label = ChartText::tr("%1: own %2, measured %3")
                              .arg(format_day_time(local_time(a.started_utc_us)), format_points(std::round(a.points.own)),
                                   format_points(std::round(a.points.measured)));
    own.points += {static_cast<double>(a.attempt), std::round(difference), label, false};
  }
  const double step = widest <= 40 ? 20 : 50, most = step * std::ceil(widest / step), step_x = std::max(1.0, round_step(last, 10));
  d.x = {ChartText::tr("attempt"), 0, step_x * std::ceil((last + 0.5) / step_x), step_x, 0};
  d.y = {ChartText::tr("points"), -most, most, step, 0};
  d.mark = 0;
  d.mark_text = ChartText::tr("as measured");
  if (!own.points.isEmpty()) {
    own.points.last().strong = true;
    d.summary = ChartText::tr("%n rated attempt(s), the last %1 points from what was measured.", nullptr, static_cast<int>(own.points.size()))
                    .arg(format_number(own.points.last().y, 0));
  }
  d.series += own;
  return d;
}

}  // namespace cusp::ui
