/// Accounts: list, add, change, switch off, new password or PIN, role. The form stands beside the list; only switching an account
/// off asks a question. Thread: GUI.
#pragma once

#include <QWidget>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/text/names.h"
#include "ui/widgets/ports.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace cusp::ui {

class Band;
class Card;
class DepartedCard;
class PeopleModel;
class Table;

class PeoplePage : public QWidget {
  Q_OBJECT

 public:
  PeoplePage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  PeopleModel* model() const { return model_; }
  Table* table() const { return table_; }
  DepartedCard& departed() { return *departed_; }
  QString message() const;

 Q_SIGNALS:
  void import_wanted();

 private:
  QWidget* make_form();
  void read();
  void show_chosen();
  void begin_new();
  void fit_secret();
  void save();
  void switch_account();
  void erase_person();
  bool show_if_failed(const Stored<void>& done);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  PeopleModel* model_;
  Table* table_ = nullptr;
  Band* band_ = nullptr;
  Card* form_ = nullptr;
  DepartedCard* departed_ = nullptr;
  QLineEdit *name_ = nullptr, *number_ = nullptr, *secret_ = nullptr;
  class QLabel *secret_label_ = nullptr, *secret_note_ = nullptr;
  QComboBox* role_ = nullptr;
  QPushButton *save_ = nullptr, *switch_ = nullptr, *erase_ = nullptr;
  std::optional<Account> edited_;
};

}  // namespace cusp::ui
