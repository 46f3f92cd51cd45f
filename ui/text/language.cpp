#include "ui/text/language.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

static void load_resources() { Q_INIT_RESOURCE(cusp_translations); }

namespace cusp::ui {
namespace {

constexpr const char* kProperty = "cusp_language";

QString of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const QString value = qEnvironmentVariable(name);
    if (!value.isEmpty()) return value.section(u'.', 0, 0).section(u'_', 0, 0);
  }
  return QStringLiteral("en");
}

}  // namespace

QVector<Language> languages() { return {{u"en"_qs, u"English"_qs}, {u"de"_qs, u"Deutsch"_qs}}; }

void install_language(QCoreApplication& app, const QString& wanted) {
  load_resources();
  QString code = wanted.isEmpty() ? of_environment() : wanted;
  bool known = code == u"pseudo";
  for (const Language& language : languages()) known = known || language.code == code;
  if (!known) code = QStringLiteral("en");

  for (QTranslator* old : app.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly)) {
    app.removeTranslator(old);
    delete old;
  }
  // Numbers and dates: the country's own where the environment names one of this language.
  const QLocale system = QLocale::system();
  const QLocale plain(code == u"pseudo" ? u"en"_qs : code);
  QLocale locale = system.language() == plain.language() ? system : plain;
  // No thousands sign: a score or a count of attempts never needs one, and a field that reads it back may not know it.
  locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
  QLocale::setDefault(locale);

  auto* of_qt = new QTranslator(&app);
  if (code != u"en" && of_qt->load(u"qtbase_"_qs + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    app.installTranslator(of_qt);
  }
  auto* own = new QTranslator(&app);
  if (own->load(u":/i18n/cusp_"_qs + code + u".qm"_qs)) app.installTranslator(own);
  app.setProperty(kProperty, code);
  if (qobject_cast<QGuiApplication*>(&app)) QGuiApplication::setLayoutDirection(plain.textDirection());
}

QString current_language() {
  const QString code = qApp ? qApp->property(kProperty).toString() : QString();
  return code.isEmpty() ? QStringLiteral("en") : code;
}

}  // namespace cusp::ui
