#include "ui/student/history_charts.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct ChartText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::HistoryCharts)
};

constexpr qsizetype kMostJoined = 60;  // attempts: the lines and rings of more would run into one band

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

/// Attempts count from 1: a short axis begins there. The numbers of a long one are multiples of its step.
ChartAxis attempts_axis(int last) {
  constexpr int kLeastShown = 4;
  const double step = std::max(1.0, round_step(std::max(last, kLeastShown), 10));
  const double least = step <= 2 ? 1 : 0;
  return {ChartText::tr("attempt"), least, std::max<double>(kLeastShown, least + step * std::ceil((last + 0.5 - least) / step)), step, 0};
}

ChartSeries series_of(const QString& name, QVector<ChartPoint> points) {
  ChartSeries out;
  out.name = name;
  out.draw = points.size() > kMostJoined ? ChartSeries::Draw::dots : ChartSeries::Draw::line_dots;
  if (!points.isEmpty()) points.last().strong = true;
  out.points = std::move(points);
  return out;
}

/// For a screen reader.
QString summary_of(const std::vector<HistoryRow>& graded) {
  if (graded.empty()) return {};
  const auto best = std::ranges::max_element(graded, {}, [](const HistoryRow& row) { return *row.score; });
  QStringList out{ChartText::tr("Attempts: %1. The last has %2 of 100 points.")
                      .arg(format_number(static_cast<double>(graded.size()), 0), format_points(*graded.back().score))};
  if (graded.size() > 1) out += ChartText::tr("The best has %1.").arg(format_points(*best->score));
  if (graded.back().pass_mark) out += ChartText::tr("The pass mark is %1.").arg(format_points(*graded.back().pass_mark));
  return out.join(u' ');
}

void put_scores(ChartData& d, const std::vector<HistoryRow>& graded) {
  double lowest = graded.empty() ? 100 : graded.back().pass_mark.value_or(100);
  for (const HistoryRow& attempt : graded) lowest = std::min(lowest, *attempt.score);
  const double least = lowest < 40 ? 0 : 40;
  d.y = {ChartText::tr("points"), least, 100, 20, 0};
  d.value_text = points_text;
  if (!graded.empty() && graded.back().pass_mark) {
    d.mark = *graded.back().pass_mark;
    d.mark_text = ChartText::tr("pass %1").arg(format_points(*d.mark));
  }
  d.summary = summary_of(graded);
}

bool is_drawn(const RatedAttempt& attempt) { return attempt.points.criteria > 0; }

QString summary_of_ratings(int count, double last) {
  const QString rated = format_number(count, 0), apart = format_number(std::abs(last), 0);
  if (last > 0) return ChartText::tr("Rated attempts: %1. The last was rated %2 of 100 points higher than it was measured.").arg(rated, apart);
  if (last < 0) return ChartText::tr("Rated attempts: %1. The last was rated %2 of 100 points lower than it was measured.").arg(rated, apart);
  return ChartText::tr("Rated attempts: %1. The last was rated as it was measured.").arg(rated);
}

}  // namespace

ChartData time_and_score(const std::vector<HistoryRow>& attempts) {
  const std::vector<HistoryRow> graded = in_order(attempts);
  ChartData d;
  d.title = ChartText::tr("Time and score");
  double longest = graded.empty() ? 1 : 0;
  for (const HistoryRow& attempt : graded) longest = std::max(longest, minutes_of(attempt));
  // Below two minutes the axis counts seconds.
  const bool seconds = longest < 2;
  const double factor = seconds ? 60 : 1;
  const double step = round_step(std::max(longest * factor, seconds ? 10.0 : 2.0), 6);
  const double most = step * (std::floor(longest * factor / step) + 1);
  d.x = {seconds ? ChartText::tr("seconds") : ChartText::tr("minutes"), 0, most, step, step < 1 ? 1 : 0};
  put_scores(d, graded);
  QVector<ChartPoint> points;
  for (const HistoryRow& attempt : graded) points += {minutes_of(attempt) * factor, *attempt.score, label_of(attempt), false};
  d.series += series_of(ChartText::tr("You"), std::move(points));
  return d;
}

ChartData score_by_attempt(const std::vector<HistoryRow>& attempts) {
  const std::vector<HistoryRow> graded = in_order(attempts);
  ChartData d;
  d.title = ChartText::tr("Points by attempt");
  int last = 0;
  for (const HistoryRow& attempt : graded) last = std::max(last, attempt.attempt);
  d.x = attempts_axis(last);
  put_scores(d, graded);
  QVector<ChartPoint> points;
  for (const HistoryRow& attempt : graded) points += {static_cast<double>(attempt.attempt), *attempt.score, label_of(attempt), false};
  d.series += series_of(ChartText::tr("Points"), std::move(points));
  return d;
}

ChartData own_against_measured(const std::vector<RatedAttempt>& attempts) {
  ChartData d;
  d.title = ChartText::tr("Own assessment");
  double widest = 20;
  int last = 0;
  QVector<ChartPoint> points;
  for (const RatedAttempt& a : attempts) {
    if (!is_drawn(a)) continue;
    const double own = std::round(a.points.own), measured = std::round(a.points.measured);
    const double difference = own - measured;  // of the points as they are shown
    widest = std::max(widest, std::abs(difference));
    last = std::max(last, a.attempt);
    //: Of an attempt: its date, points by own assessment, measured points.
    const QString label = ChartText::tr("%1: own %2, measured %3")
                              .arg(format_day_time(local_time(a.started_utc_us)), format_points(own), format_points(measured));
    points += {static_cast<double>(a.attempt), difference, label, false};
  }
  const double step = widest <= 40 ? 20 : 50, most = step * std::ceil(widest / step);
  d.x = attempts_axis(last);
  d.y = {ChartText::tr("points"), -most, most, step, 0};
  d.value_text = points_text;
  d.mark = 0;
  d.mark_text = ChartText::tr("as measured");
  if (!points.isEmpty()) d.summary = summary_of_ratings(static_cast<int>(points.size()), points.last().y);
  d.series += series_of(ChartText::tr("Own less measured"), std::move(points));
  return d;
}

std::vector<SessionId> sessions_drawn(const std::vector<HistoryRow>& attempts) {
  std::vector<SessionId> out;
  for (const HistoryRow& attempt : in_order(attempts)) out.push_back(attempt.session);
  return out;
}

std::vector<SessionId> sessions_drawn(const std::vector<RatedAttempt>& attempts) {
  std::vector<SessionId> out;
  for (const RatedAttempt& a : attempts)
    if (is_drawn(a)) out.push_back(a.session);
  return out;
}

}  // namespace cusp::ui
