#include "ui/app/password_dialog.h"

#include <QApplication>
#include <QBoxLayout>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <algorithm>

#include "ui/session/records_task.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

PasswordDialog::PasswordDialog(Store& store, const Account& account, QWidget* parent)
    : QDialog(parent), store_(store), account_(account) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Change password"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(24), px(24), px(24), px(24));
  column->setSpacing(px(12));
  band_ = new Band;
  column->addWidget(band_);
  const auto field = [&](const QString& label) {
    auto* edit = new QLineEdit;
    edit->setEchoMode(QLineEdit::Password);
    column->addWidget(labelled(label, edit));
    return edit;
  };
  old_ = field(tr("Password until now"));
  fresh_ = field(tr("New password, at least 8 characters"));
  again_ = field(tr("New password again"));
  auto* row = new QHBoxLayout;
  row->addStretch();
  QPushButton* cancel = make_button(tr("Cancel"));
  QPushButton* change = make_button(tr("Change password"), ButtonKind::primary);
  change->setDefault(true);
  row->addWidget(cancel);
  row->addWidget(change);
  column->addLayout(row);
  wait_.emplace(change);
  setMinimumWidth(px(400));
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(change, &QPushButton::clicked, this, &PasswordDialog::submit);
}

void PasswordDialog::reject() {
  if (!waiting()) QDialog::reject();
}

void PasswordDialog::refuse(const Message& message, QLineEdit& wrong) {
  band_->show_message(Band::Kind::bad, message.what, message.more);
  band_->updateGeometry();  // one that stood there before may have had fewer lines
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
  wrong.selectAll();
  wrong.setFocus();
}

void PasswordDialog::submit() {
  if (waiting()) return;
  if (fresh_->text() != again_->text()) return refuse({tr("The two new passwords differ."), tr("Type them again.")}, *fresh_);
  wait_->start(tr("Changing…"));
  changing_ = with_own_store(store_, [self = QPointer(this), account = account_, old = old_->text().toStdString(), fresh = fresh_->text().toStdString()](OwnStore own) {
    const auto done = std::make_shared<Stored<void>>(own ? (*own)->accounts.set_password(account.actor(), account.id, old, fresh)
                                                         : Stored<void>(std::unexpected(own.error())));
    QMetaObject::invokeMethod(
        qApp,
        [self, done] {
          if (self) self->show_answer(*done);
        },
        Qt::QueuedConnection);
  });
}

void PasswordDialog::show_answer(const Stored<void>& done) {
  wait_->finish();
  if (done) return accept();
  if (done.error().code == StorageError::wrong_password) {
    return refuse({tr("The password until now is another one."), tr("Nothing was changed.")}, *old_);
  }
  refuse(describe_account(done.error(), QString::fromStdString(account_.number), Secret::password), *fresh_);
}

}  // namespace cusp::ui
