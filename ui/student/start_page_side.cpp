// The side of the start page: the last result with advice, and time against points.
#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "scenarios/grading/maxima.h"
#include "ui/modules.h"
#include "ui/student/history_charts.h"
#include "ui/student/start_page.h"
#include "ui/text/critical_events.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kAdviceShown = 2;

/// What format_points() rounds to, as a whole number, so that equal texts compare equal.
double tenths(double points) { return std::round(shown_points(points) * 10); }

}  // namespace

QWidget* StartPage::make_side(const Account& account) {
  auto* panel = new QWidget;
  auto* side = new QVBoxLayout(panel);
  side->setContentsMargins(0, 0, 0, 0);
  side->setSpacing(px(16));
  side->addWidget(make_last(account));
  side->addWidget(make_chart());
  side->addStretch(1);
  return panel;
}

QWidget* StartPage::make_last(const Account& account) {
  const auto& last = course_.last_graded;
  if (!last) {
    auto* card = new Card(tr("Last result"));
    card->body()->addWidget(new EmptyState(u"chart"_qs, tr("No result yet"),
                                           tr("After the first attempt its points and what to do next time stand here.")));
    return card;
  }
  auto* card = new Card(tr("Last result"), format_day(local_time(last->started_utc_us)));
  auto* row = new QHBoxLayout;
  row->setSpacing(px(12));
  row->addWidget(make_label(format_points(*last->score), TextRole::score, Weight::bold));
  auto* of = new QVBoxLayout;
  of->setSpacing(px(2));
  of->addStretch();
  of->addWidget(make_label(tr("of 100"), TextRole::body, Weight::regular, "text2"));
  of->addWidget(new Chip(result_text(*last), static_cast<Chip::Kind>(result_chip(*last))));
  of->addStretch();
  row->addLayout(of);
  row->addStretch();
  const auto best = store_.history.best_before(account.actor(), last->session);
  if (best && *best && (*best)->score) {
    // Of the points as they are shown.
    const double apart = tenths(*last->score) - tenths(*(*best)->score);
    const QString points = format_points(std::abs(apart) / 10);
    QLabel* against = make_label(apart > 0    ? tr("%1 more than\nyour best before").arg(points)
                                 : apart == 0 ? tr("the same as\nyour best before")
                                              : tr("%1 less than\nyour best before").arg(points),
                                 TextRole::caption, Weight::regular, "text2");
    against->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
    row->addWidget(against);
  }
  card->body()->addLayout(row);
  QLabel* title = make_label(local(last->title), TextRole::caption, Weight::regular, "text2");
  title->setWordWrap(true);
  card->body()->addWidget(title);
  card->body()->addWidget(make_rule());
  card->body()->addWidget(make_label(tr("What to do next time"), TextRole::body, Weight::bold));
  add_advice(*card, *last, account);
  QPushButton* report = make_button(tr("Open the report"));
  card->body()->addWidget(report, 0, Qt::AlignLeading);
  connect(report, &QPushButton::clicked, this, [this, session = last->session] { Q_EMIT report_wanted(session); });
  return card;
}

void StartPage::add_advice(Card& card, const HistoryRow& last, const Account& account) {
  const auto details = store_.history.details(account.actor(), last.session);
  const auto say = [&](const QString& text) { card.body()->addWidget(make_paragraph(text)); };
  if (!details || !details->grade) return say(tr("The report has the points of each criterion."));
  const Grade& grade = details->grade->grade;
  const auto add = [&](const QString& icon_name, Ink ink, const QString& head, const QString& what_to_do) {
    auto* line = new QHBoxLayout;
    line->setSpacing(px(8));
    auto* sign = new QLabel;
    sign->setPixmap(icon_pixmap(icon_name, ink, 16, devicePixelRatioF()));
    line->addWidget(sign, 0, Qt::AlignTop);
    QLabel* text = make_label(u"<b>%1</b> %2"_qs.arg(head.toHtmlEscaped(), what_to_do.toHtmlEscaped()));
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    line->addWidget(text, 1);
    card.body()->addLayout(line);
  };
  const auto row = std::ranges::find(course_.rows, last.scenario, [](const CourseRow& one) { return one.exercise.scenario.id; });
  const Scenario* scenario = row != course_.rows.end() ? &row->exercise.scenario : nullptr;
  TissueNames own;
  if (scenario)
    if (const auto folder = exercise_folder(store_, row->exercise, volumes_)) own = tissue_names_in(*folder, *scenario);
  for (const CriticalEvent& event : critical_events(grade, &store_, last.session)) {
    add(u"cross"_qs, Ink::bad, critical_text(event, scenario ? scenario->specimen : SpecimenSource()) + u'.', critical_advice(event.key));
  }
  int shown = 0;
  bool changed = false;
  for (const LossReason& reason : loss_reasons(grade)) {
    if (!reason.critical.empty()) continue;
    const CriterionGrade& c = grade.criteria[reason.criterion];
    const bool by_hand = std::ranges::count(details->grade->overrides, c.id, &SignedStatement::criterion) > 0;
    changed = changed || by_hand;
    if (by_hand) continue;
    const QString advice = advice_text(c);
    if (advice.isEmpty() || ++shown > kAdviceShown) continue;
    add(c.id.starts_with("depth_") ? u"ruler"_qs : u"target"_qs, Ink::text2, metric_name(c.id, scenario ? &scenario->target : nullptr, own) + u':', advice);
  }
  const bool marked = std::ranges::all_of(grade.criteria, [](const CriterionGrade& c) { return c.points_max > 0; });
  const bool full = marked && loss_reasons(grade).size() == grade.critical.size();
  if (shown > 0 || (full && !grade.critical.empty())) return;
  if (changed) return say(tr("An examiner changed the points; the remarks in the report give the reasons."));
  say(full ? tr("Nothing: every criterion has its full points.") : tr("Not every criterion has its full points: see the report."));
}

QWidget* StartPage::make_chart() {
  // One exercise and one device class a chart: those of the last result.
  const auto& last = course_.last_graded;
  const std::vector<HistoryRow>& attempts = course_.charted;
  auto* card = new Card(tr("Time and score"), last ? local(last->title) : QString());
  card->wrap_aside();
  if (attempts.empty()) {
    card->body()->addWidget(new EmptyState(u"clock"_qs, tr("Nothing to draw yet"), tr("Each attempt becomes one point.")));
    return card;
  }
  auto* chart = new Chart;
  chart->set_data(time_and_score(attempts));
  chart->setFixedHeight(px(200));
  card->body()->addWidget(chart);
  const auto row = std::ranges::find(course_.rows, last->scenario, [](const CourseRow& one) { return one.exercise.scenario.id; });
  const bool free_of_time = row != course_.rows.end() && !asks_for_time(row->exercise.scenario);
  const int count = static_cast<int>(attempts.size());
  const QString what = free_of_time ? tr("Time earns no points. %1 only, %n attempt(s).", nullptr, count) : tr("%1 only, %n attempt(s).", nullptr, count);
  QLabel* note = make_label(what.arg(device_name(last->device_class)), TextRole::caption, Weight::regular, "text2");
  note->setWordWrap(true);
  card->body()->addWidget(note);
  connect(chart, &Chart::point_opened, this, [this, sessions = sessions_drawn(attempts)](int, int point) {
    Q_EMIT report_wanted(sessions[static_cast<std::size_t>(point)]);
  });
  return card;
}

}  // namespace cusp::ui
