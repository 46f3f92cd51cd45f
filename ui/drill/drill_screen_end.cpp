// How an attempt ends on the drilling screen: finished and graded, or left.

#include <QLocale>
#include <QPointer>
#include <utility>

#include "ui/drill/drill_screen_inner.h"

namespace cusp::ui {

void DrillScreen::ask_finish() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  if (in.input) in.input->release_all();
  in.stage->set_asking(true);
  in.attempt->session->pause();
  const Question question =
      in.guidance == Guidance::silent
          ? Question{tr("Hand in?"), tr("The tooth is kept as it is now; nothing can be changed afterwards."), tr("Hand in")}
          : Question{tr("Finish and see the result?"), tr("The tooth is measured as it is now."), tr("Finish")};
  in.ports.ask(this, question,
               [self = QPointer(this)](bool yes) {
                 if (!self || !self->running()) return;
                 self->inner_->stage->set_asking(false);
                 if (yes) {
                   self->finish_now();
                 } else {
                   self->inner_->attempt->session->resume();
                   self->setFocus();
                 }
               });
}

void DrillScreen::finish_now() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  if (in.input) in.input->set_enabled(false);
  in.working = true;
  in.look_timer.stop();
  in.sound->stop();
  enable_controls(false);
  in.bar->enable_leave(false);
  in.stats.write_where_asked();
  in.busy->start(tr("Measuring the tooth"), Busy::Cancel::none);
  in.worker = std::thread([this, session = in.attempt->session.get()] {
    const auto progress = [this, shown = 0](double share) mutable {
      const int percent = static_cast<int>(100 * share);
      if (std::exchange(shown, percent) == percent) return;
      QMetaObject::invokeMethod(this, [this, share] { if (inner_->working) inner_->busy->set_progress(share, QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%'); }, Qt::QueuedConnection);
    };
    auto result = std::make_shared<Outcome<SessionResult>>(session->finish(progress));
    QMetaObject::invokeMethod(this, [this, result] { graded(result); }, Qt::QueuedConnection);
  });
}

void DrillScreen::graded(const std::shared_ptr<Outcome<SessionResult>>& result) {
  Inner& in = *inner_;
  if (in.worker.joinable()) in.worker.join();
  in.working = false;
  in.busy->finish();
  in.bar->enable_leave(true);
  if (!*result && result->error().code == SessionError::recording_failed) {
    // The record may become writable again: nothing is lost while this screen stands.
    in.stage->show_stopped(DrillStage::Stop::record, describe(result->error()));
    in.bar->enable_finish(true);
    return;
  }
  in.over = true;
  in.stage->view()->set_bur_source({});
  in.attempt->session.reset();
  if (*result) {
    Q_EMIT finished(std::make_shared<const SessionResult>(std::move(**result)));
  } else {
    Q_EMIT failed(result->error());
  }
}

void DrillScreen::ask_leave() {
  Inner& in = *inner_;
  if (in.opening) in.opening->call_off();
  if (in.working && !in.unseen) return;
  if (!running()) {
    Q_EMIT left();
    return;
  }
  const auto leave = [self = QPointer(this)](bool yes) {
    if (!self || !self->running()) return;
    Inner& inner = *self->inner_;
    inner.stage->set_asking(false);
    if (!yes) {
      inner.attempt->session->resume();
      self->setFocus();
      return;
    }
    inner.look_timer.stop();
    inner.sound->stop();
    inner.stats.write_where_asked();
    inner.over = true;
    inner.stage->view()->set_bur_source({});
    inner.attempt->session->abandon();
    inner.attempt->session.reset();
    Q_EMIT self->left();
  };
  if (in.input) in.input->release_all();
  double removed = 0;
  for (const double mm3 : in.attempt->session->view().removed_mm3) removed += mm3;
  if (removed <= 0 && in.leave_code.isEmpty()) return leave(true);
  in.stage->set_asking(true);
  in.attempt->session->pause();
  if (!in.leave_code.isEmpty()) {
    in.ports.ask(this,
                 {tr("Leave this assessment?"), tr("It counts as interrupted. To leave, the invigilator types the start code."), tr("Leave"), true,
                  {}, in.leave_code},
                 leave);
    return;
  }
  in.ports.ask(this,
               {tr("Leave this attempt?"),
                in.live.recording == RecordingState::off ? tr("Nothing of it is kept.")
                                                         : tr("It stays in your results as interrupted."),
                tr("Leave"), true},
               leave);
}

}  // namespace cusp::ui
