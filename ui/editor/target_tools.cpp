// What stands over the tooth of the editor: tools, legend, and progress in the middle.

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <array>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/teeth/landmarks.h"
#include "ui/editor/handle_knob.h"
#include "ui/editor/target_view.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/line_sample.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr std::array kTurns = {PresetView::working, PresetView::buccal, PresetView::distal, PresetView::lingual};

QFrame* make_panel(QWidget* parent) {
  auto* card = new QFrame(parent);
  card->setProperty("kind", u"card"_qs);
  card->setAutoFillBackground(true);
  return card;
}

/// A row of the legend.
QWidget* make_row(QFrame& legend) {
  auto* part = new QWidget(&legend);
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(6));
  legend.layout()->addWidget(part);
  return part;
}

}  // namespace

void TargetView::make_tools() {
  tools_ = make_panel(this);
  auto* row = new QHBoxLayout(tools_);
  row->setContentsMargins(px(3), px(3), px(3), px(3));
  row->setSpacing(px(2));
  QPushButton* turn = make_button(tr("Turn"), ButtonKind::quiet, u"turn"_qs);
  QPushButton* above = make_button(tr("From above"), ButtonKind::quiet, u"eye"_qs);
  QPushButton* carved = carved_button_ = make_button(tr("Cut out"), ButtonKind::quiet, u"cutaway"_qs);
  carved->setCheckable(true);
  carved->setChecked(true);
  carved->setToolTip(tr("Show the tooth as it is when the target is met"));
  QPushButton* section = make_button(tr("Section"), ButtonKind::quiet, u"layers"_qs);
  make_section(*section);
  for (QPushButton* button : {turn, above, carved, section}) {
    row->addWidget(button);
    tool_texts_.emplace_back(button, button->text());
    if (button->toolTip().isEmpty()) button->setToolTip(button->accessibleName());
  }
  connect(turn, &QPushButton::clicked, this, [this] {
    Camera camera = view_->camera();
    const int fdi = sided_fdi(model_.scenario().specimen);
    camera.set_preset(kTurns[static_cast<std::size_t>(preset_++) % kTurns.size()], mesial_x(fdi));
    view_->set_camera(camera);
  });
  connect(above, &QPushButton::clicked, this, [this] {
    Camera camera = view_->camera();
    camera.set_preset(PresetView::occlusal);
    view_->set_camera(camera);
  });
  connect(carved, &QPushButton::toggled, this, [this](bool on) {
    carved_ = on;
    mesh_wanted_ = true;
    run_next();
  });
}

void TargetView::make_legend() {
  legend_ = make_panel(this);
  auto* inside = new QHBoxLayout(legend_);
  inside->setContentsMargins(px(12), px(7), px(12), px(7));
  const auto add = [](QWidget& part, QWidget* sample, const QString& text) {
    part.layout()->addWidget(sample);
    part.layout()->addWidget(make_label(text, TextRole::caption));
  };
  target_legend_ = make_row(*legend_);
  add(*target_legend_, new LineSample(LineSample::Line::target, target_legend_), tr("Target"));
  static_cast<QHBoxLayout*>(target_legend_->layout())->addSpacing(px(6));
  add(*target_legend_, new LineSample(LineSample::Line::tolerance_zone, target_legend_), tr("Tolerance zone"));
  mark_legend_ = make_row(*legend_);
  add(*mark_legend_, new KnobSample(MarkState::proposed, mark_legend_), tr("Proposed landmark"));
  static_cast<QHBoxLayout*>(mark_legend_->layout())->addSpacing(px(6));
  add(*mark_legend_, new KnobSample(MarkState::set, mark_legend_), tr("Set landmark"));
  mark_legend_->hide();
}

void TargetView::set_centre(QWidget* widget) {
  if (centre_) centre_->deleteLater();
  centre_ = nullptr;
  if (widget) {
    centre_ = make_panel(this);
    (new QVBoxLayout(centre_))->addWidget(widget);
    widget->show();
    centre_->show();
  }
  place_all();
}

/// Signs alone where the view is too narrow for their texts.
void TargetView::fit_tools() {
  for (const auto& [button, text] : tool_texts_) button->setText(text);
  tools_->adjustSize();
  if (tools_->width() <= width() - px(24)) return;
  for (const auto& [button, text] : tool_texts_) button->setText({});
  tools_->adjustSize();
}

}  // namespace cusp::ui
