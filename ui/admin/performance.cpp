#include "ui/admin/performance.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>
#include <ranges>

#include "ui/admin/criteria_card.h"
#include "ui/modules.h"
#include "ui/student/course.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kNarrowBelow = 1040;       // px at 100 %, of the page
constexpr double kFrom = 40;    // points: least value of the axis unless somebody has fewer
constexpr int kMostSorted = 5000;  // attempts that another order than the newest first is made of: fetched in 0.2 s
constexpr int kMostDots = 300;  // attempts drawn one by one

/// Sorts by SortRole: numbers by value, names by the language.
class Sorted : public QSortFilterProxyModel {
 public:
  explicit Sorted(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortRole(SortRole);
    setSortLocaleAware(true);
    setSortCaseSensitivity(Qt::CaseInsensitive);
  }
};

/// Each of the newest attempts that has points, by its number.
Stored<ChartSeries> dots_of(Store& store, const Actor& reader, HistoryFilter newest) {
  newest.limit = kMostDots;
  const auto rows = store.history.list(reader, newest);
  if (!rows) return std::unexpected(rows.error());
  ChartSeries dots;
  dots.draw = ChartSeries::Draw::dots;
  for (const HistoryRow& r : *rows) {
    if (r.score) dots.points += {static_cast<double>(r.attempt), *r.score, QString::fromStdString(r.student_name), false};
  }
  return dots;
}

}  // namespace

Performance::Performance(Store& store, const Actor& reader, const Ports& ports, std::filesystem::path volumes, QWidget* parent)
    : QWidget(parent), store_(store), reader_(reader), ports_(ports), volumes_(std::move(volumes)),
      model_(new AttemptsModel(this)), sorted_(new Sorted(this)) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* body = nullptr;
  outer->addWidget(make_scroll_page(&body));
  body->setSpacing(px(12));
  auto* head = new PageHead(tr("Performance"));
  QPushButton* csv = make_button(tr("Export CSV"), ButtonKind::standard, u"export"_qs, QKeySequence::Save);
  csv->setEnabled(may(reader.role, Action::export_results));
  head->buttons()->addWidget(csv);
  connect(csv, &QPushButton::clicked, this, &Performance::export_csv);
  QPushButton* pack = make_button(tr("Open an appeal pack"), ButtonKind::standard, u"import"_qs);
  head->buttons()->addWidget(pack);
  connect(pack, &QPushButton::clicked, this, &Performance::choose_pack);
  body->addWidget(head);
  body->addWidget(make_filters());
  without_scripted_ = make_label(tr("Attempts of scripted operators are left out. The filter “%1” shows them alone.").arg(tr("Scripted")),
                                 TextRole::caption, Weight::regular, "text2");
  without_scripted_->setWordWrap(true);
  body->addWidget(without_scripted_);
  band_ = new Band;
  body->addWidget(band_);
  QWidget* attempts = make_table();
  unread_ = make_unread_band(table_, [this] { model_->failed() ? model_->fetch_again() : read(); });  // else the first page failed
  body->addWidget(unread_);
  body->addWidget(make_progress());
  body->addWidget(make_figures());
  body->addLayout(make_charts());
  criteria_ = new CriteriaCard;
  body->addWidget(criteria_);
  body->addWidget(attempts, 1);
  fill_filters();
  read();
  setFocusProxy(search_);
}

QBoxLayout* Performance::make_charts() {
  charts_ = new QBoxLayout(QBoxLayout::LeftToRight);
  charts_->setSpacing(px(12));
  spread_ = new Chart;
  learning_ = new Chart;
  for (auto [chart, title, aside] : {std::tuple{spread_, tr("How scores spread"), tr("attempts, five points a bar")},
                                     std::tuple{learning_, tr("Learning"), tr("points by attempt")}}) {
    auto* card = new Card(title, aside);
    card->setFixedHeight(px(236));
    card->body()->addWidget(chart);
    charts_->addWidget(card, 1);
    if (chart != learning_) continue;
    learning_card_ = card;
    no_learning_ = make_paragraph({});
    no_learning_->hide();
    card->body()->addWidget(no_learning_, 1);
  }
  return charts_;
}

QWidget* Performance::make_table() {
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  table_ = new Table;
  table_->setAccessibleName(tr("Attempts"));
  sorted_->setSourceModel(model_);
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(AttemptsModel::kDate, Qt::DescendingOrder);
  connect(table_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, &Performance::fetch_for_order);
  table_->set_stretch_column(AttemptsModel::kExercise);
  table_->setMinimumHeight(px(280));
  below_ = new QStackedWidget;
  below_->addWidget(table_);
  auto* none = new EmptyState(u"chart"_qs, tr("No attempt fits"), tr("Nobody has an attempt that fits these filters, or none is finished yet."),
                              tr("Show all attempts"));
  connect(none, &EmptyState::acted, this, [this] {
    for (QComboBox* box : choices()) box->setCurrentIndex(0);
    search_->clear();
  });
  below_->addWidget(none);
  card->body()->addWidget(below_);
  const auto open = [this](const QModelIndex& at) {
    Q_EMIT report_wanted(model_->row(sorted_->mapToSource(at).row()).session);
  };
  connect(table_, &Table::row_opened, this, open);
  connect(table_, &QTableView::clicked, this, [open](const QModelIndex& at) {
    if (at.column() == AttemptsModel::kOpen) open(at);
  });
  return card;
}

QWidget* Performance::make_figures() {
  auto* bar = new QWidget;
  figures_ = new QGridLayout(bar);
  figures_->setContentsMargins(0, 0, 0, 0);
  figures_->setSpacing(px(12));
  const QString names[] = {tr("Attempts counted"), tr("Median score"), tr("Passed"), tr("Median time")};
  for (int i = 0; i < kFigures; ++i) {
    auto* card = new Card;
    card->setAccessibleName(names[i]);
    card->body()->setContentsMargins(px(16), px(8), px(16), px(8));
    card->body()->setSpacing(0);
    card->body()->addWidget(make_label(names[i], TextRole::caption, Weight::regular, "text2"));
    auto* line = new QHBoxLayout;
    line->setSpacing(px(8));
    figure_[i] = make_label({}, TextRole::page_title, Weight::bold);
    note_[i] = make_label({}, TextRole::caption, Weight::regular, "text2");
    line->addWidget(figure_[i]);
    line->addWidget(note_[i], 1, Qt::AlignBottom);
    card->body()->addLayout(line);
    figures_->addWidget(card, 0, i);
  }
  return bar;
}

void Performance::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

std::optional<HistoryPage> Performance::page(const HistoryFilter& filter, const std::optional<HistoryKey>& after) {
  auto page = store_.history.page(reader_, filter, after, kAttemptsAtOnce);
  if (page) return std::move(*page);
  unread_->show_message(Band::Kind::bad,
                        after ? tr("Older attempts are not shown: they could not be read.") : tr("The attempts could not be read."),
                        describe(page.error()).line());
  return std::nullopt;
}

void Performance::read() {
  band_->clear();  // it speaks of the filters before
  unread_->clear();
  const HistoryFilter shown = filter();
  without_scripted_->setVisible(any_scripted_ && shown.scripted == false);
  auto first = page(shown, std::nullopt);
  if (!first) {
    model_->set_rows({});
    below_->setCurrentIndex(0);  // that no attempt fits is not known
    return show_no_figures();
  }
  model_->set_pages(std::move(*first), [this, shown](const HistoryKey& after) { return page(shown, after); });
  below_->setCurrentIndex(model_->rowCount() == 0 ? 1 : 0);
  fetch_for_order(table_->horizontalHeader()->sortIndicatorSection(), table_->horizontalHeader()->sortIndicatorOrder());
  table_->choose_row(0);
  const auto figures = store_.history.figures(reader_, shown);
  if (!figures) {
    show_failure(figures.error());
    return show_no_figures();
  }
  for (Chart* chart : {spread_, learning_}) chart->parentWidget()->show();
  show_numbers(*figures);
  show_spread(*figures);
  show_learning(*figures);
  criteria_->setVisible(shown.scenario.has_value());
  if (!shown.scenario) return;
  const auto by_criterion = store_.history.by_criterion(reader_, shown);
  if (!by_criterion) {
    criteria_->hide();
    return show_failure(by_criterion.error());
  }
  const std::optional<Exercise> exercise = exercise_of(shown);
  if (!exercise) return criteria_->show_figures(*by_criterion, {}, {});
  const Scenario& scenario = exercise->scenario;
  const auto folder = exercise_folder(store_, *exercise, volumes_);
  criteria_->show_figures(*by_criterion, scenario.target, folder ? tissue_names_in(*folder, scenario) : TissueNames());
}

std::optional<Exercise> Performance::exercise_of(const HistoryFilter& shown) {
  const auto versions = store_.scenarios.versions(*shown.scenario);
  if (!versions) return std::nullopt;
  for (const ScenarioVersion& v : *versions | std::views::reverse) {
    if (shown.version_number && v.number != *shown.version_number) continue;
    if (auto exercise = load_exercise(store_, v.id)) return std::move(*exercise);
  }
  return std::nullopt;
}

void Performance::fetch_for_order(int column, Qt::SortOrder order) {
  if (column == AttemptsModel::kDate && order == Qt::DescendingOrder) return;
  while (model_->canFetchMore() && model_->rowCount() < kMostSorted) model_->fetchMore();
  if (model_->failed()) return table_->sortByColumn(AttemptsModel::kDate, Qt::DescendingOrder);  // what is missing may stand first
  if (!model_->canFetchMore()) return;
  band_->show_message(Band::Kind::look, tr("Too many attempts for another order than the newest first."),
                      tr("Up to %1 can be sorted: choose an exercise, a student or a period.").arg(format_number(kMostSorted, 0)));
  table_->sortByColumn(AttemptsModel::kDate, Qt::DescendingOrder);
}

/// In place of those of the filters before.
void Performance::show_no_figures() {
  for (QLabel* figure : figure_) figure->setText(QStringLiteral("–"));
  for (QLabel* note : note_) note->clear();
  for (Chart* chart : {spread_, learning_}) chart->parentWidget()->hide();
  criteria_->hide();
}

void Performance::show_numbers(const Figures& f) {
  const QString none = QStringLiteral("–");
  figure_[0]->setText(format_number(f.attempts, 0));
  const bool students_alone = filter().drilled_by == DrilledBy::students;
  note_[0]->setText(students_alone ? tr("%n student(s)", nullptr, f.students) : tr("%n person(s)", nullptr, f.students));
  figure_[1]->setText(f.median_score ? format_points(*f.median_score) : none);
  note_[1]->setText(f.attempts < 4 ? QString()
                               : tr("half lie in %1 to %2").arg(format_points(f.middle_half.low), format_points(f.middle_half.high)));
  figure_[2]->setText(f.attempts > 0 ? format_share(f.passed, f.attempts) : none);
  note_[2]->setText(f.passed_95 ? tr("95 % interval %1 to %2")
                                      .arg(format_number(100 * f.passed_95->low, 0), format({100 * f.passed_95->high, std::nullopt, u"%"_qs, 0}))
                                : QString());
  figure_[3]->setText(f.median_time_s ? duration_text(*f.median_time_s) : none);
}

void Performance::show_spread(const Figures& f) {
  ChartData spread;
  spread.title = tr("How scores spread");
  constexpr auto kBelow = static_cast<std::size_t>(kFrom / kSpreadPoints);
  const std::span<const int> all(f.spread);
  const bool poor = f.pass_mark.value_or(kFrom) < kFrom || std::ranges::any_of(all.first(kBelow), [](int attempts) { return attempts > 0; });
  const double least = poor ? 0 : kFrom;
  const std::span<const int> bars = poor ? all : all.subspan(kBelow);
  const int highest = std::max(4, *std::ranges::max_element(bars));
  const double step = std::max(1.0, std::ceil(highest / 4.0));
  spread.x = {tr("points"), least, 100, poor ? 2 * kSpreadPoints : kSpreadPoints, 0};
  constexpr double kForMark = 0.3;  // steps above the highest bar: the mark's text stands there
  spread.y = {tr("attempts"), 0, step * std::ceil(highest / step + kForMark), step, 0};
  spread.value_text = [](double attempts) { return tr("%n attempt(s)", nullptr, static_cast<int>(attempts)); };
  ChartSeries counted;
  counted.name = tr("Attempts");
  counted.draw = ChartSeries::Draw::bars;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double from = least + kSpreadPoints * static_cast<double>(i);
    counted.points += {from, static_cast<double>(bars[i]),
                       i == 0 ? tr("below %1").arg(format_number(from + kSpreadPoints, 0))
                              : tr("%1 to %2").arg(format_number(from, 0), format_number(from + kSpreadPoints, 0)),
                       false};
  }
  spread.series += counted;
  spread.mark = f.pass_mark;
  if (spread.mark) spread.mark_text = tr("pass %1").arg(format_points(*spread.mark));
  spread.summary = tr("%n attempt(s).", nullptr, f.attempts);
  spread_->set_data(spread);
}

void Performance::show_no_learning(const QString& why) {
  learning_->hide();
  no_learning_->setText(why);
  no_learning_->show();
}

void Performance::show_learning(const Figures& f) {
  if (f.attempts == 0) return show_no_learning(tr("No attempt has points yet."));
  no_learning_->hide();
  learning_->show();
  ChartData learning;
  learning.title = tr("Learning");
  // Later attempts are often those at harder exercises.
  const bool together = !filter().scenario && exercise_->count() > 2;
  learning_card_->set_aside(together ? tr("points by attempt, all exercises together") : tr("points by attempt"));
  // Numbers that fewer than three students have reached have no median.
  const int last_attempt = std::max(4, f.learning.empty() ? f.last_attempt : f.learning.back().attempt);
  learning.x = {tr("attempt"), 1, static_cast<double>(last_attempt), std::max(1.0, std::ceil(last_attempt / 10.0)), 0};
  learning.y = {tr("points"), 0, 100, 20, 0};
  learning.value_text = points_text;
  if (f.learning.empty()) {
    // Too few students for a median: each attempt is one dot.
    auto dots = dots_of(store_, reader_, filter());
    if (!dots) return show_no_learning(tr("The attempts of this chart could not be read.") + u' ' + describe(dots.error()).line());
    dots->name = tr("Attempts");
    learning.series += std::move(*dots);
    learning.summary = tr("Each dot is one attempt: medians need three students.");
  } else {
    ChartSeries low, high, median;
    median.name = tr("Median");
    low.name = high.name = tr("Middle half");
    low.quiet = high.quiet = true;
    low.draw = high.draw = median.draw = ChartSeries::Draw::line;
    for (const LearningPoint& p : f.learning) {
      low.points += {static_cast<double>(p.attempt), p.middle_half.low, tr("Lower end of the middle half"), false};
      high.points += {static_cast<double>(p.attempt), p.middle_half.high, tr("Upper end of the middle half"), false};
      median.points += {static_cast<double>(p.attempt), p.median, tr("Median of %n student(s)", nullptr, p.students), false};
    }
    low.name.clear();
    learning.series << high << low << median;
    learning.summary = tr("Median over %n attempt(s).", nullptr, static_cast<int>(f.learning.size()));
  }
  learning.mark = f.pass_mark;
  if (learning.mark) learning.mark_text = tr("pass %1").arg(format_points(*learning.mark));
  learning_->set_data(learning);
}

void Performance::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool narrow = width() < px(kNarrowBelow);
  charts_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  for (int i = 0; i < kFigures; ++i) {
    figures_->addWidget(figure_[i]->parentWidget(), narrow ? i / 2 : 0, narrow ? i % 2 : i);
    figures_->setColumnStretch(i, narrow && i >= 2 ? 0 : 1);
  }
}

}  // namespace cusp::ui
