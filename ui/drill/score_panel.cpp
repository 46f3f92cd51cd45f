#include "ui/drill/score_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/metrics/several_targets.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/drill/section_view.h"
#include "ui/drill/session_foot.h"
#include "ui/text/grade_text.h"
#include "ui/text/tooth_sides.h"
#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kWidth = 304, kFoldedWidth = 228;  // px at 100 %
constexpr int kLeastBar = 32;                     // gives way to long names

QGridLayout* make_grid() {
  auto* out = new QGridLayout;
  out->setHorizontalSpacing(px(8));
  out->setVerticalSpacing(px(8));
  return out;
}

Bar::Role role_of(Tissue tissue) {
  switch (tissue) {
    case Tissue::enamel: return Bar::Role::enamel;
    case Tissue::dentine:
    case Tissue::cementum: return Bar::Role::dentine;
    case Tissue::carious_dentine:
    case Tissue::carious_enamel: return Bar::Role::carious;
    case Tissue::pulp: return Bar::Role::pulp;
    default: return Bar::Role::plain;
  }
}

/// The colour that a tissue has on the tooth, as a small square.
class Swatch : public QWidget {
 public:
  explicit Swatch(const QColor& colour, QWidget* parent = nullptr) : QWidget(parent), colour_(colour) {
    setFixedSize(px(12), px(12));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(QPen(tokens().border, 1));
    p.setBrush(colour_);
    p.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
  }

 private:
  QColor colour_;
};

QColor on_tooth(Tissue tissue) {
  const Colour c = tissue_colours()[index_of(tissue) % kTissueCodes];
  return QColor::fromRgbF(c.r, c.g, c.b);
}

void set_value(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

/// A name beside a number takes as many lines as it needs.
void wrap_name(const QWidget& fact_row) {
  for (QLabel* label : fact_row.findChildren<QLabel*>())
    if (!label->text().isEmpty()) label->setWordWrap(true);
}

QLabel* make_value() {
  QLabel* out = make_label({}, TextRole::body, Weight::bold);
  out->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return out;
}

}  // namespace

QVBoxLayout* ScorePanel::add_part(const QString& title, QLabel** aside) {
  auto* part = new QFrame(this);
  auto* whole = new QVBoxLayout(part);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  auto* rows = new QVBoxLayout;
  rows->setContentsMargins(px(16), px(11), px(16), px(11));
  rows->setSpacing(px(8));
  whole->addLayout(rows);
  whole->addWidget(make_rule());
  auto* head = new QHBoxLayout;
  head->addWidget(make_label(title, TextRole::section, Weight::bold));
  head->addStretch();
  if (aside != nullptr) {
    *aside = make_label({}, TextRole::caption, Weight::regular, "text2");
    head->addWidget(*aside);
  }
  rows->addLayout(head);
  body_->layout()->addWidget(part);
  return rows;
}

ScorePanel::ScorePanel(QWidget* parent) : QFrame(parent) {
  set_kind(this, "panel_right");
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(1, 0, 0, 0);
  whole->setSpacing(0);
  QVBoxLayout* column = make_scrolled(*whole);

  make_task();
  QVBoxLayout* rows = add_part(tr("Section at the bur"), &section_aside_);
  section_part_ = rows->parentWidget();
  section_ = new SectionView(section_part_);
  rows->addWidget(section_);
  handpiece_ = new HandpiecePanel(this);
  column->addWidget(handpiece_);
  handpiece_rule_ = make_rule();
  handpiece_rule_->hide();
  column->addWidget(handpiece_rule_);
  make_progress();
  rows = add_part(tr("Removed so far"));
  removed_part_ = rows->parentWidget();
  tissue_grid_ = make_grid();
  rows->addLayout(tissue_grid_);
  make_device();

  column->addStretch();
  whole->addWidget(make_rule());
  foot_ = new SessionFoot;
  whole->addLayout(foot_);
  fold(false);
}

/// A small window scrolls what does not fit; whether the record is safe always stands below it.
QVBoxLayout* ScorePanel::make_scrolled(QVBoxLayout& whole) {
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  body_ = new QWidget;
  set_kind(body_, "page_surface");
  body_->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(body_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  scroll->setWidget(body_);
  whole.addWidget(scroll, 1);
  return column;
}

void ScorePanel::make_task() {
  QVBoxLayout* rows = add_part(tr("Your task"));
  task_part_ = rows->parentWidget();
  task_part_->hide();
  task_ = make_label({});
  task_->setWordWrap(true);
  rows->addWidget(task_);
}

void ScorePanel::make_progress() {
  QVBoxLayout* rows = add_part(tr("Progress"));
  progress_part_ = rows->parentWidget();
  auto* line = new QHBoxLayout;
  line->setSpacing(px(8));
  percent_ = make_label({}, TextRole::page_title, Weight::bold);
  percent_->setAccessibleDescription(tr("Target removed"));
  line->addWidget(percent_);
  QLabel* unit = make_label(tr("of the target removed"), TextRole::caption, Weight::regular, "text2");
  unit->setWordWrap(true);
  line->addWidget(unit, 1);
  rows->addLayout(line);
  percent_bar_ = new Bar(Bar::Role::target, progress_part_);
  percent_bar_->setAccessibleName(tr("Target removed"));
  rows->addWidget(percent_bar_);
  target_grid_ = make_grid();
  rows->addLayout(target_grid_);
  QWidget* over_cut = make_fact_row(QStringLiteral("warning"), tr("Over-cut"), &over_cut_);
  over_pulp_row_ = make_fact_row(QStringLiteral("shield"), tr("Least dentine over pulp"), &over_pulp_);
  for (QWidget* row : {over_cut, over_pulp_row_}) {
    wrap_name(*row);
    rows->addWidget(row);
  }
}

void ScorePanel::make_device() {
  QVBoxLayout* rows = add_part(tr("Device"));
  auto* line = new QHBoxLayout;
  device_ = make_label({});
  device_->setWordWrap(true);
  device_state_ = make_value();
  line->addWidget(device_, 1);
  line->addWidget(device_state_);
  rows->addLayout(line);
  softened_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  softened_->setWordWrap(true);
  softened_->hide();
  rows->addWidget(softened_);
  no_pedal_ = make_label(tr("The foot pedal is not plugged in any more. Until it is, the button alone cuts."), TextRole::caption, Weight::bold, "look");
  no_pedal_->setWordWrap(true);
  no_pedal_->hide();
  rows->addWidget(no_pedal_);
}

void ScorePanel::fold(bool on) {
  folded_ = on;
  setFixedWidth(px(on ? kFoldedWidth : kWidth));
  section_part_->setVisible(!on);
  percent_bar_->setVisible(!on);
  for (const TissueRow& one : tissues_) fold_bars(*tissue_grid_, one.row);
  for (const BarRow& row : targets_) fold_bars(*target_grid_, row);
  handpiece_->fold(on);
}

ScorePanel::BarRow ScorePanel::add_bar(QGridLayout& grid, const QString& name, Bar::Role role) {
  const BarRow row{make_label(name), new Bar(role, this), make_value()};
  row.bar->setAccessibleName(name);
  row.bar->setMinimumWidth(px(kLeastBar));
  row.value->setAccessibleDescription(name);
  const int at = grid.rowCount();
  grid.addWidget(row.name, at, 1);
  grid.addWidget(row.bar, at, 2);
  grid.addWidget(row.value, at, 3);
  fold_bars(grid, row);
  return row;
}

/// A row for each of several targets: which of them is still to be cut.
void ScorePanel::add_targets(const Scenario& scenario) {
  for (const Region* one : asked_targets(scenario)) {
    if (targets_.size() == LiveReading::kMostTargets) return;
    QString name = target_title(one->name, &scenario.target);
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    targets_.push_back(add_bar(*target_grid_, name, Bar::Role::target));
  }
}

void ScorePanel::fold_bars(QGridLayout& grid, const BarRow& row) const {
  row.bar->setVisible(!folded_);
  row.name->setWordWrap(folded_);
  grid.setColumnStretch(folded_ ? 1 : 2, 1);
  grid.setColumnStretch(folded_ ? 2 : 1, 0);
}

void ScorePanel::set_exercise(const Scenario& scenario, const Has& has) {
  const int fdi = sided_fdi(scenario.specimen);
  const bool sided = is_tooth_number(fdi);  // of another specimen no side is known
  section_aside_->setText(!sided ? tr("across") : fdi < 30 ? tr("buccal–palatal") : tr("buccal–lingual"));
  if (sided) section_->set_sides(tooth_sides(fdi)[2].letter, tooth_sides(fdi)[3].letter);
  const bool guided = has.guidance == Guidance::full;
  task_->setText(briefing_text(scenario));
  task_part_->setVisible(!guided && !task_->text().isEmpty());
  progress_part_->setVisible(has.target && guided);
  removed_part_->setVisible(guided);
  over_pulp_row_->setVisible(has.pulp);
  add_targets(scenario);
  handpiece_->set_exercise(scenario, has.guidance);
  handpiece_rule_->setVisible(!handpiece_->isHidden());
  for (const ScenarioTissue& t : scenario.tissues) {
    tissues_.push_back({t.tissue, add_bar(*tissue_grid_, tissue_name(t.tissue, has.names), role_of(t.tissue))});
    tissue_grid_->addWidget(new Swatch(on_tooth(t.tissue), this), tissue_grid_->rowCount() - 1, 0);
  }
}

void ScorePanel::set_device(const DeviceLimits& limits, double stiffness_share) {
  device_->setText(device_name(limits.device_class));
  softened_->setVisible(stiffness_share < 1.0);
  if (stiffness_share < 1.0) {
    softened_->setText(tr("All tissues feel softer, at %1 of their stiffness: with more this device could begin to "
                          "tremble.")
                           .arg(format({stiffness_share * 100, {}, QStringLiteral("%"), 0})));
  }
}

void ScorePanel::show_values(const LiveView& live) {
  const QString mm3 = QStringLiteral("mm3");
  set_value(percent_, format({live.target_removed_percent, {}, QStringLiteral("%"), 0}));
  percent_bar_->set_share(live.target_removed_percent / 100, percent_->text());
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    set_value(targets_[i].value, format({live.removed_of_percent[i], {}, QStringLiteral("%"), 0}));
    targets_[i].bar->set_share(live.removed_of_percent[i] / 100, targets_[i].value->text());
  }
  set_value(over_cut_, format({live.over_leeway_mm3 + live.over_beyond_mm3, {}, mm3, 1}));
  set_value(over_pulp_, live.pulp_exposed    ? tr("open")
                        : live.over_pulp_mm ? format({*live.over_pulp_mm, {}, QStringLiteral("mm"), 1})
                                            : tr("enough"));
  show_tissues(live);
  handpiece_->show_values(live);
  QString state;
  switch (live.device) {
    case Sample::Status::fresh: state = live.fault == Fault::none ? tr("steady") : tr("stopped"); break;
    case Sample::Status::late: state = tr("slow"); break;
    case Sample::Status::gone: state = tr("not connected"); break;
  }
  set_value(device_state_, state);
  foot_->show_values(live);
}

void ScorePanel::show_pedal(bool plugged) {
  had_pedal_ = had_pedal_ || plugged;
  const bool missed = had_pedal_ && !plugged;
  if (missed != no_pedal_->isHidden()) return;
  no_pedal_->setVisible(missed);
  announce(this, missed ? no_pedal_->text() : tr("The foot pedal is plugged in again."));
}

void ScorePanel::show_tissues(const LiveView& live) {
  const QString mm3 = QStringLiteral("mm3");
  double most = 1.0;  // mm³: bars are compared with the largest, and never with less than this
  for (const TissueRow& r : tissues_) most = std::max(most, live.removed_mm3[index_of(r.tissue)]);
  for (const TissueRow& r : tissues_) {
    const double removed = live.removed_mm3[index_of(r.tissue)];
    set_value(r.row.value, format({removed, {}, mm3, 2}));
    r.row.bar->set_share(removed / most, r.row.value->text());
  }
}

}  // namespace cusp::ui
