/// The style of the program, with its rule for the wheel. Private to ui/widgets. Thread: GUI.
#pragma once

#include "ui/widgets/theme.h"

namespace cusp::ui {

/// The wheel scrolls the page. A spin box, a combo box, a slider or a tab bar takes it only with the focus, on a page that does
/// not scroll.
class PageStyle : public CuspStyle {
 public:
  using CuspStyle::polish;
  void polish(QWidget* widget) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace cusp::ui
