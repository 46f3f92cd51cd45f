#include "ui/widgets/parts.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "ui/widgets/format.h"
#include "ui/widgets/head_row.h"
#include "ui/widgets/number_field.h"

namespace cusp::ui {
namespace {

constexpr int kBesidePlaceholder = 96;  // px at 100 %: the sign, the cross, padding and borders of a search field
constexpr double kShareOfScreen = 0.95;  // of width and height: 5 % of 768 px are 38, as high as a title bar

QString with_key(const QString& text, const QKeySequence& key) {
  return key.isEmpty() ? text : text + u" ("_qs + key.toString(QKeySequence::NativeText) + u')';
}

}  // namespace

QPushButton* make_button(const QString& text, ButtonKind kind, const QString& icon_name, const QKeySequence& key) {
  // The style leaves no gap between icon and text.
  auto* button = new QPushButton(icon_name.isEmpty() || text.isEmpty() ? text : u' ' + text);
  button->setAutoDefault(true);  // Enter presses it
  button->setAccessibleName(text);
  switch (kind) {
    case ButtonKind::standard: break;
    case ButtonKind::primary: button->setProperty("kind", u"primary"_qs); break;
    case ButtonKind::quiet: button->setProperty("kind", u"quiet"_qs); break;
    case ButtonKind::erase: button->setProperty("kind", u"erase"_qs); break;
  }
  if (!icon_name.isEmpty()) {
    button->setIcon(icon(icon_name, kind == ButtonKind::primary ? Ink::on_accent
                                    : kind == ButtonKind::erase ? Ink::bad
                                                                : Ink::text));
    button->setIconSize(QSize(px(18), px(18)));
  }
  if (!key.isEmpty()) {
    button->setShortcut(key);
    button->setToolTip(with_key(text, key));
  }
  return button;
}

QPushButton* make_large_button(const QString& text, ButtonKind kind, const QString& icon_name) {
  QPushButton* button = make_button(text, kind, icon_name);
  button->setProperty("large", true);
  return button;
}

QToolButton* make_icon_button(const QString& icon_name, const QString& name, const QKeySequence& key) {
  auto* button = new QToolButton;
  button->setIcon(icon(icon_name));
  button->setIconSize(QSize(px(20), px(20)));
  button->setAccessibleName(name);
  button->setToolTip(with_key(name, key));
  if (!key.isEmpty()) button->setShortcut(key);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

Card::Card(QWidget* parent) : QFrame(parent) {
  setProperty("kind", u"card"_qs);
  body_ = new QVBoxLayout(this);
  body_->setContentsMargins(px(16), px(16), px(16), px(16));
  body_->setSpacing(px(8));
}

Card::Card(const QString& title, const QString& aside, QWidget* parent) : Card(parent) {
  aside_text_ = aside;
  head_ = new QHBoxLayout;
  title_ = make_label(title, TextRole::section, Weight::bold);
  aside_ = make_label(aside, TextRole::caption, Weight::regular, "text3");
  head_->addWidget(title_);
  head_->addStretch();
  head_->addWidget(aside_);
  body_->addLayout(head_);
  setAccessibleName(title);
}

void Card::set_title(const QString& title) {
  if (title_) title_->setText(title_->wordWrap() ? breakable(title) : title);
  setAccessibleName(title);
}
void Card::wrap_title() {
  title_->setWordWrap(true);
  title_->setText(breakable(title_->text()));
  head_->setStretchFactor(title_, 1);
}
void Card::set_aside(const QString& aside) {
  aside_text_ = aside;
  if (aside_) show_aside();
}

void Card::show_aside() {
  if (aside_kind_ == Aside::whole) return aside_->setText(aside_->wordWrap() ? breakable(aside_text_) : aside_text_);
  const QString shown = aside_->fontMetrics().elidedText(aside_text_, Qt::ElideRight, aside_->contentsRect().width());
  aside_->setText(shown);
  aside_->setAccessibleName(aside_text_);
  aside_->setToolTip(shown == aside_text_ ? QString() : tool_tip_text(aside_text_));
}

void Card::elide_aside() {
  aside_kind_ = Aside::elided;
  aside_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // its text asks for no width
  aside_->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
  head_->setStretchFactor(aside_, 1);
  aside_->installEventFilter(this);
  show_aside();
}

bool Card::eventFilter(QObject* watched, QEvent* event) {
  if (watched == aside_ && event->type() == QEvent::Resize) show_aside();
  return QFrame::eventFilter(watched, event);
}

void Card::wrap_aside() {
  aside_->setWordWrap(true);
  aside_->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
  head_->setStretchFactor(aside_, 1);
  show_aside();
}

Segments::Segments(const QStringList& names, QWidget* parent, Begin begin) : QWidget(parent), group_(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  const QFontMetrics plain(font_of(TextRole::body)), bold(font_of(TextRole::body, Weight::bold));
  for (int i = 0; i < names.size(); ++i) {
    auto* button = new QPushButton(names[i]);
    button->setCheckable(true);
    button->setAutoDefault(true);  // Enter presses it
    button->setAccessibleName(names[i]);
    button->setProperty("kind", names.size() == 1         ? u"segment_only"_qs
                                : i == 0                  ? u"segment_first"_qs
                                : i == names.size() - 1   ? u"segment_last"_qs
                                                          : u"segment_middle"_qs);
    group_->addButton(button, i);
    row->addWidget(button, 1);
    // The chosen one is bold, which its size hint does not know.
    button->setMinimumWidth(button->sizeHint().width() + bold.horizontalAdvance(names[i]) - plain.horizontalAdvance(names[i]));
  }
  if (!names.isEmpty() && begin == Begin::first_chosen) group_->button(0)->setChecked(true);
  connect(group_, &QButtonGroup::idToggled, this, [this](int id, bool on) {
    if (on) Q_EMIT changed(id);
  });
}
int Segments::chosen() const { return group_->checkedId(); }
void Segments::choose(int index) {
  if (auto* button = group_->button(index)) button->setChecked(true);
}
QAbstractButton* Segments::button(int index) const { return group_->button(index); }

Band::Band(QWidget* parent) : QFrame(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(px(16), px(10), px(12), px(10));
  row->setSpacing(px(12));
  sign_ = new QLabel;
  text_ = make_label({});
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  row->addWidget(sign_, 0, Qt::AlignTop);
  body_ = new QBoxLayout(QBoxLayout::LeftToRight);
  body_->setSpacing(px(12));
  body_->addWidget(text_, 1);
  ways_out_ = new HeadRow(HeadRow::Kind::buttons);
  ways_out_->setSpacing(px(12));
  body_->addLayout(ways_out_);
  row->addLayout(body_, 1);
  hide();
}

void Band::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit_ways();
}

void Band::fit_ways() {
  const bool beside = 2 * ways_out_->sizeHint().width() <= width();
  body_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void Band::show_message(Kind kind, const QString& what, const QString& more) {
  static constexpr const char* kKinds[] = {"band_info", "band_look", "band_bad", "band_good"};
  static const QString kIcons[] = {u"info"_qs, u"warning"_qs, u"warning"_qs, u"check"_qs};
  static constexpr Ink kInks[] = {Ink::accent, Ink::look, Ink::bad, Ink::good};
  const auto k = static_cast<int>(kind);
  set_kind(this, kKinds[k]);
  sign_->setPixmap(icon_pixmap(kIcons[k], kInks[k], 20, devicePixelRatioF()));
  const QString first = breakable(what).toHtmlEscaped(), rest = breakable(more).toHtmlEscaped();
  text_->setText(more.isEmpty() ? u"<b>%1</b>"_qs.arg(first) : u"<b>%1</b> %2"_qs.arg(first, rest));
  setAccessibleName(more.isEmpty() ? what : what + u' ' + more);
  text_->setAccessibleName(accessibleName());  // without the places where a line may end
  fit_ways();  // one of them may be hidden since
  show();
  announce(this, accessibleName());
}

void Band::clear() { hide(); }
QString Band::text() const { return accessibleName(); }

Band* make_unread_band(QWidget* rows, std::function<void()> again) {
  auto* band = new Band;
  QPushButton* button = make_button(Band::tr("Try again"), ButtonKind::standard, u"refresh"_qs);
  band->ways_out()->addWidget(button);
  QObject::connect(button, &QPushButton::clicked, band, [band, rows, again = std::move(again)] {
    rows->setFocus();  // the button goes
    band->clear();
    again();
  });
  return band;
}

QFormLayout* make_form() {
  auto* form = new QFormLayout;
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(px(4));
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setFormAlignment(Qt::AlignLeading | Qt::AlignTop);
  return form;
}

QLabel* add_field(QFormLayout& form, const QString& label, QWidget* field, int gap) {
  QLabel* text = make_label(label, TextRole::caption);
  text->setContentsMargins(0, px(gap), 0, 0);
  text->setBuddy(field);
  field->setAccessibleName(label);
  form.addRow(text, field);
  if (auto* number = qobject_cast<NumberField*>(field)) form.addRow(number->note());
  return text;
}

QWidget* labelled(const QString& label, QWidget* field) {
  auto* box = new QWidget;
  QFormLayout* form = make_form();
  box->setLayout(form);
  add_field(*form, label, field);
  return box;
}

QTabBar* make_tabs(const QStringList& names) {
  auto* tabs = new QTabBar;
  tabs->setProperty("kind", u"segments"_qs);
  tabs->setDrawBase(false);
  tabs->setExpanding(true);
  tabs->setUsesScrollButtons(false);
  for (const QString& name : names) tabs->addTab(name);
  return tabs;
}

QLabel* make_paragraph(const QString& text) {
  QLabel* out = make_label(text, TextRole::body, Weight::regular, "text2");
  out->setWordWrap(true);
  out->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return out;
}

QWidget* make_fact_row(const QString& icon_name, const QString& name, QLabel** value) {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(px(8));
  auto* sign = new QLabel(row);
  sign->setPixmap(icon_pixmap(icon_name, Ink::text2, 16, row->devicePixelRatioF()));
  line->addWidget(sign);
  line->addWidget(make_label(name), 1);
  *value = make_label({}, TextRole::body, Weight::bold);
  (*value)->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  (*value)->setAccessibleDescription(name);
  line->addWidget(*value);
  return row;
}

QFrame* make_rule(Qt::Orientation orientation) {
  auto* rule = new QFrame;
  rule->setProperty("kind", u"rule"_qs);
  if (orientation == Qt::Horizontal) {
    rule->setFixedHeight(1);
  } else {
    rule->setFixedWidth(1);
  }
  return rule;
}

QLabel* make_key_cap(const QString& key) {
  QLabel* label = make_label(key, TextRole::caption);
  label->setProperty("kind", u"key"_qs);
  return label;
}

void announce(QWidget* from, const QString& message) {
  // Qt 6.4 has no announcement event; screen readers speak the description of a widget with an alert.
  from->setAccessibleDescription(message);
  QAccessibleEvent event(from, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

PageHead::PageHead(const QString& title, const QString& aside, QWidget* parent) : QWidget(parent) {
  auto* all = new HeadRow(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(px(8));
  auto* titles = new QWidget;
  auto* row = new QHBoxLayout(titles);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(12));
  row->addWidget(make_label(title, TextRole::page_title, Weight::bold));
  QLabel* quiet = make_label(aside, TextRole::body, Weight::regular, "text2");
  quiet->setContentsMargins(0, px(6), 0, 0);
  row->addWidget(quiet);
  row->addStretch(1);
  all->addWidget(titles);
}

QLineEdit* make_search_field(const QString& name, int width_px) {
  auto* field = new QLineEdit;
  field->setPlaceholderText(name);
  field->setAccessibleName(name);
  field->addAction(icon(QStringLiteral("search"), Ink::text2), QLineEdit::LeadingPosition);
  field->setClearButtonEnabled(true);
  // The style's own sign is of another family.
  if (auto* clear = field->findChild<QAction*>(u"_q_qlineeditclearaction"_qs)) clear->setIcon(icon(u"cross"_qs, Ink::text2));
  const int whole = QFontMetrics(font_of(TextRole::body)).horizontalAdvance(name) + px(kBesidePlaceholder);
  field->setFixedWidth(std::max(width_px, whole));
  return field;
}

QSize most_of_screen(const QWidget& dialog) { return dialog.screen()->availableGeometry().size() * kShareOfScreen; }

QWidget* make_page(QWidget* content) {
  auto* page = new QWidget;
  page->setProperty("kind", u"page"_qs);
  page->setAttribute(Qt::WA_StyledBackground);
  (new QVBoxLayout(page))->addWidget(content);
  return page;
}

QScrollArea* make_scrolling(QWidget* page) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(page);
  return area;
}

QWidget* make_scroll_page(QVBoxLayout** body, QWidget* parent) {
  auto* page = new QWidget;
  page->setProperty("kind", u"page"_qs);
  page->setAttribute(Qt::WA_StyledBackground);
  *body = new QVBoxLayout(page);
  (*body)->setContentsMargins(px(24), px(16), px(24), px(24));
  (*body)->setSpacing(px(16));
  QScrollArea* area = make_scrolling(page);
  area->setParent(parent);
  return area;
}

void scroll_pages_to_current(QAbstractItemView& view, int beside) {
  if (!view.currentIndex().isValid()) return;
  const QRect current = view.visualRect(view.currentIndex());
  for (QWidget* above = view.parentWidget(); above != nullptr; above = above->parentWidget()) {
    auto* area = qobject_cast<QScrollArea*>(above);
    if (area == nullptr || area->widget() == nullptr) continue;
    const int y = view.viewport()->mapTo(area->widget(), current.center()).y();
    area->ensureVisible(area->horizontalScrollBar()->value(), y, 0, current.height() / 2 + beside);
  }
}

}  // namespace cusp::ui
