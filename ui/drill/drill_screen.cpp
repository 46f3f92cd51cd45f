#include "ui/drill/drill_screen.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPointer>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <thread>

#include "ui/drill/bur_tray.h"
#include "ui/drill/drill_bar.h"
#include "ui/drill/drill_stage.h"
#include "ui/drill/go_opening.h"
#include "ui/drill/go_sound.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/drill/homing_card.h"
#include "ui/drill/pointer_input.h"
#include "ui/drill/score_panel.h"
#include "ui/view/frame_stats.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kLookMs = 33;           // bur and clock
constexpr int kTextEvery = 3;         // looks between two of texts and gauges, about ten a second
constexpr std::chrono::milliseconds kFollow{30};
constexpr double kUsualShare = 0.53;  // of full force: 0.8 N where that is 1.5, about what a handpiece is led with
constexpr double kLeastUsualN = 0.4;

}  // namespace

struct DrillScreen::Inner {
  Ports ports;
  // Widgets.
  DrillBar* bar;
  DrillStage* stage;
  ScorePanel* panel;
  BurTray* tray;
  Busy* busy;
  QTimer look_timer;
  GoSound* sound;
  HomingCard* homing;

  // The go.
  DeviceChoice choice;
  std::unique_ptr<GoOpening> opening;  // until the go has started
  QTimer opening_timer;
  std::shared_ptr<OpenedGo> go;
  std::unique_ptr<PointerInput> input;
  std::thread worker;  // grades
  FrameStats stats;
  LiveView live;
  int looks = 0;
  bool working = false, over = false;
};

DrillScreen::DrillScreen(QWidget* parent, Ports ports) : QWidget(parent), inner_(std::make_unique<Inner>()) {
  Inner& in = *inner_;
  in.ports = std::move(ports);
  set_kind(this, "page");
  setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);

  in.bar = new DrillBar(this);
  connect(in.bar, &DrillBar::leave, this, &DrillScreen::ask_leave);
  connect(in.bar, &DrillBar::pause, this, &DrillScreen::toggle_pause);
  connect(in.bar, &DrillBar::finish, this, &DrillScreen::ask_finish);
  column->addWidget(in.bar);

  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  in.stage = new DrillStage(this);
  connect(in.stage, &DrillStage::go_on, this, &DrillScreen::toggle_pause);
  connect(in.stage, &DrillStage::leave, this, &DrillScreen::ask_leave);
  connect(in.stage, &DrillStage::sections_wanted, this,
          [this](const std::optional<SectionWish>& panel, const std::optional<SectionWish>& lid) {
            if (inner_->go) inner_->go->feed->want_sections(panel, lid);
          });
  left->addWidget(in.stage, 1);
  in.tray = new BurTray(this);
  connect(in.tray, &BurTray::bur_chosen, this, [this](int index) {
    if (inner_->go && inner_->go->run) inner_->go->run->change_bur(static_cast<std::size_t>(index));
    if (inner_->go && inner_->go->device.hand) inner_->go->device.hand->set_bur(static_cast<std::uint16_t>(index));
  });
  left->addWidget(in.tray);
  middle->addLayout(left, 1);
  in.panel = new ScorePanel(this);
  in.sound = new GoSound(*in.panel->handpiece(), this);
  connect(in.panel->handpiece(), &HandpiecePanel::coolant_changed, this, [this](bool on) {
    if (inner_->go && inner_->go->run) inner_->go->run->set_coolant(on);
  });
  middle->addWidget(in.panel);
  column->addLayout(middle, 1);

  in.busy = new Busy(in.stage);
  in.busy->hide();
  in.stage->set_centre(in.busy);
  in.stage->view()->set_stats(&in.stats);
  in.stage->view()->installEventFilter(this);

  in.homing = new HomingCard(in.stage);
  in.opening_timer.setInterval(kLookMs);
  connect(&in.opening_timer, &QTimer::timeout, this, &DrillScreen::show_opening);
  in.look_timer.setInterval(kLookMs);
  connect(&in.look_timer, &QTimer::timeout, this, &DrillScreen::look);
  const auto key = [this](const QKeySequence& keys, auto act) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, act);
  };
  key(QKeySequence(Qt::Key_BracketLeft), [this] { inner_->tray->step(-1); });
  key(QKeySequence(Qt::Key_BracketRight), [this] { inner_->tray->step(+1); });
  key(QKeySequence(Qt::CTRL | Qt::Key_P), [this] { inner_->panel->setVisible(!inner_->panel->isVisible()); });
  key(QKeySequence(Qt::CTRL | Qt::Key_Enter), [this] { ask_finish(); });
  key(QKeySequence(Qt::CTRL | Qt::Key_Space), [this] {
    announce(this, (inner_->stage->spoken() + u' ' + inner_->panel->handpiece()->spoken()).trimmed());
  });
  enable_controls(false);
}

void DrillScreen::use_device(DeviceChoice choice) { inner_->choice = std::move(choice); }

void DrillScreen::show_opening() {
  Inner& in = *inner_;
  if (!in.opening) return;
  if (in.opening->called_off()) in.opening->call_off();
  FalconPort* falcon = in.opening->falcon();
  if (falcon == nullptr) return;
  in.busy->finish();
  in.homing->show_falcon(falcon->view());
}

DrillScreen::~DrillScreen() {
  inner_->opening.reset();  // whoever closes the window while a Falcon waits for a hand does not wait for it
  if (inner_->worker.joinable()) inner_->worker.join();
  // A go that was just started and not yet taken over ends here, while the view that it asks for frames still stands.
  QCoreApplication::removePostedEvents(this, QEvent::MetaCall);
  inner_->look_timer.stop();
  // The view outlives the go by a moment: nothing may be asked of it any more.
  inner_->stage->view()->set_bur_source({});
  inner_->stage->view()->set_stats(nullptr);
  inner_->input.reset();
  if (inner_->go) inner_->go->run.reset();
}

void DrillScreen::keep_sound_in(Settings* settings) { inner_->sound->keep_in(settings); }
bool DrillScreen::running() const { return inner_->go && inner_->go->run && !inner_->over; }
ToothView* DrillScreen::view() const { return inner_->stage->view(); }

void DrillScreen::enable_controls(bool on) {
  inner_->bar->enable_go(on);
  inner_->tray->setEnabled(on);
  inner_->stage->enable_tools(on);
}

void DrillScreen::begin(RunPlan plan, const DrillText& text, std::unique_ptr<HapticPort> port) {
  Inner& in = *inner_;
  in.bar->set_exercise(text.title, text.aside);
  in.tray->set_burs(plan.scenario.instruments);
  in.working = true;
  in.busy->start(tr("Getting the tooth ready"), Busy::Cancel::none);
  in.opening = std::make_unique<GoOpening>(
      GoOpening::Order{std::move(plan), in.choice, std::move(port),
                       [view = QPointer<ToothView>(in.stage->view())] {
                         if (view) view->feed_changed();
                       }},
      // The opening is over before this screen goes, and what it has posted by then is taken back.
      [this](std::shared_ptr<OpenedGo> go, std::optional<RunFailure> failure) {
        QMetaObject::invokeMethod(
            this, [this, go = std::move(go), failure = std::move(failure)]() mutable { opened(std::move(go), failure); },
            Qt::QueuedConnection);
      });
  in.opening_timer.start();
}

void DrillScreen::opened(std::shared_ptr<OpenedGo> opened, const std::optional<RunFailure>& failure) {
  Inner& in = *inner_;
  in.working = false;
  in.busy->finish();
  in.opening_timer.stop();
  in.homing->hide();
  const bool called_off = in.opening && in.opening->called_off();
  in.opening.reset();
  if (failure) {
    in.over = true;
    if (called_off) {
      Q_EMIT left();
    } else {
      Q_EMIT failed(*failure);
    }
    return;
  }
  in.go = std::move(opened);
  OpenedGo& go = *in.go;
  const Scenario& scenario = go.run->scenario();
  const bool is_tooth = !scenario.specimen.generator.ends_with("block");
  in.panel->set_exercise(scenario, !go.look->empty(), go.has_pulp, is_tooth);
  in.panel->set_device(go.run->device(), go.run->stiffness_share());
  in.bar->set_device(go.run->device());
  in.sound->begin(scenario);
  in.stage->set_exercise(scenario, *go.look, go.bounds, go.device.hand != nullptr, is_tooth, go.pulp_depth_mm);
  ToothView* view = in.stage->view();
  view->set_feed(go.patches);
  view->set_scenery(go.scenery);
  view->set_lines(go.lines);
  view->set_bur_source([this, view]() -> std::optional<BurPose> {
    if (!running() || inner_->working) return view->scene().bur;
    const Scene& scene = *inner_->go->run->scene();
    const LiveView live = inner_->go->run->view();
    const StepOutput& out = live.output;
    const Bur& bur = scene.burs[std::min<std::size_t>(out.bur, scene.burs.size() - 1)];
    return BurPose{bur, out.proxy_mm, out.tick > 0 ? out.axis : scene.tool_axis, out.cutting && !stands_still(live)};
  });
  if (go.device.hand) {
    // An emulated Falcon has three axes: it cannot turn the handpiece.
    go.device.hand->set_turn_limit(go.device.emulated == nullptr ? scenario.tool_turn_deg : 0.0);
    in.input = std::make_unique<PointerInput>(*view, *go.device.hand, go.run->scene()->tool_axis,
                                              std::clamp(kUsualShare * scenario.device.full_force_n, kLeastUsualN,
                                                         PointerHand::kMaxPushN),
                                              nullptr);
    connect(in.input.get(), &PointerInput::push_changed, in.stage, &DrillStage::show_wanted_push);
    in.stage->show_wanted_push(in.input->push_n());
  }
  enable_controls(true);
  in.look_timer.start();
  setFocus();
}

void DrillScreen::look() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  in.live = in.go->run->view();
  in.sound->follow(in.live, *in.go->run->scene());
  in.stage->view()->follow_bur(kFollow);
  if (auto image = in.go->feed->take_panel()) in.panel->section()->show_image(*image);
  if (auto image = in.go->feed->take_lid()) in.stage->show_cutaway(std::move(*image));
  if (in.looks++ % kTextEvery != 0) return;
  in.bar->set_seconds(in.live.seconds);
  in.panel->show_values(in.live);
  in.tray->choose(in.live.output.bur);
  in.bar->show_grant(in.live.grant);
  in.stage->show_values(in.live, in.go->device.falcon != nullptr ? &in.go->device.falcon->view() : nullptr);
  const bool stopped = in.live.phase == LoopPhase::paused || in.live.phase == LoopPhase::held;
  if (in.input) in.input->set_enabled(!stopped);
  in.bar->set_stopped(stopped);
  // The clock of the exercise has run out, or inputs could not be kept: the go is graded as it stands.
  const bool behind = in.live.end == LoopEnd::ring_full;
  if (behind) in.stage->show_stopped(DrillStage::Stop::behind);
  if (const double limit = in.go->run->scenario().time_limit_s; behind || (limit > 0 && in.live.seconds >= limit)) finish_now();
}

void DrillScreen::toggle_pause() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  if (in.live.phase == LoopPhase::paused || in.live.phase == LoopPhase::held) {
    in.go->run->resume();
    setFocus();
  } else {
    if (in.input) in.input->let_go();
    in.go->run->pause();
  }
}

void DrillScreen::ask_finish() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  if (in.input) in.input->let_go();
  in.stage->set_asking(true);
  in.go->run->pause();
  in.ports.ask(this, {tr("Finish and see the result?"), tr("The tooth is measured as it is now."), tr("Finish")},
               [self = QPointer(this)](bool yes) {
                 if (!self || !self->running()) return;
                 self->inner_->stage->set_asking(false);
                 if (yes) {
                   self->finish_now();
                 } else {
                   self->inner_->go->run->resume();
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
  in.worker = std::thread([this, run = in.go->run.get()] {
    auto result = std::make_shared<Run<RunResult>>(run->finish());
    QMetaObject::invokeMethod(this, [this, result] { graded(result); }, Qt::QueuedConnection);
  });
}

void DrillScreen::graded(const std::shared_ptr<Run<RunResult>>& result) {
  Inner& in = *inner_;
  if (in.worker.joinable()) in.worker.join();
  in.working = false;
  in.busy->finish();
  in.bar->enable_leave(true);
  if (!*result && result->error().code == RunError::recording_failed) {
    // The disk may come back: nothing is lost while this screen stands.
    in.stage->show_stopped(DrillStage::Stop::record, tell(result->error()));
    in.bar->enable_finish(true);
    return;
  }
  in.over = true;
  in.stage->view()->set_bur_source({});
  in.go->run.reset();
  if (*result) {
    Q_EMIT finished(std::make_shared<const RunResult>(std::move(**result)));
  } else {
    Q_EMIT failed(result->error());
  }
}

void DrillScreen::ask_leave() {
  Inner& in = *inner_;
  if (in.opening) in.opening->call_off();
  if (in.working) return;
  if (!running()) {
    Q_EMIT left();
    return;
  }
  const auto leave = [self = QPointer(this)](bool yes) {
    if (!self || !self->running()) return;
    Inner& inner = *self->inner_;
    inner.stage->set_asking(false);
    if (!yes) {
      inner.go->run->resume();
      self->setFocus();
      return;
    }
    inner.look_timer.stop();
    inner.sound->stop();
    inner.stats.write_where_asked();
    inner.over = true;
    inner.stage->view()->set_bur_source({});
    inner.go->run->abandon();
    inner.go->run.reset();
    Q_EMIT self->left();
  };
  if (in.input) in.input->let_go();
  double removed = 0;
  for (const double mm3 : in.go->run->view().removed_mm3) removed += mm3;
  if (removed <= 0) return leave(true);
  in.stage->set_asking(true);
  in.go->run->pause();
  in.ports.ask(this,
               {tr("Leave this go?"),
                in.live.recording == RecordingState::off ? tr("Nothing of it is kept.")
                                                         : tr("It stays in your results as interrupted."),
                tr("Leave"), true},
               leave);
}

void DrillScreen::keyPressEvent(QKeyEvent* event) {
  Inner& in = *inner_;
  if (event->key() == Qt::Key_Escape) return ask_leave();
  if (in.input && !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) &&
      in.input->press_key(event->key(), event->isAutoRepeat()))
    return;
  if (event->modifiers() == Qt::NoModifier && in.stage->press_tool(event->key())) return;
  QWidget::keyPressEvent(event);
}

void DrillScreen::keyReleaseEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  if (inner_->input && inner_->input->release_key(event->key())) return;
  QWidget::keyReleaseEvent(event);
}

void DrillScreen::focusOutEvent(QFocusEvent* event) {
  // Another widget or window, or a menu, gets what follows: a key that is let go there is never told here.
  if (inner_->input) inner_->input->let_go();
  QWidget::focusOutEvent(event);
}

bool DrillScreen::eventFilter(QObject* watched, QEvent* event) {
  // A click on the tooth brings the keys back to drilling.
  if (event->type() == QEvent::MouseButtonPress) setFocus(Qt::MouseFocusReason);
  return QWidget::eventFilter(watched, event);
}

}  // namespace cusp::ui
