/// Stands on the import page while there is no file: where to drop one, and what is read. Thread: GUI.
#pragma once

#include "ui/widgets/parts.h"

namespace cusp::ui {

class ImportDrop : public Card {
  Q_OBJECT

 public:
  explicit ImportDrop(QWidget* parent = nullptr);
  QPushButton* button() const { return button_; }

 Q_SIGNALS:
  void choose();

 private:
  void add_kind(QHBoxLayout& row, const QString& name, const QString& formats, const QString& about);

  QPushButton* button_;
};

}  // namespace cusp::ui
