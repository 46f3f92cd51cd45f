/// Accounts as a table, in the order of a column. No widget.
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <map>
#include <optional>
#include <vector>

#include "storage/repositories/accounts.h"
#include "ui/modules.h"

namespace cusp::ui {

class PeopleModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kNumber, kRole, kCohort, kState, kSignIn, kColumns };
  explicit PeopleModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  /// `cohorts`: names of each student's.
  void set_accounts(std::vector<Account> accounts, std::map<UserId, QStringList> cohorts = {});
  /// Shows only accounts with this text in name, number or cohort, and of this role if there is one.
  void narrow(const QString& text, std::optional<Role> role = std::nullopt);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Who is the same in that column stands by name.
  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
  const Account& account(int row) const { return shown_[static_cast<std::size_t>(row)]; }
  int row_of(UserId id) const;

 private:
  QString cohorts_of(const Account& account) const;
  /// Below 0, 0 or above 0, by the column of the order.
  int compare(const Account& a, const Account& b) const;
  void order_all();
  /// Those of all_ that the search leaves.
  void fill_shown();

  std::vector<Account> all_, shown_;
  std::map<UserId, QStringList> cohorts_;
  QString search_;
  std::optional<Role> role_;
  int column_ = kName;
  Qt::SortOrder order_ = Qt::AscendingOrder;
};

}  // namespace cusp::ui
