/// Parts of every page: buttons by kind, cards, forms, segments, the message band. Thread: GUI.
#pragma once

#include <QAbstractButton>
#include <QFrame>
#include <QString>
#include <functional>

#include "ui/widgets/icon.h"

class QAbstractItemView;
class QLineEdit;
class QBoxLayout;
class QButtonGroup;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QTabBar;
class QToolButton;
class QVBoxLayout;

namespace cusp::ui {

enum class ButtonKind { standard, primary, quiet, erase };

/// `icon_name` may be empty. `key` becomes the shortcut and stands in the tooltip ("Finish (Ctrl+Return)").
QPushButton* make_button(const QString& text, ButtonKind kind = ButtonKind::standard, const QString& icon_name = {},
                         const QKeySequence& key = {});
/// 40 px high, for the main action of a page.
QPushButton* make_large_button(const QString& text, ButtonKind kind, const QString& icon_name = {});
/// Icon without text; `name` is the accessible name and the tooltip.
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
  /// Lets a long one take lines. The card's height then depends on its width.
  void wrap_title();
  void set_aside(const QString& aside);
  /// Lets a long one take lines beside the title. The card's height then depends on its width.
  void wrap_aside();
  /// Elides one that is longer than its place beside the title; the tool tip has the whole then.
  void elide_aside();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Aside : std::uint8_t { whole, elided };
  void show_aside();

  QVBoxLayout* body_;
  QHBoxLayout* head_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* aside_ = nullptr;
  QString aside_text_;  // as it was set
  Aside aside_kind_ = Aside::whole;
};

/// Choice of one among a few, side by side. Arrow keys move. Pages of a form have make_tabs() instead.
class Segments : public QWidget {
  Q_OBJECT

 public:
  enum class Begin : std::uint8_t { first_chosen, none_chosen };
  explicit Segments(const QStringList& names, QWidget* parent = nullptr, Begin begin = Begin::first_chosen);
  int chosen() const;  // -1: none yet
  void choose(int index);
  QAbstractButton* button(int index) const;

 Q_SIGNALS:
  void changed(int index);

 private:
  QButtonGroup* group_;
};

/// Message at the head of a page: sign, bold sentence, plain sentence, buttons. Where these would take more than half of
/// the width they stand below, in as many lines as they need. A screen reader announces it.
class Band : public QFrame {
  Q_OBJECT

 public:
  enum class Kind { info, look, bad, good };
  explicit Band(QWidget* parent = nullptr);
  void show_message(Kind kind, const QString& what, const QString& more = {});
  void clear();
  QString text() const;
  QLayout* ways_out() { return ways_out_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_ways();

  QLabel* sign_;
  QLabel* text_;
  QBoxLayout* body_;  // text_ and ways_out_
  QLayout* ways_out_;
};

/// A band for rows that could not be read, with a button "Try again". The button clears the band and gives the focus to `rows`
/// before it calls `again`. `rows` outlives the band.
Band* make_unread_band(QWidget* rows, std::function<void()> again);

/// A form with each label above its field, 4 px apart.
QFormLayout* make_form();
/// Adds a field `gap` px (at 100 %) below the one before, and a number's note below it. The label is the field's buddy and
/// its accessible name.
QLabel* add_field(QFormLayout& form, const QString& label, QWidget* field, int gap = 0);
/// A form of one field, to stand beside others.
QWidget* labelled(const QString& label, QWidget* field);

/// Two or more pages of a form, side by side ("Student | Staff"), in the look of Segments.
QTabBar* make_tabs(const QStringList& names);

/// A paragraph in the second ink, whose text the mouse selects. Without a parent.
QLabel* make_paragraph(const QString& text);

/// A line of a panel: icon, name, and the value at the right, whose accessible description is the name. Without a parent.
QWidget* make_fact_row(const QString& icon_name, const QString& name, QLabel** value);

QFrame* make_rule(Qt::Orientation orientation = Qt::Horizontal);
QLabel* make_key_cap(const QString& key);

/// Makes a screen reader speak `message`; the focus stays.
void announce(QWidget* from, const QString& message);

/// Head of a page: title of 24 px, quiet text beside it, buttons at the right or, in a narrow window, below.
class PageHead : public QWidget {
  Q_OBJECT

 public:
  explicit PageHead(const QString& title, const QString& aside = {}, QWidget* parent = nullptr);
  QLayout* buttons() { return layout(); }
};

/// A field to search by, with its sign; `name` is placeholder and accessible name. Wider than `width_px` if the name needs it.
QLineEdit* make_search_field(const QString& name, int width_px);

/// What a dialog takes of its screen at most; its frame takes the rest.
QSize most_of_screen(const QWidget& dialog);

/// A page that one widget fills.
QWidget* make_page(QWidget* content);
/// `page` in an area that scrolls where the window is smaller than what the page needs at least.
QScrollArea* make_scrolling(QWidget* page);
/// A page that scrolls if it is too tall; `body` receives its layout.
QWidget* make_scroll_page(QVBoxLayout** body, QWidget* parent = nullptr);
/// Scrolls the pages around a view that is as high as its rows, so that its current one is seen with `beside` px above and below.
void scroll_pages_to_current(QAbstractItemView& view, int beside);

}  // namespace cusp::ui
