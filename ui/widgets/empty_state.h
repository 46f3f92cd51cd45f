/// Stands where a list is still empty: gives the reason and offers the next action. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/widgets/icon.h"

class QPushButton;

namespace cusp::ui {

class EmptyState : public QWidget {
  Q_OBJECT

 public:
  /// `act` may be empty: then there is no button.
  EmptyState(const QString& icon_name, const QString& title, const QString& why, const QString& act = {},
             Ink ink = Ink::text2, QWidget* parent = nullptr);
  QPushButton* button() { return button_; }

 Q_SIGNALS:
  void acted();

 private:
  QPushButton* button_ = nullptr;
};

}  // namespace cusp::ui
