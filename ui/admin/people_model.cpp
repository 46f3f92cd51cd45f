#include "ui/admin/people_model.h"

#include "ui/text/names.h"
#include "ui/widgets/table.h"

namespace cusp::ui {

void PeopleModel::set_accounts(std::vector<Account> accounts, std::map<UserId, QStringList> cohorts) {
  all_ = std::move(accounts);
  cohorts_ = std::move(cohorts);
  narrow(search_, role_);
}

QString PeopleModel::cohorts_of(const Account& account) const {
  const auto found = cohorts_.find(account.id);
  return found == cohorts_.end() ? QString() : found->second.join(u", "_qs);
}

void PeopleModel::narrow(const QString& text, std::optional<Role> role) {
  beginResetModel();
  search_ = text.trimmed();
  role_ = role;
  shown_.clear();
  for (const Account& a : all_) {
    if (role_ && a.role != *role_) continue;
    for (const QString& field : {QString::fromStdString(a.name), QString::fromStdString(a.number), cohorts_of(a)}) {
      if (!field.contains(search_, Qt::CaseInsensitive)) continue;
      shown_.push_back(a);
      break;
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
  if (role == ChipRole && index.column() == kState && a.disabled) return static_cast<int>(Chip::Kind::look);  // the rule needs no sign
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kName: return QString::fromStdString(a.name);
    case kNumber: return QString::fromStdString(a.number);
    case kRole: return role_name(a.role);
    case kCohort: return cohorts_of(a);
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
    case kNumber: return tr("Signs in as");
    case kRole: return tr("Role");
    case kSignIn: return tr("Signs in with");
    case kCohort: return tr("Cohort");
    case kState: return tr("Account");
    default: return {};
  }
}

}  // namespace cusp::ui
