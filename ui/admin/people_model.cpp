#include "ui/admin/people_model.h"

#include <algorithm>

#include "ui/text/names.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

int compare_texts(const std::string& a, const std::string& b) { return stands_before(a, b) ? -1 : stands_before(b, a) ? 1 : 0; }

/// As keys: the order is the same in every language.
int way_in(const Account& a) { return (a.has_pin ? 1 : 0) + (a.has_password ? 2 : 0); }

}  // namespace

void PeopleModel::set_accounts(std::vector<Account> accounts, std::map<UserId, QStringList> cohorts) {
  all_ = std::move(accounts);
  cohorts_ = std::move(cohorts);
  order_all();
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
  fill_shown();
  endResetModel();
}

void PeopleModel::fill_shown() {
  shown_.clear();
  for (const Account& a : all_) {
    if (role_ && a.role != *role_) continue;
    for (const QString& field : {QString::fromStdString(a.name), QString::fromStdString(a.number), cohorts_of(a)}) {
      if (!field.contains(search_, Qt::CaseInsensitive)) continue;
      shown_.push_back(a);
      break;
    }
  }
}

int PeopleModel::compare(const Account& a, const Account& b) const {
  switch (column_) {
    case kNumber: return compare_texts(a.number, b.number);
    case kRole: return static_cast<int>(a.role) - static_cast<int>(b.role);
    case kCohort: return compare_texts(cohorts_of(a).toStdString(), cohorts_of(b).toStdString());
    case kState: return static_cast<int>(a.disabled) - static_cast<int>(b.disabled);
    case kSignIn: return way_in(a) - way_in(b);
    default: return compare_texts(a.name, b.name);
  }
}

void PeopleModel::order_all() {
  std::ranges::stable_sort(all_, [this](const Account& a, const Account& b) {
    const int order = compare(a, b);
    if (order == 0) return stands_before(a.name, b.name);
    return order_ == Qt::AscendingOrder ? order < 0 : order > 0;
  });
}

void PeopleModel::sort(int column, Qt::SortOrder order) {
  if (column < 0 || column >= kColumns) return;
  Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
  column_ = column;
  order_ = order;
  const QModelIndexList before = persistentIndexList();
  std::vector<UserId> people;
  for (const QModelIndex& at : before) people.push_back(account(at.row()).id);
  order_all();
  fill_shown();
  QModelIndexList after;
  for (qsizetype i = 0; i < before.size(); ++i) after << index(row_of(people[static_cast<std::size_t>(i)]), before[i].column());
  changePersistentIndexList(before, after);
  Q_EMIT layoutChanged({}, VerticalSortHint);
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
