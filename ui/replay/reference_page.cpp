#include "ui/replay/reference_page.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/shapes/target.h"
#include "scenarios/teeth/landmarks.h"
#include "ui/replay/playback_bar.h"
#include "ui/text/bur_text.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kLookMs = 33;
constexpr std::chrono::milliseconds kFollow{30};
constexpr double kLongestLook_s = 0.2;  // a window that stood still does not jump ahead
constexpr double kSpecimenShare = 0.6, kSceneryShare = 0.7, kPathShare = 0.8;  // of the way to the tooth that is shown
constexpr std::array kViews = {PresetView::occlusal, PresetView::buccal, PresetView::lingual, PresetView::distal};  // keys 2 to 5

}  // namespace

bool ReferencePage::offered(const Scenario& scenario) {
  return !scenario.instruments.empty() && (needs_voxels(scenario.target) || !TargetShape(scenario.target).empty());
}

ReferencePage::ReferencePage(std::shared_ptr<ToothCache> teeth, const ToothWish& wish, const QString& title, QWidget* parent)
    : QWidget(parent), player_(std::move(teeth), wish), stack_(new QStackedWidget), expected_time_s_(wish.scenario.expected_time_s),
      tool_tilt_deg_(wish.scenario.tool_tilt_deg) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Ideal preparation"));
  mesial_x_ = mesial_x(sided_fdi(wish.scenario.specimen));
  setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_bar(title));
  column->addWidget(stack_, 1);
  bar_ = new PlaybackBar;
  bar_->setEnabled(false);
  column->addWidget(bar_);
  busy_ = new Busy;
  connect(busy_, &Busy::cancelled, this, &ReferencePage::back_wanted);
  busy_->setMaximumWidth(px(420));
  auto* waiting = new QWidget;
  auto* middle = new QHBoxLayout(waiting);
  middle->addWidget(busy_);
  stack_->addWidget(waiting);
  stack_->addWidget(make_stage());
  busy_->start(tr("Making the ideal preparation"), Busy::Cancel::offered);
  connect(bar_, &PlaybackBar::position_changed, this, &ReferencePage::show_caption);
  connect(bar_, &PlaybackBar::playing_changed, this, &ReferencePage::show_caption);
  connect(&timer_, &QTimer::timeout, this, &ReferencePage::look);
  timer_.start(kLookMs);
  since_.start();
}

QWidget* ReferencePage::make_bar(const QString& title) {
  const auto [bar, row] = make_bar_top();
  connect(add_way_back({bar, row}, tr("Briefing")), &QPushButton::clicked, this, &ReferencePage::back_wanted);
  add_title({bar, row}, tr("Ideal preparation: %1").arg(title));
  return bar;
}

QWidget* ReferencePage::make_stage() {
  view_ = new ToothView;
  view_->setAccessibleName(tr("The tooth while the ideal preparation is cut"));
  view_->set_left_turns(true);
  view_->set_bur_source([this] { return bur_now(); });
  // The picture says what it shows, wherever it is photographed or projected.
  auto* card = new QFrame(view_);
  card->setProperty("kind", u"card"_qs);
  card->setAutoFillBackground(true);
  auto* row = new QHBoxLayout(card);
  row->setContentsMargins(px(12), px(6), px(6), px(6));
  row->setSpacing(px(8));
  row->addWidget(make_label(tr("Ideal preparation"), TextRole::body, Weight::bold));
  caption_ = make_label({}, TextRole::body, Weight::regular, "text2");
  caption_->setMinimumWidth(px(300));  // its texts change, its place does not
  row->addWidget(caption_);
  QToolButton* turn = make_icon_button(u"refresh"_qs, tr("Turn back to the first view"), QKeySequence(Qt::Key_1));
  connect(turn, &QToolButton::clicked, this, &ReferencePage::turn_back);
  row->addWidget(turn);
  card->move(px(12), px(12));
  return view_;
}

double ReferencePage::shown_s() const { return static_cast<double>(shown_) / ReferenceCut::kStepsPerSecond; }

std::optional<BurPose> ReferencePage::bur_now() const {
  if (!show_ || finished()) return std::nullopt;
  // Never before the cuts that the tooth shows.
  const PathMoment moment = show_->timeline.at(std::min(bar_->position_s(), shown_s()));
  return BurPose{show_->bur, moment.pivot_mm, show_->timeline.axis(), moment.cut && bar_->playing()};
}

bool ReferencePage::finished() const { return std::min(bar_->position_s(), shown_s()) >= show_->timeline.seconds(); }

void ReferencePage::look() {
  const double dt_s = std::min(1e-3 * static_cast<double>(since_.restart()), kLongestLook_s);
  if (const auto failure = player_.failure()) return show_failure(*failure);
  if (!show_) {
    show_ = player_.show();
    if (!show_) return show_progress();
    begin();
  }
  bar_->advance(dt_s, shown_s());
  player_.want(static_cast<int>(std::ceil(bar_->position_s() * ReferenceCut::kStepsPerSecond - 1e-6)));
  if (const int shown = player_.shown(); shown != shown_) {
    shown_ = shown;
    view_->feed_changed();
    show_caption();
  }
  view_->follow_bur(kFollow);
}

void ReferencePage::show_progress() {
  const auto [part, part_share] = player_.progress();
  const QString percent = QLocale().toString(qRound(100 * part_share)) + QChar(0x00A0) + u'%';
  if (!part) {
    busy_->set_progress(kPathShare, tr("Planning the bur’s path"));
  } else if (*part == ToothPart::specimen) {
    busy_->set_progress(kSpecimenShare * part_share, part_share > 0 ? tr("Growing the tooth: %1").arg(percent) : tr("Fetching the tooth"));
  } else {
    const bool mesh = *part == ToothPart::mesh;
    busy_->set_progress(mesh ? kSpecimenShare : kSceneryShare, mesh ? tr("Shaping the tooth’s surface") : tr("Growing the other teeth of the jaw"));
  }
}

void ReferencePage::begin() {
  busy_->finish();
  stack_->setCurrentWidget(view_);
  view_->set_scenery(show_->scenery);
  view_->set_lines(show_->lines);
  view_->set_feed(show_->patches);
  turn_back();
  bar_->set_length(show_->timeline.seconds());
  bar_->setEnabled(true);
  bar_->set_playing(true);
  bar_->setFocus();
  show_caption();
  announce(this, tr("The ideal preparation plays."));
}

void ReferencePage::show_failure(const ReferencePlayer::Failure& failure) {
  timer_.stop();
  busy_->finish();
  bar_->setEnabled(false);
  const Message message = std::visit(
      [this](const auto& f) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(f)>, OperatorCutError>) return describe(f, tool_tilt_deg_);
        else return describe(f);
      },
      failure);
  auto* state = new EmptyState(u"warning"_qs, message.what, message.more, tr("Briefing"), Ink::look);
  connect(state, &EmptyState::acted, this, &ReferencePage::back_wanted);
  stack_->setCurrentIndex(stack_->addWidget(make_page(state)));
  state->button()->setFocus();
}

void ReferencePage::show_caption() {
  QString text = tr("Bur %1").arg(bur_text(show_->bur));
  if (finished()) {
    text = tr("finished; turn the tooth to look at it");
  } else if (expected_time_s_ > 0) {
    text = tr("%1; by hand it takes about %2").arg(text, expected_time_text(expected_time_s_));
  }
  if (text == caption_->text()) return;
  caption_->setText(text);
  caption_->parentWidget()->adjustSize();
}

void ReferencePage::turn_back() {
  if (show_) view_->set_camera(Camera::about(show_->start_view.centre_mm, show_->start_view.radius_mm));
}

void ReferencePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && event->isAutoRepeat()) return;
  const int view = event->key() - Qt::Key_2;
  if (show_ && view >= 0 && view < static_cast<int>(kViews.size())) {
    Camera camera = view_->camera();
    camera.set_preset(kViews[static_cast<std::size_t>(view)], mesial_x_);
    return view_->set_camera(camera);
  }
  if (event->key() == Qt::Key_Escape) return Q_EMIT back_wanted();
  if (show_ && bar_->press_key(event->key(), event->modifiers())) return;
  QWidget::keyPressEvent(event);
}

}  // namespace cusp::ui
