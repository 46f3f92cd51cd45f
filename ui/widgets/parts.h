/// Small parts that every screen uses: buttons by kind, cards, key caps, a choice of segments, a band over the page.
#pragma once

#include <QAbstractButton>
#include <QFrame>
#include <QString>
#include <functional>

#include "ui/widgets/icon.h"

class QBoxLayout;
class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace cusp::ui {

enum class ButtonKind { standard, primary, quiet, erase };

/// `icon_name` may be empty; `key` is shown as a key cap text in the tooltip ("P", "Ctrl+Return") and set as shortcut.
QPushButton* make_button(const QString& text, ButtonKind kind = ButtonKind::standard, const QString& icon_name = {},
                         const QKeySequence& key = {});
/// 40 high, for a page's main act.
QPushButton* make_large_button(const QString& text, ButtonKind kind, const QString& icon_name = {});
/// Icon alone, with name and tooltip.
QToolButton* make_icon_button(const QString& icon_name, const QString& name, const QKeySequence& key = {});

/// A card: surface, one line around, radius 8.
class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);
  /// Section title at the left, quiet text at the right.
  explicit Card(const QString& title, const QString& aside = {}, QWidget* parent = nullptr);
  QVBoxLayout* body() { return body_; }
  QHBoxLayout* head() { return head_; }
  void set_title(const QString& title);
  void set_aside(const QString& aside);

 private:
  QVBoxLayout* body_;
  QHBoxLayout* head_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* aside_ = nullptr;
};

/// One of a few, side by side ("Student | Staff"). Arrow keys move.
class Segments : public QWidget {
  Q_OBJECT

 public:
  explicit Segments(const QStringList& names, QWidget* parent = nullptr);
  int chosen() const;
  void choose(int index);
  QAbstractButton* button(int index) const;

 Q_SIGNALS:
  void changed(int index);

 private:
  QButtonGroup* group_;
};

/// A band at the head of a page: sign, bold sentence, plain sentence, ways out. Announced when it appears.
class Band : public QFrame {
  Q_OBJECT

 public:
  enum class Kind { info, look, bad, good };
  explicit Band(QWidget* parent = nullptr);
  void show_message(Kind kind, const QString& what, const QString& more = {});
  void clear();
  QString text() const;
  QHBoxLayout* ways_out() { return ways_out_; }

 private:
  QLabel* sign_;
  QLabel* text_;
  QHBoxLayout* ways_out_;
};

/// A field under its label, 12 px; the label is the field's buddy and its name.
QWidget* labelled(const QString& label, QWidget* field, QLabel** out_label = nullptr);

/// A line of a panel: sign, name, and at the right the value, which is said under that name. Without a parent.
QWidget* make_fact_row(const QString& icon_name, const QString& name, QLabel** value);

QFrame* make_rule(Qt::Orientation orientation = Qt::Horizontal);
QLabel* make_key_cap(const QString& key);

/// Tells a screen reader, without moving the focus.
void announce(QWidget* from, const QString& sentence);

/// A page's head: bold 24 title, quiet text beside it, room for buttons at the right.
class PageHead : public QWidget {
  Q_OBJECT

 public:
  explicit PageHead(const QString& title, const QString& aside = {}, QWidget* parent = nullptr);
  QHBoxLayout* buttons() { return buttons_; }

 private:
  QHBoxLayout* buttons_;
};

/// A page that scrolls when it is too tall: returns the body's layout through `body`.
QWidget* make_scroll_page(QVBoxLayout** body, QWidget* parent = nullptr);

}  // namespace cusp::ui
