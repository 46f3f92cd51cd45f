// The parts of the sign-in page.

#include "ui/signin/sign_in.h"

#include <QAction>
#include <QBoxLayout>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSysInfo>
#include <QTabBar>
#include <QToolButton>

#include "ui/signin/pin_field.h"
#include "ui/text/language.h"
#include "ui/widgets/format.h"
#include "ui/widgets/menu_button.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kFieldGap = 12;    // px at 100 %, above the label of the next field

QLineEdit* make_field(QLineEdit::EchoMode echo = QLineEdit::Normal) {
  auto* field = new QLineEdit;
  field->setProperty("large", true);
  field->setFixedHeight(px(40));
  field->setEchoMode(echo);
  return field;
}

QWidget* make_row_sign(const QString& icon_name, Ink ink, QLabel* text) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(px(6));
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(icon_name, ink, 16, row->devicePixelRatioF()));
  layout->addWidget(sign, 0, Qt::AlignTop);
  layout->addWidget(text, 1);
  return row;
}

}  // namespace

QWidget* SignIn::make_head() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  auto* logo = new QLabel;
  logo->setPixmap(icon_pixmap(u"tooth"_qs, Ink::accent, 22, devicePixelRatioF()));
  row->addWidget(logo);
  row->addWidget(make_label(u"Cusp"_qs, TextRole::live, Weight::bold));
  row->addStretch();
  auto* language = make_button({}, ButtonKind::quiet, u"globe"_qs);
  for (const Language& l : languages()) {
    if (l.code == current_language()) language->setText(l.name);
  }
  language->setAccessibleName(tr("Language"));
  language->setToolTip(tr("Language"));
  auto* menu = new QMenu(language);
  for (const Language& l : languages()) {
    QAction* action = menu->addAction(l.name);
    action->setCheckable(true);
    action->setChecked(l.code == current_language());
    connect(action, &QAction::triggered, this, [this, code = l.code] { Q_EMIT language_chosen(code); });
  }
  put_menu(language, menu);
  row->addWidget(language);
  QToolButton* theme = make_icon_button(tokens().dark ? u"sun"_qs : u"moon"_qs,
                                        tokens().dark ? tr("Light colours") : tr("Dark colours"));
  connect(theme, &QToolButton::clicked, this, &SignIn::theme_toggled);
  row->addWidget(theme);
  return head;
}

QWidget* SignIn::make_notices() {
  auto* notices = new QWidget;
  notices->setFixedWidth(px(kFormWidth));
  auto* column = new QVBoxLayout(notices);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  reading_only_ = new Band;
  incident_ = new Band;
  column->addWidget(reading_only_);
  column->addWidget(incident_);
  try_again_ = make_button(tr("Try again"), ButtonKind::standard);
  try_again_->hide();
  way_back_ = make_button(tr("Go back to a backup"), ButtonKind::standard);
  way_back_->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(try_again_);
  row->addWidget(way_back_);
  row->addStretch();
  column->addLayout(row);
  connect(try_again_, &QPushButton::clicked, this, &SignIn::try_again);
  connect(way_back_, &QPushButton::clicked, this, &SignIn::way_back_wanted);
  return notices;
}

/// Which computer this is, and where its results lie.
QWidget* SignIn::make_station() {
  const QString file = QString::fromStdString(store_.database().file().filename().string());
  QLabel* foot = make_label(tr("%1: results are kept on this computer, in %2.").arg(QSysInfo::machineHostName(), isolate(file)),
                            TextRole::caption, Weight::regular, "text2");
  foot->setToolTip(QString::fromStdString(store_.database().file().string()));
  foot->setWordWrap(true);
  return make_row_sign(u"monitor"_qs, Ink::text2, foot);
}

QWidget* SignIn::make_sign_in_form() {
  auto* form = new QWidget;
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  column->addWidget(make_label(tr("Sign in"), TextRole::page_title, Weight::bold));
  column->addWidget(make_label(QSysInfo::machineHostName(), TextRole::body, Weight::regular, "text2"));
  column->addSpacing(px(16));
  who_ = make_tabs({tr("Student"), tr("Staff")});
  column->addWidget(who_);
  column->addSpacing(px(16));
  student_fields_ = make_student_fields();
  staff_fields_ = make_staff_fields();
  column->addWidget(student_fields_);
  column->addWidget(staff_fields_);
  staff_fields_->hide();

  column->addSpacing(px(12));
  band_ = new Band;
  column->addWidget(band_);
  column->addSpacing(px(4));
  enter_ = make_large_button(tr("Sign in"), ButtonKind::primary);
  column->addWidget(enter_);
  column->addSpacing(px(24));
  auto* or_row = new QHBoxLayout;
  or_row->setSpacing(px(12));
  or_row->addWidget(make_rule(), 1);
  or_row->addWidget(make_label(tr("or"), TextRole::caption, Weight::regular, "text2"));
  or_row->addWidget(make_rule(), 1);
  column->addLayout(or_row);
  column->addSpacing(px(20));
  add_try_it(*column);

  connect(who_, &QTabBar::currentChanged, this, &SignIn::show_fields);
  connect(enter_, &QPushButton::clicked, this, &SignIn::submit);
  return form;
}

QWidget* SignIn::make_student_fields() {
  auto* fields = new QWidget;
  QFormLayout* form = make_form();
  fields->setLayout(form);
  number_ = make_field();
  number_->addAction(icon(u"person"_qs, Ink::text2), QLineEdit::LeadingPosition);
  add_field(*form, tr("Student number"), number_);
  pin_ = new PinField;
  add_field(*form, tr("PIN, six digits"), pin_, kFieldGap);
  connect(number_, &QLineEdit::returnPressed, this, [this] {
    if (pin_->text().isEmpty() && !number_->text().isEmpty()) {
      pin_->setFocus();
    } else {
      submit();
    }
  });
  connect(pin_, &PinField::completed, this, [this] { enter_->setFocus(); });
  connect(pin_, &PinField::returnPressed, this, &SignIn::submit);
  return fields;
}

QWidget* SignIn::make_staff_fields() {
  auto* fields = new QWidget;
  QFormLayout* form = make_form();
  fields->setLayout(form);
  staff_number_ = make_field();
  staff_number_->addAction(icon(u"person"_qs, Ink::text2), QLineEdit::LeadingPosition);
  add_field(*form, tr("User name"), staff_number_);
  password_ = make_field(QLineEdit::Password);
  password_->addAction(icon(u"lock"_qs, Ink::text2), QLineEdit::LeadingPosition);
  add_field(*form, tr("Password"), password_, kFieldGap);
  connect(staff_number_, &QLineEdit::returnPressed, password_, qOverload<>(&QWidget::setFocus));
  connect(password_, &QLineEdit::returnPressed, this, &SignIn::submit);
  return fields;
}

void SignIn::add_try_it(QBoxLayout& column) {
  try_it_ = make_large_button(tr("Try it"), ButtonKind::standard, u"play"_qs);
  try_it_->setIcon(icon(u"play"_qs, Ink::accent));
  column.addWidget(try_it_);
  QLabel* note = make_label(tr("No account. You drill a practice block with the mouse; nothing goes into the school’s "
                               "records."),
                            TextRole::caption, Weight::regular, "text2");
  note->setWordWrap(true);
  column.addSpacing(px(4));
  column.addWidget(note);
  connect(try_it_, &QPushButton::clicked, this, &SignIn::try_it);
}

QWidget* SignIn::make_first_start_form() {
  auto* form = new QWidget;
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  column->addWidget(make_label(tr("First start"), TextRole::page_title, Weight::bold));
  QLabel* why = make_label(tr("Nobody manages this computer’s records yet. Make the administrator; everybody else is "
                              "added afterwards."),
                           TextRole::body, Weight::regular, "text2");
  why->setWordWrap(true);
  column->addWidget(why);
  column->addSpacing(px(12));
  name_ = make_field();
  staff_number_ = make_field();
  password_ = make_field(QLineEdit::Password);
  repeat_ = make_field(QLineEdit::Password);
  QFormLayout* fields = make_form();
  column->addLayout(fields);
  for (auto [label, field] : {std::pair{tr("Your name"), name_}, std::pair{tr("User name"), staff_number_},
                              std::pair{tr("Password, at least 8 characters"), password_},
                              std::pair{tr("Password again"), repeat_}}) {
    add_field(*fields, label, field, field == name_ ? 0 : kFieldGap);
  }
  column->addSpacing(px(12));
  band_ = new Band;
  column->addWidget(band_);
  column->addSpacing(px(4));
  enter_ = make_large_button(tr("Make the administrator"), ButtonKind::primary);
  column->addWidget(enter_);
  column->addSpacing(px(20));
  add_try_it(*column);
  column->addSpacing(px(12));
  QPushButton* back = make_button(tr("Go back to a backup"));
  column->addWidget(back);
  connect(back, &QPushButton::clicked, this, &SignIn::way_back_wanted);
  connect(enter_, &QPushButton::clicked, this, &SignIn::create_administrator);
  connect(repeat_, &QLineEdit::returnPressed, this, &SignIn::create_administrator);
  return form;
}

}  // namespace cusp::ui
