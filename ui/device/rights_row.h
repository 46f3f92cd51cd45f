/// What to do about a device that this user may not open: one line to copy. Thread: GUI.
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;

namespace cusp::ui {

class RightsRow : public QWidget {
  Q_OBJECT

 public:
  explicit RightsRow(QWidget* parent = nullptr);
  /// Shows itself with this command; empty: hides.
  void set_command(const QString& command);

 private:
  QLineEdit* line_;
};

}  // namespace cusp::ui
