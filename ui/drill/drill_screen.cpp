#include "ui/drill/drill_screen.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "scenarios/format/keys.h"
#include "ui/app/sentences.h"
#include "ui/app/settings.h"
#include "ui/device/homing_view.h"
#include "ui/drill/burr_tray.h"
#include "ui/drill/coach.h"
#include "ui/drill/drill_feed.h"
#include "ui/drill/drill_stage.h"
#include "ui/drill/frame_stats.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/drill/pointer_input.h"
#include "ui/drill/score_panel.h"
#include "ui/drill/tooth_view.h"
#include "ui/session/scene_builder.h"
#include "ui/sound/drill_sound.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp {
namespace {

constexpr int kLookMs = 33;           // burr and clock
constexpr int kHomingWidth = 420;     // px at 100 %
constexpr int kTextEvery = 3;         // looks between two of texts and gauges, about ten a second
constexpr std::chrono::milliseconds kFollow{30};
constexpr double kUsualShare = 0.53;  // of full force: 0.8 N where that is 1.5, about what a handpiece is led with
constexpr double kLeastUsualN = 0.4;
constexpr double kStartAboveMm = 1.5;

/// What the worker makes before the go starts, and hands to the window.
struct Opened {
  RunDevice device;
  std::shared_ptr<PatchFeed> patches;
  std::shared_ptr<DrillFeed> feed;
  std::vector<OverlayLine> lines;
  std::shared_ptr<TargetLook> look;
  std::shared_ptr<const SceneryLook> scenery;
  Box bounds;
  bool has_pulp = false;
  std::unique_ptr<ExerciseRun> run;
};

/// A Falcon that a worker opens, for the window to look at and to call off. The port lives in the worker's Opened, which
/// comes to the window whole, or the pointer is taken back first.
struct Opening {
  std::atomic<FalconPort*> falcon{nullptr};
  std::atomic<bool> left{false};
  std::atomic<bool> over{false};  // the worker has nothing more to do with the device
};

/// Place above the target where the burr begins, clear of all tissue.
Vec3 start_place(const Specimen& specimen, const TargetLook& look, const Burr& burr) {
  const Grid& grid = specimen.grid();
  const Vec3 top = grid.centre_mm(grid.size);
  Vec3 at = 0.5 * (grid.origin_mm + top);
  if (!look.empty()) {
    at.x = 0.5 * (look.shape().low().x + look.shape().high().x);
    at.y = 0.5 * (look.shape().low().y + look.shape().high().y);
  }
  at.z = top.z + burr.radius_mm + kStartAboveMm;
  return at;
}

}  // namespace

struct DrillScreen::Inner {
  Ports ports;
  // Widgets.
  QLabel *title, *aside, *clock, *device;
  QPushButton *leave, *pause, *finish;
  DrillStage* stage;
  ScorePanel* panel;
  BurrTray* tray;
  Busy* busy;
  QTimer look_timer;
  DrillSound* sound;
  Settings* settings = nullptr;

  // The go.
  DeviceChoice choice;
  std::shared_ptr<Opening> opening;  // while the worker opens the device
  QFrame* homing_card;
  HomingView* homing;
  QTimer opening_timer;
  std::shared_ptr<Opened> go;
  std::unique_ptr<PointerInput> input;
  std::thread worker;
  FrameStats stats;
  LiveView live;
  int looks = 0;
  bool paused = false, working = false, over = false;
  LoopPhase shown_phase = LoopPhase::ready;
  bool told_priority = false;
};

DrillScreen::DrillScreen(QWidget* parent, Ports ports) : QWidget(parent), inner_(std::make_unique<Inner>()) {
  Inner& in = *inner_;
  in.ports = std::move(ports);
  set_kind(this, "page");
  setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);

  auto* bar = new QFrame(this);
  set_kind(bar, "bar_top");
  bar->setFixedHeight(px(48));
  auto* top = new QHBoxLayout(bar);
  top->setContentsMargins(px(12), 0, px(12), 0);
  top->setSpacing(px(12));
  in.leave = make_button(tr("Leave"), ButtonKind::quiet, QStringLiteral("chevron_left"));
  connect(in.leave, &QPushButton::clicked, this, &DrillScreen::ask_leave);
  top->addWidget(in.leave);
  QFrame* rule = make_rule(Qt::Vertical);
  rule->setFixedHeight(px(32));
  top->addWidget(rule, 0, Qt::AlignVCenter);
  in.title = make_label({}, TextRole::section, true);
  in.aside = make_label({});
  set_kind(in.aside, "tag");
  top->addWidget(in.title);
  top->addWidget(in.aside, 0, Qt::AlignVCenter);
  top->addStretch(1);
  auto* clock_sign = new QLabel(bar);
  clock_sign->setPixmap(icon_pixmap(QStringLiteral("clock"), Ink::text2, 16, devicePixelRatioF()));
  in.clock = make_label(format_clock(0), TextRole::live, true);
  in.clock->setAccessibleDescription(tr("Time"));
  in.clock->setMinimumWidth(QFontMetrics(font_of(TextRole::live, true)).horizontalAdvance(QStringLiteral("00:00:00")));
  top->addWidget(clock_sign);
  top->addWidget(in.clock);
  top->addStretch(1);
  in.device = make_label({}, TextRole::body, false, "text2");
  top->addWidget(in.device, 0, Qt::AlignVCenter);
  in.pause = make_button(tr("Pause"), ButtonKind::standard, QStringLiteral("pause"), QKeySequence(Qt::Key_P));
  connect(in.pause, &QPushButton::clicked, this, &DrillScreen::toggle_pause);
  top->addWidget(in.pause);
  in.finish = make_button(tr("Finish"), ButtonKind::primary, QStringLiteral("flag"),
                          QKeySequence(Qt::CTRL | Qt::Key_Return));
  connect(in.finish, &QPushButton::clicked, this, &DrillScreen::ask_finish);
  top->addWidget(in.finish);
  column->addWidget(bar);

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
  in.tray = new BurrTray(this);
  connect(in.tray, &BurrTray::burr_chosen, this, [this](int index) {
    if (inner_->go && inner_->go->run) inner_->go->run->change_burr(static_cast<std::size_t>(index));
    if (inner_->go && inner_->go->device.hand) inner_->go->device.hand->set_burr(static_cast<std::uint16_t>(index));
  });
  left->addWidget(in.tray);
  middle->addLayout(left, 1);
  in.panel = new ScorePanel(this);
  in.sound = new DrillSound(this);
  connect(in.panel->handpiece(), &HandpiecePanel::coolant_changed, this, [this](bool on) {
    if (inner_->go && inner_->go->run) inner_->go->run->set_coolant(on);
  });
  connect(in.panel->handpiece(), &HandpiecePanel::volume_changed, this, [this](int percent) {
    inner_->sound->set_volume(percent);
    if (inner_->settings) inner_->settings->set_volume_percent(percent);
  });
  connect(in.panel->handpiece(), &HandpiecePanel::muted_changed, this, [this](bool muted) {
    inner_->sound->set_muted(muted);
    if (inner_->settings) inner_->settings->set_muted(muted);
  });
  middle->addWidget(in.panel);
  column->addLayout(middle, 1);

  in.busy = new Busy(in.stage);
  in.busy->hide();
  in.stage->set_centre(in.busy);
  in.stage->view()->set_stats(&in.stats);
  in.stage->view()->installEventFilter(this);

  in.homing_card = new Card(this);
  in.homing = new HomingView(in.homing_card);
  in.homing->setFixedWidth(px(kHomingWidth));
  static_cast<Card*>(in.homing_card)->body()->addWidget(in.homing);
  in.homing_card->hide();
  in.opening_timer.setInterval(kLookMs);
  connect(&in.opening_timer, &QTimer::timeout, this, &DrillScreen::show_opening);
  in.look_timer.setInterval(kLookMs);
  connect(&in.look_timer, &QTimer::timeout, this, [this] { look(); });
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
  FalconPort* falcon = in.opening->falcon.load(std::memory_order_acquire);
  if (falcon == nullptr) return;
  if (in.opening->left.load()) falcon->cancel();
  in.homing->show_falcon(falcon->view());
  if (!in.homing_card->isVisible()) {
    in.busy->finish();
    in.homing_card->show();
  }
  in.homing_card->adjustSize();
  in.homing_card->move((width() - in.homing_card->width()) / 2, (height() - in.homing_card->height()) / 2);
  in.homing_card->raise();
}

DrillScreen::~DrillScreen() {
  // Whoever closes the window while a Falcon waits for a hand does not wait for it.
  while (inner_->opening && inner_->worker.joinable() && !inner_->opening->over.load(std::memory_order_acquire)) {
    if (FalconPort* falcon = inner_->opening->falcon.load(std::memory_order_acquire)) falcon->cancel();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (inner_->worker.joinable()) inner_->worker.join();
  // A go that was just started and not yet taken over ends here, while the view that it asks for frames still stands.
  QCoreApplication::removePostedEvents(this, QEvent::MetaCall);
  inner_->look_timer.stop();
  // The view outlives the go by a moment: nothing may be asked of it any more.
  inner_->stage->view()->set_burr_source({});
  inner_->stage->view()->set_stats(nullptr);
  inner_->input.reset();
  if (inner_->go) inner_->go->run.reset();
}

void DrillScreen::keep_sound_in(Settings* settings) { inner_->settings = settings; }

bool DrillScreen::running() const { return inner_->go && inner_->go->run && !inner_->over; }

ToothView* DrillScreen::view() const { return inner_->stage->view(); }

void DrillScreen::enable_controls(bool on) {
  inner_->pause->setEnabled(on);
  inner_->finish->setEnabled(on);
  inner_->tray->setEnabled(on);
  inner_->stage->enable_tools(on);
}

void DrillScreen::begin(RunPlan plan, const DrillText& text, std::unique_ptr<HapticPort> port) {
  Inner& in = *inner_;
  in.title->setText(text.title);
  in.aside->setText(text.aside);
  in.aside->setVisible(!text.aside.isEmpty());
  in.tray->set_burrs(plan.scenario.instruments);
  in.working = true;
  in.busy->start(tr("Getting the tooth ready"), false);
  // Qt's pointer guards the answer: the worker is joined before this screen goes.
  in.opening = std::make_shared<Opening>();
  auto answer = [this, opening = in.opening](std::shared_ptr<Opened> go, std::optional<RunFailure> failure) {
    opening->over.store(true, std::memory_order_release);
    QMetaObject::invokeMethod(
        this, [this, go = std::move(go), failure = std::move(failure)]() mutable { opened(std::move(go), failure); },
        Qt::QueuedConnection);
  };
  QPointer<ToothView> view = in.stage->view();
  auto shared_port = std::make_shared<std::unique_ptr<HapticPort>>(std::move(port));
  in.opening_timer.start();
  in.worker = std::thread([plan = std::move(plan), shared_port, answer, view, choice = in.choice, opening = in.opening]() mutable {
    auto go = std::make_shared<Opened>();
    // Beside the specimen: a jaw's other teeth take as long as its own.
    std::jthread beside([&go = *go, source = plan.scenario.specimen] { go.scenery = scenery_of(source); });
    auto specimen = plan.specimen ? Run<std::shared_ptr<const Specimen>>(plan.specimen)
                                  : build_specimen(plan.scenario, plan.scenario_folder);
    if (!specimen) return answer(nullptr, specimen.error());
    plan.specimen = *specimen;
    go->look = std::make_shared<TargetLook>(plan.scenario.target, plan.scenario.leeway);
    go->patches = std::make_shared<PatchFeed>(go->look->feed());
    {
      const Volume whole(*specimen);
      go->patches->build_all(whole);
      go->lines = go->look->lines(whole);
    }
    const Grid& grid = (*specimen)->grid();
    go->bounds = {grid.origin_mm, grid.centre_mm(grid.size)};
    for (const ScenarioTissue& t : plan.scenario.tissues) go->has_pulp = go->has_pulp || t.tissue == Tissue::pulp;
    beside.join();
    go->feed = std::make_shared<DrillFeed>(go->patches, *go->look, [view] {
      if (view) view->feed_changed();
    }, go->scenery);
    plan.observers.push_back(go->feed.get());
    if (*shared_port) {
      go->device.port = std::move(*shared_port);
    } else {
      const Vec3 start =
          start_place(**specimen, *go->look, plan.scenario.instruments.empty() ? Burr() : plan.scenario.instruments[0]);
      auto device = make_run_device(choice, start, plan.scenario.instruments.size());
      if (!device) return answer(nullptr, std::move(run_fail(RunError::device, device.error()).error()));
      go->device = std::move(*device);
    }
    opening->falcon.store(go->device.falcon, std::memory_order_release);
    auto run = ExerciseRun::start(std::move(plan), *go->device.port);
    opening->falcon.store(nullptr, std::memory_order_release);
    if (!run) {
      // The window may hold the pointer for the length of one look: the port goes with the answer, on its thread.
      auto failed = run.error();
      return answer(std::move(go), std::move(failed));
    }
    go->run = std::move(*run);
    answer(std::move(go), std::nullopt);
  });
}

void DrillScreen::opened(std::shared_ptr<void> opaque, const std::optional<RunFailure>& failure) {
  Inner& in = *inner_;
  if (in.worker.joinable()) in.worker.join();
  in.working = false;
  in.busy->finish();
  in.opening_timer.stop();
  in.homing_card->hide();
  const bool called_off = in.opening && in.opening->left.load();
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
  in.go = std::static_pointer_cast<Opened>(opaque);
  Opened& go = *in.go;
  const Scenario& scenario = go.run->scenario();
  const bool is_tooth = !scenario.specimen.generator.ends_with("block");
  in.panel->set_exercise(scenario, !go.look->empty(), go.has_pulp, is_tooth);
  in.panel->set_device(go.run->device(), go.run->stiffness_share());
  in.device->setText(device_name(go.run->device().device_class));
  if (has_phenomenon(scenario.phenomena, "sound")) {
    const int volume = in.settings ? in.settings->volume_percent() : Settings::kUsualVolumePercent;
    const bool muted = in.settings && in.settings->muted();
    in.sound->set_volume(volume);
    in.sound->set_muted(muted);
    in.panel->handpiece()->set_sound(in.sound->start(), volume, muted);
  }
  in.stage->set_exercise(scenario, *go.look, go.bounds, go.device.hand != nullptr, is_tooth);
  ToothView* view = in.stage->view();
  view->set_feed(go.patches);
  view->set_scenery(go.scenery);
  view->set_lines(go.lines);
  view->set_burr_source([this]() -> std::optional<BurrPose> {
    if (!running() || inner_->working) return inner_->stage->view()->scene().burr;
    const Scene& scene = *inner_->go->run->scene();
    const StepOutput& out = inner_->go->run->view().output;
    return BurrPose{scene.burrs[std::min<std::size_t>(out.burr, scene.burrs.size() - 1)], out.proxy_mm,
                    out.tick > 0 ? out.axis : scene.tool_axis, out.cutting};
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
  const bool heard = in.live.phase == LoopPhase::running && in.sound->available();
  if (in.sound->available()) in.sound->follow(heard ? heard_of(in.live.output, *in.go->run->scene()) : DrillHeard{});
  in.stage->view()->follow_burr(kFollow);
  if (auto image = in.go->feed->take_panel()) in.panel->section()->show_image(*image);
  if (auto image = in.go->feed->take_lid()) in.stage->show_cutaway(std::move(*image));
  if (in.looks++ % kTextEvery != 0) return;
  const QString time = format_clock(in.live.seconds);
  if (time != in.clock->text()) in.clock->setText(time);
  in.panel->show_values(in.live);
  in.tray->choose(in.live.output.burr);
  // Only a device that pushes a hand suffers from late ticks; said as soon as the loop knows what it was granted.
  if (!in.told_priority && in.live.grant.refusal != RealtimeRefusal::not_asked) {
    in.told_priority = true;
    if (in.go->run->device().closed_loop && !in.live.grant.realtime()) {
      const Told told = tell(in.live.grant);
      in.device->setText(tr("%1, may be delayed").arg(device_name(in.go->run->device().device_class)));
      in.device->setToolTip(told.line());
      set_ink(in.device, "look");
      announce(this, told.line());
    }
  }
  in.stage->show_values(in.live);
  const bool stopped = in.live.phase == LoopPhase::paused || in.live.phase == LoopPhase::held;
  if (in.input) in.input->set_enabled(!stopped);
  if (in.live.phase != in.shown_phase) {
    in.shown_phase = in.live.phase;
    const QString act = stopped ? tr("Go on") : tr("Pause");
    in.pause->setIcon(icon(stopped ? QStringLiteral("play") : QStringLiteral("pause")));
    in.pause->setText(u' ' + act);  // as make_button: the style leaves no room after the sign
    in.pause->setAccessibleName(act);
    in.pause->setToolTip(QStringLiteral("%1 (%2)").arg(act, QKeySequence(Qt::Key_P).toString(QKeySequence::NativeText)));
    in.pause->setShortcut(Qt::Key_P);  // a new text takes the shortcut away
  }
  // The clock of the exercise has run out, or inputs could not be kept: the go is graded as it stands.
  const double limit = in.go->run->scenario().time_limit_s;
  const bool behind = in.live.end == LoopEnd::ring_full;
  if (behind) in.stage->show_stopped(DrillStage::Stop::behind);
  if (behind || (limit > 0 && in.live.seconds >= limit)) finish_now();
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
  in.leave->setEnabled(false);
  in.stats.write_where_asked();
  in.busy->start(tr("Measuring the tooth"), false);
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
  in.leave->setEnabled(true);
  if (!*result && result->error().code == RunError::recording_failed) {
    // The disk may come back: nothing is lost while this screen stands.
    in.stage->show_stopped(DrillStage::Stop::record, QString::fromStdString(result->error().where));
    in.finish->setEnabled(true);
    return;
  }
  in.over = true;
  in.stage->view()->set_burr_source({});
  in.go->run.reset();
  if (*result) {
    Q_EMIT finished(std::make_shared<const RunResult>(std::move(**result)));
  } else {
    Q_EMIT failed(result->error());
  }
}

void DrillScreen::ask_leave() {
  Inner& in = *inner_;
  if (in.opening) {
    in.opening->left.store(true);
    show_opening();
  }
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
    inner.stage->view()->set_burr_source({});
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

void DrillScreen::hideEvent(QHideEvent* event) {
  if (inner_->input) inner_->input->let_go();
  QWidget::hideEvent(event);
}

bool DrillScreen::eventFilter(QObject* watched, QEvent* event) {
  // A click on the tooth brings the keys back to drilling.
  if (event->type() == QEvent::MouseButtonPress) setFocus(Qt::MouseFocusReason);
  if (event->type() == QEvent::WindowDeactivate && inner_->input) inner_->input->let_go();
  return QWidget::eventFilter(watched, event);
}

}  // namespace cusp
