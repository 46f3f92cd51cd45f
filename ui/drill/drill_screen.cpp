#include "ui/drill/drill_screen.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QPointer>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/drill/drill_screen_inner.h"
#include "ui/drill/section_view.h"
#include "ui/session/bur_depth.h"
#include "ui/settings/settings.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kFoldsBelowWidth = 800, kFoldsBelowHeight = 480;  // px at 100 %: panel and tray to titles and numbers
constexpr int kLookMs = 33;           // bur and clock
constexpr int kTextEvery = 3;         // looks between two of texts and gauges, about ten a second
constexpr std::chrono::milliseconds kFollow{30};
constexpr double kUsualShare = 0.53;  // of full force: 0.8 N where that is 1.5, about what a handpiece is led with
constexpr double kLeastUsualN = 0.4;
constexpr double kSpecimenShare = 0.8, kSceneryShare = 0.9, kDeviceShare = 0.95;  // of the way to the attempt

/// Of the bur's head above the target's floor under it; nullopt: no target there.
std::optional<double> above_floor_mm(const LiveView& live, const OpenedAttempt& attempt) {
  if (attempt.look->empty()) return std::nullopt;
  const TargetShape& shape = attempt.look->shape();
  const Vec3 at = live.output.proxy_mm;
  const auto floor_mm = floor_under_mm(shape, {at.x, at.y});
  return floor_mm ? std::optional(shape.top_mm() - *floor_mm - live.bur_depth_mm) : std::nullopt;
}

}  // namespace

DrillScreen::DrillScreen(Ports ports, QWidget* parent) : QWidget(parent), inner_(std::make_unique<Inner>()) {
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
  make_main(*column);

  in.busy = new Busy(in.stage);
  connect(in.busy, &Busy::cancelled, this, &DrillScreen::ask_leave);
  in.busy->hide();
  in.stage->set_centre(in.busy);
  in.stage->view()->set_stats(&in.stats);
  in.stage->view()->installEventFilter(this);
  connect(in.stage->view(), &ToothView::feed_shown, this, &DrillScreen::tooth_shown);
  connect(in.stage->view(), &ToothView::drawing_failed, this, &DrillScreen::stop_undrawn);

  in.homing = new HomingCard(in.stage);
  in.opening_timer.setInterval(kLookMs);
  connect(&in.opening_timer, &QTimer::timeout, this, &DrillScreen::show_opening);
  in.look_timer.setInterval(kLookMs);
  connect(&in.look_timer, &QTimer::timeout, this, &DrillScreen::look);
  make_keys();
  fold(true);  // a window that is too narrow for the whole would grow before it is folded
  enable_controls(false);
}

/// Stage and tray at the left, the panel at the right.
void DrillScreen::make_main(QVBoxLayout& column) {
  Inner& in = *inner_;
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  in.stage = new DrillStage(this);
  connect(in.stage, &DrillStage::go_on, this, &DrillScreen::toggle_pause);
  connect(in.stage, &DrillStage::finish_again, this, &DrillScreen::finish_now);
  connect(in.stage, &DrillStage::leave, this, &DrillScreen::ask_leave);
  connect(in.stage, &DrillStage::sections_wanted, this,
          [this](const std::optional<SectionWish>& panel, const std::optional<SectionWish>& lid) {
            if (inner_->attempt) inner_->attempt->feed->want_sections(panel, lid);
          });
  left->addWidget(in.stage, 1);
  in.tray = new BurTray(this);
  connect(in.tray, &BurTray::bur_chosen, this, [this](int index) {
    if (inner_->attempt && inner_->attempt->session) inner_->attempt->session->change_bur(static_cast<std::size_t>(index));
    if (inner_->input) inner_->input->forget_depth();  // another head stands on another pivot
    if (inner_->attempt && inner_->attempt->device.hand) inner_->attempt->device.hand->set_bur(static_cast<std::uint16_t>(index));
  });
  left->addWidget(in.tray);
  middle->addLayout(left, 1);
  in.panel = new ScorePanel(this);
  in.sound = new AttemptSound(*in.panel->handpiece(), this);
  connect(in.panel->handpiece(), &HandpiecePanel::coolant_changed, this, [this](bool on) {
    if (inner_->attempt && inner_->attempt->session) inner_->attempt->session->set_coolant(on);
  });
  middle->addWidget(in.panel);
  column.addLayout(middle, 1);
}

bool DrillScreen::is_small() const { return width() < px(kFoldsBelowWidth) || height() < px(kFoldsBelowHeight); }

void DrillScreen::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fold(is_small());
}

void DrillScreen::fold(bool on) {
  // An assessment has neither section nor bars: the task fits the folded panel.
  inner_->panel->fold(on || inner_->guidance == Guidance::silent);
  inner_->tray->fold(on);
}

void DrillScreen::make_keys() {
  const auto key = [this](const QKeySequence& keys, auto act) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, act);
  };
  key(QKeySequence(Qt::Key_BracketLeft), [this] { inner_->tray->step(-1); });
  key(QKeySequence(Qt::Key_BracketRight), [this] { inner_->tray->step(+1); });
  key(QKeySequence(Qt::CTRL | Qt::Key_P), [this] {
    if (inner_->panel->isAncestorOf(focusWidget())) setFocus();  // else Qt gives the keys to the next button
    inner_->panel->setVisible(!inner_->panel->isVisible());
  });
  key(QKeySequence(Qt::CTRL | Qt::Key_Enter), [this] { ask_finish(); });
  key(QKeySequence(Qt::CTRL | Qt::Key_Space), [this] {
    announce(this, (inner_->stage->spoken() + u' ' + inner_->panel->handpiece()->spoken()).trimmed());
  });
}

void DrillScreen::use_device(DeviceChoice choice) { inner_->choice = std::move(choice); }
void DrillScreen::watch_pedal(std::function<bool()> plugged) { inner_->pedal_plugged = std::move(plugged); }
void DrillScreen::use_teeth(std::shared_ptr<ToothCache> teeth) { inner_->teeth = std::move(teeth); }

void DrillScreen::show_progress() {
  const AttemptOpening::Progress now = inner_->opening->progress();
  // A tooth that is read from the cache has no share: its parts follow at once.
  const QString percent = now.share > 0 ? QLocale().toString(qRound(100 * now.share)) + QChar(0x00A0) + u'%' : QString();
  QString part = tr("Starting the attempt");
  double share = kDeviceShare;
  if (now.part == ToothPart::specimen) {
    part = percent.isEmpty() ? tr("Fetching the tooth") : tr("Growing the tooth: %1").arg(percent);
    share = std::max(now.share, 0.0) * kSpecimenShare;
  } else if (now.part == ToothPart::mesh) {
    part = tr("Shaping the tooth’s surface");
    share = kSpecimenShare;  // the specimen is there
  } else if (now.part == ToothPart::scenery) {
    part = tr("Growing the other teeth of the jaw");
    share = kSceneryShare;
  }
  inner_->busy->set_progress(share, part);
}

void DrillScreen::show_opening() {
  Inner& in = *inner_;
  if (!in.opening) return;
  if (in.opening->called_off()) return in.opening->call_off();
  FalconPort* falcon = in.opening->falcon();
  if (falcon != nullptr && in.homing->show_falcon(falcon->view())) return in.busy->finish();
  if (!in.busy->running()) in.busy->start(tr("Starting the attempt"), Busy::Cancel::offered);
  show_progress();
}

DrillScreen::~DrillScreen() {
  inner_->opening.reset();  // whoever closes the window while a Falcon waits for a hand does not wait for it
  if (inner_->worker.joinable()) inner_->worker.join();
  // An attempt that was just started and not yet taken over ends here, while the view that it asks for frames still stands.
  QCoreApplication::removePostedEvents(this, QEvent::MetaCall);
  inner_->look_timer.stop();
  // The view outlives the attempt by a moment: nothing may be asked of it any more.
  inner_->stage->view()->set_bur_source({});
  inner_->stage->view()->set_stats(nullptr);
  inner_->input.reset();
  if (inner_->attempt) inner_->attempt->session.reset();
}

void DrillScreen::keep_settings_in(Settings* settings) {
  inner_->sound->keep_in(settings);
  inner_->stage->show_handpiece(settings->handpiece_shown());
  inner_->stage->view()->set_hand(settings->left_handed() ? HandSide::left : HandSide::right);
  connect(inner_->stage, &DrillStage::handpiece_switched, this, [settings](bool shown) { settings->set_handpiece_shown(shown); });
}
bool DrillScreen::running() const { return inner_->attempt && inner_->attempt->session && !inner_->over; }
bool DrillScreen::working() const { return inner_->working; }
ToothView* DrillScreen::view() const { return inner_->stage->view(); }

void DrillScreen::enable_controls(bool on) {
  inner_->bar->enable_pause(on);
  inner_->tray->setEnabled(on);
  inner_->stage->enable_tools(on);
}

void DrillScreen::begin(SessionPlan plan, const DrillText& text, std::unique_ptr<HapticPort> port) {
  Inner& in = *inner_;
  in.bar->set_exercise(text.title, text.aside);
  in.guidance = plan.guidance;
  in.bar->offer_pause(in.guidance == Guidance::full);
  in.leave_code = QString::fromStdString(plan.start_code);
  fold(is_small());
  in.tray->set_burs(plan.scenario.instruments);
  in.working = true;
  in.busy->start(tr("Getting the tooth ready"), Busy::Cancel::offered);
  in.opening = std::make_unique<AttemptOpening>(
      AttemptOpening::Order{std::move(plan), in.choice, std::move(port), in.teeth,
                            [view = QPointer<ToothView>(in.stage->view())] {
                              if (view) view->feed_changed();
                            }},
      // The opening is over before this screen goes, and what it has posted by then is taken back.
      [this](std::shared_ptr<OpenedAttempt> attempt, std::optional<SessionFailure> failure) {
        QMetaObject::invokeMethod(
            this, [this, attempt = std::move(attempt), failure = std::move(failure)]() mutable { opened(std::move(attempt), failure); },
            Qt::QueuedConnection);
      });
  in.opening_timer.start();
}

void DrillScreen::opened(std::shared_ptr<OpenedAttempt> opened, const std::optional<SessionFailure>& failure) {
  Inner& in = *inner_;
  in.opening_timer.stop();
  in.homing->hide();
  const bool called_off = in.opening && in.opening->called_off();
  in.opening.reset();
  if (failure) {
    in.working = false;
    in.busy->finish();
    in.over = true;
    if (called_off) return report_left();
    Q_EMIT failed(*failure);
    return;
  }
  in.attempt = std::move(opened);
  if (called_off) return leave_now();  // it had just started
  OpenedAttempt& attempt = *in.attempt;
  const Scenario& scenario = attempt.session->scenario();
  const bool is_tooth = !scenario.specimen.generator.ends_with("block");
  in.panel->set_exercise(scenario, {.target = !attempt.look->empty(), .pulp = attempt.has_pulp, .guidance = in.guidance,
                                    .names = attempt.session->scene()->specimen->names()});
  in.panel->set_device(attempt.session->device(), attempt.session->stiffness_share());
  in.bar->set_device(attempt.session->device());
  in.bar->set_time_limit(attempt.session->time_limit_s());
  in.sound->begin(scenario);
  in.stage->set_exercise(scenario, *attempt.look,
                         {.bounds = attempt.bounds,
                          .start_view = attempt.start_view,
                          .guidance = in.guidance,
                          .by_mouse = attempt.device.hand != nullptr,
                          .is_tooth = is_tooth,
                          .pulp_depth_mm = attempt.pulp_depth_mm});
  ToothView* view = in.stage->view();
  view->set_scenery(attempt.scenery);
  view->set_lines(attempt.lines);
  view->set_bur_source([this, view]() -> std::optional<BurPose> {
    if (!running() || inner_->working) return view->scene().bur;
    const Scene& scene = *inner_->attempt->session->scene();
    const LiveView live = inner_->attempt->session->view();
    const StepOutput& out = live.output;
    const Bur& bur = scene.burs[std::min<std::size_t>(out.bur, scene.burs.size() - 1)];
    return BurPose{bur, out.proxy_mm, out.tick > 0 ? out.axis : scene.tool_axis, out.cutting && !stands_still(live)};
  });
  if (attempt.device.hand) follow_pointer();
  in.unseen = true;
  hold_while_minimised();           // where no frame comes, look() does not begin
  view->set_feed(attempt.patches);  // feed_shown() goes on
}

/// Mouse and keys move the device's hand.
void DrillScreen::follow_pointer() {
  Inner& in = *inner_;
  OpenedAttempt& attempt = *in.attempt;
  const Scenario& scenario = attempt.session->scenario();
  // An emulated Falcon has three axes: it cannot turn the handpiece.
  attempt.device.hand->set_turn_limit(attempt.device.emulated == nullptr ? scenario.tool_turn_deg : 0.0);
  in.input = std::make_unique<PointerInput>(*in.stage->view(), *attempt.device.hand, attempt.session->scene()->tool_axis,
                                            std::clamp(kUsualShare * scenario.device.full_force_n, kLeastUsualN,
                                                       PointerHand::kMaxPushN),
                                            nullptr);
  connect(in.input.get(), &PointerInput::push_changed, in.stage, &DrillStage::show_wanted_push);
  in.stage->show_wanted_push(in.input->push_n());
  connect(in.input.get(), &PointerInput::depth_held, in.stage, &DrillStage::show_depth_held);
  connect(in.stage, &DrillStage::depth_hold_wanted, in.input.get(), &PointerInput::hold_depth);
}

/// Before the tooth is seen, a press would meet nothing and put the bur elsewhere.
void DrillScreen::tooth_shown() {
  Inner& in = *inner_;
  in.unseen = false;
  if (in.over) return;
  in.working = false;
  in.busy->finish();
  enable_controls(true);
  in.hand.count_input();
  in.look_timer.start();
  setFocus();
  if (in.stage->undrawn()) stop_undrawn();
}

/// Nobody sees where the bur cuts: the attempt stands, until a start with pictures continues it.
void DrillScreen::stop_undrawn() {
  Inner& in = *inner_;
  in.stood = true;
  in.stage->set_undrawn();
  if (!running() || in.working) return;
  if (in.input) in.input->release_all();
  in.attempt->session->pause();
}

void DrillScreen::look() {
  Inner& in = *inner_;
  if (!running() || in.working) return;
  in.live = in.attempt->session->view();
  in.live.cut_ignored = in.live.cut_ignored || (in.input && in.input->ignores_cut());
  if (in.asked && in.live.device == Sample::Status::gone) in.stood = true;
  hold_while_minimised();
  in.sound->follow(in.live, *in.attempt->session->scene());
  in.stage->view()->follow_bur(kFollow);
  const Vec3 bur_mm = in.live.output.proxy_mm;
  in.stage->follow_bur(bur_mm, in.input && !stands_still(in.live) ? in.input->hand_mm(bur_mm) : std::nullopt);
  if (in.input) in.input->follow_bur(in.live.output.proxy_mm, above_floor_mm(in.live, *in.attempt));
  if (auto image = in.attempt->feed->take_panel()) in.panel->section()->show_image(*image);
  if (auto image = in.attempt->feed->take_lid()) in.stage->show_cutaway(std::move(*image));
  if (in.looks++ % kTextEvery != 0) return;
  in.bar->set_seconds(in.live.seconds);
  if (in.live.time_is_up) return finish_now();  // the session holds itself at its time limit
  in.panel->show_values(in.live);
  if (in.pedal_plugged) in.panel->show_pedal(in.pedal_plugged());
  in.tray->show_burs(stands_still(in.live) ? in.live.wanted_bur : in.live.output.bur, in.live.wanted_bur);
  in.bar->show_grant(in.live.grant);
  const InversePort* inverse3 = in.attempt->device.inverse;
  in.stage->set_handle_gone(inverse3 != nullptr && inverse3->view().session.trouble == inverse::Trouble::no_handle);
  in.stage->show_values(in.live, in.attempt->device.falcon != nullptr ? &in.attempt->device.falcon->view() : nullptr);
  const bool stopped = in.live.phase == LoopPhase::paused || in.live.phase == LoopPhase::held;
  if (in.input) in.input->set_enabled(!stopped && !in.asked);
  in.bar->set_stopped(stopped);
  keep_awake();
  in.bar->enable_pause(!in.live.silent && !in.stage->undrawn());
  // Inputs could not be kept: the attempt is graded as it stands.
  if (in.live.end == LoopEnd::ring_full) finish_now();
}

void DrillScreen::toggle_pause() {
  Inner& in = *inner_;
  if (!running() || in.working || in.stage->undrawn()) return;
  if (in.live.phase == LoopPhase::paused || in.live.phase == LoopPhase::held) {
    in.attempt->session->resume();
    setFocus();
  } else if (in.guidance == Guidance::full) {
    if (in.input) in.input->set_enabled(false);
    in.attempt->session->pause();
  }
}

/// A shortcut that is held acts once: else a key held too long would pause and resume in turn.
bool DrillScreen::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride || !static_cast<QKeyEvent*>(event)->isAutoRepeat()) return QWidget::event(event);
  event->accept();  // it comes as a key press, which does nothing
  return true;
}

void DrillScreen::keyPressEvent(QKeyEvent* event) {
  Inner& in = *inner_;
  const bool is_tool = event->key() >= Qt::Key_1 && event->key() <= Qt::Key_6;
  if (event->isAutoRepeat() && (is_tool || event->key() == Qt::Key_Escape)) return;
  if (event->key() == Qt::Key_Escape) return ask_leave();
  const bool arrow = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_Down;  // with Ctrl it turns the handpiece
  if (in.input && !(event->modifiers() & (arrow ? Qt::KeyboardModifiers(Qt::AltModifier) : Qt::ControlModifier | Qt::AltModifier))) {
    using KeyPress = PointerInput::KeyPress;
    if (in.input->press_key(event->key(), event->isAutoRepeat() ? KeyPress::repeated : KeyPress::first)) return;
  }
  if (!(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) && in.stage->press_key(event->key(), event->modifiers())) return;
  if (event->modifiers() == Qt::NoModifier && !event->isAutoRepeat() && running() && in.panel->handpiece()->press_key(event->key())) return;
  QWidget::keyPressEvent(event);
}

void DrillScreen::keyReleaseEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  if (inner_->input && inner_->input->release_key(event->key())) return;
  QWidget::keyReleaseEvent(event);
}

void DrillScreen::focusOutEvent(QFocusEvent* event) {
  // Another widget or window, or a menu, gets what follows: this widget never hears of a key released there.
  if (inner_->input) inner_->input->release_all();
  QWidget::focusOutEvent(event);
}

bool DrillScreen::eventFilter(QObject* watched, QEvent* event) {
  // A click on the tooth brings the keys back to drilling.
  if (event->type() == QEvent::MouseButtonPress) setFocus(Qt::MouseFocusReason);
  return QWidget::eventFilter(watched, event);
}

}  // namespace cusp::ui
