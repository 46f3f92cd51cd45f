/// A button that folds a menu down. Thread: GUI.
#pragma once

class QMenu;
class QPushButton;

namespace cusp::ui {

/// Gives the button its menu, and the sign of one.
QPushButton* put_menu(QPushButton* button, QMenu* menu);

}  // namespace cusp::ui
