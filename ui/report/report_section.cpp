#include "ui/report/report_section.h"

#include <QBoxLayout>
#include <cmath>
#include <utility>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/operators/fast_cut.h"
#include "ui/report/pinned_tooth.h"
#include "ui/view/section_bar.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/line_sample.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kOnPlaneMm = 0.25;  // from a pinned place to the plane, for which ring and card are still true [M]

/// What the reference operator leaves of the uncut tooth; null: it has no path to the target, or is cancelled.
std::shared_ptr<const Volume> reference_preparation(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen,
                                                    PlanCancel cancel) {
  const auto plan = plan_by_name("reference", scenario, *specimen, cancel);
  if (!plan || plan->strokes.empty() || is_cancelled(cancel)) return nullptr;
  auto volume = std::make_shared<Volume>(specimen);
  return cut_along(*plan, scenario, *volume) ? volume : nullptr;
}

QWidget* legend_of(LineSample::Line line, const QString& text) {
  auto* out = new QWidget;
  auto* row = new QHBoxLayout(out);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(6));
  row->addWidget(new LineSample(line, out));
  row->addWidget(make_label(text, TextRole::caption));
  return out;
}

}  // namespace

ReportSection::ReportSection(PinnedTooth& tooth, std::shared_ptr<const Volume> volume, const Scenario& scenario, QWidget* parent)
    : QWidget(parent), tooth_(tooth), volume_(std::move(volume)), scenario_(scenario), bar_(new SectionBar(*tooth.view())) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  column->addWidget(bar_);
  auto* legend = new QHBoxLayout;
  legend->setContentsMargins(px(12), 0, px(12), 0);
  legend->setSpacing(px(16));
  reference_line_ = legend_of(LineSample::Line::reference, tr("Ideal preparation"));
  target_line_ = legend_of(LineSample::Line::target, tr("Target"));
  for (QWidget* one : {reference_line_, target_line_}) legend->addWidget(one);
  legend->addWidget(legend_of(LineSample::Line::tolerance_zone, tr("Tolerance zone")));
  legend->addStretch();
  column->addLayout(legend);
  reference_line_->hide();
  bar_->set_tooth(sided_fdi(scenario.specimen));
  connect(&tooth_, &PinnedTooth::scenery_came, this, &ReportSection::show_cut);
  connect(bar_, &SectionBar::moved, this, &ReportSection::follow_plane);
  show_cut();
  hide();
}

void ReportSection::set_open(bool open) {
  setVisible(open);
  if (!open) {
    bar_->close();
    tooth_.show_pin(PinnedTooth::Pin::shown);
    return tooth_.set_cut_open(false);
  }
  tooth_.set_cut_open(true);
  show_cut();
  go_through(tooth_.place_mm());
  bar_->open();
  if (!std::exchange(asked_, true)) cut_reference();
}

void ReportSection::go_through(const std::optional<Vec3>& place_mm) {
  if (place_mm) bar_->go_through(*place_mm);
}

/// A place that the plane has left is not marked.
void ReportSection::follow_plane() {
  if (!bar_->is_open()) return;
  const auto& place_mm = tooth_.place_mm();
  const SectionPlane plane = bar_->plane();
  const bool left = place_mm && std::abs(glm::dot(*place_mm - plane.centre_mm, plane.normal())) > kOnPlaneMm;
  tooth_.show_pin(left ? PinnedTooth::Pin::hidden : PinnedTooth::Pin::shown);
}

void ReportSection::cut_reference() {
  cutting_.start(this, [scenario = scenario_, specimen = volume_->specimen_ptr()](const PoolLink<ReportSection>& link) {
    auto reference = reference_preparation(scenario, specimen, link.cancel_flag());
    link.post([reference](ReportSection& section) {
      section.cutting_.finish();
      section.reference_ = reference;
      section.show_cut();
    });
  });
}

void ReportSection::show_cut() {
  reference_line_->setVisible(reference_ != nullptr);
  target_line_->setVisible(reference_ == nullptr);
  bar_->show_cut({.volume = volume_,
                  .target = scenario_.target,
                  .leeway = scenario_.leeway,
                  .scenery = tooth_.scenery(),
                  .ideal = reference_});
}

}  // namespace cusp::ui
