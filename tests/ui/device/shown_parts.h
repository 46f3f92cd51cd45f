/// What a page or a form shows: its buttons and its labels by their texts.
#pragma once

#include <QLabel>
#include <QPushButton>

#include "tests/modules.h"

namespace cusp::test {

inline QPushButton* button(QWidget& in, const QString& text) {
  for (QPushButton* b : in.findChildren<QPushButton*>())
    if (b->text().trimmed() == text) return b;
  return nullptr;
}
inline bool shows(QWidget& in, const QString& part) {
  for (const QLabel* label : in.findChildren<QLabel*>())
    if (label->isVisibleTo(&in) && label->text().contains(part)) return true;
  return false;
}

}  // namespace cusp::test
