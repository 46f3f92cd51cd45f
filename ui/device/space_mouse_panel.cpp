#include "ui/device/space_mouse_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

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

constexpr int kSpaceMouseRefreshMs = 100;
constexpr int kAxes = 6;

QString percent(double share) {
  const double shown = std::round(100.0 * share);
  return format({shown + 0.0, {}, QStringLiteral("%"), 0});
}

}  // namespace

struct SpaceMousePanel::Inner {
  explicit Inner(hid::SpaceMouseReader& r) : reader(r) {}

  hid::SpaceMouseReader& reader;
  std::optional<HidSettings> kept;
  hid::SpaceMouseSettings settings;
  hid::SpaceMouseView view;
  QTimer timer;
  QString announced;

  QCheckBox *use, *turns, *moves;
  Chip* state;
  RightsRow* rights;
  std::array<Bar*, kAxes> bars{};
  std::array<QLabel*, kAxes> values{};
  QSlider* speed;
  NumberField* dead_zone;
  QLabel *speed_text, *battery, *rest_note;
  QPushButton* rest;
  KeptBand* unkept = nullptr;  // none where nothing is kept

  void keep() {
    if (kept) unkept->show_kept(kept->set_space_mouse(settings));
    reader.set_settings(settings);
  }
};

SpaceMousePanel::SpaceMousePanel(hid::SpaceMouseReader& reader, Settings* settings, QWidget* parent)
    : QWidget(parent), inner_(std::make_unique<Inner>(reader)) {
  Inner& in = *inner_;
  if (settings) in.kept.emplace(settings->file());
  in.settings = reader.settings();
  const auto [column, chip] = panel_card(*this, QStringLiteral("SpaceMouse"));
  in.state = chip;
  in.use = new QCheckBox(tr("The SpaceMouse leads the view of the tooth"));
  column->addWidget(in.use);
  in.rights = new RightsRow;
  column->addWidget(in.rights);
  auto* note = make_label(tr("Its left button brings the first view back, its right one puts in the mirror or takes it out."),
                          TextRole::caption, Weight::regular, "text2");
  note->setWordWrap(true);
  column->addWidget(note);

  make_axes(column);
  make_settings(column);
  make_rest(column);
  if (in.kept) column->addWidget(in.unkept = new KeptBand(in.kept->file()));
  connect_settings();
  connect_rest();
  in.timer.setInterval(kSpaceMouseRefreshMs);
  connect(&in.timer, &QTimer::timeout, this, &SpaceMousePanel::look);
  look();
}

void SpaceMousePanel::make_axes(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(px(12));
  grid->setVerticalSpacing(px(4));
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(4, 1);
  const QString names[kAxes] = {tr("Right"), tr("Up"), tr("Nearer"), tr("Tilt"), tr("Turn"), tr("Roll")};
  const int width =
      QFontMetrics(font_of(TextRole::caption)).horizontalAdvance(percent(-1)) + px(4);
  for (int i = 0; i < kAxes; ++i) {
    const int column_at = i < 3 ? 0 : 3;
    grid->addWidget(make_label(names[i], TextRole::caption, Weight::regular, "text2"), i % 3, column_at);
    auto* bar = new Bar(Bar::Role::accent);
    bar->setAccessibleName(names[i]);
    grid->addWidget(bar, i % 3, column_at + 1);
    auto* value = make_label(percent(0), TextRole::caption);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setMinimumWidth(width);
    grid->addWidget(value, i % 3, column_at + 2);
    in.bars[static_cast<std::size_t>(i)] = bar;
    in.values[static_cast<std::size_t>(i)] = value;
  }
  column->addLayout(grid);
}

void SpaceMousePanel::make_settings(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* uses = new QHBoxLayout;
  uses->setSpacing(px(16));
  in.turns = new QCheckBox(tr("Turn the view"));
  in.moves = new QCheckBox(tr("Move and zoom"));
  uses->addWidget(in.turns);
  uses->addWidget(in.moves);
  uses->addStretch(1);
  column->addLayout(uses);

  auto* numbers = new QHBoxLayout;
  numbers->setSpacing(px(16));
  in.speed = new QSlider(Qt::Horizontal);
  in.speed->setRange(20, 300);
  in.speed->setPageStep(20);
  in.speed->setAccessibleName(tr("Speed"));
  in.speed->setMinimumHeight(px(20));
  in.speed_text = make_label({}, TextRole::body);
  in.speed_text->setMinimumWidth(QFontMetrics(font_of(TextRole::body)).horizontalAdvance(percent(3)) + px(4));
  auto* speed_row = new QWidget;
  auto* speed_line = new QHBoxLayout(speed_row);
  speed_line->setContentsMargins(0, 0, 0, 0);
  speed_line->addWidget(in.speed, 1);
  speed_line->addWidget(in.speed_text);
  numbers->addWidget(labelled(tr("Speed"), speed_row), 1);
  in.dead_zone = new NumberField;
  in.dead_zone->setDecimals(0);
  in.dead_zone->setRange(0, 40);
  in.dead_zone->setSuffix(QStringLiteral("\u00A0%"));
  numbers->addWidget(labelled(tr("Dead zone"), in.dead_zone));
  column->addLayout(numbers);
}

void SpaceMousePanel::make_rest(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* foot = new QHBoxLayout;
  foot->setSpacing(px(8));
  in.rest = make_button(tr("Hand is off: take this as rest"), ButtonKind::standard);
  foot->addWidget(in.rest);
  in.rest_note = make_label({}, TextRole::caption, Weight::regular, "text2");
  foot->addWidget(in.rest_note, 1);
  in.battery = make_label({}, TextRole::caption, Weight::regular, "text2");
  foot->addWidget(in.battery);
  column->addLayout(foot);
}

void SpaceMousePanel::connect_settings() {
  Inner& in = *inner_;
  connect(in.use, &QCheckBox::toggled, this, [this](bool on) {
    inner_->settings.on = on;
    inner_->keep();
    look();
  });
  connect(in.turns, &QCheckBox::toggled, this, [this](bool on) {
    inner_->settings.turns = on;
    inner_->keep();
  });
  connect(in.moves, &QCheckBox::toggled, this, [this](bool on) {
    inner_->settings.moves = on;
    inner_->keep();
  });
  connect(in.speed, &QSlider::valueChanged, this, [this](int value) {
    inner_->settings.speed = value / 100.0;
    inner_->speed_text->setText(percent(value / 100.0));
    inner_->keep();
  });
  connect(in.dead_zone, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    inner_->settings.dead_zone = value / 100.0;
    inner_->keep();
  });
}

void SpaceMousePanel::connect_rest() {
  Inner& in = *inner_;
  connect(in.rest, &QPushButton::clicked, this, [this] {
    Inner& i = *inner_;
    const auto raw = i.reader.view(std::chrono::steady_clock::now()).raw;
    // A hand that still holds it would make a rest that creeps: a quarter of the way is no rest.
    const bool still = std::all_of(raw.begin(), raw.end(),
                                   [&i](std::int16_t v) { return std::abs(v) < 0.25 * i.settings.full_scale; });
    if (still) {
      i.settings.rest = raw;
      i.keep();
    }
    i.rest_note->setText(still ? tr("Taken over") : tr("Take the hand off first"));
    set_ink(i.rest_note, still ? "good" : "look");
    announce(this, i.rest_note->text());
  });
}

SpaceMousePanel::~SpaceMousePanel() = default;

void SpaceMousePanel::look() {
  Inner& in = *inner_;
  in.view = in.reader.view(std::chrono::steady_clock::now());
  const hid::SpaceMouseView& view = in.view;
  const bool denied = view.denied && view.device.has_value();
  in.state->set(view.connected ? tr("connected") : denied ? tr("no permission") : tr("not connected"),
                view.connected ? Chip::Kind::good : denied ? Chip::Kind::look : Chip::Kind::plain);
  in.rights->set_command(
      denied ? QString::fromStdString(hid::udev_install_command(view.device->vendor, view.device->product)) : QString());
  const QSignalBlocker a(in.use), b(in.turns), c(in.moves), d(in.speed);
  in.use->setChecked(in.settings.on);
  in.turns->setChecked(in.settings.turns);
  in.moves->setChecked(in.settings.moves);
  in.speed->setValue(static_cast<int>(std::lround(100 * in.settings.speed)));
  in.speed_text->setText(percent(in.settings.speed));
  in.dead_zone->show_value(std::round(100 * in.settings.dead_zone));
  const auto& m = view.motion;
  const std::array<double, kAxes> shares = {m.move[0], m.move[1], m.move[2], m.turn[0], m.turn[1], m.turn[2]};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const QString text = percent(shares[i]);
    if (in.values[i]->text() != text) in.values[i]->setText(text);
    in.bars[i]->set_share(std::abs(shares[i]), text);
  }
  in.rest->setEnabled(view.connected);
  in.battery->setText(view.battery_percent ? tr("Battery %1").arg(percent(*view.battery_percent / 100.0)) : QString());
  if (const QString now = summary(); now != in.announced) {
    in.announced = now;
    Q_EMIT summary_changed(now);
  }
}

QString SpaceMousePanel::summary() const {
  const hid::SpaceMouseView& view = inner_->view;
  if (!view.device) return tr("No SpaceMouse is connected");
  const QString name = hid_name(*view.device);
  if (!view.connected) return view.denied ? tr("%1: no permission").arg(name) : tr("%1: not connected").arg(name);
  return inner_->settings.on ? tr("%1: connected").arg(name) : tr("%1: connected, not used").arg(name);
}

void SpaceMousePanel::showEvent(QShowEvent* event) {
  inner_->timer.start();
  look();
  QWidget::showEvent(event);
}

void SpaceMousePanel::hideEvent(QHideEvent* event) {
  inner_->timer.stop();
  QWidget::hideEvent(event);
}

}  // namespace cusp::ui
