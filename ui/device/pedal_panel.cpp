#include "ui/device/pedal_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "device/hid/pedal_finder.h"
#include "device/hid/permissions.h"
#include "ui/device/hid_settings.h"
#include "ui/device/kept_band.h"
#include "ui/device/panel_card.h"
#include "ui/device/pedal_text.h"
#include "ui/device/rights_row.h"
#include "ui/modules.h"
#include "ui/settings/settings.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kPedalRefreshMs = 100;
constexpr int kTeachMs = 20;  // while a foot is watched
constexpr double kFull = 65535.0;

QString percent_of(double share) { return format({100.0 * share, {}, QStringLiteral("%"), 0}); }

}  // namespace

enum class PedalPanel::Lesson : std::uint8_t { none, rest, press, release, coolant };

struct PedalPanel::Inner {
  explicit Inner(hid::PedalReader& r) : reader(r) {}

  hid::PedalReader& reader;
  std::optional<HidSettings> kept;
  hid::PedalSettings settings;
  hid::PedalView view;
  std::vector<hid::HidDevice> offered;
  hid::PedalFinder finder;
  Lesson lesson = Lesson::none;
  QTimer timer;
  QString announced;

  QCheckBox* use;
  QComboBox* device;
  Chip* state;
  RightsRow* rights;
  QLabel *down, *drills, *coolant, *keyboard_note, *task, *heard;
  Bar* bar;
  QPushButton *teach, *teach_coolant, *no_coolant, *next, *cancel;
  NumberField* dead_zone;
  QWidget *dead_row, *lesson_box;
  KeptBand* unkept = nullptr;  // none where nothing is kept

  void keep() {
    if (kept) unkept->show_kept(kept->set_pedal(settings));
    reader.set_settings(settings);
  }
};

PedalPanel::PedalPanel(hid::PedalReader& reader, Settings* settings, QWidget* parent)
    : QWidget(parent), inner_(std::make_unique<Inner>(reader)) {
  Inner& in = *inner_;
  if (settings) in.kept.emplace(settings->file());
  in.settings = reader.settings();
  const auto [column, chip] = panel_card(*this, tr("Foot pedal"));
  in.state = chip;

  in.use = new QCheckBox(tr("The pedal drives the handpiece"));
  column->addWidget(in.use);
  in.device = new QComboBox;
  column->addWidget(labelled(tr("Which pedal"), in.device));
  in.rights = new RightsRow;
  column->addWidget(in.rights);
  in.keyboard_note = make_label(tr("This pedal plays keyboard: what it types goes to the window as well. With its maker's "
                                   "program, set it to a key from F13 to F24."),
                                TextRole::caption, Weight::regular, "text2");
  in.keyboard_note->setWordWrap(true);
  column->addWidget(in.keyboard_note);

  make_controls(column);
  make_lesson(column);
  if (in.kept) column->addWidget(in.unkept = new KeptBand(in.kept->file()));
  connect_lesson();
  connect_settings();
  connect_device();
  in.timer.setInterval(kPedalRefreshMs);
  connect(&in.timer, &QTimer::timeout, this, &PedalPanel::look);
  look();
}

void PedalPanel::make_controls(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(px(12));
  grid->setVerticalSpacing(px(8));
  grid->setColumnStretch(1, 1);
  grid->addWidget(make_label(tr("Pressed"), TextRole::body, Weight::regular, "text2"), 0, 0);
  in.bar = new Bar(Bar::Role::accent);
  in.bar->setAccessibleName(tr("Pressed"));
  grid->addWidget(in.bar, 0, 1);
  in.down = make_label(percent_of(0), TextRole::body, Weight::bold);
  in.down->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  in.down->setMinimumWidth(QFontMetrics(font_of(TextRole::body, Weight::bold)).horizontalAdvance(percent_of(1)) + px(4));
  grid->addWidget(in.down, 0, 2);
  const auto row = [&](int at, const QString& name, QLabel** value, QWidget* acts) {
    grid->addWidget(make_label(name, TextRole::body, Weight::regular, "text2"), at, 0);
    *value = make_label({});
    (*value)->setAccessibleDescription(name);
    grid->addWidget(*value, at, 1);
    grid->addWidget(acts, at, 2);
  };
  in.teach = make_button(tr("Calibrate"), ButtonKind::standard);
  row(1, tr("Drills"), &in.drills, in.teach);
  auto* acts = new QWidget;
  auto* line = new QHBoxLayout(acts);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(px(8));
  in.no_coolant = make_button(tr("None"), ButtonKind::quiet);
  in.no_coolant->setAccessibleName(tr("No switch for the coolant"));
  in.teach_coolant = make_button(tr("Choose"), ButtonKind::standard);
  in.teach_coolant->setAccessibleName(tr("Choose the switch for the coolant"));
  line->addWidget(in.no_coolant);
  line->addWidget(in.teach_coolant);
  row(2, tr("Coolant"), &in.coolant, acts);
  column->addLayout(grid);

  in.dead_zone = new NumberField;
  in.dead_zone->setDecimals(0);
  in.dead_zone->setRange(0, static_cast<int>(100 * hid::PedalCalibration::kMostDeadZone));
  in.dead_zone->setSuffix(QStringLiteral("\u00A0%"));
  in.dead_row = labelled(tr("Dead zone at both ends"), in.dead_zone);
  in.dead_row->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  column->addWidget(in.dead_row);
}

void PedalPanel::make_lesson(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* box = new QFrame;
  set_kind(box, "band_info");
  box->setFocusPolicy(Qt::TabFocus);
  box->setAccessibleName(tr("Calibrate"));
  in.lesson_box = box;
  auto* steps = new QVBoxLayout(box);
  steps->setContentsMargins(px(12), px(12), px(12), px(12));
  steps->setSpacing(px(8));
  in.task = make_label({}, TextRole::body, Weight::bold);
  in.task->setWordWrap(true);
  in.heard = make_label({}, TextRole::body, Weight::regular, "text2");
  in.heard->setWordWrap(true);
  steps->addWidget(in.task);
  steps->addWidget(in.heard);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(px(8));
  buttons->addStretch(1);
  in.cancel = make_button(tr("Cancel"), ButtonKind::quiet);
  in.next = make_button(tr("Next"), ButtonKind::primary);
  buttons->addWidget(in.cancel);
  buttons->addWidget(in.next);
  steps->addLayout(buttons);
  column->addWidget(box);
  box->hide();
}

void PedalPanel::connect_lesson() {
  Inner& in = *inner_;
  connect(in.teach, &QPushButton::clicked, this, [this] { learn(Lesson::rest); });
  connect(in.teach_coolant, &QPushButton::clicked, this, [this] {
    inner_->finder.rest(inner_->reader.view().controls);
    learn(Lesson::coolant);
  });
  connect(in.cancel, &QPushButton::clicked, this, [this] { learn(Lesson::none); });
  connect(in.next, &QPushButton::clicked, this, [this] {
    Inner& i = *inner_;
    const std::vector<hid::Control> controls = i.reader.view().controls;
    if (i.lesson == Lesson::rest) {
      i.finder.rest(controls);
      return learn(Lesson::press);
    }
    if (i.lesson == Lesson::press) return learn(Lesson::release);
    const auto found = i.finder.released(controls, i.dead_zone->value() / 100.0);
    if (!found || !i.view.device) return;
    i.settings.vendor = i.view.device->vendor;
    i.settings.product = i.view.device->product;
    i.settings.interface_number = i.view.device->interface_number;
    i.settings.drill = found->id;
    i.settings.calibration = found->calibration;
    i.keep();
    learn(Lesson::none);
  });
}

void PedalPanel::connect_settings() {
  Inner& in = *inner_;
  connect(in.no_coolant, &QPushButton::clicked, this, [this] {
    inner_->settings.coolant.reset();
    inner_->keep();
    look();
  });
  connect(in.use, &QCheckBox::toggled, this, [this](bool on) {
    inner_->settings.on = on;
    inner_->keep();
    look();
  });
  connect(in.dead_zone, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    Inner& i = *inner_;
    const auto& old = i.settings.calibration;
    if (const auto wanted = hid::PedalCalibration::from(old.released_raw(), old.pressed_raw(), value / 100.0)) {
      i.settings.calibration = *wanted;
      i.keep();
    }
  });
}

void PedalPanel::connect_device() {
  Inner& in = *inner_;
  connect(in.device, &QComboBox::activated, this, [this](int index) {
    Inner& i = *inner_;
    hid::PedalSettings fresh;
    fresh.on = i.settings.on;
    if (index > 0 && static_cast<std::size_t>(index) <= i.offered.size()) {
      const hid::HidDevice& device = i.offered[static_cast<std::size_t>(index) - 1];
      const bool same = device.vendor == i.settings.vendor && device.product == i.settings.product &&
                        device.interface_number == i.settings.interface_number;
      if (same) return;
      fresh.vendor = device.vendor;
      fresh.product = device.product;
      fresh.interface_number = device.interface_number;
      // A keyboard or a joystick drives nothing before somebody has chosen the control.
      if (!hid::is_known_pedal(device.vendor, device.product)) fresh.drill = hid::ControlId{};
    }
    i.settings = fresh;
    i.keep();
    learn(Lesson::none);
  });
}

void PedalPanel::learn(Lesson lesson) {
  Inner& in = *inner_;
  const Lesson before = std::exchange(in.lesson, lesson);
  const bool has_keys = in.lesson_box->hasFocus() || in.lesson_box->isAncestorOf(QApplication::focusWidget());
  in.timer.setInterval(lesson == Lesson::none ? kPedalRefreshMs : kTeachMs);
  in.lesson_box->setVisible(lesson != Lesson::none);
  in.next->setVisible(lesson != Lesson::coolant);
  in.next->setText(lesson == Lesson::release ? tr("Take it over") : tr("Next"));
  for (QPushButton* begins : {in.teach, in.teach_coolant}) begins->setEnabled(lesson == Lesson::none);
  switch (lesson) {
    case Lesson::none: break;
    case Lesson::rest: in.task->setText(tr("Press the pedal once, release it, and take the foot off.")); break;
    case Lesson::press: in.task->setText(tr("Press the pedal all the way down and hold it.")); break;
    case Lesson::release: in.task->setText(tr("Take the foot off the pedal.")); break;
    case Lesson::coolant: in.task->setText(tr("Press the switch that runs the coolant.")); break;
  }
  if (lesson != Lesson::none) announce(this, in.task->text());
  // On none of its buttons: a pedal that plays keyboard would press them.
  if (before == Lesson::none && lesson != Lesson::none) in.lesson_box->setFocus();
  if (lesson == Lesson::none && has_keys) (before == Lesson::coolant ? in.teach_coolant : in.teach)->setFocus();
  look();
}

PedalPanel::~PedalPanel() = default;

void PedalPanel::look() {
  Inner& in = *inner_;
  in.view = in.reader.view();
  const hid::PedalView& view = in.view;
  const bool denied = view.denied && view.device.has_value();
  in.state->set(view.connected ? tr("connected") : denied ? tr("no permission") : tr("not connected"),
                view.connected ? Chip::Kind::good : denied ? Chip::Kind::look : Chip::Kind::plain);
  in.rights->set_command(
      denied ? QString::fromStdString(hid::udev_install_command(view.device->vendor, view.device->product)) : QString());

  show_devices();
  const QSignalBlocker still(in.use);
  in.use->setChecked(in.settings.on);
  in.dead_zone->show_value(std::round(100 * in.settings.calibration.dead_zone()));
  const bool chosen = in.settings.drill && *in.settings.drill != hid::ControlId{};
  const auto kind = chosen ? control_kind(*in.settings.drill, view.controls) : hid::ControlKind::button;
  in.drills->setText(chosen               ? control_name(*in.settings.drill, kind)
                     : in.settings.drill ? tr("Nothing yet: calibrate it")
                                         : tr("Any switch of it"));
  set_ink(in.drills, in.settings.drill && !chosen ? "look" : "");
  in.coolant->setText(in.settings.coolant ? control_name(*in.settings.coolant, control_kind(*in.settings.coolant, view.controls))
                                          : tr("None"));
  in.no_coolant->setVisible(in.settings.coolant.has_value());
  in.dead_row->setVisible(chosen && kind == hid::ControlKind::axis);
  in.keyboard_note->setVisible(chosen && kind == hid::ControlKind::key);
  const double share = view.reading.pressed / kFull;
  in.down->setText(percent_of(share));
  in.bar->set_share(share, in.down->text());
  in.teach->setEnabled(view.connected && in.lesson == Lesson::none);
  in.teach_coolant->setEnabled(view.connected && in.lesson == Lesson::none);

  show_lesson();
  if (const QString now = summary(); now != in.announced) {
    in.announced = now;
    Q_EMIT summary_changed(now);
  }
}

void PedalPanel::show_devices() {
  Inner& in = *inner_;
  const hid::PedalView& view = in.view;
  if (in.offered != view.devices || in.device->count() == 0) {
    in.offered = view.devices;
    const QSignalBlocker quiet(in.device);
    in.device->clear();
    in.device->addItem(tr("The first foot pedal that is found"));
    for (const hid::HidDevice& device : in.offered) in.device->addItem(hid_name(device));
  }
  int index = 0;
  for (std::size_t i = 0; i < in.offered.size(); ++i) {
    if (in.settings.vendor != 0 && in.offered[i].vendor == in.settings.vendor &&
        in.offered[i].product == in.settings.product && index == 0 &&
        (in.settings.interface_number < 0 || in.offered[i].interface_number == in.settings.interface_number))
      index = static_cast<int>(i) + 1;
  }
  if (!in.device->view()->isVisible() && in.device->currentIndex() != index) in.device->setCurrentIndex(index);
}

void PedalPanel::show_lesson() {
  Inner& in = *inner_;
  const hid::PedalView& view = in.view;
  if (in.lesson != Lesson::none) {
    if (!view.connected) {
      in.heard->show();
      in.heard->setText(tr("The pedal is not connected any more."));
      in.next->setEnabled(false);
    } else if (in.lesson == Lesson::rest) {
      in.heard->hide();
      in.next->setEnabled(true);
    } else if (in.lesson == Lesson::release) {
      const auto back = in.finder.released(view.controls);
      in.heard->show();
      in.heard->setText(back ? tr("It is: %1").arg(control_name(back->id, back->kind))
                             : tr("The pedal is not back where it rested. If the foot is off, the pedal was pressed at the first "
                                  "step: cancel, and calibrate again."));
      in.next->setEnabled(back.has_value());
    } else {
      in.finder.press(view.controls);
      const auto found = in.finder.found();
      if (in.lesson == Lesson::coolant) {
        const bool switches = found && found->kind != hid::ControlKind::axis;
        if (switches && found->calibration.pressed_raw() < found->calibration.released_raw()) {
          in.finder.rest(view.controls);  // a switch that was down was released: the one for the coolant comes
        } else if (switches) {
          in.settings.coolant = found->id;
          in.keep();
          in.cancel->click();
          return;
        }
      }
      in.heard->setVisible(true);
      const bool back = in.lesson == Lesson::press && in.finder.released(view.controls);
      const auto down = in.lesson == Lesson::press ? in.finder.down_at_rest() : std::nullopt;
      in.heard->setText(!found && down ? tr("%1 was down at the first step. If the foot was on the pedal, cancel and calibrate again.")
                                             .arg(control_name(down->id, down->kind))
                        : !found ? tr("Nothing has moved yet.")
                        : back ? tr("The pedal is back where it rested. If it is down, it was pressed at the first step: cancel, "
                                    "and calibrate again.")
                               : tr("It is: %1").arg(control_name(found->id, found->kind)));
      in.next->setEnabled(found && !back);
    }
  }
}

QString PedalPanel::summary() const {
  const hid::PedalView& view = inner_->view;
  if (!view.device) return tr("No foot pedal is connected");
  const QString name = hid_name(*view.device);
  if (!view.connected) return view.denied ? tr("%1: no permission").arg(name) : tr("%1: not connected").arg(name);
  return inner_->settings.on ? tr("%1: connected").arg(name) : tr("%1: connected, not used").arg(name);
}

void PedalPanel::showEvent(QShowEvent* event) {
  inner_->timer.start();
  look();
  QWidget::showEvent(event);
}

void PedalPanel::hideEvent(QHideEvent* event) {
  inner_->timer.stop();
  QWidget::hideEvent(event);
}

}  // namespace cusp::ui
