/// What the files of sentences in this folder share: their context of translation, and text from the rooms below. Private to ui/app.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

namespace cusp {

/// Words::tr("…") is looked up in the context cusp::Sentences.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(cusp::Sentences)
};

inline QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace cusp
