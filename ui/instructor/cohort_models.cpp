#include "ui/instructor/cohort_models.h"

#include <QDateTime>
#include <algorithm>

#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

bool is_title(Qt::Orientation orientation, int role) { return orientation == Qt::Horizontal && role == Qt::DisplayRole; }

QVariant at_right() { return QVariant(static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter)); }

QString moment(std::optional<std::int64_t> utc_us) {
  return utc_us ? format_day_time(local_time(*utc_us)) : QStringLiteral("–");
}

}  // namespace

void CohortsModel::set_cohorts(std::vector<Cohort> cohorts) {
  beginResetModel();
  cohorts_ = std::move(cohorts);
  endResetModel();
}

int CohortsModel::row_of(CohortId id) const {
  const auto it = std::ranges::find(cohorts_, id, &Cohort::id);
  return it == cohorts_.end() ? -1 : static_cast<int>(it - cohorts_.begin());
}

int CohortsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(cohorts_.size()); }
int CohortsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CohortsModel::data(const QModelIndex& index, int role) const {
  const Cohort& c = cohort(index.row());
  if (role == BoldRole) return index.column() == kName;
  if (role == Qt::TextAlignmentRole && index.column() == kStudents) return at_right();
  if (role == Qt::ToolTipRole && index.column() == kName) return tool_tip_text(QString::fromStdString(c.name));
  if (role != Qt::DisplayRole) return {};
  return index.column() == kName ? QVariant(QString::fromStdString(c.name)) : QVariant(QLocale().toString(c.students));
}

QVariant CohortsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section == kStudents) return at_right();
  if (!is_title(orientation, role)) return {};
  return section == kName ? tr("Cohort") : tr("Students");
}

void CohortStudentsModel::set_students(std::vector<Account> students) {
  beginResetModel();
  students_ = std::move(students);
  std::ranges::sort(students_, stands_before, &Account::name);
  endResetModel();
}

int CohortStudentsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(students_.size());
}
int CohortStudentsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CohortStudentsModel::data(const QModelIndex& index, int role) const {
  const Account& s = student(index.row());
  if (role == QuietRole) return s.disabled;
  if (role != Qt::DisplayRole) return {};
  return QString::fromStdString(index.column() == kName ? s.name : s.number);
}

QVariant CohortStudentsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (!is_title(orientation, role)) return {};
  return section == kName ? tr("Name") : tr("Number");
}

void AssignmentsModel::set_rows(std::vector<AssignmentRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int AssignmentsModel::row_of(AssignmentId id) const {
  const auto it = std::ranges::find(rows_, id, [](const AssignmentRow& row) { return row.assignment.id; });
  return it == rows_.end() ? -1 : static_cast<int>(it - rows_.begin());
}

int AssignmentsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.size()); }
int AssignmentsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant AssignmentsModel::data(const QModelIndex& index, int role) const {
  const AssignmentRow& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == BoldRole) return index.column() == kExercise;
  if (role == QuietRole) return row.assignment.withdrawn;
  if (role == Qt::TextAlignmentRole && index.column() == kAttempts) return at_right();
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kExercise: return local(row.title);
    case kKind: return kind_name(row.assignment.kind);
    case kOpens: return moment(row.assignment.opens_utc_us);
    case kDue: return row.assignment.withdrawn ? tr("withdrawn") : moment(row.assignment.due_utc_us);
    case kAttempts:
      return row.assignment.attempts_allowed ? QLocale().toString(*row.assignment.attempts_allowed) : tr("any number");
    default: return {};
  }
}

QVariant AssignmentsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section == kAttempts) return at_right();
  if (!is_title(orientation, role)) return {};
  switch (section) {
    case kExercise: return tr("Exercise");
    case kKind: return tr("Kind");
    case kOpens: return tr("From");
    case kDue: return tr("Due");
    case kAttempts: return tr("Attempts");
    default: return {};
  }
}

}  // namespace cusp::ui
