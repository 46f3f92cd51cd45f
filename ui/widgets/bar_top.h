/// The bar at the top of a page that fills the window: a surface of 48 px with a line below. Thread: GUI.
#pragma once

#include <QString>

class QFrame;
class QHBoxLayout;
class QPushButton;

namespace cusp::ui {

/// The bar, and the row that the page fills.
struct BarTop {
  QFrame* bar = nullptr;
  QHBoxLayout* row = nullptr;
};
BarTop make_bar_top();
/// The way back (Alt+Left) with a rule after it, which begins the row.
QPushButton* add_way_back(const BarTop& top, const QString& name);

}  // namespace cusp::ui
