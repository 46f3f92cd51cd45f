#include "ui/device/falcon_panel.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSysInfo>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "device/catalogue.h"
#include "device/falcon/force_test.h"
#include "device/falcon/permissions.h"
#include "device/falcon/self_test.h"
#include "device/falcon/weighing.h"
#include "ui/device/falcon_now.h"
#include "ui/device/homing_view.h"
#include "ui/device/kept_band.h"
#include "ui/device/panel_card.h"
#include "ui/device/rights_row.h"
#include "ui/device/self_test_report.h"
#include "ui/device/trim_form.h"
#include "ui/modules.h"
#include "ui/session/device_bench.h"
#include "ui/text/falcon_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_bytes.h"

namespace cusp::ui {
namespace {

constexpr int kFalconRefreshMs = 50;
constexpr double kFeelN = 2.0;  // of the force test

void set_text_if_new(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

}  // namespace

struct FalconPanel::Inner {
  enum class Running { nothing, force, self_test, weighing };
  Inner(DeviceSettings& station, Ports world, Role role) : settings(station), ports(std::move(world)), staff(role != Role::student) {}

  DeviceSettings& settings;
  Ports ports;
  bool staff;
  std::string kind, name;
  std::unique_ptr<DeviceBench> bench;
  BenchView view;
  Running running = Running::nothing;
  falcon::SelfTestResult found;
  bool has_found = false, shown_failure = false;
  QTimer timer;

  Band* band;
  QPushButton* again;
  RightsRow* rights;
  HomingView* homing;
  FalconNow* now;
  Card* trim_card;
  TrimForm* trim;
  KeptBand* unkept;
  QLabel *step, *outcome, *measured;
  QProgressBar* progress;
  QPushButton *force, *self_test, *weigh, *stop, *save;
  QPushButton* started = nullptr;  // began the newest test

  void begin(Running test, QPushButton* button, std::unique_ptr<falcon::Trial> trial) {
    if (!bench || !bench->start(std::move(trial))) return;
    running = test;
    started = button;
  }
};

FalconPanel::FalconPanel(DeviceSettings& settings, Ports ports, Role role, QWidget* parent)
    : QWidget(parent), inner_(std::make_unique<Inner>(settings, std::move(ports), role)) {
  Inner& in = *inner_;
  QVBoxLayout* column = make_column(this, 16);
  in.band = new Band(this);
  in.again = make_button(tr("Try again"), ButtonKind::standard, QStringLiteral("refresh"));
  connect(in.again, &QPushButton::clicked, this, [this] { set_device(inner_->kind, inner_->name); });
  in.band->ways_out()->addWidget(in.again);
  column->addWidget(in.band);
  in.rights = new RightsRow(this);
  column->addWidget(in.rights);

  make_live(column);
  make_tests(column);
  column->addWidget(in.unkept = new KeptBand(settings.file()));  // of tests and trim: between them
  make_trim(column);
  in.self_test->setVisible(in.staff);
  in.weigh->setVisible(in.staff);
  in.measured->setVisible(in.staff);
  in.save->hide();
  in.stop->hide();
  in.step->hide();
  in.progress->hide();
  in.outcome->hide();
  in.timer.setInterval(kFalconRefreshMs);
  connect(&in.timer, &QTimer::timeout, this, &FalconPanel::look);
}

void FalconPanel::make_live(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* row = new QHBoxLayout;
  row->setSpacing(px(16));
  auto* place = new Card(tr("Homing"), {}, this);
  in.homing = new HomingView(place);
  place->body()->addWidget(in.homing);
  place->body()->addStretch();
  row->addWidget(place, 1);

  auto* live = new Card(tr("Now"), {}, this);
  in.now = new FalconNow(live);
  connect(in.now, &FalconNow::light_wanted, this, [this](std::uint8_t leds) {
    if (inner_->bench) inner_->bench->set_leds(leds);
  });
  live->body()->addWidget(in.now);
  live->body()->addStretch();
  row->addWidget(live, 1);
  column->addLayout(row);
}

void FalconPanel::make_tests(QVBoxLayout* column) {
  Inner& in = *inner_;
  auto* tests = new Card(tr("Tests"), {}, this);
  auto* acts = new QHBoxLayout;
  acts->setSpacing(px(8));
  in.force = make_button(tr("Feel the force"), ButtonKind::standard, QStringLiteral("hand"));
  connect(in.force, &QPushButton::clicked, this, &FalconPanel::start_force_test);
  acts->addWidget(in.force);
  in.self_test = make_button(tr("Self-test"), ButtonKind::standard, QStringLiteral("ruler"));
  connect(in.self_test, &QPushButton::clicked, this, &FalconPanel::start_self_test);
  acts->addWidget(in.self_test);
  in.weigh = make_button(tr("Weigh the grip"), ButtonKind::standard, QStringLiteral("dot"));
  connect(in.weigh, &QPushButton::clicked, this, &FalconPanel::start_weighing);
  acts->addWidget(in.weigh);
  acts->addStretch();
  in.stop = make_button(tr("Stop"), ButtonKind::erase, QStringLiteral("stop"));
  connect(in.stop, &QPushButton::clicked, this, [this] {
    if (inner_->bench) inner_->bench->stop_trial();
  });
  acts->addWidget(in.stop);
  tests->body()->addLayout(acts);
  in.step = make_label({}, TextRole::section, Weight::bold);
  in.progress = new QProgressBar(tests);
  in.progress->setRange(0, 100);
  in.progress->setTextVisible(false);
  in.outcome = make_label({});
  in.outcome->setWordWrap(true);
  in.measured = make_label({}, TextRole::body, Weight::regular, "text2");
  in.measured->setWordWrap(true);
  in.save = make_button(tr("Save the report…"), ButtonKind::standard, QStringLiteral("save"));
  connect(in.save, &QPushButton::clicked, this, &FalconPanel::save_report);
  for (QWidget* w : std::initializer_list<QWidget*>{in.step, in.progress, in.outcome, in.measured}) tests->body()->addWidget(w);
  tests->body()->addWidget(in.save, 0, Qt::AlignLeft);
  column->addWidget(tests);
}

void FalconPanel::make_trim(QVBoxLayout* column) {
  Inner& in = *inner_;
  in.trim_card = new Card(tr("How the grip leads the bur"), {}, this);
  in.trim = new TrimForm(in.trim_card);
  in.trim_card->body()->addWidget(in.trim);
  connect(in.trim, &TrimForm::changed, this, [this](const FalconTrim& trim) {
    FalconProfile profile = inner_->settings.profile(inner_->name);
    put_trim(trim, profile);
    inner_->unkept->show_kept(inner_->settings.set_profile(inner_->name, profile));
    if (inner_->bench) inner_->bench->set_force_gain(trim.force_gain);
    show_measured();
  });
  column->addWidget(in.trim_card);
}

FalconPanel::~FalconPanel() = default;

void FalconPanel::set_device(const std::string& kind, const std::string& name) {
  release();
  inner_->kind = kind;
  inner_->name = name;
  inner_->has_found = false;
  inner_->save->hide();
  inner_->outcome->hide();
  inner_->band->clear();
  inner_->rights->set_command({});
  inner_->homing->show_falcon({});
  // Nothing is kept of an emulated one.
  inner_->trim_card->setVisible(inner_->staff && kind == "falcon");
  inner_->trim->set_trim(trim_of(inner_->settings.profile(name)));
  inner_->trim->hide_grip();
  show_measured();
  if (isVisible()) open();
}

void FalconPanel::open() {
  Inner& in = *inner_;
  if (in.kind.empty() || in.bench) return;
  in.shown_failure = false;
  in.bench = std::make_unique<DeviceBench>(in.settings.choice_of(in.kind, in.name));
  in.timer.start();
}

void FalconPanel::release() {
  inner_->timer.stop();
  inner_->bench.reset();
  inner_->running = Inner::Running::nothing;
  inner_->view = {};
}

void FalconPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  open();
  look();
}

void FalconPanel::hideEvent(QHideEvent* event) {
  release();
  QWidget::hideEvent(event);
}

QString FalconPanel::summary() const {
  if (!inner_->band->text().isEmpty()) return inner_->band->text();
  return phase_text(inner_->view.falcon.session);
}

void FalconPanel::look() {
  Inner& in = *inner_;
  if (!in.bench) return;
  in.view = in.bench->view();
  const BenchView& v = in.view;
  in.homing->show_falcon(v.falcon);
  if (v.phase == BenchPhase::failed && !in.shown_failure) {
    in.shown_failure = true;
    if (const auto failure = in.bench->failure()) {
      const Message message = describe_falcon(*failure);
      in.band->show_message(Band::Kind::bad, message.what, message.more);
      // Where Qt put the keyboard when the button went.
      if (in.now->isAncestorOf(QApplication::focusWidget())) in.again->setFocus();
      if (failure->code == PortError::no_permission)
        in.rights->set_command(QString::fromStdString(falcon::udev_install_command()));
    }
  }
  const bool up = v.phase == BenchPhase::running;
  in.now->show_bench(v);
  const bool homed = up && v.falcon.session.phase == falcon::Phase::ready;
  if (homed) {
    in.trim->show_grip(v.falcon);
  } else {
    in.trim->hide_grip();
  }
  const bool tests = in.running != Inner::Running::nothing;
  in.trim->setEnabled(!tests);
  const bool may = homed && !tests;
  in.force->setEnabled(may);
  in.self_test->setEnabled(may);
  in.weigh->setEnabled(may);
  // Whoever feels a wrong force stops it with one key: elsewhere that key would press what happens to stand next.
  const bool begins = tests && in.stop->isHidden(), ends = !tests && in.stop->hasFocus();
  in.stop->setVisible(tests);
  if (begins) in.stop->setFocus();
  if (ends && in.started != nullptr) in.started->setFocus();
  in.step->setVisible(tests);
  in.progress->setVisible(tests);
  if (!tests) return;
  QString step;
  switch (in.running) {
    case Inner::Running::force: step = way_text(static_cast<falcon::ForceWay>(v.trial_step)); break;
    case Inner::Running::self_test: step = tr("Measuring, direction %1 of 3. Keep your hand off.").arg(v.trial_step + 1); break;
    case Inner::Running::weighing:
      step = tr("Weighing, place %1 of %2. Keep your hand off.").arg(std::min(v.trial_step + 1, +falcon::Weighing::kPlaces)).arg(+falcon::Weighing::kPlaces);
      break;
    case Inner::Running::nothing: break;
  }
  set_text_if_new(in.step, step);
  in.progress->setValue(static_cast<int>(std::lround(100 * v.trial_share)));
  trial_over();
}

void FalconPanel::start_force_test() {
  const Question question{tr("Hold the grip loosely"), tr("It pushes six ways, one after the other, up to %1. Releasing the grip switches it off.").arg(format({kFeelN, {}, QStringLiteral("N"), 1})), tr("Push")};
  inner_->ports.ask(this, question, [self = QPointer(this)](bool yes) {
    if (self && yes) self->inner_->begin(Inner::Running::force, self->inner_->force, std::make_unique<falcon::ForceTest>(kFeelN));
  });
}

void FalconPanel::start_self_test() {
  const Question question{tr("Release the grip"), tr("For half a minute it moves by itself, a centimetre each way. Nobody may touch it, and nothing may stand in its way."), tr("Measure")};
  inner_->ports.ask(this, question, [self = QPointer(this)](bool yes) {
    if (self && yes) self->inner_->begin(Inner::Running::self_test, self->inner_->self_test, std::make_unique<falcon::SelfTest>());
  });
}

void FalconPanel::start_weighing() {
  const Question question{tr("Stand it upright and release the grip"), tr("It holds the grip at nine places, for half a minute. From then on it carries its own weight."), tr("Weigh")};
  inner_->ports.ask(this, question, [self = QPointer(this)](bool yes) {
    if (!self || !yes) return;
    Inner& inner = *self->inner_;
    const FalconSettings driver = settings_for(inner.settings.profile(inner.name));
    inner.begin(Inner::Running::weighing, inner.weigh, std::make_unique<falcon::Weighing>(driver.geometry, driver.calibration));
  });
}

void FalconPanel::trial_over() {
  Inner& in = *inner_;
  const auto trial = in.bench->take_trial();
  if (!trial) return;
  const Inner::Running was = std::exchange(in.running, Inner::Running::nothing);
  in.outcome->show();
  if (trial->end() != falcon::TrialEnd::done) {
    in.outcome->setText(end_text(trial->end()));
    announce(this, in.outcome->text());
    return;
  }
  const bool real = in.kind == "falcon";
  FalconProfile profile = in.settings.profile(in.name);
  if (was == Inner::Running::force) {
    in.outcome->setText(tr("All six ways were pushed. If one of them felt wrong, report it to the staff."));
  } else if (was == Inner::Running::weighing) {
    const auto weight = dynamic_cast<const falcon::Weighing&>(*trial).result();
    if (!weight) {
      in.outcome->setText(tr("No weight fits what was held. Stand it upright, keep hands off, and weigh again."));
    } else {
      profile.gravity = *weight;
      const QString kilos = format({weight->grip_kg * 1e3, {}, QStringLiteral("g"), 0});
      in.outcome->setText(real ? tr("The grip weighs %1. From the next attempt on it carries itself.").arg(kilos)
                               : tr("The grip weighs %1. Nothing is kept of an emulated one.").arg(kilos));
      if (real) in.unkept->show_kept(in.settings.set_profile(in.name, profile));
    }
  } else {
    in.found = dynamic_cast<const falcon::SelfTest&>(*trial).result();
    self_test_over();
  }
  announce(this, in.outcome->text());
  show_measured();
}

/// Takes over what was measured of a real Falcon.
void FalconPanel::self_test_over() {
  Inner& in = *inner_;
  FalconProfile profile = in.settings.profile(in.name);
  in.has_found = true;
  const auto damping = in.found.damping_ns_per_m(), delay = in.found.delay_ms();
  if (!damping || !delay) {
    in.outcome->setText(tr("It moved too little to be measured. Is something in its way? The report has what there is."));
  } else {
    const double before = allowed_stiffness(profile).n_per_mm;
    profile.damping_ns_per_m = damping;
    profile.delay_ms = delay;
    profile.friction_n = in.found.friction_n();
    profile.moving_kg = in.found.moving_kg();
    profile.encoder_mm = in.found.encoder_mm();
    in.outcome->setText(measured_text(in.found, before, allowed_stiffness(profile).n_per_mm) +
                        (in.kind == "falcon" ? QString() : u' ' + tr("The figures of an emulated one are not kept.")));
    if (in.kind == "falcon") {
      in.settings.set_profile(in.name, profile);
      in.unkept->show_kept(in.settings.set_tested_at(in.name, in.ports.now()));  // the profile's, too
    }
  }
  in.save->show();
  const auto outcome = damping && delay ? TestOutcome::passed : TestOutcome::failed;
  Q_EMIT tested({.device_class = std::string(device_kind(in.kind)->device_class), .device = in.name, .outcome = outcome});
}

void FalconPanel::show_measured() {
  Inner& in = *inner_;
  if (in.kind != "falcon") {
    in.measured->setText({});
    return;
  }
  const FalconProfile profile = in.settings.profile(in.name);
  const AllowedStiffness allowed = allowed_stiffness(profile);
  const QString most = format({allowed.n_per_mm, {}, QStringLiteral("N/mm"), 2});
  const auto when = in.settings.tested_at(in.name);
  in.measured->setText(allowed.assumed || !when
                           ? tr("Not measured yet: damping and delay are assumed, and exercises are no stiffer than %1.").arg(most)
                           : tr("Measured %1: exercises are no stiffer than %2.").arg(format_day_time(*when), most));
}

void FalconPanel::save_report() {
  Inner& in = *inner_;
  if (!in.has_found) return;
  const FalconProfile profile = in.settings.profile(in.name);
  const ReportedDevice device{in.kind, in.name, QSysInfo::machineHostName().toStdString(), in.settings.firmware().sha256, in.ports.now()};
  const QByteArray text = self_test_report(device, in.found, profile, in.view);
  in.ports.pick_file(this, {tr("Save the report"), QStringLiteral("falcon-self-test.json"), tr("Report (*.json)"), true},
                     [self = QPointer(this), text](const QString& path) {
                       if (!self) return;
                       const auto written = save_bytes(path, text);
                       self->inner_->outcome->setText(written ? tr("The report lies at %1.").arg(isolate(path))
                                                              : tr("%1 cannot be written: %2.").arg(isolate(path), written.error()));
                     });
}

}  // namespace cusp::ui
