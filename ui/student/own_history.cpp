#include "ui/student/own_history.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/student/history_charts.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

/// Of the student's own hand. `rows`: newest first.
std::optional<HistoryRow> newest_result(const std::vector<HistoryRow>& rows) {
  const auto found = std::ranges::find_if(rows, [](const HistoryRow& row) { return row.score && row.operator_name == kUserOperator; });
  return found == rows.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

OwnHistory::OwnHistory(Store& store, const Actor& student, QWidget* parent)
    : QWidget(parent), store_(store), student_(student) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(16));
  head_ = new PageHead(tr("My results"));
  outer->addWidget(head_);
  fill();
}

void OwnHistory::fill() {
  const auto scenarios = store_.history.scenarios(student_, student_.id);
  if (!scenarios) {
    const Message message = describe(scenarios.error());
    auto* unread = new EmptyState(u"warning"_qs, message.what, message.more, tr("Try again"), Ink::bad);
    connect(unread, &EmptyState::acted, this, [this] {
      fill();
      (table_ != nullptr ? static_cast<QWidget*>(table_) : instead_->button())->setFocus(Qt::OtherFocusReason);
    });
    return show_instead(unread);
  }
  if (scenarios->empty()) {
    auto* empty = new EmptyState(u"chart"_qs, tr("No attempt yet"), tr("Each attempt you finish stays here, with its report."),
                                 tr("Choose an exercise"));
    connect(empty, &EmptyState::acted, this, &OwnHistory::exercises_wanted);
    return show_instead(empty);
  }
  show_instead(nullptr);
  auto* outer = static_cast<QVBoxLayout*>(layout());
  make_choice(*scenarios);
  head_->buttons()->addWidget(exercise_);
  make_table();
  unread_ = make_unread_band(table_, [this] { read_unread(); });
  outer->addWidget(unread_);
  charted_ = make_label({}, TextRole::body, Weight::bold);
  charted_->setWordWrap(true);
  outer->addWidget(charted_);
  outer->addLayout(make_charts());
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  card->body()->addWidget(table_);
  outer->addWidget(card, 1);
  show_attempts();
  setFocusProxy(table_);
}

/// In place of the one before, whose button may have called. nullptr: of none.
void OwnHistory::show_instead(EmptyState* state) {
  if (instead_ != nullptr) {
    instead_->hide();
    layout()->removeWidget(instead_);
    instead_->deleteLater();
  }
  instead_ = state;
  if (state != nullptr) static_cast<QVBoxLayout*>(layout())->addWidget(state, 1);
}

void OwnHistory::make_choice(std::vector<PractisedScenario> scenarios) {
  exercise_ = new QComboBox;
  exercise_->setAccessibleName(tr("Exercise"));
  exercise_->setMinimumWidth(px(240));
  exercise_->setMaximumWidth(px(420));  // a longer name is cut in the closed list
  exercise_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  offer(std::move(scenarios));
  connect(exercise_, &QComboBox::currentIndexChanged, this, &OwnHistory::show_attempts);
}

/// In place of those that the choice had, without a signal. What is chosen stays, or becomes all exercises.
void OwnHistory::offer(std::vector<PractisedScenario> scenarios) {
  std::ranges::sort(scenarios, stands_before, [](const PractisedScenario& s) { return local(s.title).toStdString(); });
  const QVariant chosen = exercise_->currentData();
  const QSignalBlocker quiet(exercise_);
  exercise_->clear();
  exercise_->addItem(tr("All exercises"));
  for (const PractisedScenario& s : scenarios) exercise_->addItem(local(s.title), QString::fromStdString(s.scenario.text()));
  exercise_->setCurrentIndex(chosen.isValid() ? std::max(0, exercise_->findData(chosen)) : 0);
}

QBoxLayout* OwnHistory::make_charts() {
  auto* charts = new QHBoxLayout;
  charts->setSpacing(px(16));
  by_attempt_ = new Chart;
  by_time_ = new Chart;
  by_rating_ = new Chart;
  for (auto [chart, title] : {std::pair{by_attempt_, tr("Points by attempt")}, std::pair{by_time_, tr("Time and score")},
                              std::pair{by_rating_, tr("Own assessment less measured")}}) {
    auto* card = new Card(title);
    card->body()->addWidget(chart);
    card->setFixedHeight(px(250));
    charts->addWidget(card, 1);
    connect(chart, &Chart::point_opened, this, [this, &sessions = chart == by_rating_ ? rated_ : drawn_](int, int point) {
      Q_EMIT report_wanted(sessions[static_cast<std::size_t>(point)]);
    });
  }
  by_rating_->parentWidget()->hide();
  return charts;
}

void OwnHistory::make_table() {
  table_ = new Table;
  table_->setAccessibleName(tr("My results"));
  model_ = new AttemptsModel(this);
  table_->setModel(model_);
  table_->setColumnHidden(AttemptsModel::kStudent, true);
  table_->set_stretch_column(AttemptsModel::kExercise);
  const auto open = [this](const QModelIndex& at) { Q_EMIT report_wanted(model_->row(at.row()).session); };
  connect(table_, &Table::row_opened, this, open);
  connect(table_, &QTableView::clicked, this, [open](const QModelIndex& at) {
    if (at.column() == AttemptsModel::kOpen) open(at);
  });
}

HistoryFilter OwnHistory::filter() const {
  HistoryFilter own;
  own.student = student_.id;
  if (const QString id = exercise_->currentData().toString(); !id.isEmpty()) own.scenario = ScenarioId::parse(id.toStdString());
  return own;
}

void OwnHistory::show_attempts() {
  const auto page_after = [this, own = filter()](const HistoryKey& after) -> std::optional<HistoryPage> {
    auto page = store_.history.page(student_, own, after, kAttemptsAtOnce);
    if (page) return std::move(*page);
    show_unread(tr("Older attempts are not shown: they could not be read."), page.error());
    return std::nullopt;
  };
  unread_->clear();
  auto first = store_.history.page(student_, filter(), std::nullopt, kAttemptsAtOnce);
  if (!first) {
    // Charts and rows of another exercise would stand under this one's name.
    hide_charts();
    model_->set_rows({});
    return show_unread(tr("Your attempts could not be read."), first.error());
  }
  const auto newest = newest_in(*first);
  const auto drawn = newest ? draw(*newest) : Stored<void>(std::unexpected(newest.error()));
  if (!drawn) {
    hide_charts();
    show_unread(tr("The charts are not shown: their attempts could not be read."), drawn.error());
  }
  model_->set_pages(std::move(*first), page_after);
  table_->choose_row(0);
}

/// On a later page only if the first has none.
Stored<std::optional<HistoryRow>> OwnHistory::newest_in(const HistoryPage& first) {
  const auto newest = newest_result(first.rows);
  if (newest || !first.after) return newest;
  const auto all = store_.history.list(student_, filter());
  if (!all) return std::unexpected(all.error());
  return newest_result(*all);
}

void OwnHistory::hide_charts() {
  for (Chart* chart : {by_attempt_, by_time_, by_rating_}) chart->parentWidget()->hide();
  charted_->clear();
}

void OwnHistory::show_unread(const QString& what, const StorageFailure& why) {
  unread_->show_message(Band::Kind::bad, what, describe(why).line());
}

void OwnHistory::read_unread() {
  if (model_->failed()) model_->fetch_again();
  if (!model_->failed() && charted_->text().isEmpty()) show_attempts();
}

bool OwnHistory::read_again() {
  auto scenarios = store_.history.scenarios(student_, student_.id);
  if (exercise_ == nullptr || !scenarios || scenarios->empty()) return false;
  offer(std::move(*scenarios));
  const int row = table_->chosen_row(), fetched = model_->rowCount();
  const SessionId kept = row < 0 ? SessionId{} : model_->row(row).session;
  show_attempts();
  while (model_->canFetchMore() && model_->rowCount() < fetched) model_->fetchMore();
  const auto at = std::ranges::find(model_->rows(), kept, &HistoryRow::session);
  if (at != model_->rows().end()) table_->choose_row(static_cast<int>(at - model_->rows().begin()));
  table_->setFocus(Qt::OtherFocusReason);
  return true;
}

/// A chart shows one exercise and one device class: those of the newest row with points. Without one there is none. What scripted
/// operators drilled in the student's name stands in the table alone, as on the start page.
Stored<void> OwnHistory::draw(const std::optional<HistoryRow>& newest) {
  if (!newest) {
    hide_charts();
    charted_->setText(tr("No result yet, so there is nothing to draw."));
    return {};
  }
  HistoryFilter same = filter();
  same.scenario = newest->scenario;
  same.device_class = newest->device_class;
  same.scripted = false;
  const auto drawn = store_.history.list(student_, same);
  if (!drawn) return std::unexpected(drawn.error());
  const auto rated = store_.history.rated_attempts(student_, student_.id, newest->scenario, newest->device_class);
  if (!rated) return std::unexpected(rated.error());
  const QString device = device_name(newest->device_class);
  charted_->setText(exercise_->currentData().toString().isEmpty() ? tr("%1, %2", "exercise, device").arg(local(newest->title), device) : device);
  drawn_ = sessions_drawn(*drawn);
  rated_ = sessions_drawn(*rated);
  by_attempt_->set_data(score_by_attempt(*drawn));
  by_time_->set_data(time_and_score(*drawn));
  by_rating_->set_data(own_against_measured(*rated));
  for (Chart* chart : {by_attempt_, by_time_}) chart->parentWidget()->show();
  by_rating_->parentWidget()->setVisible(!rated->empty());
  return {};
}

}  // namespace cusp::ui
