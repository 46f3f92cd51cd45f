#include "ui/admin/people_model.h"

#include "ui/text/names.h"
#include "ui/widgets/table.h"

namespace cusp::ui {

void PeopleModel::set_accounts(std::vector<Account> accounts) {
  all_ = std::move(accounts);
  narrow(search_);
}

void PeopleModel::narrow(const QString& text) {
  beginResetModel();
  search_ = text.trimmed();
  shown_.clear();
  for (const Account& a : all_) {
    if (QString::fromStdString(a.name).contains(search_, Qt::CaseInsensitive) ||
        QString::fromStdString(a.number).contains(search_, Qt::CaseInsensitive)) {
      shown_.push_back(a);
    }
  }
  endResetModel();
}

int PeopleModel::row_of(UserId id) const {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (shown_[i].id == id) return static_cast<int>(i);
  }
  return -1;
}

int PeopleModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(shown_.size()); }
int PeopleModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant PeopleModel::data(const QModelIndex& index, int role) const {
  const Account& a = account(index.row());
  if (role == BoldRole) return index.column() == kName;
  if (role == QuietRole) return a.disabled;
  if (role == ChipRole && index.column() == kState) {
    return static_cast<int>(a.disabled ? Chip::Kind::look : Chip::Kind::good);
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kName: return QString::fromStdString(a.name);
    case kNumber: return QString::fromStdString(a.number);
    case kRole: return role_name(a.role);
    case kSignIn:
      if (a.has_pin && a.has_password) return tr("PIN or password");
      if (a.has_pin) return tr("PIN");
      if (a.has_password) return tr("Password");
      return tr("number alone");
    case kState: return a.disabled ? tr("Switched off") : tr("Active");
    default: return {};
  }
}

QVariant PeopleModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kName: return tr("Name");
    case kNumber: return tr("Number or user name");
    case kRole: return tr("Role");
    case kSignIn: return tr("Signs in with");
    case kState: return tr("Account");
    default: return {};
  }
}

}  // namespace cusp::ui
