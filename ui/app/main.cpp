// `cusp` opens the desktop, `cusp NAME.cusp` with that exercise file; `cusp VERB …` does the same work without a window.

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>

#include "device/hid/hid_station.h"
#include "device/hid/transport_hidapi.h"
#include "ui/app/accessible_parts.h"
#include "ui/app/desktop.h"
#include "ui/app/run_marker.h"
#include "ui/cli/verbs.h"
#include "ui/device/hid_settings.h"
#include "ui/render/opengl_allowed.h"
#include "ui/settings/settings.h"
#include "ui/text/language.h"
#include "ui/widgets/theme.h"

int main(int argc, char** argv) {
  if (cusp::ui::is_verb(argc, argv)) return cusp::ui::run_verb(argc, argv);

  QApplication app(argc, argv);
  cusp::ui::install_accessible_parts();
  QCoreApplication::setApplicationName(QStringLiteral("Cusp"));
  QGuiApplication::setDesktopFileName(QStringLiteral("cusp"));
  QCommandLineParser line;
  const QCommandLineOption database(QStringLiteral("db"), QStringLiteral("Database file."), QStringLiteral("FILE"));
  line.addOption(database);
  const QCommandLineOption safe(QStringLiteral("safe"), QStringLiteral("Start without 3D pictures: grade, replay and administer."));
  line.addOption(safe);
  line.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("Exercise file."), QStringLiteral("[FILE]"));
  line.process(app);

  if (line.isSet(safe)) cusp::ui::forbid_opengl();
  const cusp::ui::RunMarker marker(cusp::ui::Desktop::marker_folder());

  cusp::ui::Settings settings;
  cusp::ui::install_language(app, settings.language());
  cusp::ui::apply_theme(app, settings.scheme(), settings.scale_percent());
  const cusp::ui::HidSettings kept;
  cusp::device::hid::HidStation hid(cusp::device::hid::make_hidapi_bus, kept.pedal(), kept.space_mouse());
  hid.start();
  cusp::ui::Desktop desktop(settings, cusp::ui::Ports::of_the_system(), cusp::ui::database_path(line.value(database)));
  desktop.use_hid(hid);
  if (const QStringList files = line.positionalArguments(); !files.isEmpty()) {
    desktop.open_after_sign_in(QFileInfo(files.first()).absoluteFilePath());
  }
  if (marker.found_crash() && cusp::ui::opengl_allowed()) {
    desktop.show();
    desktop.offer_safe_start();
  } else {
    desktop.start();
    desktop.show();
  }
  return QApplication::exec();
}
