#include "ui/admin/student_list_model.h"

#include <QLocale>
#include <algorithm>

#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

using State = ListedStudent::State;
using Problem = ListedStudent::Problem;

QString state_text(const ListedStudent& student) {
  switch (student.state) {
    case State::fresh: return student.namesake.isEmpty() ? StudentListModel::tr("new") : StudentListModel::tr("name has number %1").arg(student.namesake);
    case State::known: return student.switched_off ? StudentListModel::tr("has an account, switched off") : StudentListModel::tr("has an account");
    case State::other_name: return StudentListModel::tr("number has another name");
    case State::bad: break;
  }
  switch (student.problem) {
    case Problem::no_number: return StudentListModel::tr("no number");
    case Problem::no_name: return StudentListModel::tr("no name");
    case Problem::too_long: return StudentListModel::tr("too long for an account");
    case Problem::twice: return StudentListModel::tr("number stands above too");
    case Problem::bad_pin: return StudentListModel::tr("PIN is not six digits");
    case Problem::staff: return StudentListModel::tr("number is a member of staff");
    case Problem::none: break;
  }
  return {};
}

Chip::Kind state_chip(const ListedStudent& student) {
  switch (student.state) {
    case State::fresh: return student.namesake.isEmpty() ? Chip::Kind::plain : Chip::Kind::look;
    case State::known: return student.switched_off ? Chip::Kind::look : Chip::Kind::good;
    case State::other_name: return Chip::Kind::look;
    case State::bad: break;
  }
  return Chip::Kind::bad;
}

}  // namespace

void StudentListModel::set_students(std::vector<ListedStudent> students) {
  beginResetModel();
  students_ = std::move(students);
  endResetModel();
}

int StudentListModel::count(State state) const { return static_cast<int>(std::ranges::count(students_, state, &ListedStudent::state)); }
int StudentListModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(students_.size()); }
int StudentListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant StudentListModel::data(const QModelIndex& index, int role) const {
  const ListedStudent& s = students_[static_cast<std::size_t>(index.row())];
  if (role == ChipRole && index.column() == kState) return static_cast<int>(state_chip(s));
  if (role == BoldRole) return index.column() == kName;
  if (role == Qt::TextAlignmentRole && index.column() == kLine) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kLine: return QLocale().toString(s.line);
    case kState: return state_text(s);
    case kName: return s.name;
    case kNumber: return s.number;
    case kPin:
      if (s.state != State::fresh && !s.made) return {};  // an account that stands keeps its PIN
      return s.pin.isEmpty() ? tr("made here") : tr("from the file");
    case kCohort: return s.cohort;
    default: return {};
  }
}

QVariant StudentListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kLine: return tr("Line");
    case kState: return tr("Account");
    case kName: return tr("Name");
    case kNumber: return tr("Number");
    case kPin: return tr("PIN");
    case kCohort: return tr("Cohort");
    default: return {};
  }
}

}  // namespace cusp::ui
