/// The languages that Cusp speaks, and switching between them while it runs.
#pragma once

#include <QString>
#include <QVector>

class QCoreApplication;

namespace cusp::ui {

struct Language {
  QString code;  // "en", "de"
  QString name;  // in its own language
};

/// Those that are complete. The pseudo-language of the tests ("pseudo") is installed like any other, but not listed.
QVector<Language> languages();

/// Those that people write texts in, by their own names in the order of the alphabet. Codes of two or three letters.
QVector<Language> world_languages();
/// "English", "Français", "Português (BR)" of a code that an exercise may have; the code itself if nobody knows it.
QString language_name(const QString& code);

/// Installs the translations (Cusp's and Qt's own), the locale and the reading direction, instead of those before.
/// "" = the language of the environment (LC_ALL, LC_MESSAGES, LANG); an unknown one is English.
/// Every widget gets QEvent::LanguageChange.
void install_language(QCoreApplication& app, const QString& code);

/// Code of the language installed now.
QString current_language();

/// Language of the exercises' own texts where they have it: that of the program unless one was chosen. "": as the program.
QString exercise_language();
void choose_exercise_language(const QString& code);

}  // namespace cusp::ui
