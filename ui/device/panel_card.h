/// How every panel of one device begins: the card that it was put into, or one of its own, with a chip that shows the
/// device's state at its head; and how its parts do. Thread: GUI.
#pragma once

class QString;
class QVBoxLayout;
class QWidget;

namespace cusp::ui {

class Chip;

struct PanelCard {
  QVBoxLayout* column;  // where the panel's rows go
  Chip* state;
};

/// Gives `panel` its layout. Where its parent is a card with a head, that card's head has the chip; else the panel brings
/// a card with this title.
PanelCard panel_card(QWidget& panel, const QString& title);

/// A part of a panel: its rows one under the other, `gap_px` apart at 100 %, with no margin of its own.
QVBoxLayout* make_column(QWidget* part, int gap_px);

}  // namespace cusp::ui
