#include "ui/student/course.h"

#include <QDateTime>
#include <algorithm>
#include <limits>
#include <utility>

#include "ui/student/exercise_groups.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

/// Kind of specimen, a column to sort by.
QString kind_of(const SpecimenSource& specimen) {
  if (specimen.generator.empty()) return CourseModel::tr("From a file");
  if (specimen.generator != "tooth") return CourseModel::tr("Block");
  return specimen.typodont ? CourseModel::tr("Model tooth") : CourseModel::tr("Tooth");
}

QString standing_text(const CourseRow& row) {
  if (row.best && row.best->score) return CourseModel::tr("%1 of 100").arg(format_points(*row.best->score));
  // The last day on which it is open: midnight, shown without its time, would read as a further day.
  if (row.due()) return CourseModel::tr("Due %1").arg(format_day(local_time(*row.due_utc_us - 1)));
  return row.attempts > 0 ? CourseModel::tr("no result yet") : CourseModel::tr("not tried yet");
}

Chip::Kind standing_kind(const CourseRow& row) {
  if (row.passed) return Chip::Kind::good;
  return row.due() ? Chip::Kind::look : Chip::Kind::plain;
}

/// What a screen reader says of a card besides its name.
QString description_of(const CourseRow& row) {
  const QString level = level_and_time_text(row.exercise.scenario), standing = standing_text(row);
  //: %1: level and expected time of an exercise, %2: the student's standing at it.
  return level.isEmpty() ? standing : CourseModel::tr("%1; %2").arg(level, standing);
}

int level_rank(const Scenario& scenario) { return static_cast<int>(scenario.level ? static_cast<std::size_t>(*scenario.level) : kLevelKeys.size()); }

QVariant right() { return QVariant(static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter)); }

}  // namespace

int Course::next() const {
  if (rows.empty()) return -1;
  const auto rank = [](const CourseRow& r) {
    constexpr auto kNever = std::numeric_limits<std::int64_t>::max();
    return std::tuple(r.passed, r.due() ? *r.due_utc_us : kNever, r.passed && r.best ? r.best->score.value_or(0) : 0.0);
  };
  const auto it = std::min_element(rows.begin(), rows.end(),
                                   [&](const CourseRow& a, const CourseRow& b) { return rank(a) < rank(b); });
  return static_cast<int>(it - rows.begin());
}

namespace {

/// What the start page shows of the newest attempts.
Stored<void> load_newest(Course& course, Store& store, const Actor& student, const std::vector<ExerciseStanding>& standings) {
  for (const ExerciseStanding& s : standings) {
    const auto moment = [](const HistoryRow& row) { return std::pair(row.started_utc_us, row.sequence); };
    if (s.last && (!course.last_graded || moment(*s.last) > moment(*course.last_graded))) course.last_graded = s.last;
  }
  auto interrupted = store.history.interrupted(student, student.id);
  if (!interrupted) return std::unexpected(interrupted.error());
  course.interrupted = std::move(*interrupted);
  const auto practices = std::ranges::stable_partition(course.interrupted, [](const HistoryRow& row) { return row.kind == SessionKind::assessment; });
  if (practices.size() > 1) course.interrupted.erase(practices.begin() + 1, practices.end());
  if (!course.last_graded) return {};
  HistoryFilter same;
  same.student = student.id;
  same.scenario = course.last_graded->scenario;
  same.device_class = course.last_graded->device_class;
  same.scripted = false;
  auto attempts = store.history.list(student, same);
  if (!attempts) return std::unexpected(attempts.error());
  std::erase_if(*attempts, [](const HistoryRow& row) { return !row.score; });
  course.charted = std::move(*attempts);
  return {};
}

/// False before it opens, and where it or its version was withdrawn.
Stored<bool> is_assigned(Store& store, const Assignment& a, std::int64_t now_us) {
  if (a.withdrawn || (a.opens_utc_us && now_us < *a.opens_utc_us)) return false;
  const auto withdrawn = store.scenarios.withdrawn(a.version);
  if (!withdrawn) return std::unexpected(withdrawn.error());
  return !*withdrawn;
}

/// Of each exercise the practice that is open, has attempts left and is due first, else the last one that is open, else the one that was
/// over last. The student drills the version of an open one, also when a newer one is published. `assigned`: by due date.
Stored<void> add_assignments(Course& course, Store& store, UserId student, const std::vector<Assignment>& assigned) {
  const std::int64_t now_us = store.context().clock();
  for (const Assignment& a : assigned) {
    if (a.kind != SessionKind::practice) continue;
    const auto here = is_assigned(store, a, now_us);
    if (!here) return std::unexpected(here.error());
    if (!*here) continue;
    auto exercise = load_exercise(store, a.version);
    if (!exercise) continue;
    const auto row = std::ranges::find_if(course.rows, [&](const CourseRow& r) { return r.exercise.scenario.id == exercise->scenario.id; });
    if (row == course.rows.end()) continue;
    if (row->assignment && !row->over && !row->used_up()) continue;
    row->over = a.due_utc_us && *a.due_utc_us <= now_us;
    if (!row->over && row->exercise.version != a.version) row->exercise = std::move(*exercise);
    row->assignment = a.id;
    row->due_utc_us = a.due_utc_us;
    if (row->over) continue;  // it limits nothing
    const auto counted = store.assignments.attempts(a.id, student);
    if (!counted) return std::unexpected(counted.error());
    row->attempts_allowed = a.attempts_allowed;
    row->attempts_counted = *counted;
    row->device_classes = a.device_classes;
  }
  return {};
}

}  // namespace

Stored<Course> load_course(Store& store, const Actor& student) {
  Course course;
  auto list = load_exercises(store);
  if (!list) return std::unexpected(list.error());
  course.unreadable = std::move(list->unreadable);
  const auto standings = store.history.standings(student, student.id);
  if (!standings) return std::unexpected(standings.error());
  if (auto loaded = load_newest(course, store, student, *standings); !loaded) return std::unexpected(loaded.error());
  const auto assigned = store.assignments.for_student(student.id);
  if (!assigned) return std::unexpected(assigned.error());
  for (Exercise& exercise : list->exercises) {
    CourseRow row;
    row.exercise = std::move(exercise);
    for (const ExerciseStanding& s : *standings) {
      if (s.scenario != row.exercise.scenario.id) continue;
      row.attempts = s.attempts;
      row.best = s.best;
      row.last = s.last;
      row.passed = s.passed;
    }
    course.rows.push_back(std::move(row));
  }
  if (auto added = add_assignments(course, store, student.id, *assigned); !added) return std::unexpected(added.error());
  return course;
}

std::optional<Exercise> exercise_to_drill(Store& store, const Actor& student, ScenarioId exercise) {
  auto course = load_course(store, student);
  if (!course) return std::nullopt;
  const auto row = std::ranges::find(course->rows, exercise, [](const CourseRow& r) { return r.exercise.scenario.id; });
  return row == course->rows.end() ? std::nullopt : std::optional(std::move(row->exercise));
}

QString uncounted_text(const CourseRow& row, const std::string& device_class) {
  if (row.over) return row.passed ? QString() : CourseModel::tr("The time for its assignment is over: a further attempt is kept, but does not count.");
  if (row.used_up()) return CourseModel::tr("Every attempt that counts is used: a further one is kept, but does not count.");
  if (storage::admits(row.device_classes, device_class)) return {};
  return CourseModel::tr("Counts only with %1: ask the staff to choose it on the page Device.").arg(device_names(row.device_classes));
}

CourseModel::CourseModel(std::vector<CourseRow> rows, QObject* parent)
    : QAbstractTableModel(parent), rows_(std::move(rows)) {
  std::vector<double> best;
  for (const CourseRow& row : rows_)
    if (row.best && row.best->score) best.push_back(*row.best->score);
  decimals_ = points_decimals(best);
}

int CourseModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.size()); }
int CourseModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CourseModel::data(const QModelIndex& index, int role) const {
  const CourseRow& r = row(index.row());
  if (role == Qt::TextAlignmentRole && (index.column() == kAttempts || index.column() == kBest)) return right();
  if (role == BoldRole && index.column() == kExercise) return true;
  if (role == IconRole && index.column() == kOpen) return u"chevron_right"_qs;
  if (role == QuietRole && index.column() == kBest) return !r.best;
  if (role == Qt::AccessibleTextRole && index.column() == kOpen) return tr("Briefing");
  if (role == StandingRole) return standing_text(r);
  if (role == LevelTextRole) return level_and_time_text(r.exercise.scenario);
  if (role == PassedRole) return r.passed;
  if (role == FdiRole) return r.exercise.scenario.specimen.grown_fdi();
  if (role == LevelRole) return level_rank(r.exercise.scenario);
  if (role == Qt::AccessibleDescriptionRole) return description_of(r);
  if (role == StandingKindRole) return static_cast<int>(standing_kind(r));
  if (role == GroupRole) return static_cast<int>(group_of(r.exercise.scenario));
  if (role == SortRole) {
    switch (index.column()) {
      case kDue: return static_cast<qlonglong>(r.due_utc_us.value_or(std::numeric_limits<qlonglong>::max()));
      case kAttempts: return r.attempts;
      case kBest: return r.best && r.best->score ? *r.best->score : -1.0;
      default: return data(index, Qt::DisplayRole).toString();
    }
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kExercise: return local(r.exercise.scenario.title);
    case kKind: return kind_of(r.exercise.scenario.specimen);
    case kDue: return r.due_utc_us ? format_day_time(local_time(*r.due_utc_us)) : tr("always open");
    case kAttempts:
      return r.attempts_allowed ? tr("%1 of %2").arg(r.attempts_counted).arg(*r.attempts_allowed) : format_number(r.attempts, 0);
    case kBest: return r.best && r.best->score ? format_points_to(*r.best->score, decimals_) : tr("none yet");
    default: return {};
  }
}

QVariant CourseModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && (section == kAttempts || section == kBest)) return right();
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kExercise: return tr("Exercise");
    case kKind: return tr("Kind");
    case kDue: return tr("Due");
    case kAttempts: return tr("Attempts");
    case kBest: return tr("Best");
    default: return QString();
  }
}

QString result_text(const HistoryRow& row) {
  if (!row.released && row.state == SessionState::finished) return AttemptsModel::tr("Not released");
  if (row.passed) return *row.passed ? AttemptsModel::tr("Passed") : AttemptsModel::tr("Not passed");
  return state_name(row.state);
}
int result_chip(const HistoryRow& row) {
  if (row.passed) return static_cast<int>(*row.passed ? Chip::Kind::good : Chip::Kind::bad);
  return static_cast<int>(row.state == SessionState::interrupted ? Chip::Kind::look : Chip::Kind::plain);
}

int AttemptsModel::decimals_of_rows() const {
  std::vector<double> scores;
  for (const HistoryRow& row : rows_)
    if (row.score) scores.push_back(*row.score);
  return points_decimals(scores);
}

void AttemptsModel::set_rows(std::vector<HistoryRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  decimals_ = decimals_of_rows();
  after_.reset();
  failed_ = false;
  endResetModel();
}
void AttemptsModel::set_pages(HistoryPage first, Fetch fetch) {
  beginResetModel();
  rows_ = std::move(first.rows);
  decimals_ = decimals_of_rows();
  after_ = first.after;
  failed_ = false;
  fetch_ = std::move(fetch);
  endResetModel();
}
bool AttemptsModel::canFetchMore(const QModelIndex& parent) const { return !parent.isValid() && after_ && !failed_; }
void AttemptsModel::fetchMore(const QModelIndex& parent) {
  if (!canFetchMore(parent)) return;
  auto page = fetch_(*after_);
  failed_ = !page;
  if (!page) return;
  after_ = page->after;
  if (page->rows.empty()) return;
  beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(page->rows.size()) - 1);
  std::ranges::move(page->rows, std::back_inserter(rows_));
  endInsertRows();
  const int before = std::exchange(decimals_, decimals_of_rows());
  if (decimals_ != before) Q_EMIT dataChanged(index(0, kScore), index(rowCount() - 1, kScore));
}
void AttemptsModel::fetch_again() {
  failed_ = false;
  fetchMore();
}
int AttemptsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.size()); }
int AttemptsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

namespace {

/// Sign and name of the way into an attempt. One that runs has none; an interrupted assessment has no report for its student.
QVariant opening_of(const HistoryRow& row, int role) {
  if (row.state == SessionState::running) return {};
  if (role == IconRole) return u"chevron_right"_qs;
  return row.state == SessionState::interrupted && !row.released ? AttemptsModel::tr("Open") : AttemptsModel::tr("Report");
}

}  // namespace

QVariant AttemptsModel::data(const QModelIndex& index, int role) const {
  const HistoryRow& r = row(index.row());
  const int column = index.column();
  if (role == Qt::TextAlignmentRole && (column == kAttempt || column == kScore || column == kTime)) return right();
  if (role == ChipRole && column == kResult) return result_chip(r);
  if (role == BoldRole && (column == kStudent || column == kScore)) return true;
  if (column == kOpen && (role == IconRole || role == Qt::AccessibleTextRole)) return opening_of(r, role);
  if (role == QuietRole && column == kScore) return !r.score;
  if (role == SortRole) {
    switch (column) {
      case kDate: return static_cast<qlonglong>(r.started_utc_us);
      case kAttempt: return r.attempt;
      case kScore: return r.score.value_or(-1);
      case kTime: return static_cast<qulonglong>(r.elapsed_us);
      default: return data(index, Qt::DisplayRole);
    }
  }
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kDate: return format_day_time(local_time(r.started_utc_us));
    case kStudent: return QString::fromStdString(r.student_name);
    case kExercise: return local(r.title);
    case kAttempt: return format_number(r.attempt, 0);
    case kScore: return r.score ? format_points_to(*r.score, decimals_) : QStringLiteral("–");
    case kResult: return result_text(r);
    case kTime: return format_clock(static_cast<double>(r.elapsed_us) * 1e-6);
    case kDevice: return device_name(r.device_class);
    default: return {};
  }
}

QVariant AttemptsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && (section == kAttempt || section == kScore || section == kTime)) return right();
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kDate: return tr("Date");
    case kStudent: return tr("Student");
    case kExercise: return tr("Exercise");
    case kAttempt: return tr("Attempt");
    case kScore: return tr("Points");
    case kResult: return tr("Result");
    case kTime: return tr("Time");
    case kDevice: return tr("Device");
    default: return QString();
  }
}

}  // namespace cusp::ui
