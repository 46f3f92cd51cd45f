// The section through the tooth of the editor.

#include <QPushButton>
#include <algorithm>

#include "scenarios/landmarks/landmarks.h"
#include "ui/editor/target_view.h"
#include "ui/view/section_bar.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kSectionWidth = 420, kSectionSide = 12;  // px at 100 %
constexpr int kNarrowView = 280, kNarrowSide = 4;      // px at 100 %; of a narrower view the bar's two ways take all

}  // namespace

void TargetView::make_section(QPushButton& button) {
  section_ = new SectionBar(*view_, this);
  set_kind(section_, "card");
  section_->setAutoFillBackground(true);
  button.setCheckable(true);
  button.setToolTip(tr("Cut the tooth open and move the section through it"));
  connect(&button, &QPushButton::toggled, this, [this](bool on) {
    if (!on) {
      section_->close();
      return place_all();
    }
    cut_section();
    section_->open();
    place_all();
  });
}

/// What the section goes through: the tooth as the view shows it, with the target as it is now.
void TargetView::cut_section() {
  if (!grown_ || !preview_) return;
  section_->set_tooth(sided_fdi(model_.scenario().specimen));
  section_->show_cut({.volume = preview_,
                      .target = model_.scenario().target,
                      .leeway = model_.scenario().leeway,
                      .scenery = scenery_,
                      .ideal = nullptr});
}

void TargetView::place_section() {
  const int side = px(width() < px(kNarrowView) ? kNarrowSide : kSectionSide);
  section_->setFixedWidth(std::min(px(kSectionWidth), width() - 2 * side));
  section_->adjustSize();
  section_->move(side, height() - section_->height() - side);
  section_->raise();
}

}  // namespace cusp::ui
