/// Accounts: list, add, change, switch off, new password or PIN, role. The form stands beside the list, in a narrow page below
/// it. Switching off and erasing ask a question, and so does another person while the form is half filled. Thread: GUI.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "storage/repositories/possible_doubles.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/text/names.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/half_filled.h"
#include "ui/widgets/ports.h"
#include "ui/widgets/rereads.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace cusp::ui {

struct AccountChange;
class Band;
class Card;
class DepartedCard;
class PeopleModel;
class Settings;
class Table;

class PeoplePage : public QWidget, public Rereads, public HalfFilled {
  Q_OBJECT

 public:
  /// `names`: what people here call other stations; outlives the page. nullptr: they are named by the end of their id.
  PeoplePage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr, const Settings* names = nullptr);
  PeopleModel* model() const { return model_; }
  Table* table() const { return table_; }
  DepartedCard& departed() { return *departed_; }
  QString message() const;
  bool read_again() override;
  bool half_filled() const override;
  /// Until the records have written what the form says. A second press is ignored meanwhile.
  bool waiting() const { return wait_ && wait_->running(); }

 Q_SIGNALS:
  void import_wanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_form();
  QWidget* make_filters();
  void filter();
  void read();
  void show_chosen();
  void show_person(const Account& account);
  /// Calls `then`; after a question, or never, if it would take away what is typed.
  void leave_form(std::function<void()> then);
  void begin_new();
  /// Who may be the same person as the form's, by another account.
  void show_doubles();
  void fit_secret();
  void save();
  void show_saved(const AccountChange& change, const Stored<void>& done);
  void fit_save();
  bool changed() const;
  void switch_account();
  void erase_person();
  /// Of an act on `account`: shows the list and the account as they stand now, and why it failed.
  bool show_if_failed(const Stored<void>& done, const Account& account);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  PeopleModel* model_;
  QBoxLayout* columns_ = nullptr;  // the list, and the form with what is below it
  Table* table_ = nullptr;
  Band* band_ = nullptr;
  QLineEdit* search_ = nullptr;
  QComboBox* shown_role_ = nullptr;  // the first entry is everybody
  QLabel* count_ = nullptr;
  Card* form_ = nullptr;
  DepartedCard* departed_ = nullptr;
  const Settings* names_;
  std::vector<PossibleDouble> doubles_;
  QLabel* same_person_ = nullptr;  // shows doubles_ of the form's person
  QLineEdit *name_ = nullptr, *number_ = nullptr, *secret_ = nullptr;
  QLabel *secret_label_ = nullptr, *secret_note_ = nullptr;
  QComboBox* role_ = nullptr;
  QPushButton *save_ = nullptr, *switch_ = nullptr, *erase_ = nullptr;
  std::optional<Account> edited_;
  std::optional<ButtonWait> wait_;  // of save_
  BackgroundTask saving_;
};

}  // namespace cusp::ui
