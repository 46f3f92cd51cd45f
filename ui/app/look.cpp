// How the desktop is shown: colours, size and languages.

#include <QApplication>

#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/settings/settings.h"
#include "ui/text/language.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

// A page is made anew, and its half-filled form goes with it: leave_page() asks first.

void Desktop::set_scheme(ColourScheme scheme) {
  leave_page([this, scheme] {
    settings_.set_scheme(scheme);
    apply_theme(*qApp, scheme, scale_percent());
    rebuild();
  });
}

void Desktop::use_text(TextSize size) {
  const int usual = settings_.scale_percent(), wanted = size == TextSize::large ? std::max(usual, kLargeTextPercent) : usual;
  if (wanted != scale_percent()) apply_theme(*qApp, settings_.scheme(), wanted);
}

void Desktop::set_language(const QString& code) {
  leave_page([this, code] {
    settings_.set_language(code);
    install_language(*qApp, code);
    rebuild();
  });
}

void Desktop::set_scale(int percent) {
  leave_page([this, percent] {
    settings_.set_scale_percent(percent);
    apply_theme(*qApp, settings_.scheme(), percent);
    rebuild();
  });
}

void Desktop::set_exercise_language(const QString& code) {
  leave_page([this, code] {
    settings_.set_exercise_language(code);
    choose_exercise_language(code);
    rebuild();
  });
}

/// Those of the published exercises, where one has more than the program speaks, or where a choice was made.
void Desktop::offer_exercise_languages(Shell& shell) {
  QStringList codes;
  for (const Language& language : languages()) codes += language.code;
  const qsizetype spoken = codes.size();
  if (const auto library = store_->scenarios.library()) {
    for (const ScenarioVersion& exercise : *library)
      for (const auto& [code, title] : exercise.title) codes += QString::fromStdString(code);
  }
  codes.removeDuplicates();
  if (codes.size() == spoken && exercise_language().isEmpty()) return;
  shell.offer_exercise_languages(codes, exercise_language());
  connect(&shell, &Shell::exercise_language_chosen, this, &Desktop::set_exercise_language);
}

}  // namespace cusp::ui
