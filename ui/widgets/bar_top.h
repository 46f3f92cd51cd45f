/// The bar at the top of a page that fills the window: a surface of 48 px with a line below. Thread: GUI.
#pragma once

#include <QString>

class QFrame;
class QHBoxLayout;
class QLabel;
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
/// The page's title takes the rest of the row. One that is longer is elided, and its tool tip has the whole then.
QLabel* add_title(const BarTop& top, const QString& title);
/// Escape goes back, too: of a page where nothing typed is lost by it.
void let_escape_go_back(QPushButton* back);

}  // namespace cusp::ui
