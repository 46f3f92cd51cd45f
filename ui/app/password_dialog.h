/// One question: a new password for one's own account.
#pragma once

#include <QDialog>

#include "storage/store.h"
#include "ui/modules.h"

class QLineEdit;

namespace cusp::ui {

class Band;

class PasswordDialog : public QDialog {
  Q_OBJECT

 public:
  PasswordDialog(Store& store, const Account& account, QWidget* parent);

 private:
  void submit();
  Store& store_;
  Account account_;
  Band* band_;
  QLineEdit *old_, *fresh_, *again_;
};

}  // namespace cusp::ui
