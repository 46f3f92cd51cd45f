/// Accounts as a table. No widget.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "storage/repositories/accounts.h"
#include "ui/modules.h"

namespace cusp::ui {

class PeopleModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kNumber, kRole, kSignIn, kState, kColumns };
  explicit PeopleModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_accounts(std::vector<Account> accounts);
  /// Shows only accounts with this text in name or number.
  void narrow(const QString& text);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const Account& account(int row) const { return shown_[static_cast<std::size_t>(row)]; }
  int row_of(UserId id) const;

 private:
  std::vector<Account> all_, shown_;
  QString search_;
};

}  // namespace cusp::ui
