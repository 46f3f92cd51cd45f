#include "ui/drill/handpiece_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "engine/removal/heat.h"
#include "scenarios/format/keys.h"
#include "ui/drill/coach.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kLookShare = 0.6;      // of the criterion: from here on the bar warns
constexpr double kShownRpm = 1000.0;    // the number moves in steps of this, so that it can be read

void set_text(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

QString degrees(double kelvin) { return format({kelvin, {}, QStringLiteral("K"), 1}); }

}  // namespace

HandpiecePanel::HandpiecePanel(QWidget* parent) : QFrame(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(11), px(16), px(11));
  column->setSpacing(px(8));
  head_ = new QHBoxLayout;
  head_->addWidget(make_label(tr("Handpiece"), TextRole::section, Weight::bold), 1);
  column->addLayout(head_);
  speed_row_ = make_fact_row(QStringLiteral("turn"), tr("Speed"), &speed_);
  column->addWidget(speed_row_);

  coolant_ = make_button(tr("Coolant is off"), ButtonKind::standard, QStringLiteral("drop"), QKeySequence(Qt::Key_W));
  coolant_->setCheckable(true);
  coolant_->setFocusPolicy(Qt::TabFocus);  // a click must not take Space from drilling
  connect(coolant_, &QPushButton::toggled, this, [this](bool on) {
    pedal_wets_ = false;
    show_coolant();
    announce(this, coolant_->accessibleName());  // its key works from anywhere
    Q_EMIT coolant_changed(on);
  });
  head_->addWidget(coolant_);

  heat_part_ = make_fact_row(QStringLiteral("heat"), tr("Tooth warmer by"), &heat_);
  column->addWidget(heat_part_);
  heat_bar_ = new Bar(Bar::Role::good, this);
  heat_bar_->setAccessibleName(tr("Tooth warmer by"));
  column->addWidget(heat_bar_);
  heat_note_ = make_label(tr("The pulp is at risk from a rise of %1").arg(degrees(kPulpCriterionK)), TextRole::caption,
                          Weight::regular, "text2");
  heat_note_->setWordWrap(true);
  column->addWidget(heat_note_);

  sound_row_ = new QWidget(this);
  auto* line = new QHBoxLayout(sound_row_);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(px(8));
  mute_ = make_icon_button(QStringLiteral("sound"), tr("Sound off"), QKeySequence(Qt::Key_M));
  mute_->setCheckable(true);
  mute_->setFocusPolicy(Qt::TabFocus);
  connect(mute_, &QToolButton::toggled, this, [this](bool muted) {
    show_muted();
    Q_EMIT muted_changed(muted);
  });
  line->addWidget(mute_);
  volume_ = new QSlider(Qt::Horizontal, sound_row_);
  volume_->setRange(0, 100);
  volume_->setPageStep(10);
  volume_->setFocusPolicy(Qt::TabFocus);
  volume_->setAccessibleName(tr("Volume"));
  volume_->setToolTip(tr("Volume"));
  connect(volume_, &QSlider::valueChanged, this, &HandpiecePanel::volume_changed);
  line->addWidget(volume_, 1);
  column->addWidget(sound_row_);
  no_sound_ = make_label(tr("No sound: this computer has no audio output."), TextRole::caption, Weight::regular, "text2");
  no_sound_->setWordWrap(true);
  column->addWidget(no_sound_);
  no_sound_->hide();
  show_coolant();
  hide();
}

void HandpiecePanel::set_exercise(const Scenario& scenario, Guidance guidance) {
  const Phenomena asked = phenomena_from_keys(scenario.phenomena);
  spindle_ = asked.handpiece != Handpiece::none;
  reckons_heat_ = asked.heat;
  shows_heat_ = asked.heat && guidance == Guidance::full;
  sounds_ = spindle_ && has_phenomenon(scenario.phenomena, "sound");
  speed_row_->setVisible(spindle_);
  coolant_->setVisible(reckons_heat_);
  heat_part_->setVisible(shows_heat_);
  heat_bar_->setVisible(shows_heat_ && !folded_);
  heat_note_->setVisible(shows_heat_);
  sound_row_->setVisible(sounds_);
  setVisible(spindle_ || reckons_heat_);
}

void HandpiecePanel::fold(bool on) {
  folded_ = on;
  head_->setDirection(on ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);  // the button is as wide as the title
  heat_bar_->setVisible(shows_heat_ && !on);
}

void HandpiecePanel::set_sound(const Sound& sound) {
  const QSignalBlocker quiet(volume_), still(mute_);
  volume_->setValue(sound.volume_percent);
  mute_->setChecked(sound.muted);
  show_muted();
  sound_row_->setVisible(sounds_ && sound.available);
  no_sound_->setVisible(sounds_ && !sound.available);
}

void HandpiecePanel::show_muted() {
  const bool muted = mute_->isChecked();
  const QString name = muted ? tr("Sound on") : tr("Sound off");
  mute_->setIcon(icon(muted ? QStringLiteral("sound_off") : QStringLiteral("sound")));
  mute_->setAccessibleName(name);
  mute_->setToolTip(QStringLiteral("%1 (%2)").arg(name, QKeySequence(Qt::Key_M).toString(QKeySequence::NativeText)));
  volume_->setEnabled(!muted);
}

void HandpiecePanel::show_coolant() {
  const bool on = coolant_->isChecked();
  const QString name = on || pedal_wets_ ? tr("Coolant is on") : tr("Coolant is off");
  coolant_->setText(u' ' + name);  // as make_button: the style leaves no space after the sign
  coolant_->setAccessibleName(name);
  coolant_->setToolTip(QStringLiteral("%1 (%2)").arg(on ? tr("Turn the coolant off") : tr("Turn the coolant on"),
                                                     QKeySequence(Qt::Key_W).toString(QKeySequence::NativeText)));
  coolant_->setShortcut(Qt::Key_W);  // a new text takes the shortcut away
}

void HandpiecePanel::show_values(const LiveView& live) {
  const StepOutput& out = live.output;
  const bool pedal_wets = !coolant_->isChecked() && !stands_still(live) && out.has(PhenomenonSign::coolant);
  if (std::exchange(pedal_wets_, pedal_wets) != pedal_wets) show_coolant();
  if (spindle_) {
    const bool stands = stands_still(live);
    const bool stalled = !stands && out.has(PhenomenonSign::stalled);
    const double rpm = stands ? 0.0 : std::round(static_cast<double>(out.spindle_rpm) / kShownRpm) * kShownRpm;
    QLocale grouped;
    grouped.setNumberOptions(grouped.numberOptions() & ~QLocale::OmitGroupSeparator);
    //: Turns of the bur in a minute.
    set_text(speed_, stalled ? tr("stalled, push less") : tr("%1 rpm").arg(format_number(rpm, 0, grouped)));
    set_ink(speed_, stalled ? "look" : "");
  }
  if (!shows_heat_) return;
  const double rise = static_cast<double>(out.heat_k);
  set_text(heat_, degrees(rise));
  heat_bar_->set_share(rise / kPulpCriterionK, heat_->text());
  heat_bar_->set_role(rise >= kPulpCriterionK                ? Bar::Role::bad
                      : rise >= kLookShare * kPulpCriterionK ? Bar::Role::look
                                                             : Bar::Role::good);
  const bool over = rise >= kPulpCriterionK;
  if (over == over_) return;
  over_ = over;
  const QString note = over ? tr("Too warm for the pulp (a rise of %1): run the coolant")
                            : tr("The pulp is at risk from a rise of %1");
  set_text(heat_note_, note.arg(degrees(kPulpCriterionK)));
  set_ink(heat_note_, over ? "bad" : "text2");
  if (over) announce(this, heat_note_->text());
}

bool HandpiecePanel::press_key(int key) {
  if (key == Qt::Key_W && !coolant_->isHidden()) coolant_->toggle();
  else if (key == Qt::Key_M && !sound_row_->isHidden()) mute_->toggle();
  else return false;
  return true;
}

QString HandpiecePanel::spoken() const {
  QStringList parts;
  if (spindle_) parts << tr("Speed %1.").arg(speed_->text());
  if (reckons_heat_) parts << coolant_->accessibleName() + u'.';
  if (shows_heat_) parts << tr("Tooth warmer by %1.").arg(heat_->text());
  return parts.join(u' ');
}

}  // namespace cusp::ui
