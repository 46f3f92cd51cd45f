#include "ui/editor/points_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <string_view>

#include "scenarios/format/keys.h"
#include "ui/editor/bands_form.h"
#include "ui/editor/first_bands.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/operator_job.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

bool has_tissue(const Scenario& s, Tissue tissue) {
  return std::ranges::any_of(s.tissues, [tissue](const ScenarioTissue& t) { return t.tissue == tissue; });
}

}  // namespace

PointsForm::PointsForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(6));
  add_section(column, tr("Points"), &sum_);
  column->addLayout(make_measuring());
  list_ = new QVBoxLayout;
  list_->setSpacing(px(6));
  column->addLayout(list_);
  auto* adding = new QHBoxLayout;
  adding->setSpacing(px(6));
  metric_ = new QComboBox;
  metric_->setAccessibleName(tr("Criterion to add"));
  metric_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  add_ = make_button(tr("Add"), ButtonKind::standard, u"plus"_qs);
  add_->setAccessibleName(tr("Add a criterion"));
  adding->addWidget(metric_, 1);
  adding->addWidget(add_);
  column->addLayout(adding);
  connect(add_, &QPushButton::clicked, this, [this] {
    const std::string metric = metric_->currentData().toString().toStdString();
    if (!metric.empty()) model_.add_criterion(metric, first_bands(metric, model_.scenario().target, model_.scenario().specimen.tooth_number()));
  });
  column->addSpacing(px(8));
  column->addWidget(make_rule());
  column->addSpacing(px(8));
  pass_ = new NumberBox(model_, tr("Pass mark, of 100"), {}, 0, 100, 1, 1, [this](double v) { return model_.set_pass(v); });
  pass_->drop_needless_decimals();
  add_row(column, tr("Pass mark, of 100"), pass_);
  pulp_ = new QCheckBox(tr("Opening the pulp fails the attempt"));
  column->addWidget(pulp_);
  connect(pulp_, &QCheckBox::toggled, this, [this](bool on) { model_.set_critical("pulp_exposure", EditorModel::listed(on)); });
  damage_ = new QCheckBox(tr("Damaging a protected part fails the attempt"));
  column->addWidget(damage_);
  connect(damage_, &QCheckBox::toggled, this, [this](bool on) { model_.set_critical("protected_damage", EditorModel::listed(on)); });
  dry_ = new QCheckBox(tr("Overheating the tooth fails the attempt"));
  column->addWidget(dry_);
  connect(dry_, &QCheckBox::toggled, this, [this](bool on) { model_.set_critical("dry_cutting", EditorModel::listed(on)); });
  own_ = new QCheckBox(tr("Own assessment before the result"));
  own_->setToolTip(tr("The student rates each criterion before the result is shown"));
  column->addWidget(own_);
  connect(own_, &QCheckBox::toggled, this, [this](bool on) {
    model_.set_own_assessment(on ? EditorModel::OwnAssessment::asked : EditorModel::OwnAssessment::not_asked);
  });
  QLabel* note = make_label(tr("Bands of depth move with the target’s depth. Those offered for form, box, margin, contact and caries "
                               "are not all verified."),
                             TextRole::caption, Weight::regular, "text2");
  note->setWordWrap(true);
  column->addWidget(note);
  column->addStretch();
  connect(&model_, &EditorModel::changed, this, &PointsForm::follow_model);
  follow_model();
}

/// The scripted operators cut the draft at once, and their values mark the bands.
QBoxLayout* PointsForm::make_measuring() {
  job_ = new OperatorJob(this);
  measure_ = make_button(tr("Measure the operators"), ButtonKind::standard, u"ruler"_qs);
  measure_->setToolTip(tr("Reference, competent and novice cut it at once; their values mark the bands of each criterion"));
  measured_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  measured_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->setSpacing(px(8));
  row->addWidget(measure_);
  row->addWidget(measured_, 1);
  connect(measure_, &QPushButton::clicked, this, &PointsForm::measure);
  connect(job_, &OperatorJob::cut, this, [this](const std::shared_ptr<const SessionResult>& result) {
    model_.now_tried({tried_by(result->operator_name), result->scenario, result->measures});
  });
  connect(job_, &OperatorJob::failed, this, [this](OperatorCutError error) { measured_->setText(describe(error, model_.scenario().tool_tilt_deg).line()); });
  connect(job_, &OperatorJob::done, this, [this] {
    if (measured_->text() == tr("Measuring")) measured_->clear();
    follow_model();
  });
  return row;
}

/// Between neighbouring teeth the operators take minutes: the button stops them.
void PointsForm::measure() {
  if (job_->running()) {
    stop_measuring({});
    return show_measuring();
  }
  measuring_ = model_.scenario();
  job_->start(measuring_, model_.specimen(), {"reference", "competent", "novice"});
  measured_->setText(tr("Measuring"));
  show_measuring();
}

void PointsForm::stop_measuring(const QString& why) {
  job_->cancel();
  measured_->setText(why);
}

/// Values of another tooth, target or bur would mark no band.
void PointsForm::show_measuring() {
  if (job_->running() && !measures_alike(measuring_, model_.scenario())) stop_measuring(tr("Stopped: the exercise was changed."));
  const bool running = job_->running();
  const QString text = running ? tr("Stop measuring") : tr("Measure the operators");
  measure_->setText(u' ' + text);  // as make_button: the style leaves no space after the sign
  measure_->setAccessibleName(text);
  measure_->setEnabled(running || (model_.specimen() != nullptr && model_.playable()));
}

PointsForm::Row PointsForm::make_row(std::size_t index) {
  const std::string metric = model_.scenario().rubric.criteria[index].metric;
  const QString name = metric_name(metric, &model_.scenario().target, model_.tissue_names());
  Row row{};
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  auto* line = new QHBoxLayout;
  line->setSpacing(px(6));
  row.open = make_wrapping_link(name);
  row.open->setAccessibleName(tr("Bands of %1").arg(name));
  row.open->setToolTip(tr("Show what earns the points"));
  line->addWidget(row.open, 1);
  row.weight = new NumberBox(model_, tr("Points for %1").arg(name), {}, 0, 1000, 1, 2,
                             [this, index](double v) { return model_.set_weight(index, v); });
  row.weight->drop_needless_decimals();
  row.weight->setFixedWidth(px(64));
  line->addWidget(row.weight);
  QPushButton* away = make_button({}, ButtonKind::quiet, u"trash"_qs);
  away->setAccessibleName(tr("Remove %1").arg(name));
  away->setToolTip(short_tool_tip(away->accessibleName()));
  away->setFixedWidth(px(32));
  line->addWidget(away);
  column->addLayout(line);
  column->addWidget(row.weight->note());
  connect(away, &QPushButton::clicked, this, [this, index] { model_.remove_criterion(index); });
  row.column = column;
  row.open->setChecked(open_ == metric);
  connect(row.open, &QPushButton::toggled, this, [this, metric, index](bool on) {
    if (on) make_bands(index);
    if (rows_[index].bands) rows_[index].bands->setVisible(on);
    if (on) open_ = metric;
    if (!on && open_ == metric) open_.clear();
  });
  list_->addWidget(box);
  return row;
}

/// Not before somebody opens them: those of ten criteria take half a second.
void PointsForm::make_bands(std::size_t index) {
  Row& row = rows_[index];
  if (row.bands) return;
  row.bands = new BandsForm(model_, index);
  row.column->addWidget(row.bands);
  row.bands->follow_model();
  tab_by_layout(*this);
}

void PointsForm::build_rows() {
  while (QLayoutItem* item = list_->takeAt(0)) {
    if (item->widget()) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  rows_.clear();
  for (std::size_t i = 0; i < model_.scenario().rubric.criteria.size(); ++i) {
    rows_.push_back(make_row(i));
    if (rows_[i].open->isChecked()) make_bands(i);
  }
  tab_by_layout(*this);
}

void PointsForm::follow_model() {
  const Scenario& s = model_.scenario();
  std::vector<std::string> metrics;
  QStringList wanted;
  for (const Criterion& c : s.rubric.criteria) {
    metrics.push_back(c.metric);
    wanted << QString::fromStdString(c.metric) << metric_name(c.metric, &s.target, model_.tissue_names());  // a target may have another title
  }
  if (wanted != built_) build_rows();
  built_ = wanted;
  double sum = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Criterion& c = s.rubric.criteria[i];
    sum += c.weight;
    rows_[i].weight->show_value(c.weight);
    if (rows_[i].bands) rows_[i].bands->follow_model();
    rows_[i].open->setAccessibleDescription(wanted_text(c));
    rows_[i].open->setToolTip(tr("Full points: %1").arg(wanted_text(c)));
  }
  show_measuring();
  sum_->setText(tr("pass %1 of 100, shares of %2").arg(format_points(s.rubric.pass), format_points(sum)));
  pass_->show_value(s.rubric.pass);
  const bool pulp = has_tissue(s, Tissue::pulp);
  const bool heat = has_phenomenon(s.phenomena, "heat");
  const QSignalBlocker quiet(pulp_), quieter(metric_), still(dry_), silent(own_), hushed(damage_);
  const auto fails = [&](std::string_view event) { return std::ranges::find(s.rubric.critical, event) != s.rubric.critical.end(); };
  own_->setChecked(s.self_assessment);
  dry_->setVisible(heat);
  dry_->setChecked(fails("dry_cutting"));
  damage_->setVisible(fails("protected_damage") || std::ranges::any_of(s.protected_parts, [](const Protected& p) { return whole_tissue(p) != Tissue::pulp; }));
  damage_->setChecked(fails("protected_damage"));
  pulp_->setEnabled(pulp);
  pulp_->setChecked(fails("pulp_exposure"));
  const QVariant kept = metric_->currentData();
  metric_->clear();
  const auto offer = [&](const std::string& metric) {
    if (std::ranges::find(metrics, metric) == metrics.end()) {
      metric_->addItem(metric_name(metric, &s.target, model_.tissue_names()), QString::fromStdString(metric));
    }
  };
  for (const MetricKey& known : kMetricKeys) {
    if ((known.key != "remaining_over_pulp" || pulp) && (heat || !needs_heat(known.key))) offer(std::string(known.key));
  }
  for (const ScenarioTissue& t : s.tissues) offer("removed_" + std::string(key_of_scenario_tissue(t.tissue)));
  for (const Region* one : named_targets(s.target))
    for (const MetricKey& known : kMetricKeys)
      if (is_of_cavity(known.key) && (known.key != "remaining_over_pulp" || pulp)) offer(metric_key(known.key, one->name));
  metric_->setCurrentIndex(std::max(metric_->findData(kept), 0));
  add_->setEnabled(metric_->count() > 0);
}

}  // namespace cusp::ui
