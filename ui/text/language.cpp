#include "ui/text/language.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <mutex>

#include "ui/widgets/format.h"

static void load_resources() { Q_INIT_RESOURCE(cusp_translations); }

namespace cusp::ui {
namespace {

/// What background tasks read while the window may change it.
struct Chosen {
  std::mutex mutex;  // guards what follows; held for a copy
  QString program, exercises;
};
Chosen& chosen() {
  static Chosen codes;
  return codes;
}
void put(QString& code, const QString& value) {
  const std::lock_guard lock(chosen().mutex);
  code = value;
}
QString copy_of(const QString& code) {
  const std::lock_guard lock(chosen().mutex);
  return code;
}

/// With a capital letter, as in a list.
QString own_name(const QLocale& locale) {
  QString name = locale.nativeLanguageName();
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name;
}

QString of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const QString value = qEnvironmentVariable(name);
    if (!value.isEmpty()) return value.section(u'.', 0, 0).section(u'_', 0, 0);
  }
  return QStringLiteral("en");
}

}  // namespace

QVector<Language> languages() { return {{u"en"_qs, u"English"_qs}, {u"de"_qs, u"Deutsch"_qs}}; }

QVector<Language> world_languages() {
  QVector<Language> out;
  for (int i = QLocale::C + 1; i <= QLocale::LastLanguage; ++i) {
    const auto language = static_cast<QLocale::Language>(i);
    const QString code = QLocale::languageToCode(language);
    const QLocale locale(language);
    // QLocale takes another language where it lacks that one.
    if (code.isEmpty() || locale.language() != language) continue;
    const QString name = language == QLocale::English ? u"English"_qs : own_name(locale);
    if (!name.isEmpty()) out += {code, name};
  }
  std::ranges::sort(out, [](const Language& a, const Language& b) { return QString::localeAwareCompare(a.name, b.name) < 0; });
  return out;
}

QString language_name(const QString& code) {
  for (const Language& language : languages())
    if (language.code == code) return language.name;
  const QLocale locale(code);
  if (locale.language() == QLocale::C) return code;
  const QString region = code.section(u'_', 1);
  return region.isEmpty() ? own_name(locale) : u"%1 (%2)"_qs.arg(own_name(locale), region);
}

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
  install_locale(locale);

  auto* of_qt = new QTranslator(&app);
  if (code != u"en" && of_qt->load(u"qtbase_"_qs + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    app.installTranslator(of_qt);
  }
  auto* own = new QTranslator(&app);
  if (own->load(u":/i18n/cusp_"_qs + code + u".qm"_qs)) app.installTranslator(own);
  put(chosen().program, code);
  if (qobject_cast<QGuiApplication*>(&app)) QGuiApplication::setLayoutDirection(plain.textDirection());
}

QString exercise_language() { return copy_of(chosen().exercises); }

void choose_exercise_language(const QString& code) { put(chosen().exercises, code); }

QString current_language() {
  const QString code = copy_of(chosen().program);
  return code.isEmpty() ? QStringLiteral("en") : code;
}

}  // namespace cusp::ui
