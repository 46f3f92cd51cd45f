#include "ui/device/inverse_panel.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "ui/device/kept_band.h"
#include "ui/device/panel_card.h"
#include "ui/session/background_task.h"
#include "ui/settings/device_settings.h"
#include "ui/settings/settings.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kInverseRefreshMs = 100;
constexpr int kLeastPercent = 5, kMostPercent = 100;  // of the hand's way: InverseSettings::scale
constexpr int kQuarterDeg = 90;

double radians(int degrees) { return degrees * std::numbers::pi / 180.0; }

QString millimetres_of_metres(double m) { return format({m * 1000.0, {}, QStringLiteral("mm"), 1}); }

}  // namespace

struct InversePanel::Inner {
  /// What the background task brings back, whenever that is.
  struct Answer {
    std::mutex mutex;
    std::optional<Result<void, PortFailure>> result;
  };

  enum class State { away, asking, answers, refused };

  std::optional<DeviceSettings> kept;
  MakePort make;
  InverseSettings settings;
  std::shared_ptr<InversePort> port;  // the background task has it too: whoever drops it last closes it
  BackgroundTask asking;
  std::shared_ptr<Answer> answer;
  QElapsedTimer asked_for;
  State state = State::away;
  PortFailure failure{PortError::not_found, {}};
  QTimer timer;
  QString announced;
  bool fixed = false;

  Chip* chip;
  QLabel *message, *place, *rate, *handle;
  QPushButton *ask, *free, *cancel;
  QProgressBar* progress;
  QComboBox* turned;
  NumberField *scale, *service;
  QWidget* values;
  KeptBand* unkept = nullptr;  // none where nothing is kept

  void keep() {
    if (kept) unkept->show_kept(kept->set_inverse(settings));
  }
};

InversePanel::InversePanel(Settings* settings, MakePort make_port, QWidget* parent)
    : QWidget(parent), inner_(std::make_unique<Inner>()) {
  Inner& in = *inner_;
  in.make = std::move(make_port);
  if (settings) {
    in.kept.emplace(settings->file());
    in.settings = in.kept->inverse();
  }
  const auto [column, chip] = panel_card(*this, QStringLiteral("Haply Inverse3"));
  in.chip = chip;
  auto* about = make_label(tr("It is reached through its maker's own service on this computer, which you install. Not yet tried with "
                              "a real device: its directions, forces and rate are not verified."),
                           TextRole::caption, Weight::regular, "text2");
  about->setWordWrap(true);
  column->addWidget(about);
  in.message = make_label({});
  in.message->setWordWrap(true);
  column->addWidget(in.message);
  in.progress = new QProgressBar;
  in.progress->setRange(0, static_cast<int>(InversePort::kLongestOpen / std::chrono::milliseconds(1)));
  in.progress->setTextVisible(false);
  in.progress->setAccessibleName(tr("Asking the service."));
  in.progress->hide();
  column->addWidget(in.progress);

  make_values(column);
  make_fields(column);
  make_acts(column);
  if (in.kept) column->addWidget(in.unkept = new KeptBand(in.kept->file()));
  connect_all();
  in.timer.setInterval(kInverseRefreshMs);
  connect(&in.timer, &QTimer::timeout, this, &InversePanel::look);
  look();
}

void InversePanel::make_values(QVBoxLayout* column) {
  Inner& in = *inner_;
  in.values = new QWidget;
  auto* grid = new QGridLayout(in.values);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(px(12));
  grid->setVerticalSpacing(px(4));
  grid->setColumnStretch(1, 1);
  const auto row = [grid](int at, const QString& name, QLabel** value) {
    grid->addWidget(make_label(name, TextRole::body, Weight::regular, "text2"), at, 0);
    *value = make_label({});
    (*value)->setAccessibleDescription(name);
    grid->addWidget(*value, at, 1);
  };
  row(0, tr("Place"), &in.place);
  row(1, tr("Answers a second"), &in.rate);
  row(2, tr("Handle"), &in.handle);
  column->addWidget(in.values);
  in.values->hide();
}

void InversePanel::make_fields(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* fields = new QHBoxLayout;
  fields->setSpacing(px(12));
  in.turned = new QComboBox;
  in.turned->addItem(tr("As it comes"));
  in.turned->addItem(tr("A quarter to the left"));
  in.turned->addItem(tr("Half round"));
  in.turned->addItem(tr("A quarter to the right"));
  in.turned->setCurrentIndex(static_cast<int>(std::lround(in.settings.yaw_rad / (std::numbers::pi / 2))) % 4);
  fields->addWidget(labelled(tr("It stands turned"), in.turned), 1);
  in.scale = new NumberField;
  in.scale->setDecimals(0);
  in.scale->setRange(kLeastPercent, kMostPercent);
  in.scale->setSuffix(QStringLiteral("\u00A0%"));
  in.scale->setValue(std::round(100 * in.settings.scale));
  fields->addWidget(labelled(tr("Of the hand's way"), in.scale));
  in.service = new NumberField;
  in.service->setDecimals(0);
  in.service->setRange(1, 65535);
  in.service->setValue(in.settings.service.port);
  fields->addWidget(labelled(tr("Port of the service"), in.service));
  column->addLayout(fields);
}

void InversePanel::make_acts(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* acts = new QHBoxLayout;
  acts->setSpacing(px(8));
  in.ask = make_button(tr("Look for it"), ButtonKind::standard, QStringLiteral("search"));
  in.free = make_button(tr("Release it"), ButtonKind::quiet);
  acts->addWidget(in.ask);
  acts->addWidget(in.free);
  in.cancel = make_button(tr("Cancel"), ButtonKind::quiet);
  in.cancel->hide();
  acts->addWidget(in.cancel);
  acts->addStretch(1);
  column->addLayout(acts);
}

void InversePanel::connect_all() {
  Inner& in = *inner_;
  connect(in.ask, &QPushButton::clicked, this, &InversePanel::connect_to_it);
  connect(in.free, &QPushButton::clicked, this, &InversePanel::release);
  connect(in.cancel, &QPushButton::clicked, this, &InversePanel::release);
  connect(in.turned, &QComboBox::currentIndexChanged, this, [this](int index) {
    inner_->settings.yaw_rad = radians(index * kQuarterDeg);
    inner_->keep();
  });
  connect(in.scale, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    inner_->settings.scale = value / 100.0;
    inner_->keep();
  });
  connect(in.service, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    inner_->settings.service.port = static_cast<std::uint16_t>(value);
    inner_->keep();
  });
}

InversePanel::~InversePanel() { release(); }

void InversePanel::fix_settings() {
  inner_->fixed = true;
  look();
}

InverseSettings InversePanel::chosen() const { return inner_->settings; }

void InversePanel::connect_to_it() {
  Inner& in = *inner_;
  if (in.state == Inner::State::asking) return;
  release();
  in.state = Inner::State::asking;
  in.port = in.make(in.settings);
  in.answer = std::make_shared<Inner::Answer>();
  in.asking = BackgroundTask([port = in.port, answer = in.answer] {
    auto result = port->open();
    const std::lock_guard lock(answer->mutex);
    answer->result = std::move(result);
  }, BackgroundTask::Holds::device);
  in.asked_for.start();
  in.timer.start();
  look();
}

void InversePanel::take_answer() {
  Inner& in = *inner_;
  {
    const std::lock_guard lock(in.answer->mutex);
    if (!in.answer->result) return;
    if (*in.answer->result) {
      in.state = Inner::State::answers;
    } else {
      in.failure = in.answer->result->error();
      in.state = Inner::State::refused;
    }
  }
  in.asking = {};
  if (in.state == Inner::State::refused) {
    in.timer.stop();
    in.port.reset();  // closed already
  }
  look();
  announce(this, in.message->text());
}

void InversePanel::release() {
  Inner& in = *inner_;
  in.timer.stop();
  if (in.port) {
    in.port->cancel();
    // The last message is sent and the connection closed on a thread that may wait for that.
    BackgroundTask([port = std::move(in.port)]() mutable { port.reset(); }, BackgroundTask::Holds::device);
  }
  in.asking = {};
  in.state = Inner::State::away;
  look();
}

void InversePanel::look() {
  Inner& in = *inner_;
  using State = Inner::State;
  if (in.state == State::asking) {
    take_answer();
    if (in.state != State::asking) return;  // it has looked
  }
  QString message;
  bool values = false;
  switch (in.state) {
    case State::away:
      in.chip->set(tr("not asked"), Chip::Kind::plain);
      message = tr("Start its service, switch the device on, and look for it.");
      break;
    case State::asking:
      in.chip->set(tr("asking"), Chip::Kind::plain);
      message = tr("Asking the service.");
      in.progress->setValue(static_cast<int>(in.asked_for.elapsed()));
      break;
    case State::refused:
      in.chip->set(tr("not found"), Chip::Kind::look);
      if (in.failure.code == PortError::not_found && in.failure.where == "service") {
        message = tr("No service answers at port %1. Start the maker's service and look again.")
                   .arg(QString::number(in.settings.service.port));
      } else if (in.failure.code == PortError::not_found) {
        message = tr("The service answers, but it knows of no Inverse3. Check its cable and power, and look again.");
      } else {
        message = tr("Something answers at port %1, but not as an Inverse3's service does.")
                   .arg(QString::number(in.settings.service.port));
      }
      break;
    case State::answers:
      values = true;
      message = show_answers();
      break;
  }
  if (in.message->text() != message) in.message->setText(message);
  in.values->setVisible(values);
  // The button that is pressed goes or is disabled: the keyboard stays with the one that takes its place.
  QPushButton* const next = in.state == State::asking ? in.cancel : in.state == State::answers ? in.free : in.ask;
  const bool has_keys = in.ask->hasFocus() || in.cancel->hasFocus() || in.free->hasFocus();
  in.ask->setEnabled(in.state == State::away || in.state == State::refused);
  in.free->setVisible(in.state == State::answers);
  in.cancel->setVisible(in.state == State::asking);
  if (has_keys) next->setFocus();
  in.progress->setVisible(in.state == State::asking);
  const bool still = !in.fixed && in.state != State::asking && in.state != State::answers;
  for (QWidget* field : {static_cast<QWidget*>(in.turned), static_cast<QWidget*>(in.scale), static_cast<QWidget*>(in.service)})
    field->setEnabled(still);
  if (const QString now = summary(); now != in.announced) {
    in.announced = now;
    Q_EMIT summary_changed(now);
  }
}

/// Fills chip, place, rate and handle; what the device does, as a sentence.
QString InversePanel::show_answers() {
  Inner& in = *inner_;
  const InverseView view = in.port->view();
  const auto& s = view.session;
  const bool ready = s.phase == inverse::Phase::ready;
  in.chip->set(ready ? tr("answers") : tr("silent"), ready ? Chip::Kind::good : Chip::Kind::look);
  const bool no_handle = s.trouble == inverse::Trouble::no_handle;
  const QString message = ready ? tr("Move it: the place below follows the hand.")
               : no_handle ? tr("Its handle does not report any more. Switch the handle on; there is no force meanwhile.")
               : tr("It does not answer any more. It is looked for by itself; there is no force meanwhile.");
  const Vec3 at = s.reading.position_m;
  in.place->setText(QStringLiteral("%1   %2   %3").arg(millimetres_of_metres(at.x), millimetres_of_metres(at.y), millimetres_of_metres(at.z)));
  in.rate->setText(view.updates_per_s > 0 ? format_number(view.updates_per_s, 0) : QStringLiteral("–"));
  QStringList down;
  if (s.reading.a) down << QStringLiteral("A");
  if (s.reading.b) down << QStringLiteral("B");
  if (s.reading.c) down << QStringLiteral("C");
  in.handle->setText(!s.has_orientation ? tr("None: the bur keeps its axis")
                     : no_handle        ? tr("Does not report")
                     : down.isEmpty()   ? tr("Reports how it is turned")
                                        : tr("Pressed: %1").arg(down.join(QStringLiteral(", "))));
  return message;
}

QString InversePanel::summary() const { return QStringLiteral("Haply Inverse3: %1").arg(inner_->chip->text()); }

void InversePanel::hideEvent(QHideEvent* event) {
  release();
  QWidget::hideEvent(event);
}

}  // namespace cusp::ui
