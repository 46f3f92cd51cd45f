/// What the files of this folder share: their translation context, and strings of the modules below. Private to ui/text.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

namespace cusp::ui {

/// Text::tr("…") is looked up in the context cusp::ui::Text.
struct Text {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Text)
};

inline QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace cusp::ui
