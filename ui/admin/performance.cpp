#include "ui/admin/performance.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "storage/export/csv.h"
#include "ui/admin/figures.h"
#include "ui/modules.h"
#include "ui/student/course.h"
#include "ui/text/language.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kStackBelow = 1000;       // px at 100 %, of the page
constexpr double kBar = 5, kFrom = 40;  // points: width of a bar; least value of the axis unless somebody has fewer

/// Sorts by SortRole: numbers by value, names by the language.
class Sorted : public QSortFilterProxyModel {
 public:
  explicit Sorted(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortRole(SortRole);
    setSortLocaleAware(true);
    setSortCaseSensitivity(Qt::CaseInsensitive);
  }
};

QComboBox* make_choice(const QString& name) {
  auto* box = new QComboBox;
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  box->setMinimumWidth(px(110));
  return box;
}

}  // namespace

Performance::Performance(Store& store, const Actor& reader, const Ports& ports, QWidget* parent)
    : QWidget(parent), store_(store), reader_(reader), ports_(ports), model_(new AttemptsModel(this)), sorted_(new Sorted(this)) {
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
  body->addWidget(head);
  body->addWidget(make_filters());
  band_ = new Band;
  body->addWidget(band_);
  body->addWidget(make_figures());
  body->addLayout(make_charts());
  body->addWidget(make_table(), 1);
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
  table_->set_stretch_column(AttemptsModel::kExercise);
  table_->setMinimumHeight(px(280));
  below_ = new QStackedWidget;
  below_->addWidget(table_);
  auto* none = new EmptyState(u"chart"_qs, tr("No attempt fits"), tr("Nobody has an attempt that fits these filters, or none is finished yet."),
                              tr("Show all attempts"));
  connect(none, &EmptyState::acted, this, [this] {
    for (QComboBox* box : {exercise_, result_, device_, period_}) box->setCurrentIndex(0);
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

QWidget* Performance::make_filters() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  exercise_ = make_choice(tr("Exercise"));
  result_ = make_choice(tr("Result"));
  device_ = make_choice(tr("Device"));
  period_ = make_choice(tr("From"));
  result_->addItem(tr("All results"));
  result_->addItem(tr("Passed"), true);
  result_->addItem(tr("Not passed"), false);
  period_->addItem(tr("All dates"));
  for (const int days : {1, 7, 30, 365}) period_->addItem(tr("Last %n day(s)", nullptr, days), days);
  for (QComboBox* box : {exercise_, result_, device_, period_}) row->addWidget(box);
  row->addStretch();
  search_ = make_search_field(tr("Find a student"), px(200));
  row->addWidget(search_);
  return bar;
}

void Performance::fill_filters() {
  exercise_->addItem(tr("All exercises"));
  device_->addItem(tr("All devices"));
  const auto rows = store_.history.list(reader_);
  if (rows) {
    std::set<ScenarioId> exercises;
    std::set<std::string> devices;
    for (const HistoryRow& r : *rows) {
      if (exercises.insert(r.scenario).second) exercise_->addItem(local(r.title), QString::fromStdString(r.scenario.text()));
      if (devices.insert(r.device_class).second) {
        device_->addItem(device_name(r.device_class), QString::fromStdString(r.device_class));
      }
    }
  }
  for (QComboBox* box : {exercise_, result_, device_, period_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &Performance::read);
  }
  connect(search_, &QLineEdit::textChanged, this, &Performance::read);
}

HistoryFilter Performance::filter() const {
  HistoryFilter f;
  if (const QString id = exercise_->currentData().toString(); !id.isEmpty()) f.scenario = ScenarioId::parse(id.toStdString());
  if (const QVariant passed = result_->currentData(); passed.isValid()) f.passed = passed.toBool();
  if (const QString device = device_->currentData().toString(); !device.isEmpty()) f.device_class = device.toStdString();
  if (const QVariant days = period_->currentData(); days.isValid()) {
    f.from_utc_us = ports_.now().addDays(-days.toInt()).toMSecsSinceEpoch() * 1000;
  }
  f.search = search_->text().trimmed().toStdString();
  return f;
}

QWidget* Performance::make_figures() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(12));
  const QString names[] = {tr("Attempts counted"), tr("Median score"), tr("Passed"), tr("Median time")};
  for (int i = 0; i < 4; ++i) {
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
    row->addWidget(card, 1);
  }
  return bar;
}

void Performance::read() {
  auto rows = store_.history.list(reader_, filter());
  if (!rows) {
    const Message message = describe(rows.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  model_->set_rows(std::move(*rows));
  below_->setCurrentIndex(model_->rowCount() == 0 ? 1 : 0);
  table_->choose_row(0);
  show_figures();
}

void Performance::show_figures() {
  const Figures f = figures_of(model_->rows());
  show_numbers(f);
  show_spread(f);
  show_learning();
}

void Performance::show_numbers(const Figures& f) {
  const QString none = QStringLiteral("–");
  figure_[0]->setText(format_number(f.attempts, 0));
  note_[0]->setText(tr("%n student(s)", nullptr, f.students));
  figure_[1]->setText(f.median_score ? format_points(std::round(*f.median_score)) : none);
  note_[1]->setText(f.attempts < 4 ? QString()
                               : tr("half lie in %1 to %2").arg(format_points(std::round(f.middle_half.low)),
                                                                format_points(std::round(f.middle_half.high))));
  figure_[2]->setText(f.attempts > 0 ? format({100.0 * f.passed / f.attempts, std::nullopt, u"%"_qs, 0}) : none);
  note_[2]->setText(f.passed_95 ? tr("95 % interval %1 to %2")
                                      .arg(format_number(100 * f.passed_95->low, 0), format_number(100 * f.passed_95->high, 0))
                                : QString());
  figure_[3]->setText(f.median_time_s ? format_clock(*f.median_time_s) : none);
  note_[3]->setText(f.median_time_s ? tr("minutes and seconds") : QString());
}

std::optional<double> Performance::common_pass_mark() const {
  std::set<double> marks;
  for (const HistoryRow& r : model_->rows()) {
    if (r.pass_mark) marks.insert(*r.pass_mark);
  }
  return marks.size() == 1 ? std::optional(*marks.begin()) : std::nullopt;
}

void Performance::show_spread(const Figures& f) {
  ChartData spread;
  spread.title = tr("How scores spread");
  const bool poor = std::ranges::any_of(model_->rows(), [](const HistoryRow& r) { return r.score && *r.score < kFrom; });
  const double least = poor ? 0 : kFrom;
  const std::vector<int> bars = spread_of(model_->rows(), least, kBar);
  const int highest = std::max(4, *std::max_element(bars.begin(), bars.end()));
  const double step = std::max(1.0, std::ceil(highest / 4.0));
  spread.x = {tr("points"), least, 100, poor ? 2 * kBar : kBar, 0};
  spread.y = {tr("attempts"), 0, step * std::ceil(highest / step), step, 0};
  ChartSeries counted;
  counted.name = tr("Attempts");
  counted.draw = ChartSeries::Draw::bars;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double from = least + kBar * static_cast<double>(i);
    counted.points += {from, static_cast<double>(bars[i]),
                       i == 0 ? tr("below %1").arg(format_number(from + kBar, 0))
                              : tr("%1 to %2").arg(format_number(from, 0), format_number(from + kBar, 0)),
                       false};
  }
  spread.series += counted;
  spread.mark = common_pass_mark();
  if (spread.mark) spread.mark_text = tr("pass %1").arg(format_points(*spread.mark));
  spread.summary = tr("%n attempt(s).", nullptr, f.attempts);
  spread_->set_data(spread);
}

void Performance::show_learning() {
  ChartData learning;
  learning.title = tr("Learning");
  const std::vector<LearningPoint> points = learning_of(model_->rows());
  int last_attempt = 4;
  for (const HistoryRow& r : model_->rows()) last_attempt = std::max(last_attempt, r.attempt);
  learning.x = {tr("attempt"), 1, static_cast<double>(last_attempt), std::max(1.0, std::ceil(last_attempt / 10.0)), 0};
  learning.y = {tr("points"), 0, 100, 20, 0};
  if (points.empty()) {
    // Too few students for a median: each attempt is one dot.
    ChartSeries dots;
    dots.name = tr("Attempts");
    dots.draw = ChartSeries::Draw::dots;
    for (const HistoryRow& r : model_->rows()) {
      if (r.score) dots.points += {static_cast<double>(r.attempt), *r.score, QString::fromStdString(r.student_name), false};
    }
    learning.series += dots;
    learning.summary = tr("Each dot is one attempt: medians need three students.");
  } else {
    ChartSeries low, high, median;
    median.name = tr("Median");
    low.name = high.name = tr("Middle half");
    low.quiet = high.quiet = true;
    low.draw = high.draw = median.draw = ChartSeries::Draw::line;
    for (const LearningPoint& p : points) {
      low.points += {static_cast<double>(p.attempt), p.middle_half.low, {}, false};
      high.points += {static_cast<double>(p.attempt), p.middle_half.high, {}, false};
      median.points += {static_cast<double>(p.attempt), p.median, tr("%n student(s)", nullptr, p.students), false};
    }
    low.name.clear();
    learning.series << high << low << median;
    learning.summary = tr("Median over %n attempt(s).", nullptr, static_cast<int>(points.size()));
  }
  learning.mark = common_pass_mark();
  if (learning.mark) learning.mark_text = tr("pass %1").arg(format_points(*learning.mark));
  learning_->set_data(learning);
}

void Performance::export_csv() {
  CsvOptions options;
  options.language = current_language().toStdString();
  const auto text = export_history(store_.context(), reader_, filter(), options);
  if (!text) {
    const Message message = describe(text.error());
    band_->show_message(Band::Kind::bad, message.what, message.more);
    return;
  }
  FileWish wish;
  wish.title = tr("Export CSV");
  wish.name = u"cusp-performance-"_qs + ports_.now().toString(u"yyyy-MM-dd"_qs) + u".csv"_qs;
  wish.filter = tr("CSV (*.csv)");
  const int rows = model_->rowCount();
  ports_.pick_file(this, wish, [this, rows, bytes = QByteArray::fromStdString(*text)](const QString& path) {
    // QSaveFile renames at the end: a full disk leaves the old file.
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) {
      band_->show_message(Band::Kind::good, tr("%n attempt(s) exported.", nullptr, rows), path);
    } else {
      band_->show_message(Band::Kind::bad, tr("The file was not written."),
                          tr("%1: %2. What was there before is unchanged.").arg(path, file.errorString()));
    }
  });
}

void Performance::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (charts_) charts_->setDirection(width() < px(kStackBelow) ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}  // namespace cusp::ui
