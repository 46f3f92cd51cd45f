/// One question: a new password for one's own account.
#pragma once

#include <QDialog>
#include <optional>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/widgets/busy.h"

class QLineEdit;

namespace cusp::ui {

class Band;
struct Message;

class PasswordDialog : public QDialog {
  Q_OBJECT

 public:
  PasswordDialog(Store& store, const Account& account, QWidget* parent);
  /// Until the records have the new password or refuse it: argon2id takes longer than a frame. The dialog stays open meanwhile.
  bool waiting() const { return wait_ && wait_->running(); }
  void reject() override;

 private:
  void submit();
  void show_answer(const Stored<void>& done);
  /// Grows with the message, and puts the keyboard on the field to type anew.
  void refuse(const Message& message, QLineEdit& wrong);
  Store& store_;
  Account account_;
  Band* band_;
  QLineEdit *old_, *fresh_, *again_;
  std::optional<ButtonWait> wait_;
  BackgroundTask changing_;
};

}  // namespace cusp::ui
