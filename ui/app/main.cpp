// `cusp` opens the desktop; `cusp VERB …` does the same work without a window.

#include <QApplication>
#include <QCommandLineParser>

#include "device/hid/hid_station.h"
#include "device/hid/transport_hidapi.h"
#include "ui/app/accessible_parts.h"
#include "ui/app/desktop.h"
#include "ui/app/language.h"
#include "ui/app/settings.h"
#include "ui/cli/verbs.h"
#include "ui/device/hid_settings.h"
#include "ui/widgets/theme.h"

int main(int argc, char** argv) {
  if (cusp::is_verb(argc, argv)) return cusp::run_verb(argc, argv);

  QApplication app(argc, argv);
  cusp::install_accessible_parts();
  QCoreApplication::setApplicationName(QStringLiteral("Cusp"));
  QGuiApplication::setDesktopFileName(QStringLiteral("cusp"));
  QCommandLineParser line;
  const QCommandLineOption database(QStringLiteral("db"), QStringLiteral("Database file."), QStringLiteral("FILE"));
  line.addOption(database);
  line.process(app);

  cusp::Settings settings;
  cusp::install_language(app, settings.language());
  cusp::apply_theme(app, settings.scheme(), settings.scale_percent());
  const cusp::HidSettings kept;
  cusp::hid::HidStation hid(cusp::hid::make_hidapi_bus, kept.pedal(), kept.space_mouse());
  hid.start();
  cusp::Desktop desktop(settings, cusp::Ports::of_the_system(), cusp::database_path(line.value(database)));
  desktop.use_hid(hid);
  desktop.start();
  desktop.show();
  return QApplication::exec();
}
