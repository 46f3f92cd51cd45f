/// What the files of sentences in this folder share: their context of translation, and text from the rooms below. Private to ui/app.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

namespace cusp::ui {

/// Text::tr("…") is looked up in the context Sentences.
struct Text {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Sentences)
};

inline QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace cusp::ui
