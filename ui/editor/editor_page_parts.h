/// What the two files of the editor's page share.
#pragma once

#include <string>

#include "ui/text/language.h"

namespace cusp::ui {

/// Of the tabs at the right.
enum EditorTab { kShapeTab, kPointsTab, kBursTab, kTissuesTab, kWordsTab, kAuditTab };

struct ShapeChoice {
  const char* key;
  const char* icon;
};
inline constexpr ShapeChoice kShapes[] = {{"outline", "fissures"}, {"channel", "channel"}, {"box", "box"}};

/// Code of the language whose title stands at the top.
inline std::string screen_language() { return current_language() == u"de" ? "de" : "en"; }

}  // namespace cusp::ui
