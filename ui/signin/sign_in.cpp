#include "ui/signin/sign_in.h"

#include <QApplication>
#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>

#include "ui/session/records_task.h"
#include "ui/signin/pin_field.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kLeftWidth = 560;     // px at 100 %
constexpr int kPictureFrom = 1100;  // px at 100 %; a narrower window shows the form alone

}  // namespace

SignIn::SignIn(Store& store, QWidget* parent) : QWidget(parent), store_(store) {
  const auto has = store_.accounts.has_administrator();
  first_start_ = has && !*has;
  setAccessibleName(first_start_ ? tr("First start") : tr("Sign in"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  // At a scale of 200 % the form is taller than the window.
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
  wait_.emplace(enter_);
  form->setFixedWidth(px(kFormWidth));
  // Stretches centre the form: an aligned one would not get the height of its wrapped lines.
  auto* middle = new QHBoxLayout;
  middle->addStretch();
  middle->addLayout(both);
  middle->addStretch();
  column->addLayout(middle);
  column->addStretch(3);
  column->addWidget(make_station());
  row->addWidget(left);

  picture_ = new QLabel;
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setMinimumSize(1, 1);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  picture_->setAccessibleName(tr("A tooth"));
  row->addWidget(picture_, 1);
}

void SignIn::show_incident(const Message& message) {
  incident_->show_message(Band::Kind::look, message.what, message.more);
  incident_->setVisible(first_start_ || who() == Who::staff);
}

void SignIn::show_note(const Message& message) {
  note_ = message;
  band_->show_message(Band::Kind::info, message.what, message.more);
}

void SignIn::show_no_drilling(const Message& why) {
  show_note(why);
  try_it_->setEnabled(false);
  try_it_->setToolTip(why.what);
  try_it_->setAccessibleDescription(why.what);
}

void SignIn::show_reading_only(const Message& why) {
  reading_only_->show_message(Band::Kind::look, why.what, why.more);
  try_again_->show();
}

void SignIn::offer_way_back() { way_back_->show(); }

void SignIn::show_fields(int tab) {
  const bool staff = tab == static_cast<int>(Who::staff);
  student_fields_->setVisible(!staff);
  staff_fields_->setVisible(staff);
  note_ ? show_note(*note_) : band_->clear();
  incident_->setVisible(staff && !incident_->text().isEmpty());
  (staff ? staff_number_ : number_)->setFocus();
}

SignIn::Who SignIn::who() const { return first_start_ ? Who::staff : static_cast<Who>(who_->currentIndex()); }
QString SignIn::typed_number() const { return who() == Who::staff ? staff_number_->text() : number_->text(); }
void SignIn::set_typed_number(const QString& number, Who who) {
  if (!first_start_) who_->setCurrentIndex(static_cast<int>(who));
  (this->who() == Who::staff ? staff_number_ : number_)->setText(number);
}
QString SignIn::typed_name() const { return first_start_ ? name_->text() : QString(); }
void SignIn::set_typed_name(const QString& name) {
  if (first_start_) name_->setText(name);
}
QString SignIn::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

void SignIn::submit() {
  if (waiting()) return;
  const bool as_staff = who() == Who::staff;
  const QString number = (as_staff ? staff_number_ : number_)->text().trimmed();
  if (number.isEmpty()) {
    (as_staff ? staff_number_ : number_)->setFocus();
    refuse({as_staff ? tr("The user name is missing.") : tr("The student number is missing."), {}});
    return;
  }
  const QString pin = as_staff ? QString() : pin_->text();
  if (!as_staff && !pin.isEmpty() && pin.size() < PinField::kDigits) {
    pin_->show_refused();
    ask_pin_again();
    refuse({tr("The PIN has six digits."), {}});
    return;
  }
  const Given given = as_staff ? Given::password : pin.isEmpty() ? Given::number : Given::pin;
  const QString secret = as_staff ? password_->text() : pin;
  ask_records(
      [given, number = number.toStdString(), secret = secret.toStdString()](Accounts& accounts) {
        return given == Given::pin ? accounts.sign_in_with_pin(number, secret) : accounts.sign_in(number, secret);
      },
      [this, given, number](const Stored<Account>& account) {
        if (!account) return refuse_sign_in(account.error(), number, given);
        password_->clear();
        pin_->clear();
        Q_EMIT signed_in(*account);
      });
}

void SignIn::refuse_sign_in(const StorageFailure& failure, const QString& number, Given given) {
  // An account without a PIN takes the number alone, so a refusal of an empty PIN means that one is set.
  const bool refused = failure.code == StorageError::wrong_password || failure.code == StorageError::other_secret;
  if (refused && given == Given::number) {
    refuse({tr("The PIN is missing."), tr("It has six digits.")});
  } else {
    refuse(describe_account(failure, number, given == Given::password ? Secret::password : Secret::pin));
  }
  if (given == Given::password) {
    password_->selectAll();
    password_->setFocus();
    return;
  }
  if (refused) pin_->show_refused();
  ask_pin_again();
}

void SignIn::ask_pin_again() {
  pin_->clear();
  pin_->setFocus();
}

void SignIn::ask_records(Question question, Answer answer) {
  wait_->start(tr("Checking…"));
  asking_ = with_own_store(store_, [self = QPointer(this), question = std::move(question), answer = std::move(answer)](OwnStore own) {
    const auto account = std::make_shared<Stored<Account>>(own ? question((*own)->accounts) : Stored<Account>(std::unexpected(own.error())));
    QMetaObject::invokeMethod(
        qApp,
        [self, account, answer] {
          if (!self) return;
          self->wait_->finish();
          // "Try it" may have put another page over this one.
          if (self->isVisible()) answer(*account);
        },
        Qt::QueuedConnection);
  });
}

void SignIn::create_administrator() {
  if (waiting()) return;
  name_->setText(without_marks_but_joiners(name_->text()));
  staff_number_->setText(without_marks(staff_number_->text()));
  if (name_->text().isEmpty() || staff_number_->text().isEmpty()) {
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
  fresh.number = staff_number_->text().toStdString();
  fresh.name = name_->text().toStdString();
  fresh.role = Role::administrator;
  fresh.password = password_->text().toStdString();
  ask_records([fresh](Accounts& accounts) { return accounts.create_first_administrator(fresh); },
              [this, number = staff_number_->text()](const Stored<Account>& account) {
                if (!account && account.error().code == StorageError::not_allowed) return Q_EMIT administrator_there();
                if (!account) return refuse(describe_account(account.error(), number, Secret::password));
                Q_EMIT signed_in(*account);
                Q_EMIT administrator_made();
              });
}

void SignIn::refuse(const Message& message) { band_->show_message(Band::Kind::bad, message.what, message.more); }

void SignIn::set_picture(const QImage& picture) {
  image_ = picture;
  if (isVisible()) resizeEvent(nullptr);
}

void SignIn::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (first_start_) {
    name_->setFocus();
  } else if (who() == Who::staff) {
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
  const QSize area(width() - px(kLeftWidth), height());
  const qreal ratio = devicePixelRatioF();
  QImage scaled = image_.scaled(area * ratio, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QSize want = area * ratio;
  scaled = scaled.copy((scaled.width() - want.width()) / 2, (scaled.height() - want.height()) / 2, want.width(), want.height());
  scaled.setDevicePixelRatio(ratio);
  picture_->setPixmap(QPixmap::fromImage(scaled));
}

}  // namespace cusp::ui
