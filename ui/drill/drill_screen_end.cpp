// How an attempt stands under a question or in a minimised window, and how it ends: finished and graded, or left.

#include <QLocale>
#include <QPointer>
#include <chrono>
#include <optional>
#include <utility>

#include "ui/drill/drill_screen_inner.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

// As long as desktops wait for mouse and keys before they blank the screen.
constexpr std::chrono::minutes kUnattended{5};

}  // namespace

/// Takes cut and force off the bur while the question is open. A pause would stop an assessment's clock.
void DrillScreen::hold_for_question() {
  Inner& in = *inner_;
  if (in.input) in.input->release_all();
  in.stage->set_asking(true);
  in.asked = true;
  in.stood = stands_still(in.attempt->session->view());
  if (in.guidance == Guidance::silent) {
    in.attempt->session->set_idle(true);
  } else {
    in.attempt->session->pause();
  }
}

/// An attempt that stood before the question stands again: the force comes back by Resume alone.
void DrillScreen::answered_no() {
  Inner& in = *inner_;
  in.attempt->session->set_idle(false);
  if (in.guidance == Guidance::full && !in.stood) in.attempt->session->resume();
  setFocus();
}

/// A device pushes and cuts also where nobody sees the tooth. Practice stands until Resume; the clock of an assessment runs on.
void DrillScreen::hold_while_minimised() {
  Inner& in = *inner_;
  const bool minimised = window()->isMinimized();
  if (in.guidance == Guidance::silent) {
    in.attempt->session->set_idle(in.asked || minimised);
  } else if (minimised && !stands_still(in.live)) {
    in.attempt->session->pause();
  }
}

void DrillScreen::count_input() { inner_->hand.count_input(); }

/// An attempt that nobody attends lets the desktop blank and lock. It runs on: its clock, its record and an assessment's time limit.
void DrillScreen::keep_awake() {
  Inner& in = *inner_;
  if (in.motion.moved(in.live.output.device_mm, in.live.orientation)) count_input();
  const bool attended = in.hand.idle_for() < kUnattended;
  const bool stopped = in.live.phase == LoopPhase::paused || in.live.phase == LoopPhase::held;
  if (stopped || !attended) in.awake.reset();
  else if (!in.awake && in.ports.keep_awake) in.awake = in.ports.keep_awake(tr("An attempt is running"));
}

void DrillScreen::ask_finish() {
  Inner& in = *inner_;
  if (!running() || in.working || in.live.silent) return;
  hold_for_question();
  const Question question =
      in.guidance == Guidance::silent
          ? Question{tr("Hand in?"), tr("The tooth is kept as it is now; nothing can be changed afterwards."), tr("Hand in")}
          : Question{tr("Finish and see the result?"), tr("The tooth is measured as it is now."), tr("Finish")};
  in.ports.ask(this, question, [self = QPointer(this)](bool yes) {
    if (!self || !self->running()) return;
    Inner& inner = *self->inner_;
    inner.stage->set_asking(false);
    inner.asked = false;
    if (inner.working) return;  // the time limit has finished it meanwhile
    yes && !inner.live.silent ? self->finish_now() : self->answered_no();
  });
}

void DrillScreen::finish_now() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  if (in.input) in.input->set_enabled(false);
  in.working = true;
  in.look_timer.stop();
  in.sound->stop();
  in.awake.reset();
  enable_controls(false);
  in.bar->enable_leave(false);
  in.stats.write_where_asked();
  if (in.live.end == LoopEnd::ring_full) {
    in.stage->show_stopped(DrillStage::Stop::behind);  // this card itself says that the tooth is measured
  } else {
    in.stage->show_stopped(DrillStage::Stop::none);
    const QString doing = in.live.time_is_up ? tr("The time is over. Measuring the tooth") : tr("Measuring the tooth");
    in.busy->start(doing, Busy::Cancel::none);
    announce(this, doing);
  }
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
  const auto then = std::exchange(in.after_leaving, nullptr);
  if (!*result && result->error().code == SessionError::recording_failed) {
    // The record may become writable again: nothing is lost while this screen stands.
    const SessionFailure& f = result->error();
    const auto* code = std::get_if<StorageError>(&f.cause);
    in.stage->show_stopped(DrillStage::Stop::record_at_end, code ? describe_refused_record({*code, f.where, f.detail}) : describe(f));
    in.bar->enable_finish(true);
    return;
  }
  in.over = true;
  in.stage->view()->set_bur_source({});
  in.attempt->session.reset();
  if (*result) {
    Q_EMIT finished(std::make_shared<const SessionResult>(std::move(**result)));
    if (then) then();
  } else {
    Q_EMIT failed(result->error());
  }
}

/// The session waits for the mirror and for the disk, on a thread of its own; for a driver that stands still it waits 3 s at most.
void DrillScreen::leave_now() {
  Inner& in = *inner_;
  in.look_timer.stop();
  in.sound->stop();
  in.awake.reset();
  in.stats.write_where_asked();
  if (in.input) in.input->set_enabled(false);
  in.over = in.working = true;
  in.unseen = false;
  in.stage->view()->set_bur_source({});
  enable_controls(false);
  in.bar->enable_leave(false);
  in.stage->show_stopped(DrillStage::Stop::none);
  in.busy->start(tr("Leaving the attempt"), Busy::Cancel::none);
  in.worker = std::thread([this, session = in.attempt->session.get()] {
    const auto unmarked = session->abandon() ? std::nullopt : std::optional(session->session());
    QMetaObject::invokeMethod(this, [this, unmarked] { abandoned(unmarked); }, Qt::QueuedConnection);
  });
}

void DrillScreen::abandoned(const std::optional<SessionId>& unmarked) {
  Inner& in = *inner_;
  in.worker.join();
  in.working = false;
  in.busy->finish();
  in.attempt->session.reset();
  if (unmarked) Q_EMIT left_unmarked(*unmarked);
  report_left();
}

void DrillScreen::report_left() {
  const auto then = std::exchange(inner_->after_leaving, nullptr);
  Q_EMIT left();
  if (then) then();
}

void DrillScreen::ask_leave() { ask_leave_then({}); }

/// The opening is called off, and a leaving shows itself. A measuring goes on, for whoever closes the window with what is waited for.
void DrillScreen::leave_after_work(std::function<void()> then) {
  Inner& in = *inner_;
  const bool closes = then != nullptr;
  if (closes) in.after_leaving = std::move(then);
  QString doing;
  if (in.opening && !in.opening->called_off()) {
    in.opening->call_off();
    in.homing->hide();
    doing = tr("Leaving the attempt");
  } else if (closes && running()) {
    in.stage->show_stopped(DrillStage::Stop::none);
    doing = tr("Cusp closes once the tooth is measured");
  }
  if (doing.isEmpty()) return;
  in.busy->start(doing, Busy::Cancel::none);
  announce(this, doing);
}

void DrillScreen::ask_leave_then(std::function<void()> then) {
  Inner& in = *inner_;
  if (in.working && !in.unseen) return leave_after_work(std::move(then));
  if (!running()) {
    Q_EMIT left();
    return;
  }
  const auto leave = [self = QPointer(this), then = std::move(then)](bool yes) {
    if (!self || !self->running()) return;
    Inner& inner = *self->inner_;
    inner.stage->set_asking(false);
    inner.asked = false;
    if (inner.working && !inner.unseen) {  // the time limit has finished it meanwhile
      if (yes) self->leave_after_work(then);
      return;
    }
    if (!yes) return self->answered_no();
    inner.after_leaving = then;
    self->leave_now();
  };
  double removed = 0;
  const LiveView now = in.attempt->session->view();
  for (const double mm3 : now.removed_mm3) removed += mm3;
  if (removed <= 0 && in.leave_code.isEmpty()) return leave(true);
  hold_for_question();
  if (!in.leave_code.isEmpty()) {
    in.ports.ask(this,
                 {tr("Leave this assessment?"), tr("It counts as interrupted. To leave, the invigilator types the start code."), tr("Leave"), true,
                  {}, in.leave_code},
                 leave);
    return;
  }
  const bool kept = !in.attempt->session->session().is_nil();
  const bool waits = now.recording == RecordingState::behind || now.recording == RecordingState::failed;
  in.ports.ask(this,
               {tr("Leave this attempt?"),
                !kept        ? tr("Nothing of it is kept.")
                : now.silent ? tr("It stays in your results as interrupted, with what was recorded until the driver of the device stood still.")
                : waits ? tr("It stays in your results as interrupted, without what cannot be written.")
                        : tr("It stays in your results as interrupted."),
                tr("Leave"), true},
               leave);
}

}  // namespace cusp::ui
