// The report's left half: the tooth, what is shown of it, and the legend.

#include <QBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include "ui/report/before_after.h"
#include "ui/report/pinned_tooth.h"
#include "ui/report/report_page.h"
#include "ui/report/report_section.h"
#include "ui/view/section_bar.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kToothWidth = 600;  // px at 100 %, of a window of 1280

}  // namespace

QWidget* ReportPage::make_tooth() {
  auto* left = new QWidget;
  left->setMinimumWidth(px(220));
  left->setMaximumWidth(px(kToothWidth) * 2);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  tooth_ = new PinnedTooth(data_.result.volume, data_.result.scenario);
  teeth_ = new BeforeAfter(tooth_, data_.result.volume, data_.result.scenario);
  column->addWidget(teeth_, 1);
  auto* legend_box = new QFrame;
  legend_box->setProperty("kind", u"bar_bottom"_qs);
  auto* legend_row = new QVBoxLayout(legend_box);
  legend_row->setContentsMargins(px(12), px(10), px(12), px(8));
  legend_row->addWidget(new DeviationLegend);
  column->addWidget(legend_box);
  if (data_.result.volume) {
    auto* section_box = new QFrame;
    section_box->setProperty("kind", u"bar_bottom"_qs);
    auto* section_column = new QVBoxLayout(section_box);
    section_column->setContentsMargins(px(12), px(4), px(12), px(8));
    section_ = new ReportSection(*tooth_, data_.result.volume, data_.result.scenario);
    section_column->addWidget(section_);
    column->addWidget(section_box);
  }
  make_tools(*legend_box)->move(px(12), px(12));
  return left;
}

/// What the view shows: one button each, and the way back to the first view. `legend`: of the colours of the difference alone.
QWidget* ReportPage::make_tools(QWidget& legend) {
  auto* tools = new QFrame(teeth_);
  tools->setProperty("kind", u"card"_qs);
  tools->setAutoFillBackground(true);
  tools_ = new QVBoxLayout(tools);
  tools_->setContentsMargins(px(4), px(4), px(4), px(4));
  tools_->setSpacing(px(4));
  QPushButton* difference = make_button(tr("Difference"), ButtonKind::quiet);
  QPushButton* drilled = make_button(tr("As drilled"), ButtonKind::quiet);
  QPushButton* both = make_button(tr("Before and after"), ButtonKind::quiet);
  for (QPushButton* b : {difference, drilled, both}) {
    b->setCheckable(true);
    b->setAutoExclusive(true);
  }
  difference->setChecked(true);
  QToolButton* turn = make_icon_button(u"refresh"_qs, tr("Turn back to the view from above"));
  shown_ = {difference, drilled, both, turn};
  if (section_) shown_.insert(shown_.begin() + 2, make_section({.drilled = *drilled, .both = *both}));
  fit_tools(px(kToothWidth));
  for (std::size_t i = 0; i + 1 < shown_.size(); ++i) QWidget::setTabOrder(shown_[i], shown_[i + 1]);
  if (section_) section_->bar()->tab_after(shown_.back());
  connect(difference, &QPushButton::toggled, tooth_, [this](bool on) { tooth_->set_colouring(on ? Colouring::deviation : Colouring::tissue); });
  connect(difference, &QPushButton::toggled, &legend, &QWidget::setVisible);
  connect(both, &QPushButton::toggled, teeth_,
          [this](bool on) { teeth_->show_teeth(on ? BeforeAfter::Shown::both : BeforeAfter::Shown::after); });
  connect(turn, &QToolButton::clicked, tooth_, &PinnedTooth::turn_back);
  tools->raise();
  return tools;
}

/// Cuts the one tooth open, in the colours of its tissues.
QPushButton* ReportPage::make_section(const TeethButtons& others) {
  QPushButton* out = make_button(tr("Section"), ButtonKind::quiet);
  out->setCheckable(true);
  out->setToolTip(tr("Cut the tooth open and compare its walls with the ideal preparation"));
  connect(out, &QPushButton::toggled, section_, [this, &drilled = others.drilled](bool on) {
    section_->set_open(on);
    section_->parentWidget()->setVisible(on);
    if (on) drilled.setChecked(true);
  });
  // Opened before the mesh stands, a section would face nothing.
  const auto may_open = [out, both = &others.both, tooth = tooth_] { out->setEnabled(tooth->tooth_shown() && !both->isChecked()); };
  connect(tooth_, &PinnedTooth::tooth_came, out, may_open);
  connect(&others.both, &QPushButton::toggled, out, [out, may_open](bool on) {
    if (on) out->setChecked(false);
    may_open();
  });
  may_open();
  section_->parentWidget()->hide();
  return out;
}

/// As many lines of buttons as the tooth's width needs.
void ReportPage::fit_tools(int width) {
  const int most = width - px(12) * 2 - px(4);
  while (QLayoutItem* old = tools_->takeAt(0)) delete old;
  QBoxLayout* line = nullptr;
  int used = 0;
  for (QWidget* button : shown_) {
    const int needed = button->sizeHint().width() + px(4);
    if (line == nullptr || used + needed > most) {
      line = new QHBoxLayout;
      line->setSpacing(px(4));
      tools_->addLayout(line);
      used = 0;
    }
    line->addWidget(button, 0, Qt::AlignLeading);
    used += needed;
  }
  for (int i = 0; i < tools_->count(); ++i) static_cast<QBoxLayout*>(tools_->itemAt(i)->layout())->addStretch();
  tools_->activate();
  tools_->parentWidget()->adjustSize();
  tooth_->set_head(tools_->parentWidget()->geometry().bottom());
}

}  // namespace cusp::ui
