// One QApplication for all tests of a program, in English, light, at 100 %, away from the user's own folders.

#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>

#include "ui/text/language.h"
#include "ui/widgets/theme.h"

int main(int argc, char** argv) {
  const QTemporaryDir home;
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"}) {
    qputenv(name, home.path().toUtf8());
  }
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("LC_ALL", "C.UTF-8");
  QApplication app(argc, argv);
  cusp::ui::install_language(app, QStringLiteral("en"));
  cusp::ui::apply_theme(app, cusp::ui::ColourScheme::light, 100);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
