#include "ui/drill/drill_stage.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/teeth/landmarks.h"
#include "ui/drill/cut_slider.h"
#include "ui/drill/hand_ghost.h"
#include "ui/drill/depth_scale.h"
#include "ui/drill/mirror_hold.h"
#include "ui/session/bur_depth.h"
#include "ui/text/failure_text.h"
#include "ui/view/compass.h"
#include "ui/widgets/format.h"
#include "ui/widgets/line_sample.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr std::array<PresetView, 4> kTurns = {PresetView::working, PresetView::buccal, PresetView::distal,
                                              PresetView::lingual};
constexpr int kLeastWidth = 400, kLeastHeight = 264;  // px at 100 %: half of full HD at 150 % leaves 272
constexpr double kLidMm = 24.0, kWideLidMm = 44.0, kLidMmPerPx = 0.05;  // a tooth is 25 mm high, a row of three 34 long

QPushButton* tool(QWidget* parent, const QString& name, const QString& icon_name, int number) {
  QPushButton* out = make_button(name, ButtonKind::quiet, icon_name);
  out->setParent(parent);
  out->setFocusPolicy(Qt::TabFocus);
  out->setToolTip(QStringLiteral("%1 (%2)").arg(name).arg(number));
  return out;
}

}  // namespace

QFrame* DrillStage::make_card(QWidget* parent) {
  auto* out = new QFrame(parent);
  set_kind(out, "card");
  return out;
}

DrillStage::DrillStage(QWidget* parent) : QWidget(parent) {
  setMinimumSize(px(kLeastWidth), px(kLeastHeight));
  view_ = new ToothView(this);
  mirror_hold_ = new MirrorHold(*view_);
  hand_ghost_ = new HandGhost(*view_, this);
  make_tools();
  make_gauges();
  make_coach();
  make_legend();
  connect_tools();
  compass_ = new Compass(*view_, this);
  cut_ = new CutSlider(this);
  cut_->hide();
  connect(cut_, &CutSlider::moved, this, &DrillStage::want_sections);
  stop_card_ = new StopCard(this);
  connect(stop_card_, &StopCard::leave, this, &DrillStage::leave);
  connect(stop_card_, &StopCard::go_on, this, &DrillStage::go_on);
  connect(stop_card_, &StopCard::finish_again, this, &DrillStage::finish_again);
  connect(view_, &ToothView::camera_changed, this, [this] {
    if (cutaway_->isChecked()) want_sections();
  });
}

void DrillStage::make_tools() {
  tools_ = make_card(this);
  auto* row = new QHBoxLayout(tools_);
  row->setContentsMargins(px(3), px(3), px(3), px(3));
  row->setSpacing(px(2));
  turn_ = tool(tools_, tr("Turn"), QStringLiteral("turn"), 1);
  mirror_ = tool(tools_, tr("Mirror"), QStringLiteral("mirror"), 2);
  cutaway_ = tool(tools_, tr("Cutaway"), QStringLiteral("cutaway"), 3);
  above_ = tool(tools_, tr("From above"), QStringLiteral("eye"), 4);
  target_ = tool(tools_, tr("Target"), QStringLiteral("target"), 5);
  handpiece_ = tool(tools_, tr("Handpiece"), QStringLiteral("handpiece"), 6);
  mirror_hint_ = make_label(tr("Drag the mirror, tilt it with the right button"), TextRole::caption, Weight::regular, "text2");
  mirror_hint_->setParent(this);
  set_kind(mirror_hint_, "tag");
  mirror_hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
  mirror_hint_->hide();
  mirror_->setToolTip(tr("Mirror (2): drag it, tilt it with the right button, or I J K L; Shift tilts, U and O bring it nearer and away"));
  for (QPushButton* button : {mirror_, cutaway_, target_, handpiece_}) button->setCheckable(true);
  target_->setChecked(true);
  show_handpiece(true);
  int number = 1;
  for (QPushButton* button : {turn_, mirror_, cutaway_, above_, target_, handpiece_}) {
    row->addWidget(button);
    QLabel* cap = make_key_cap(QString::number(number++));
    cap->setFixedHeight(px(18));
    row->addWidget(cap, 0, Qt::AlignVCenter);
    if (button != handpiece_) row->addSpacing(px(4));
    caps_.emplace_back(button, cap);
  }
}

void DrillStage::connect_tools() {
  connect(turn_, &QPushButton::clicked, this, [this] {
    preset_ = (preset_ + 1) % static_cast<int>(kTurns.size());
    Camera camera = view_->camera();
    camera.set_preset(kTurns[static_cast<std::size_t>(preset_)], mesial_x_);
    view_->set_camera(camera);
  });
  connect(above_, &QPushButton::clicked, this, [this] {
    preset_ = static_cast<int>(kTurns.size()) - 1;
    Camera camera = view_->camera();
    camera.set_preset(PresetView::occlusal);
    view_->set_camera(camera);
  });
  connect(mirror_, &QPushButton::toggled, this, &DrillStage::hold_mirror);
  connect(cutaway_, &QPushButton::toggled, this, [this](bool on) {
    if (on) mirror_->setChecked(false);
    if (!on) view_->set_cutaway(std::nullopt);
    cut_->setVisible(on);
    cut_->centre();
    place_all();
    want_sections();
  });
  connect(handpiece_, &QPushButton::toggled, view_, &ToothView::set_handpiece_shown);
  connect(handpiece_, &QPushButton::clicked, this, &DrillStage::handpiece_switched);
  connect(target_, &QPushButton::toggled, this, [this](bool on) {
    view_->set_target_shown(on);
    place_all();
  });
}

void DrillStage::make_gauges() {
  depth_ = new Gauge(tr("Depth"), QStringLiteral("mm"), Gauge::Grows::down, this);
  push_ = new Gauge(tr("Force"), QStringLiteral("N"), Gauge::Grows::up, this);
  push_->set_scale({.least = 0, .most = 3, .major_step = 0.5});
  push_->set_scale_side(Gauge::ScaleSide::right);
  wanted_push_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  wanted_push_->setParent(this);
  set_kind(wanted_push_, "tag");
  wanted_push_->setAlignment(Qt::AlignCenter);
  wanted_push_->hide();
  hold_ = make_button(tr("Hold depth"), ButtonKind::standard);
  hold_->setParent(this);
  hold_->setCheckable(true);
  hold_->setFocusPolicy(Qt::TabFocus);
  hold_->setToolTip(tr("The bur goes no deeper than now (%1)").arg(u'H'));
  hold_->hide();
  connect(hold_, &QPushButton::toggled, this, &DrillStage::depth_hold_wanted);
}

void DrillStage::make_legend() {
  legend_ = make_card(this);
  auto* row = new QHBoxLayout(legend_);
  row->setContentsMargins(px(12), px(7), px(12), px(7));
  row->setSpacing(px(6));
  row->addWidget(new LineSample(LineSample::Line::target, legend_));
  row->addWidget(make_label(tr("Target"), TextRole::caption));
  row->addSpacing(px(6));
  row->addWidget(new LineSample(LineSample::Line::tolerance_zone, legend_));
  row->addWidget(make_label(tr("Tolerance zone"), TextRole::caption));
  legend_->hide();
}

void DrillStage::set_exercise(const Scenario& scenario, const TargetLook& look, const Setup& setup) {
  look_ = look;
  const Box& bounds = setup.bounds;
  pulp_depth_mm_ = setup.pulp_depth_mm;
  leeway_ = scenario.leeway;
  burs_ = scenario.instruments;
  by_mouse_ = setup.by_mouse;
  is_tooth_ = setup.is_tooth;
  mesial_x_ = mesial_x(sided_fdi(scenario.specimen));
  wide_ = glm::length(glm::dvec2(bounds.high - bounds.low)) > kLidMm;
  const double depth = required_depth_mm();
  scale_depth(0);
  if (!look.empty()) show_required(depth);
  // Harder than full force cuts no faster.
  if (scenario.device.full_force_n <= push_->most()) push_->set_limit(scenario.device.full_force_n);
  depth_->set_value(std::nullopt);
  push_->set_value(0.0);

  guided_ = setup.guidance == Guidance::full;
  depth_->setVisible(guided_);
  cutaway_->setVisible(guided_);  // a section shows where the pulp lies
  view_->set_camera(Camera::about(setup.start_view.centre_mm, setup.start_view.radius_mm));
  target_->setVisible(!look.empty());
  compass_->set_tooth(sided_fdi(scenario.specimen));
  coach_card_->hide();
  wanted_push_->setVisible(by_mouse_);
  hold_->setVisible(by_mouse_);
  shown_ = spoken_ = {Coach::carry_on, -1};
  want_sections();
  place_all();
}

double DrillStage::required_depth_mm() const {
  constexpr double kUsualMm = 2.0;  // without a target
  return look_ && !look_->empty() ? look_->shape().top_mm() - look_->shape().floor_mm() : kUsualMm;
}

void DrillStage::show_required(double depth_mm) {
  depth_->set_band(depth_mm - leeway_.floor_mm, depth_mm);
  depth_->set_limit(depth_mm + leeway_.floor_mm);
}

void DrillStage::scale_depth(double seen_mm) {
  const double most = depth_scale_mm(
      {.required_mm = required_depth_mm(), .leeway_mm = leeway_.floor_mm, .pulp_mm = pulp_depth_mm_, .seen_mm = seen_mm});
  depth_->set_scale({.least = 0, .most = most, .major_step = most > 4 ? 1.0 : 0.5});
}

void DrillStage::want_sections() {
  SectionWish panel;
  panel.shift_mm = Vec3(0.0, 0.0, -0.9);
  std::optional<SectionWish> lid;
  if (cutaway_->isChecked()) {
    // Upright, and facing the viewer.
    SectionWish wish;
    const Vec3 right = view_->camera().right();
    wish.right = glm::normalize(Vec3(right.x, right.y, 0.0));
    wish.height = static_cast<int>(kLidMm / kLidMmPerPx);
    wish.width = static_cast<int>((wide_ ? kWideLidMm : kLidMm) / kLidMmPerPx);
    wish.mm_per_px = kLidMmPerPx;
    wish.shift_mm = Vec3(0.0, 0.0, -6.0) + cut_->nearer_mm() * glm::cross(wish.right, wish.up);
    wish.with_bur = false;
    lid = wish;
  }
  Q_EMIT sections_wanted(guided_ ? std::optional(panel) : std::nullopt, lid);
}

void DrillStage::show_cutaway(SectionImage image) {
  if (cutaway_->isChecked()) view_->set_cutaway(std::move(image));
}

void DrillStage::show_wanted_push(double newtons) {
  wanted_push_->setText(tr("Wheel: %1").arg(format({newtons, {}, QStringLiteral("N"), 1})));
  wanted_push_->adjustSize();
  place_all();
}

void DrillStage::show_depth_held(bool on) {
  const QSignalBlocker quiet(hold_);
  hold_->setChecked(on);
  announce(hold_, on ? tr("Depth held") : tr("Depth free"));
}

double DrillStage::bur_radius_mm() const {
  return burs_.empty() ? 0.0 : burs_[std::min<std::size_t>(live_.output.bur, burs_.size() - 1)].radius_mm;
}

void DrillStage::show_values(const LiveView& live, const FalconView* falcon) {
  live_ = live;
  const double radius = bur_radius_mm();
  show_depth(live, radius);
  const bool pushes = live.output.contact && !stands_still(live);
  // As in the record, the spring of a proxy that has not converged is no push: the last known one stays.
  if (!pushes || !live.output.deferred) push_->set_value(pushes ? live.push_n : 0.0);
  Stop stop = Stop::none;
  if (undrawn_) {
    stop = Stop::undrawn;
  } else if (live.silent) {
    stop = Stop::silent;
  } else if (live.recording == RecordingState::failed) {
    stop = Stop::record;
  } else if (live.device == Sample::Status::gone) {
    stop = handle_gone_ ? Stop::handle_gone : Stop::device_gone;
  } else if (live.phase == LoopPhase::held) {
    const bool was_gone = live.fault == Fault::gone || live.fault == Fault::stale;
    stop = was_gone && live.device == Sample::Status::fresh ? Stop::device_back : Stop::fault;
  } else if (live.phase == LoopPhase::paused) {
    stop = Stop::paused;
  }
  show_stopped(stop, live.recording_failure ? describe_refused_record(*live.recording_failure) : Message{}, live.fault);
  if (stop_card_->show_falcon(falcon)) place_all();

  if (look_) show_coach(coach(live, look_->shape(), leeway_, radius));
}

void DrillStage::show_depth(const LiveView& live, double bur_radius_mm) {
  // Beside the tooth a bur is below the plane too, and in nothing. Before the first step it has no place.
  const Vec3 at = live.output.proxy_mm;
  const bool over_target = !look_ || look_->empty() ||
                           wall_mm(look_->shape(), {at.x, at.y}) < bur_radius_mm + leeway_.side_mm;
  if (look_ && !look_->empty()) {
    const TargetShape& shape = look_->shape();
    show_required(shape.top_mm() - floor_under_mm(shape, {at.x, at.y}).value_or(shape.floor_mm()));
  }
  const bool known = live.output.tick > 0 && live.device != Sample::Status::gone && (live.output.contact || over_target) && live.bur_depth_mm >= 0;
  if (known && live.bur_depth_mm > depth_->most()) scale_depth(live.bur_depth_mm);
  depth_->set_value(known ? std::optional(live.bur_depth_mm) : std::nullopt);
}

void DrillStage::show_stopped(Stop stop, const Message& record, Fault fault) {
  if (asking_ && stop == Stop::paused) stop = Stop::none;
  if (stop_card_->show_stop(stop, record, fault)) place_all();
}

void DrillStage::enable_tools(bool on) { tools_->setEnabled(on); }

void DrillStage::show_handpiece(bool on) {
  handpiece_->setChecked(on);
  view_->set_handpiece_shown(on);
}

void DrillStage::hold_mirror(bool on) {
  place_all();
  if (!on) return mirror_hold_->put_away();
  if (cutaway_->isChecked()) cutaway_->setChecked(false);  // a tooth cut open is no tooth in a mouth
  mirror_hold_->take(view_->camera().centre_mm());
}

bool DrillStage::press_key(int key, Qt::KeyboardModifiers modifiers) {
  if (mirror_hold_->press_key(key, modifiers)) return true;
  QPushButton* const buttons[] = {turn_, mirror_, cutaway_, above_, target_, handpiece_};
  const int index = key - Qt::Key_1;
  if ((modifiers & ~Qt::KeypadModifier) != Qt::NoModifier || index < 0 || index >= static_cast<int>(std::size(buttons)) || !buttons[index]->isEnabled() || !buttons[index]->isVisible()) return false;
  buttons[index]->click();
  return true;
}

QString DrillStage::spoken() const {
  if (depth_->isHidden()) return tr("Force %1.").arg(push_->value_text());
  if (!look_ || look_->empty()) return tr("Depth %1, force %2.").arg(depth_->value_text(), push_->value_text());
  return tr("Depth %1, force %2, %3 of the target removed. %4")
      .arg(depth_->value_text(), push_->value_text(),
           format({live_.target_removed_percent, {}, QStringLiteral("%"), 0}), coach_->text());
}

void DrillStage::set_centre(QWidget* widget) {
  centre_ = widget;
  centre_->setFixedSize(px(360), px(110));  // its text comes only when it shows
  place_all();
}

}  // namespace cusp::ui
