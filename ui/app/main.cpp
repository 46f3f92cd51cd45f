// `cusp` opens the desktop, `cusp NAME.cusp` with that exercise file; `cusp VERB …` does the same work without a window.

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QTimer>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "device/hid/hid_station.h"
#include "device/hid/transport_hidapi.h"
#include "ui/app/accessible_parts.h"
#include "ui/app/closing_window.h"
#include "ui/app/desktop.h"
#include "ui/app/run_marker.h"
#include "ui/cli/terminal.h"
#include "ui/cli/verbs.h"
#include "ui/device/hid_settings.h"
#include "ui/render/opengl_allowed.h"
#include "ui/session/background_task.h"
#include "ui/session/keep_awake.h"
#include "ui/settings/settings.h"
#include "ui/student/exercises.h"
#include "ui/text/language.h"
#include "ui/widgets/theme.h"

namespace {

using Steps = std::vector<std::function<void()>>;

/// Each step in a turn of the event loop of its own: the window answers between them. None follows once `turns` is gone.
void run_in_turns(QObject* turns, const Steps& steps, std::size_t next = 0) {
  if (next == steps.size()) return;
  steps[next]();
  QTimer::singleShot(0, turns, [turns, steps, next] { run_in_turns(turns, steps, next + 1); });
}

}  // namespace

int main(int argc, char** argv) {
  cusp::ui::hold_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the process's file-size limit then fails with EFBIG
  std::signal(SIGPIPE, SIG_IGN);  // a write to a pipe that its reader has closed then fails with EPIPE, and the program goes on
  if (cusp::ui::is_verb(argc, argv) || cusp::ui::no_display(argc, argv)) return cusp::ui::run_verb(argc, argv);

  QApplication app(argc, argv);
  cusp::ui::TasksEndHere tasks_end;
  cusp::ui::install_accessible_parts();
  QCoreApplication::setApplicationName(QStringLiteral("Cusp"));
  QGuiApplication::setDesktopFileName(QStringLiteral("cusp"));
  QCommandLineParser line;
  const QCommandLineOption database(QStringLiteral("db"), QStringLiteral("Database file."), QStringLiteral("FILE"));
  line.addOption(database);
  const QCommandLineOption safe(QStringLiteral("safe"), QStringLiteral("Start without 3D pictures: grade, replay and administer."));
  line.addOption(safe);
  line.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("Exercise file."), QStringLiteral("[FILE]"));
  if (!line.parse(QCoreApplication::arguments())) {
    std::fprintf(stderr, "cusp: %s\n", qUtf8Printable(line.errorText()));
    return 2;  // as a verb's kWrongUsage
  }
  cusp::ui::install_language(app, {});  // of the environment, as a verb speaks; the window has its own
  if (const auto status = cusp::ui::refuse_files(line.positionalArguments())) return *status;

  if (line.isSet(safe)) cusp::ui::forbid_opengl();
  const cusp::ui::RunMarker marker(cusp::ui::Desktop::marker_folder());

  cusp::ui::Settings settings;
  const cusp::ui::HidSettings kept;
  cusp::device::hid::HidStation hid(cusp::device::hid::make_hidapi_bus, kept.pedal(), kept.space_mouse());
  hid.start();
  std::optional<cusp::ui::Desktop> desktop;
  const auto look = [&] {
    cusp::ui::install_language(app, settings.language());
    cusp::ui::choose_exercise_language(settings.exercise_language());
    cusp::ui::apply_theme(app, settings.scheme(), settings.scale_percent());
  };
  const auto make = [&] {
    cusp::ui::Ports ports = cusp::ui::Ports::of_the_system();
    ports.keep_awake = [](const QString& why) { return std::make_shared<cusp::ui::KeepAwake>(why.toStdString()); };
    desktop.emplace(settings, std::move(ports), cusp::ui::database_path(line.value(database)));
    desktop->use_hid(hid);
    if (const QStringList files = line.positionalArguments(); !files.isEmpty()) {
      desktop->open_after_sign_in(QFileInfo(files.first()).absoluteFilePath());
    }
  };
  const auto start = [&] { desktop->start(); };
  const auto show = [&] { desktop->show(); };
  const cusp::ui::BackgroundTask read_ahead(cusp::ui::read_builtin_exercises);  // 0.1 s that a page would wait for
  const auto offer = [&] { desktop->offer_safe_start(); };
  const bool crashed = marker.found_crash() && cusp::ui::opengl_allowed();
  auto turns = std::make_unique<QObject>();
  QTimer::singleShot(0, turns.get(), [&turns, steps = crashed ? Steps{look, make, show, offer} : Steps{look, make, start, show}] { run_in_turns(turns.get(), steps); });
  const int status = QApplication::exec();
  turns.reset();
  desktop.reset();  // what its pages have begun is dropped
  if (cusp::ui::ClosingWindow().wait() == cusp::ui::ClosingWindow::End::left) tasks_end.leave_tasks(status);
  return status;
}
