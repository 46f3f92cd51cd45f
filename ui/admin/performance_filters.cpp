// The filters of the performance page.

#include <QComboBox>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/admin/performance.h"
#include "ui/student/course.h"
#include "ui/text/names.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/head_row.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kScripted = -1;  // "drilled by", beside the values of DrilledBy
constexpr std::string_view kScriptDevice = "scripted";  // device class of a script

using Entries = std::vector<std::pair<QString, QString>>;  // name and id

/// Chooses the entry with `data`, else the first one, without a signal.
void choose(QComboBox* box, const QVariant& data) {
  const QSignalBlocker quiet(box);
  box->setCurrentIndex(data.isValid() ? std::max(0, box->findData(data)) : 0);
}

/// `all` and the entries, in place of those that a choice had. Returns whether it still holds what is chosen in it.
bool offer(QComboBox* box, const QString& all, const Entries& entries) {
  const QVariant chosen = box->currentData();
  {
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItem(all);
    for (const auto& [name, id] : entries) box->addItem(name, id);
  }
  choose(box, chosen);
  return box->currentData() == chosen;
}

}  // namespace

QWidget* Performance::make_filters() {
  auto* bar = new QWidget;
  auto* row = new HeadRow(bar);  // the search stands alone where the window is narrow
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  search_ = make_search_field(tr("Find a student"), px(200));
  row->addWidget(search_);
  exercise_ = make_choice(tr("Exercise"));
  version_ = make_choice(tr("Version"));
  cohort_ = make_choice(tr("Cohort"));
  who_ = make_choice(tr("Drilled by"));
  who_->addItem(tr("Everybody"));
  who_->addItem(tr("Students"), static_cast<int>(DrilledBy::students));
  who_->addItem(tr("Staff"), static_cast<int>(DrilledBy::staff));
  who_->addItem(tr("Scripted"), kScripted);
  kind_ = make_choice(tr("Kind"));
  kind_->addItem(tr("All kinds"));
  kind_->addItem(tr("Practice"), static_cast<int>(SessionKind::practice));
  kind_->addItem(tr("Assessments"), static_cast<int>(SessionKind::assessment));
  result_ = make_choice(tr("Result"));
  device_ = make_choice(tr("Device"));
  period_ = make_choice(tr("From"));
  result_->addItem(tr("All results"));
  result_->addItem(tr("Passed"), true);
  result_->addItem(tr("Not passed"), false);
  period_->addItem(tr("All dates"));
  for (const int days : {1, 7, 30, 365}) period_->addItem(tr("Last %n day(s)", nullptr, days), days);
  for (QComboBox* box : choices()) row->addWidget(box);
  return bar;
}

void Performance::fill_filters() {
  static_cast<void>(offer_choices());  // read() names a failure of the records
  connect(exercise_, &QComboBox::currentIndexChanged, this, &Performance::fill_versions);
  for (QComboBox* box : choices()) connect(box, &QComboBox::currentIndexChanged, this, &Performance::read);
  connect(search_, &QLineEdit::textChanged, this, &Performance::read);
}

bool Performance::offer_choices() {
  auto scenarios = store_.history.scenarios(reader_);
  const auto devices = store_.history.device_classes(reader_);
  auto cohorts = store_.cohorts.list();
  const auto scripted = store_.history.page(reader_, {.scripted = true}, std::nullopt, 1);
  Entries exercises, classes, groups;
  if (scenarios) {
    std::ranges::sort(*scenarios, stands_before, [](const PractisedScenario& s) { return local(s.title).toStdString(); });
    for (const PractisedScenario& s : *scenarios) exercises.emplace_back(local(s.title), QString::fromStdString(s.scenario.text()));
  }
  if (devices) {
    for (const std::string& device : *devices) classes.emplace_back(device_name(device), QString::fromStdString(device));
  }
  if (cohorts) {
    std::ranges::sort(*cohorts, stands_before, &Cohort::name);
    for (const Cohort& cohort : *cohorts) groups.emplace_back(QString::fromStdString(cohort.name), QString::fromStdString(cohort.id.text()));
  }
  const QVariant version = version_->currentData();
  const bool same_exercise = offer(exercise_, tr("All exercises"), exercises);
  offer(device_, tr("All devices"), classes);
  offer(cohort_, tr("All cohorts"), groups);
  fill_versions();
  if (same_exercise) choose(version_, version);
  any_scripted_ = scripted && !scripted->rows.empty();
  return scenarios && devices && cohorts && scripted;
}

void Performance::fill_versions() {
  const QSignalBlocker quiet(version_);
  version_->clear();
  version_->addItem(tr("All versions"));
  const auto scenario = ScenarioId::parse(exercise_->currentData().toString().toStdString());
  version_->setVisible(scenario.has_value());
  if (!scenario) return;
  const auto versions = store_.scenarios.versions(*scenario);
  for (const ScenarioVersion& v : versions ? *versions : std::vector<ScenarioVersion>{}) version_->addItem(tr("Version %1").arg(v.number), v.number);
}

HistoryFilter Performance::filter() const {
  HistoryFilter f;
  if (const QVariant number = version_->currentData(); number.isValid()) f.version_number = number.toInt();
  if (const QString id = cohort_->currentData().toString(); !id.isEmpty()) f.cohort = CohortId::parse(id.toStdString());
  const QVariant who = who_->currentData();
  if (who.isValid() && who.toInt() != kScripted) f.drilled_by = static_cast<DrilledBy>(who.toInt());
  if (const QVariant kind = kind_->currentData(); kind.isValid()) f.kind = static_cast<SessionKind>(kind.toInt());
  if (const QString id = exercise_->currentData().toString(); !id.isEmpty()) f.scenario = ScenarioId::parse(id.toStdString());
  if (const QVariant passed = result_->currentData(); passed.isValid()) f.passed = passed.toBool();
  if (const QString device = device_->currentData().toString(); !device.isEmpty()) f.device_class = device.toStdString();
  const bool device_is_a_script = !who.isValid() && f.device_class == kScriptDevice;
  if (!device_is_a_script) f.scripted = who.isValid() && who.toInt() == kScripted;
  if (const QVariant days = period_->currentData(); days.isValid()) {
    f.from_utc_us = ports_.now().addDays(-days.toInt()).toMSecsSinceEpoch() * 1000;
  }
  f.search = search_->text().trimmed().toStdString();
  return f;
}

bool Performance::read_again() {
  if (!offer_choices()) return false;
  const int row = table_->chosen_row(), fetched = model_->rowCount();
  const SessionId kept = row < 0 ? SessionId{} : model_->row(sorted_->mapToSource(sorted_->index(row, 0)).row()).session;
  read();
  while (model_->canFetchMore() && model_->rowCount() < fetched) model_->fetchMore();
  const auto at = std::ranges::find(model_->rows(), kept, &HistoryRow::session);
  const int found = static_cast<int>(at - model_->rows().begin());
  if (at != model_->rows().end()) table_->choose_row(sorted_->mapFromSource(model_->index(found, 0)).row());
  table_->setFocus(Qt::OtherFocusReason);
  return true;
}

}  // namespace cusp::ui
