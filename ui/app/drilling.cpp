// The desktop's way into a go and out of it.

#include <QApplication>
#include <QKeyEvent>

#include "device/hid/hid_station.h"
#include "scenarios/format/read.h"
#include "ui/app/desktop.h"
#include "ui/device/falcon_text.h"
#include "ui/device/space_mouse_turner.h"
#include "ui/drill/drill_screen.h"
#include "ui/modules.h"
#include "ui/settings/device_settings.h"

namespace cusp::ui {

DrillScreen* Desktop::open_drilling(const RunPlan& plan, const DrillText& text) {
  auto* screen = new DrillScreen(nullptr, ports_);
  screen->keep_sound_in(&settings_);
  const DeviceChoice device = DeviceSettings(settings_.file()).choice();
  screen->use_device(device);
  connect(screen, &DrillScreen::left, this, &Desktop::back);
  connect(screen, &DrillScreen::failed, this, [this, kind = device.kind](const RunFailure& failure) {
    back();
    const auto* port = std::get_if<PortError>(&failure.cause);
    tell_failure(port != nullptr && kind == "falcon" ? tell_falcon({*port, failure.where, failure.detail}) : tell(failure));
  });
  push(screen);
  for (SpaceMouseTurner* turner : screen->findChildren<SpaceMouseTurner*>()) {
    connect(turner, &SpaceMouseTurner::mirror_asked, screen, [screen] {
      QKeyEvent mirror(QEvent::KeyPress, Qt::Key_2, Qt::NoModifier);  // so that the tool bar shows it too
      QApplication::sendEvent(screen, &mirror);
    });
  }
  RunPlan with_pedal = plan;
  if (hid_) with_pedal.pedal = hid_->pedal_source();
  screen->begin(std::move(with_pedal), text);
  return screen;
}

void Desktop::drill(const Exercise& exercise) {
  RunPlan plan;
  QString aside = tr("Try it: nothing is kept");
  if (account_) {
    plan.database = database_;
    plan.student = account_->actor();
    const auto goes = store_->history.attempts(account_->actor(), account_->id, exercise.scenario.id);
    aside = tr("Practice, go %1").arg(goes.value_or(0) + 1);
  } else {
    plan.kind = SessionKind::try_it;
  }
  show_drilling(exercise, std::move(plan), aside);
}

void Desktop::go_on(const SessionId& session) {
  const auto details = store_->history.details(account_->actor(), session);
  if (!details) return tell_failure(tell(details.error()));
  // The exercise as it was then: a newer version may have another target.
  const auto version = store_->scenarios.version(details->session.version);
  if (!version) return tell_failure(tell(version.error()));
  auto scenario = read_scenario(version->json);
  if (!scenario) return tell_failure(tell(scenario.error()));
  RunPlan plan;
  plan.database = database_;
  plan.student = account_->actor();
  plan.go_on = session;
  const Exercise exercise{std::move(*scenario), version->id, version->number, version->files};
  show_drilling(exercise, std::move(plan), tr("Practice, attempt %1, continued").arg(details->row.attempt));
}

void Desktop::show_drilling(const Exercise& exercise, RunPlan plan, const QString& aside) {
  plan.scenario = exercise.scenario;
  plan.version = exercise.version;
  if (const auto folder = exercise_folder(*store_, exercise, volume_folder())) plan.scenario_folder = *folder;
  const DrillText text{local(exercise.scenario.title), aside};
  DrillScreen* screen = open_drilling(plan, text);
  connect(screen, &DrillScreen::finished, this, [this, exercise](std::shared_ptr<const RunResult> result) {
    back();
    show_result(std::move(result), exercise);
  });
}

}  // namespace cusp::ui
