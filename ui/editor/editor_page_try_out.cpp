// Try-outs of the draft: by the author's own hand, and by the reference operator.
#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/editor/editor_page.h"
#include "ui/editor/operator_job.h"
#include "ui/editor/target_view.h"
#include "ui/render/opengl_allowed.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

/// By the author's own hand, and by the reference operator.
void EditorPage::add_try_outs(QHBoxLayout& row) {
  try_ = make_button(tr("Try out"), ButtonKind::standard, u"hand"_qs, QKeySequence(Qt::Key_F5));
  if (!opengl_allowed()) {
    try_->setToolTip(ToothView::pictures_off());
    try_->setAccessibleDescription(try_->toolTip());
  }
  row.addWidget(try_);
  try_key_ = make_key_cap(u"F5"_qs);
  try_key_->setFixedHeight(px(18));
  row.addWidget(try_key_, 0, Qt::AlignVCenter);
  reference_ = make_button(tr("Reference"), ButtonKind::standard, u"bur"_qs, QKeySequence(Qt::SHIFT | Qt::Key_F5));
  reference_->setAccessibleName(tr("Try out by the reference operator"));
  reference_->setToolTip(tr("The reference operator cuts it at once, and a report shows its points (Shift+F5)"));
  row.addWidget(reference_);
  connect(try_, &QPushButton::clicked, this, &EditorPage::try_out);
  connect(reference_, &QPushButton::clicked, this, &EditorPage::try_out_by_reference);
}

void EditorPage::try_out() {
  take_typed();
  if (!grown_ || !model_->playable()) return;
  stop_reference();  // its report would open over the drilling
  SessionPlan plan;
  plan.scenario = model_->scenario();
  plan.scenario_folder = model_->folder();
  plan.student = actor_;
  plan.kind = SessionKind::try_out;  // no database: the records get nothing
  plan.specimen = grown_->whole->specimen_ptr();
  Q_EMIT try_out_wanted(plan, local(model_->scenario().title));
}

void EditorPage::follow_reference() {
  reference_job_ = new OperatorJob(this);
  connect(reference_job_, &OperatorJob::cut, this, [this](const std::shared_ptr<const SessionResult>& result) {
    model_->now_tried({TriedBy::reference, result->scenario, result->measures});
    Q_EMIT result_wanted(result);
  });
  connect(reference_job_, &OperatorJob::failed, this, [this](OperatorCutError error) {
    const Message message = describe(error, model_->scenario().tool_tilt_deg);
    band_->show_message(Band::Kind::look, message.what, message.more);
  });
  connect(reference_job_, &OperatorJob::done, this, &EditorPage::end_reference);
  // Its cuts are of the exercise as it was.
  connect(model_, &EditorModel::changed, this, &EditorPage::stop_reference);
}

void EditorPage::try_out_by_reference() {
  take_typed();
  if (!grown_ || !model_->playable() || reference_job_->running()) return;
  band_->clear();
  auto* busy = new Busy;
  busy->start(tr("The reference operator cuts it"), Busy::Cancel::offered);
  connect(busy, &Busy::cancelled, this, &EditorPage::stop_reference);
  stage_->set_centre(busy);
  reference_job_->start(model_->scenario(), grown_->whole->specimen_ptr(), {"reference"});
  follow_model();
}

void EditorPage::stop_reference() {
  if (!reference_job_->running()) return;
  reference_job_->cancel();
  end_reference();
}

void EditorPage::end_reference() {
  if (busy_ == nullptr) stage_->set_centre(nullptr);  // else the tooth grows: its progress stands there
  follow_model();
}

}  // namespace cusp::ui
