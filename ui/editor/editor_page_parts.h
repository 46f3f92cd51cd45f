/// Declarations that the editor_page*.cpp files share.
#pragma once

#include <string>

#include "ui/text/language.h"

namespace cusp::ui {

/// Index of a tab at the right.
enum EditorTab { kShapeTab, kPointsTab, kBursTab, kTissuesTab, kWordsTab, kAuditTab };

struct ShapeChoice {
  const char* key;
  const char* icon;
};
inline constexpr ShapeChoice kShapes[] = {{"outline", "fissures"}, {"channel", "channel"}, {"box", "box"}};

/// Code of the language of the title at the head.
inline std::string screen_language() { return current_language() == u"de" ? "de" : "en"; }

}  // namespace cusp::ui
