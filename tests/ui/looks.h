// Pages in each language and colour scheme, and pictures of them.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QWidget>

#include "tests/modules.h"
#include "ui/text/language.h"
#include "ui/widgets/theme.h"

namespace cusp::test {

/// What the bars leave of the window that full HD has at 200 %.
inline constexpr QSize kPageAtHalfOfFullHd{744, 476};

/// visit("de-light") and so on, each with its language and scheme set.
template <class Visit>
void in_each_look(Visit&& visit) {
  for (const char* language : {"de", "en"})
    for (const auto& [scheme, look] : {std::pair{ColourScheme::light, "light"}, {ColourScheme::dark, "dark"}}) {
      install_language(*qApp, QLatin1String(language));
      apply_theme(*qApp, scheme, 100);
      visit(QStringLiteral("%1-%2").arg(QLatin1String(language), QLatin1String(look)));
    }
}

inline bool pictures_wanted() { return qEnvironmentVariableIsSet("CUSP_PICTURES"); }

/// name.png in the folder CUSP_PICTURES, if that is set.
inline void leave_picture(QWidget& widget, const QString& name) {
  if (!pictures_wanted()) return;
  EXPECT_TRUE(widget.grab().save(qEnvironmentVariable("CUSP_PICTURES") + u'/' + name + QStringLiteral(".png")));
}

/// No visible button cuts its text. `look`: for the message.
inline void expect_buttons_fit(const QWidget& shown, const QString& look = {}) {
  for (const QAbstractButton* button : shown.findChildren<QAbstractButton*>()) {
    if (!button->isVisibleTo(&shown) || button->text().isEmpty()) continue;
    EXPECT_GE(button->width(), button->sizeHint().width()) << look.toStdString() << ": " << button->text().toStdString();
    EXPECT_GE(button->height(), button->sizeHint().height()) << look.toStdString() << ": " << button->text().toStdString();
  }
}

}  // namespace cusp::test
