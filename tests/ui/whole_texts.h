// Pages without a cut or covered text.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <string>
#include <vector>

namespace cusp::test {

inline std::string described(const QWidget& widget) {
  QString text = widget.accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget); text.isEmpty() && button) text = button->text();
  if (const auto* label = qobject_cast<const QLabel*>(&widget); text.isEmpty() && label) text = label->text();
  return (QString::fromLatin1(widget.metaObject()->className()) + QStringLiteral(" \"") + text.left(60) + u'"').toStdString();
}

/// A text that its widget is too small for.
inline bool clipped(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    if (label->text().isEmpty()) return false;
    return label->wordWrap() ? label->heightForWidth(label->width()) > label->height() + 1 : label->sizeHint().width() > label->width() + 1;
  }
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return button && !button->text().isEmpty() && button->sizeHint().width() > button->width() + 1;
}

/// Cut off by a widget that it stands in, up to one that scrolls.
inline bool beyond_parent(const QWidget& widget) {
  if (widget.isWindow()) return false;
  for (const QWidget* at = widget.parentWidget(); at != nullptr; at = at->parentWidget()) {
    if (qobject_cast<const QAbstractScrollArea*>(at->parentWidget())) return false;
    if (!at->rect().adjusted(-1, -1, 1, 1).contains(QRect(widget.mapTo(at, QPoint()), widget.size()))) return true;
    if (at->isWindow()) return false;
  }
  return false;
}

inline void expect_nothing_clipped(QWidget& window, const std::string& page) {
  QTest::qWait(0);
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || !(qobject_cast<const QLabel*>(widget) || qobject_cast<const QAbstractButton*>(widget))) continue;
    EXPECT_FALSE(clipped(*widget)) << page << ": too small for its text, " << described(*widget) << ", " << widget->width() << " of "
                                   << widget->sizeHint().width();
    EXPECT_FALSE(beyond_parent(*widget)) << page << ": cut off, " << described(*widget);
  }
}

/// Buttons, fields and texts of one parent that cover each other.
inline void expect_nothing_overlaps(QWidget& window, const std::string& page) {
  for (const QWidget* parent : window.findChildren<QWidget*>()) {
    if (!parent->isVisible()) continue;
    std::vector<const QWidget*> shown;
    for (const QWidget* one : parent->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
      const bool read = qobject_cast<const QLabel*>(one) || qobject_cast<const QAbstractButton*>(one) || qobject_cast<const QLineEdit*>(one);
      if (read && one->isVisible() && !one->size().isEmpty()) shown.push_back(one);
    }
    for (std::size_t i = 0; i < shown.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(shown[i]->geometry().intersects(shown[j]->geometry())) << page << ": " << described(*shown[i]) << " covers " << described(*shown[j]);
  }
}

inline constexpr QSize kHalfOfFullHd{960, 540};  // at 200 %

/// Nothing of a page cut off or covered at kHalfOfFullHd. `page`: for the message.
inline void expect_whole_at_half_of_full_hd(QWidget& window, const std::string& page) {
  QTest::qWait(0);
  EXPECT_EQ(window.size(), kHalfOfFullHd) << page << ": needs " << window.minimumSizeHint().width() << " x " << window.minimumSizeHint().height();
  expect_nothing_clipped(window, page);
  expect_nothing_overlaps(window, page);
}

}  // namespace cusp::test
