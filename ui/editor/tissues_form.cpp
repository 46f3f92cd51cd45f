#include "ui/editor/tissues_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "scenarios/format/keys.h"
#include "scenarios/format/ranges.h"
#include "scenarios/tissues/tissue_facts.h"
#include "ui/editor/form_parts.h"
#include "ui/modules.h"
#include "ui/text/names.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

/// Keys in the order of the list; the first stands for none.
constexpr std::array<const char*, 4> kHandpieces = {"", "spindle-turbine", "spindle-electric", "spindle-slow"};

QLabel* make_note() {
  QLabel* note = make_label({}, TextRole::caption, Weight::regular, "text2");
  note->setAlignment(Qt::AlignRight);
  note->setWordWrap(true);
  return note;
}

}  // namespace

QString figure_note(double value, const Sourced<double>& usual) {
  if (value != usual.value) return TissuesForm::tr("set for this exercise");
  if (!usual.verified) return TissuesForm::tr("usual, not verified");
  if (usual.source == "paper") return TissuesForm::tr("usual, from the published method");
  if (usual.source == "chun-2014") return TissuesForm::tr("usual, by hardness (Chun 2014)");
  return TissuesForm::tr("usual, from %1").arg(QString::fromStdString(usual.source));
}

TissuesForm::TissuesForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(6));
  list_ = new QVBoxLayout;
  list_->setSpacing(px(6));
  column->addLayout(list_);
  column->addSpacing(px(4));
  column->addWidget(make_rule());
  column->addSpacing(px(4));
  add_section(column, tr("Handpiece"));
  handpiece_ = new QComboBox;
  handpiece_->addItems({tr("Any: speed is not reckoned"), tr("Turbine"), tr("Electric"), tr("Slow")});
  handpiece_->setAccessibleName(tr("Handpiece"));
  column->addWidget(handpiece_);
  const NumberRange &tilt = *range_of("/device/tool_tilt_deg"), &turn = *range_of("/device/tool_turn_deg");
  tilt_ = new NumberBox(model_, tr("Tilt of the handpiece"), u"deg"_qs, tilt.least, tilt.most, 1, 1,
                        [this](double value) { return model_.set_tool_tilt_deg(value); });
  tilt_->setToolTip(tr("From vertical; above 0 the shank leans towards buccal"));
  add_row(column, tr("Tilt at rest"), tilt_);
  turn_ = new NumberBox(model_, tr("Turn of the handpiece"), u"deg"_qs, turn.least, turn.most, 1, 1,
                        [this](double value) { return model_.set_tool_turn_deg(value); });
  turn_->setToolTip(tr("How far the student may turn the handpiece from its tilt at rest; 0: not at all"));
  add_row(column, tr("Turn from there"), turn_);
  const auto box = [column, this](const QString& text, const char* key) {
    auto* out = new QCheckBox(text);
    column->addWidget(out);
    connect(out, &QCheckBox::toggled, this, [this, key](bool on) { model_.set_phenomenon(key, EditorModel::listed(on)); });
    return out;
  };
  vibration_ = box(tr("Bur vibrates in the hand"), "vibration");
  sound_ = box(tr("Drilling sound"), "sound");
  heat_ = box(tr("Coolant and heat"), "heat");
  friction_ = box(tr("Friction"), "friction");
  QLabel* note = make_label(tr("How handpieces give way, tremble and warm a tooth is general knowledge, not verified."),
                            TextRole::caption, Weight::regular, "text2");
  note->setWordWrap(true);
  column->addWidget(note);
  column->addStretch();
  connect(handpiece_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index >= 0) model_.set_handpiece(kHandpieces[static_cast<std::size_t>(index)]);
  });
  connect(&model_, &EditorModel::changed, this, &TissuesForm::follow_model);
  follow_model();
}

TissuesForm::Row TissuesForm::make_row(std::size_t index, const QString& name) {
  Row row{};
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, px(6));
  column->setSpacing(px(2));
  add_section(column, name);
  row.stiffness = new NumberBox(model_, tr("Stiffness of %1").arg(name), u"N/mm"_qs, 0.05, 20, 0.1, 2, [this, index](double v) {
    return model_.set_tissue_figures(index, v, model_.scenario().tissues[index].speed_mm_s);
  });
  add_row(column, tr("Stiffness"), row.stiffness);
  row.stiffness_note = make_note();
  column->addWidget(row.stiffness_note);
  row.speed = new NumberBox(model_, tr("Removal speed of %1").arg(name), u"mm/s"_qs, 0, 100, 0.1, 2, [this, index](double v) {
    return model_.set_tissue_figures(index, model_.scenario().tissues[index].stiffness_n_per_mm, v);
  });
  add_row(column, tr("Removal speed"), row.speed);
  row.speed_note = make_note();
  column->addWidget(row.speed_note);
  list_->addWidget(box);
  return row;
}

void TissuesForm::follow_model() {
  const Scenario& s = model_.scenario();
  QStringList names;
  for (const ScenarioTissue& t : s.tissues) names << tissue_name(t.tissue, model_.tissue_names());
  if (names != built_) {
    while (QLayoutItem* item = list_->takeAt(0)) {
      if (item->widget()) {
        item->widget()->hide();
        item->widget()->deleteLater();
      }
      delete item;
    }
    rows_.clear();
    built_ = names;
    for (std::size_t i = 0; i < s.tissues.size(); ++i) rows_.push_back(make_row(i, names[static_cast<qsizetype>(i)]));
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ScenarioTissue& t = s.tissues[i];
    const TissueFacts& usual = tissue_facts(t.tissue);
    const auto show = [](NumberBox* box, QLabel* note, double value, const Sourced<double>& figure) {
      box->show_value(value);
      note->setText(figure_note(value, figure));
      box->setAccessibleDescription(note->text());
    };
    show(rows_[i].stiffness, rows_[i].stiffness_note, t.stiffness_n_per_mm, usual.stiffness_n_per_mm);
    show(rows_[i].speed, rows_[i].speed_note, t.speed_mm_s, usual.speed_mm_s);
  }
  const auto has = [&s](const char* key) { return has_phenomenon(s.phenomena, key); };
  int handpiece = 0;
  for (std::size_t i = kHandpieces.size() - 1; i > 0; --i)
    if (has(kHandpieces[i])) handpiece = static_cast<int>(i);
  const QSignalBlocker q1(handpiece_), q2(vibration_), q3(sound_), q4(heat_), q5(friction_);
  handpiece_->setCurrentIndex(handpiece);
  tilt_->show_value(s.tool_tilt_deg);
  turn_->show_value(s.tool_turn_deg);
  vibration_->setChecked(has("vibration"));
  sound_->setChecked(has("sound"));
  heat_->setChecked(has("heat"));
  friction_->setChecked(has("friction"));
  vibration_->setEnabled(handpiece > 0);
  sound_->setEnabled(handpiece > 0);
}

}  // namespace cusp::ui
