#include "ui/signin/sign_in.h"

#include <QAction>
#include <QBoxLayout>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSysInfo>
#include <QToolButton>

#include "ui/signin/pin_boxes.h"
#include "ui/text/language.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kFormWidth = 320;    // px at 100 %
constexpr int kLeftWidth = 560;
constexpr int kPictureFrom = 1100;  // below it the form has the window to itself

QLineEdit* make_field(bool secret = false) {
  auto* field = new QLineEdit;
  field->setProperty("large", true);
  field->setFixedHeight(px(40));
  if (secret) field->setEchoMode(QLineEdit::Password);
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

SignIn::SignIn(Store& store, QWidget* parent) : QWidget(parent), store_(store) {
  const auto has = store_.accounts.has_administrator();
  first_start_ = has && !*has;
  setAccessibleName(first_start_ ? tr("First start") : tr("Sign in"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  // Scrolls where the form is taller than the window: at 200 % it is.
  auto* left = new QScrollArea;
  left->setWidgetResizable(true);
  left->setFrameShape(QFrame::NoFrame);
  left->setFocusPolicy(Qt::NoFocus);
  left->setObjectName(u"sign_in_left"_qs);
  auto* panel = new QFrame;
  panel->setProperty("kind", u"bar_side"_qs);
  left->setWidget(panel);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(px(40), px(28), px(40), px(28));
  column->addWidget(make_head());
  column->addStretch(2);
  QWidget* form = first_start_ ? make_first_start_form() : make_sign_in_form();
  auto* both = new QVBoxLayout;
  both->setSpacing(px(16));
  both->addWidget(make_notices());
  both->addWidget(form);
  form->setFixedWidth(px(kFormWidth));
  // Between stretches, not aligned: an aligned form would not be given the height its wrapped lines need.
  auto* middle = new QHBoxLayout;
  middle->addStretch();
  middle->addLayout(both);
  middle->addStretch();
  column->addLayout(middle);
  column->addStretch(3);
  const QString file = QString::fromStdString(store_.database().file().filename().string());
  QLabel* foot = make_label(tr("%1: results are kept on this computer, in %2.").arg(QSysInfo::machineHostName(), isolate(file)),
                            TextRole::caption, false, "text2");
  foot->setToolTip(QString::fromStdString(store_.database().file().string()));
  foot->setWordWrap(true);
  column->addWidget(make_row_sign(u"monitor"_qs, Ink::text2, foot));
  row->addWidget(left);

  picture_ = new QLabel;
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setMinimumSize(1, 1);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  picture_->setAccessibleName(tr("A tooth"));
  row->addWidget(picture_, 1);
}

QWidget* SignIn::make_head() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  auto* logo = new QLabel;
  logo->setPixmap(icon_pixmap(u"tooth"_qs, Ink::accent, 22, devicePixelRatioF()));
  row->addWidget(logo);
  row->addWidget(make_label(u"Cusp"_qs, TextRole::live, true));
  row->addStretch();
  auto* language = make_button({}, ButtonKind::quiet, u"globe"_qs);
  for (const Language& l : languages()) {
    if (l.code == current_language()) language->setText(l.name + u"  ▾"_qs);
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
  language->setMenu(menu);
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
  column->addWidget(try_again_, 0, Qt::AlignLeft);
  connect(try_again_, &QPushButton::clicked, this, &SignIn::try_again);
  return notices;
}

void SignIn::show_incident(const Told& told) {
  incident_->show_message(Band::Kind::look, told.what, told.more);
  incident_->setVisible(first_start_ || staff());
}

void SignIn::show_reading_only(const Told& why) {
  reading_only_->show_message(Band::Kind::look, why.what, why.more);
  try_again_->show();
}

QWidget* SignIn::make_sign_in_form() {
  auto* form = new QWidget;
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  column->addWidget(make_label(tr("Sign in"), TextRole::page_title, true));
  column->addWidget(make_label(QSysInfo::machineHostName(), TextRole::body, false, "text2"));
  column->addSpacing(px(16));
  who_ = new Segments({tr("Student"), tr("Staff")});
  column->addWidget(who_);
  column->addSpacing(px(16));

  student_fields_ = new QWidget;
  auto* student = new QVBoxLayout(student_fields_);
  student->setContentsMargins(0, 0, 0, 0);
  student->setSpacing(px(16));
  number_ = make_field();
  number_->addAction(icon(u"person"_qs, Ink::text2), QLineEdit::LeadingPosition);
  student->addWidget(labelled(tr("Student number"), number_));
  pin_ = new PinBoxes;
  student->addWidget(labelled(tr("PIN, six digits"), pin_));
  column->addWidget(student_fields_);

  staff_fields_ = new QWidget;
  auto* staff_column = new QVBoxLayout(staff_fields_);
  staff_column->setContentsMargins(0, 0, 0, 0);
  staff_column->setSpacing(px(16));
  staff_number_ = make_field();
  staff_number_->addAction(icon(u"person"_qs, Ink::text2), QLineEdit::LeadingPosition);
  staff_column->addWidget(labelled(tr("User name"), staff_number_));
  password_ = make_field(true);
  password_->addAction(icon(u"lock"_qs, Ink::text2), QLineEdit::LeadingPosition);
  staff_column->addWidget(labelled(tr("Password"), password_));
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
  or_row->addWidget(make_label(tr("or"), TextRole::caption, false, "text2"));
  or_row->addWidget(make_rule(), 1);
  column->addLayout(or_row);
  column->addSpacing(px(20));
  QPushButton* try_button = make_large_button(tr("Try it"), ButtonKind::standard, u"play"_qs);
  try_button->setIcon(icon(u"play"_qs, Ink::accent));
  column->addWidget(try_button);
  QLabel* note = make_label(tr("No account. You drill a practice block with the mouse; nothing goes into the school’s "
                               "records."),
                            TextRole::caption, false, "text2");
  note->setWordWrap(true);
  column->addSpacing(px(4));
  column->addWidget(note);

  connect(who_, &Segments::changed, this, &SignIn::show_segment);
  connect(enter_, &QPushButton::clicked, this, &SignIn::submit);
  connect(number_, &QLineEdit::returnPressed, this, [this] {
    if (pin_->pin().isEmpty() && !number_->text().isEmpty()) {
      pin_->setFocus();
    } else {
      submit();
    }
  });
  connect(pin_, &PinBoxes::completed, this, [this] { enter_->setFocus(); });
  connect(pin_, &PinBoxes::edited, this, [this] { pin_->set_wrong(false); });
  connect(pin_, &PinBoxes::accepted, this, &SignIn::submit);
  connect(staff_number_, &QLineEdit::returnPressed, password_, qOverload<>(&QWidget::setFocus));
  connect(password_, &QLineEdit::returnPressed, this, &SignIn::submit);
  connect(try_button, &QPushButton::clicked, this, &SignIn::try_it);
  return form;
}

QWidget* SignIn::make_first_start_form() {
  auto* form = new QWidget;
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(4));
  column->addWidget(make_label(tr("First start"), TextRole::page_title, true));
  QLabel* why = make_label(tr("Nobody manages this computer’s records yet. Make the administrator; everybody else is "
                              "added afterwards."),
                           TextRole::body, false, "text2");
  why->setWordWrap(true);
  column->addWidget(why);
  column->addSpacing(px(12));
  name_ = make_field();
  staff_number_ = make_field();
  password_ = make_field(true);
  repeat_ = make_field(true);
  for (auto [label, field] : {std::pair{tr("Your name"), name_}, std::pair{tr("User name"), staff_number_},
                              std::pair{tr("Password, at least 8 characters"), password_},
                              std::pair{tr("Password again"), repeat_}}) {
    column->addWidget(labelled(label, field));
    column->addSpacing(px(8));
  }
  band_ = new Band;
  column->addWidget(band_);
  enter_ = make_large_button(tr("Make the administrator"), ButtonKind::primary);
  column->addWidget(enter_);
  column->addSpacing(px(20));
  QPushButton* try_button = make_large_button(tr("Try it"), ButtonKind::standard, u"play"_qs);
  try_button->setIcon(icon(u"play"_qs, Ink::accent));
  column->addWidget(try_button);
  QLabel* note = make_label(tr("No account. You drill a practice block with the mouse; nothing goes into the school’s "
                               "records."),
                            TextRole::caption, false, "text2");
  note->setWordWrap(true);
  column->addWidget(note);
  connect(enter_, &QPushButton::clicked, this, &SignIn::create_administrator);
  connect(repeat_, &QLineEdit::returnPressed, this, &SignIn::create_administrator);
  connect(try_button, &QPushButton::clicked, this, &SignIn::try_it);
  return form;
}

void SignIn::show_segment(int index) {
  student_fields_->setVisible(index == 0);
  staff_fields_->setVisible(index == 1);
  band_->clear();
  incident_->setVisible(index == 1 && !incident_->text().isEmpty());
  (index == 0 ? number_ : staff_number_)->setFocus();
}

bool SignIn::staff() const { return who_ && who_->chosen() == 1; }
QString SignIn::typed_number() const {
  if (first_start_) return {};
  return staff() ? staff_number_->text() : number_->text();
}
void SignIn::set_typed_number(const QString& number, bool staff) {
  if (first_start_) return;
  who_->choose(staff ? 1 : 0);
  (staff ? staff_number_ : number_)->setText(number);
}
QString SignIn::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

void SignIn::submit() {
  const bool as_staff = staff();
  const QString number = (as_staff ? staff_number_ : number_)->text().trimmed();
  if (number.isEmpty()) {
    (as_staff ? staff_number_ : number_)->setFocus();
    refuse({as_staff ? tr("The user name is missing.") : tr("The student number is missing."), {}});
    return;
  }
  const QString pin = as_staff ? QString() : pin_->pin();
  if (!as_staff && !pin.isEmpty() && pin.size() < PinBoxes::kDigits) {
    pin_->set_wrong(true);
    refuse({tr("The PIN has six digits."), {}});
    return;
  }
  const auto account =
      as_staff        ? store_.accounts.sign_in(number.toStdString(), password_->text().toStdString())
      : pin.isEmpty() ? store_.accounts.sign_in(number.toStdString(), "")
                      : store_.accounts.sign_in_with_pin(number.toStdString(), pin.toStdString());
  if (account) {
    password_->clear();
    pin_->clear();
    Q_EMIT signed_in(*account);
    return;
  }
  const StorageFailure& failure = account.error();
  // Nothing typed and no PIN wanted: then the account has a PIN or a password, and it is missing.
  const bool refused = failure.code == StorageError::wrong_password || failure.code == StorageError::other_secret;
  if (refused && !as_staff && pin.isEmpty()) {
    refuse({tr("The PIN is missing."), tr("It has six digits.")});
  } else {
    refuse(tell_account(failure, number, as_staff ? Secret::password : Secret::pin));
  }
  if (refused && !as_staff) {
    pin_->clear();
    pin_->set_wrong(true);
    pin_->setFocus();
  }
  if (as_staff) {
    password_->selectAll();
    password_->setFocus();
  }
}

void SignIn::create_administrator() {
  if (name_->text().trimmed().isEmpty() || staff_number_->text().trimmed().isEmpty()) {
    refuse({tr("Name and user name are needed."), {}});
    return;
  }
  if (password_->text() != repeat_->text()) {
    refuse({tr("The two passwords differ."), tr("Type them again.")});
    password_->clear();
    repeat_->clear();
    password_->setFocus();
    return;
  }
  NewAccount fresh;
  fresh.number = staff_number_->text().trimmed().toStdString();
  fresh.name = name_->text().trimmed().toStdString();
  fresh.role = Role::administrator;
  fresh.password = password_->text().toStdString();
  const auto account = store_.accounts.create_first_administrator(fresh);
  if (!account) {
    refuse(tell_account(account.error(), staff_number_->text().trimmed(), Secret::password));
    return;
  }
  Q_EMIT signed_in(*account);
}

void SignIn::refuse(const Told& told) { band_->show_message(Band::Kind::bad, told.what, told.more); }

void SignIn::set_picture(const QImage& picture) {
  image_ = picture;
  if (isVisible()) resizeEvent(nullptr);
}

void SignIn::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (first_start_) {
    name_->setFocus();
  } else if (staff()) {
    staff_number_->setFocus();
  } else {
    (number_->text().isEmpty() ? static_cast<QWidget*>(number_) : pin_)->setFocus();
  }
}

void SignIn::resizeEvent(QResizeEvent* event) {
  if (event) QWidget::resizeEvent(event);
  const bool wide = width() >= px(kPictureFrom);
  picture_->setVisible(wide);
  auto* left = findChild<QScrollArea*>(u"sign_in_left"_qs);
  left->setMinimumWidth(wide ? px(kLeftWidth) : 0);
  left->setMaximumWidth(wide ? px(kLeftWidth) : QWIDGETSIZE_MAX);
  if (!wide || image_.isNull()) return;
  const QSize room(width() - px(kLeftWidth), height());
  const qreal ratio = devicePixelRatioF();
  QImage scaled = image_.scaled(room * ratio, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QSize want = room * ratio;
  scaled = scaled.copy((scaled.width() - want.width()) / 2, (scaled.height() - want.height()) / 2, want.width(), want.height());
  scaled.setDevicePixelRatio(ratio);
  picture_->setPixmap(QPixmap::fromImage(scaled));
}

}  // namespace cusp::ui
