// The parts of the editor page and their connections.
#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "scenarios/format/ranges.h"
#include "ui/editor/audit_page.h"
#include "ui/editor/burs_form.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_page_parts.h"
#include "ui/editor/points_form.h"
#include "ui/editor/shape_form.h"
#include "ui/editor/specimen_form.h"
#include "ui/editor/target_view.h"
#include "ui/editor/tissues_form.h"
#include "ui/editor/texts_form.h"
#include "ui/session/audit_run.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kLeft = 248, kRight = 368, kChecks = 80, kChecksNarrow = 124;  // px at 100 %
constexpr int kNarrow = 1100;  // px at 100 %, of the window

/// The shown field of this class and name: a form may have made its rows anew. nullptr if there is none.
QWidget* field_like(const QWidget& page, const QMetaObject* kind, const QString& name) {
  if (name.isEmpty()) return nullptr;
  for (QWidget* one : page.findChildren<QWidget*>())
    if (one->metaObject() == kind && one->accessibleName() == name && one->isVisible() && one->isEnabled()) return one;
  return nullptr;
}

}  // namespace

void EditorPage::lay_out() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_top_bar());
  band_ = new Band;
  column->addWidget(band_);
  column->addWidget(make_clash());
  column->addWidget(make_panels(), 1);
}

QWidget* EditorPage::make_panels() {
  auto* body = new QWidget;
  body->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // fit_left() fits it to the window
  body->setMinimumWidth(stage_->minimumWidth() + px(kRight));
  body_ = new QVBoxLayout(body);
  body_->setContentsMargins(0, 0, 0, 0);
  body_->setSpacing(0);
  panels_ = new QHBoxLayout;
  panels_->setSpacing(0);
  body_->addLayout(panels_, 1);
  panels_->addWidget(make_left());
  middle_ = new QVBoxLayout;
  middle_->setSpacing(0);
  middle_->addWidget(stage_, 1);
  middle_->addWidget(make_checks());
  panels_->addLayout(middle_, 1);
  panels_->addWidget(make_right());
  return body;
}

bool EditorPage::left_in_tabs() const { return tabs_->indexOf(left_) >= 0; }

/// In a window too narrow for three panels the left one is a tab at the right, the checks take the whole width, where a message needs
/// fewer lines, and the top bar keeps signs for texts.
void EditorPage::fit_left() {
  const bool into_tabs = width() < px(kLeft) + stage_->minimumWidth() + px(kRight);
  if (into_tabs == left_in_tabs()) return;
  if (into_tabs) {
    left_->setMinimumWidth(0);
    left_->setMaximumWidth(QWIDGETSIZE_MAX);
    tabs_->addTab(left_, tr("Target"));
  } else {
    tabs_->removeTab(tabs_->indexOf(left_));
    left_->setFixedWidth(px(kLeft));
    panels_->insertWidget(0, left_);
    left_->show();
  }
  QWidget* checks = check_->parentWidget();
  (into_tabs ? middle_ : body_)->removeWidget(checks);
  (into_tabs ? body_ : middle_)->addWidget(checks);
  back_->setText(into_tabs ? QString() : u' ' + tr("Library"));  // as make_button: the style leaves no space after the sign
  back_->setShortcut(Qt::ALT | Qt::Key_Left);                    // a new text takes the shortcut away
  show_version();
}

/// In a narrow window the try-outs keep sign, name and tooltip alone, and the checks their sum.
void EditorPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit_left();
  const bool narrow = width() < px(kNarrow);
  try_->setText(narrow ? QString() : u' ' + tr("Try out"));  // as make_button: the style leaves no space after the sign
  try_->setShortcut(Qt::Key_F5);                             // a new text takes the shortcut away
  reference_->setText(narrow ? QString() : u' ' + tr("Reference"));
  reference_->setShortcut(Qt::SHIFT | Qt::Key_F5);
  try_key_->setHidden(narrow);
  check_aside_->setHidden(narrow);
  checks_chip_->setHidden(narrow);
  show_->setText(narrow ? QString() : u' ' + tr("Show"));
  check_->parentWidget()->setFixedHeight(px(narrow && !left_in_tabs() ? kChecksNarrow : kChecks));  // a check takes a line more
  title_->setMinimumWidth(px(narrow ? 100 : 200));
}

QWidget* EditorPage::make_top_bar() {
  const auto [bar, row] = make_bar_top();
  bar->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // resizeEvent() fits it to the window
  back_ = add_way_back({bar, row}, tr("Library"));
  back_->setToolTip(tr("Keeps the draft and goes back (Alt+Left)"));
  connect(back_, &QPushButton::clicked, this, &EditorPage::leave);
  title_ = new QLineEdit;
  title_->setAccessibleName(tr("Title of the exercise"));
  title_->setToolTip(tr("Title, in the language of the screen; the others stand under Texts"));
  title_->setFont(font_of(TextRole::section, Weight::bold));
  title_->setMaximumWidth(px(340));
  title_->setMaxLength(static_cast<int>(kMostTextCharacters));
  row->addWidget(title_, 1);
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    // English is required: an emptied title keeps its last letter until another is typed.
    model_->set_title(screen_language(), text.trimmed());
  });
  connect(title_, &QLineEdit::editingFinished, this, [this] {
    model_->end_gesture();
    show_title();
  });
  version_ = new Chip;
  row->addWidget(version_);
  row->addStretch();
  undo_ = make_icon_button(u"undo"_qs, tr("Undo"), QKeySequence::Undo);
  redo_ = make_icon_button(u"redo"_qs, tr("Redo"), QKeySequence(Qt::CTRL | Qt::Key_Y));
  row->addWidget(undo_);
  row->addWidget(redo_);
  row->addSpacing(px(8));
  connect(undo_, &QToolButton::clicked, this, [this] { step_history(undo_, &QUndoStack::undo); });
  connect(redo_, &QToolButton::clicked, this, [this] { step_history(redo_, &QUndoStack::redo); });
  add_try_outs(*row);
  stop_proof_ = make_button(tr("Stop checking"));
  stop_proof_->hide();
  row->addWidget(stop_proof_);
  connect(stop_proof_, &QPushButton::clicked, this, &EditorPage::stop_proof);
  publish_ = make_button(tr("Publish"), ButtonKind::primary);
  row->addWidget(publish_);
  publish_wait_ = std::make_unique<ButtonWait>(publish_);
  connect(publish_, &QPushButton::clicked, this, &EditorPage::publish_version);
  return bar;
}

void EditorPage::step_history(QToolButton* button, void (QUndoStack::*step)()) {
  const QPointer<QWidget> field = window()->focusWidget();
  const QMetaObject* kind = field ? field->metaObject() : nullptr;
  const QString name = field ? field->accessibleName() : QString();
  button->setFocus();  // a field with the focus would keep its typed text
  (model_->stack().*step)();
  QWidget* again = field && field->isVisible() && field->isEnabled() ? field.data() : field_like(*this, kind, name);
  if (again != nullptr) return again->setFocus();
  if (!button->isEnabled()) setFocus();  // a disabled button hands the focus on to Try out
}

QWidget* EditorPage::make_left() {
  left_ = new QStackedWidget;
  left_->setFixedWidth(px(kLeft));
  auto* side = new QFrame;
  side->setProperty("kind", u"bar_side"_qs);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(px(8), px(12), px(8), px(12));  // the widest button stands beside a scroll bar
  column->setSpacing(px(8));
  column->addWidget(make_label(tr("Target"), TextRole::section, Weight::bold));
  shapes_ = new QButtonGroup(this);
  for (int i = 0; i < static_cast<int>(std::size(kShapes)); ++i) {
    const QString name = shape_name(kShapes[i].key);
    auto* button = new QPushButton(icon(QString::fromLatin1(kShapes[i].icon)), u"  "_qs + name);
    button->setIconSize(QSize(px(20), px(20)));
    button->setProperty("kind", u"nav"_qs);
    button->setCheckable(true);
    button->setAutoDefault(false);
    button->setAccessibleName(name);
    shapes_->addButton(button, i);
    column->addWidget(button);
  }
  connect(shapes_, &QButtonGroup::idToggled, this, [this](int id, bool on) {
    if (on) model_->set_shape(kShapes[id].key);
  });
  column->addSpacing(px(8));
  column->addWidget(make_rule());
  column->addSpacing(px(8));
  column->addWidget(make_label(tr("In this exercise"), TextRole::section, Weight::bold));
  contents_ = new QVBoxLayout;
  contents_->setSpacing(px(8));
  column->addLayout(contents_);
  column->addStretch();
  on_top_ = make_button(tr("Put the target on the tooth"), ButtonKind::standard, u"target"_qs);
  on_top_->setToolTip(tr("Moves the target to the middle of the tooth, at its surface"));
  column->addWidget(on_top_);
  connect(on_top_, &QPushButton::clicked, this, &EditorPage::put_target_on_top);
  column->addWidget(make_rule());
  add_tooth(*column);
  QScrollArea* area = make_scrolling(side);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // its texts wrap
  left_->addWidget(area);
  auto* frame = new QFrame;
  frame->setProperty("kind", u"bar_side"_qs);
  auto* inside = new QVBoxLayout(frame);
  inside->setContentsMargins(0, 0, 1, 0);
  tooth_page_ = forms_.add([this] {
    auto* form = new SpecimenForm(*model_, ports_);
    connect(form, &SpecimenForm::done, this, [this] { show_tooth_form(false); });
    return form;
  });
  inside->addWidget(tooth_page_);
  left_->addWidget(frame);
  return left_;
}

void EditorPage::add_tooth(QVBoxLayout& column) {
  column.addWidget(make_label(tr("Tooth"), TextRole::section, Weight::bold));
  auto* row = new QHBoxLayout;
  tooth_ = make_label({});
  tooth_->setWordWrap(true);
  row->addWidget(tooth_, 1);
  change_ = make_button(tr("Change"), ButtonKind::standard);
  change_->setAccessibleName(tr("Change the tooth"));
  row->addWidget(change_);
  column.addLayout(row);
  connect(change_, &QPushButton::clicked, this, [this] { show_tooth_form(true); });
}

QWidget* EditorPage::make_right() {
  auto* panel = new QFrame;
  panel->setProperty("kind", u"panel_right"_qs);
  panel->setFixedWidth(px(kRight));
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(1, 0, 0, 0);
  tabs_ = new QTabWidget;
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setProperty("tight", true);  // six tabs in 368 px, or seven
  tabs_->addTab(forms_.add([this] { return new ShapeForm(*model_); }), tr("Shape"));
  tabs_->addTab(forms_.add([this] { return new PointsForm(*model_); }), tr("Points"));
  tabs_->addTab(forms_.add([this] { return new BursForm(*model_); }), tr("Burs"));
  tabs_->addTab(forms_.add([this] { return new TissuesForm(*model_); }), tr("Tissues"));
  tabs_->addTab(forms_.add([this] { return new TextsForm(*model_); }), tr("Texts"));
  tabs_->addTab(forms_.add([this] { return new AuditPage(*model_, [](const std::string& folder) { return audit_runner(folder); }); }), tr("Audit"));
  connect(tabs_, &QTabWidget::currentChanged, this, [this](int index) { forms_.fill(tabs_->widget(index)); });
  column->addWidget(tabs_);
  return panel;
}

QWidget* EditorPage::make_checks() {
  auto* bar = new QFrame;
  bar->setProperty("kind", u"bar_bottom"_qs);
  bar->setFixedHeight(px(kChecks));
  bar->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  bar->setAccessibleName(tr("Checks"));
  auto* column = new QVBoxLayout(bar);
  column->setContentsMargins(px(16), px(8), px(16), px(8));
  column->setSpacing(px(2));
  auto* head = new QHBoxLayout;
  head->setSpacing(px(8));
  check_sign_ = new QLabel;
  head->addWidget(check_sign_);
  check_title_ = make_label({}, TextRole::body, Weight::bold);
  head->addWidget(check_title_);
  check_aside_ = make_label({}, TextRole::body, Weight::regular, "text2");
  head->addWidget(check_aside_);
  head->addStretch();
  checks_chip_ = new Chip;
  head->addWidget(checks_chip_);
  column->addLayout(head);
  auto* row = new QHBoxLayout;
  check_ = make_label({});
  check_->setWordWrap(true);
  check_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(check_, 1);
  next_check_ = make_icon_button(u"chevron_right"_qs, tr("Next check"));
  row->addWidget(next_check_);
  connect(next_check_, &QToolButton::clicked, this, &EditorPage::show_next_check);
  show_ = make_button(tr("Show"), ButtonKind::standard, u"target"_qs);
  show_->setAccessibleName(tr("Show where"));
  show_->setToolTip(show_->accessibleName());
  row->addWidget(show_);
  column->addLayout(row);
  connect(show_, &QPushButton::clicked, this, &EditorPage::show_place_of_check);
  return bar;
}

}  // namespace cusp::ui
