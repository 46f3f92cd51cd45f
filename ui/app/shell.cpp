#include "ui/app/shell.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QSysInfo>
#include <QToolButton>
#include <algorithm>

#include "ui/settings/settings.h"
#include "ui/text/language.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/rereads.h"

namespace cusp::ui {
namespace {

constexpr int kSidebar = 200;  // px at 100 %
constexpr int kNameWide = 180;  // of an account in the bar

/// A page as large as the window leaves it; it scrolls where it needs more. A resizable QScrollArea would give it its wished height.
class PageArea : public QScrollArea {
 public:
  explicit PageArea(QWidget* page) {
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setWidget(page);
    page->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) fit();
    return QScrollArea::eventFilter(watched, event);
  }
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    fit();
  }

 private:
  void fit() {
    const QLayout* layout = widget()->layout();
    QSize size = viewport()->size().expandedTo(widget()->minimumSizeHint());
    if (layout != nullptr && layout->hasHeightForWidth())
      size.setHeight(std::max(viewport()->height(), layout->totalMinimumHeightForWidth(size.width())));
    widget()->resize(size);
  }
};

/// A press checks its entry, and a question may keep what holds.
void check_what_holds(const QList<QAction*>& entries, const QVariant& holds) {
  for (QAction* entry : entries) entry->setChecked(entry->data() == holds);
}

}  // namespace

Shell::Shell(const Account& account, QVector<NavEntry> entries, QWidget* parent)
    : QWidget(parent), entries_(std::move(entries)), notice_(new Band), group_(new QButtonGroup(this)), pages_(new QStackedWidget) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  top_ = make_top_bar(account);
  column->addWidget(top_);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  side_ = make_sidebar();
  row->addWidget(side_);
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  above_ = new QVBoxLayout;  // takes no space while the notice is hidden
  above_->setContentsMargins(px(24), px(16), px(24), 0);
  above_->setSpacing(px(8));
  above_->addWidget(notice_);
  right->addLayout(above_);
  right->addWidget(pages_, 1);
  row->addLayout(right, 1);
  column->addLayout(row, 1);
}

void Shell::show_notice(const Message& message) { notice_->show_message(Band::Kind::look, message.what, message.more); }

void Shell::show_outcome(Band::Kind kind, const Message& outcome, std::function<void()> closed) {
  auto* band = new Band;
  QPushButton* button = make_button(tr("Close"));
  band->ways_out()->addWidget(button);
  above_->addWidget(band);
  connect(button, &QPushButton::clicked, band, [this, band, closed = std::move(closed)] {
    page()->setFocus();  // the button goes
    band->hide();
    band->deleteLater();
    closed();
  });
  band->show_message(kind, outcome.what, outcome.more);
}

QWidget* Shell::make_top_bar(const Account& account) {
  const auto [bar, row] = make_bar_top();
  bar->setAccessibleName(tr("Top bar"));
  row->addSpacing(px(4));
  auto* logo = new QLabel;
  logo->setPixmap(icon_pixmap(u"tooth"_qs, Ink::accent, 20, devicePixelRatioF()));
  row->addWidget(logo);
  row->addWidget(make_label(u"Cusp"_qs, TextRole::section, Weight::bold));
  row->addStretch();
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(u"monitor"_qs, Ink::text2, 16, devicePixelRatioF()));
  row->addWidget(sign);
  row->addWidget(make_label(QSysInfo::machineHostName(), TextRole::caption, Weight::regular, "text2"));
  row->addSpacing(px(20));

  row->addWidget(make_language_button());
  QToolButton* theme = make_icon_button(tokens().dark ? u"sun"_qs : u"moon"_qs,
                                        tokens().dark ? tr("Light colours") : tr("Dark colours"));
  connect(theme, &QToolButton::clicked, this, &Shell::theme_toggled);
  row->addWidget(theme);
  QToolButton* help = make_icon_button(u"help"_qs, tr("Help"), QKeySequence(Qt::Key_F1));
  connect(help, &QToolButton::clicked, this, &Shell::help_wanted);
  row->addWidget(help);
  QFrame* rule = make_rule(Qt::Vertical);
  rule->setFixedHeight(px(24));
  row->addWidget(rule);

  row->addWidget(make_account_button(account));
  return bar;
}

QToolButton* Shell::make_language_button() {
  QToolButton* globe = make_icon_button(u"globe"_qs, tr("Language"));
  auto* speech = language_menu_ = new QMenu(globe);
  for (const Language& l : languages()) {
    QAction* action = speech->addAction(l.name);
    action->setCheckable(true);
    action->setData(l.code);
    action->setChecked(l.code == current_language());
    connect(action, &QAction::triggered, this, [this, speech, code = l.code] {
      check_what_holds(speech->actions(), current_language());
      Q_EMIT language_chosen(code);
    });
  }
  globe->setMenu(speech);
  globe->setPopupMode(QToolButton::InstantPopup);
  return globe;
}

void Shell::offer_exercise_languages(const QStringList& codes, const QString& chosen) {
  auto* menu = new QMenu(tr("Exercises in"), language_menu_);
  auto* group = new QActionGroup(menu);
  const auto add = [&](const QString& code, const QString& name) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setData(code);
    action->setChecked(code == chosen);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, group, chosen, code] {
      check_what_holds(group->actions(), chosen);
      Q_EMIT exercise_language_chosen(code);
    });
  };
  add({}, tr("As the program"));
  for (const QString& code : codes) add(code, language_name(code));
  language_menu_->addSeparator();
  language_menu_->addMenu(menu);
}

QPushButton* Shell::make_account_button(const Account& account) {
  auto* button = new QPushButton;
  button->setProperty("kind", u"quiet"_qs);
  button->setObjectName(u"account"_qs);
  auto* inside = new QHBoxLayout(button);
  inside->setContentsMargins(px(8), 0, px(8), 0);
  inside->setSpacing(px(8));
  auto* face = new QLabel;
  face->setPixmap(icon_pixmap(u"person"_qs, Ink::text, 20, devicePixelRatioF()));
  auto* chevron = new QLabel;
  chevron->setPixmap(icon_pixmap(u"chevron_down"_qs, Ink::text2, 16, devicePixelRatioF()));
  const QString name = QString::fromStdString(account.name);
  QLabel* who = make_label({});
  who->setText(who->fontMetrics().elidedText(name, Qt::ElideRight, px(kNameWide)));
  QLabel* role = make_label(role_name(account.role), TextRole::body, Weight::regular, "text2");
  for (QLabel* label : {face, who, role, chevron}) {
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    inside->addWidget(label);
  }
  button->setMinimumWidth(inside->sizeHint().width());
  button->setAccessibleName(tr("Account of %1").arg(name));
  button->setToolTip(short_tool_tip(button->accessibleName()));
  button->setMenu(make_account_menu(account, button));
  return button;
}

QMenu* Shell::make_account_menu(const Account& account, QWidget* button) {
  auto* menu = new QMenu(button);
  account_menu_ = menu;
  QMenu* size = menu->addMenu(tr("Size of everything"));
  auto* sizes = new QActionGroup(size);
  for (const int percent : {100, 125, 150, 175, 200}) {
    QAction* action = size->addAction(QLocale().toString(percent) + QChar(0x00A0) + u'%');
    action->setCheckable(true);
    action->setData(percent);
    action->setChecked(percent == scale_percent());
    sizes->addAction(action);
    connect(action, &QAction::triggered, this, [this, sizes, percent] {
      check_what_holds(sizes->actions(), scale_percent());
      Q_EMIT scale_chosen(percent);
    });
  }
  if (account.has_password) {
    connect(menu->addAction(tr("Change password…")), &QAction::triggered, this, &Shell::password_wanted);
  }
  menu->addSeparator();
  QAction* out = menu->addAction(icon(u"sign_out"_qs), tr("Sign out"));
  connect(out, &QAction::triggered, this, &Shell::signed_out);
  return menu;
}

void Shell::keep_hand_in(Settings& settings) {
  auto* menu = new QMenu(tr("Handpiece"), account_menu_);
  auto* hands = new QActionGroup(menu);
  for (const bool left : {false, true}) {
    QAction* action = menu->addAction(left ? tr("In the left hand") : tr("In the right hand"));
    action->setCheckable(true);
    action->setChecked(left == settings.left_handed());
    hands->addAction(action);
    connect(action, &QAction::triggered, this, [&settings, left] { settings.set_left_handed(left); });
  }
  const QList<QAction*> entries = account_menu_->actions();
  account_menu_->insertMenu(entries.at(entries.size() - 2), menu);  // above the rule before signing out
}

QWidget* Shell::make_sidebar() {
  auto* side = new QFrame;
  side->setProperty("kind", u"bar_side"_qs);
  side->setFixedWidth(px(kSidebar));
  side->setAccessibleName(tr("Pages"));
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(px(8), px(12), px(8), px(16));
  column->setSpacing(px(2));
  for (int i = 0; i < entries_.size(); ++i) {
    auto* button = new QPushButton(icon(entries_[i].icon, Ink::text2), u"  "_qs + entries_[i].name);
    button->setIconSize(QSize(px(20), px(20)));
    button->setProperty("kind", u"nav"_qs);
    button->setCheckable(true);
    button->setAutoDefault(true);  // Enter presses it too
    button->setAccessibleName(entries_[i].name);
    group_->addButton(button, i);
    column->addWidget(button);
    connect(button, &QPushButton::toggled, this, [button, name = entries_[i].icon](bool on) {
      button->setIcon(icon(name, on ? Ink::accent : Ink::text2));
    });
    connect(button, &QPushButton::clicked, this, [this, i] { leave_for(entries_[i].key); });
  }
  column->addStretch();
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(px(12), 0, 0, 0);
  foot->setSpacing(px(8));
  device_sign_ = new QLabel;
  foot->addWidget(device_sign_);
  device_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  device_->setWordWrap(true);
  foot->addWidget(device_, 1);
  column->addLayout(foot);
  return side;
}

void Shell::show_device(const QString& name, const QString& icon_name) {
  device_sign_->setPixmap(icon_pixmap(icon_name, Ink::text2, 16, devicePixelRatioF()));
  device_->setText(name);
}

/// A press checks its button. Until the page is left, the button of the page is checked.
void Shell::leave_for(const QString& key) {
  for (int i = 0; i < entries_.size(); ++i)
    if (entries_[i].key == key_) group_->button(i)->setChecked(true);
  leave_([self = QPointer(this), key] {
    if (self) self->show_page(key);
  });
}

void Shell::show_page(const QString& key) {
  for (int i = 0; i < entries_.size(); ++i) {
    if (entries_[i].key != key) continue;
    key_ = key;
    group_->button(i)->setChecked(true);
    QWidget* old = pages_->currentWidget();  // the area in which a page scrolls
    QWidget* fresh = entries_[i].make();
    fresh->setAccessibleName(entries_[i].name);
    pages_->addWidget(new PageArea(fresh));
    pages_->setCurrentIndex(pages_->count() - 1);
    if (old) {
      pages_->removeWidget(old);
      old->deleteLater();
    }
    if (fresh->focusProxy()) fresh->setFocus(Qt::OtherFocusReason);
    return;
  }
}

void Shell::show_again() {
  auto* below = dynamic_cast<Rereads*>(page());
  if (below == nullptr || !below->read_again()) return show_page(key_);
  // A page that has had the focus knows where it was, and has no proxy any more (theme.cpp).
  QWidget* last = page()->focusWidget() ? page()->focusWidget() : page()->focusProxy();
  if (last && !page()->isAncestorOf(window()->focusWidget())) last->setFocus(Qt::OtherFocusReason);
}

QWidget* Shell::page() const {
  const auto* area = qobject_cast<QScrollArea*>(pages_->currentWidget());
  return area ? area->widget() : nullptr;
}

void Shell::next_pane() {
  QWidget* panes[] = {top_, side_, pages_};
  int now = 2;
  for (int i = 0; i < 3; ++i) {
    if (QApplication::focusWidget() && panes[i]->isAncestorOf(QApplication::focusWidget())) now = i;
  }
  for (int step = 1; step <= 3; ++step) {
    QWidget* pane = panes[(now + step) % 3];
    if (pane == side_ && group_->checkedButton()) {
      group_->checkedButton()->setFocus(Qt::TabFocusReason);
      return;
    }
    for (QWidget* w : pane->findChildren<QWidget*>()) {
      if (w->isVisible() && w->isEnabled() && (w->focusPolicy() & Qt::TabFocus)) {
        w->setFocus(Qt::TabFocusReason);
        return;
      }
    }
  }
}

}  // namespace cusp::ui
