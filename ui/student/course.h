/// A student's standing: each exercise with its attempts, best and last result, and which one is next. Models over it feed
/// tables; no widget here.
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <optional>
#include <vector>

#include "ui/student/exercises.h"

namespace cusp::ui {

struct CourseRow {
  Exercise exercise;
  int attempts = 0;
  std::optional<HistoryRow> best, last;
  bool passed = false;  // in any attempt, also with fewer points than the best
  std::optional<std::int64_t> due_utc_us;
  bool over = false;  // due_utc_us is past: no further attempt counts
  std::optional<int> attempts_allowed;  // while it is not over
  int attempts_counted = 0;  // of those allowed
  std::optional<AssignmentId> assignment;
  std::vector<std::string> device_classes;  // that the assignment admits; none = every one

  bool used_up() const { return attempts_allowed && attempts_counted >= *attempts_allowed; }
  /// It has a due date, and a further attempt counts.
  bool due() const { return due_utc_us && !over && !used_up(); }
};

struct Course {
  std::vector<CourseRow> rows;
  std::vector<StorageFailure> unreadable;
  std::optional<HistoryRow> last_graded;    // the newest graded attempt
  /// Interrupted attempts that can be resumed or graded here: every assessment, newest first, then the newest practice.
  std::vector<HistoryRow> interrupted;
  std::vector<HistoryRow> charted;          // graded attempts at the exercise and with the device class of last_graded, newest first

  /// Index of the next exercise: not passed before passed, then by due date where an attempt still counts, then by the lowest best score;
  /// -1 without exercises.
  int next() const;
};

Stored<Course> load_course(Store& store, const Actor& student);

/// In the version in which the student's attempts count: the one that is assigned and open, else the newest. Nullopt: none can be read.
std::optional<Exercise> exercise_to_drill(Store& store, const Actor& student, ScenarioId exercise);

/// Why a further attempt would not count for the assignment, and what helps; empty: it counts, nothing is assigned, or the exercise is passed
/// and its assignment over. `device_class`: of this station's device.
QString uncounted_text(const CourseRow& row, const std::string& device_class);

class CourseModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kExercise, kKind, kDue, kAttempts, kBest, kOpen, kColumns };
  /// Of a card: its standing as text, int(Chip::Kind) for it, int(ExerciseGroup), level and expected time as text, int(Level) with
  /// unstated ones last, bool passed, FDI number of its tooth or 0.
  enum Role { StandingRole = Qt::UserRole + 100, StandingKindRole, GroupRole, LevelTextRole, LevelRole, PassedRole, FdiRole };
  explicit CourseModel(std::vector<CourseRow> rows, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const CourseRow& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<CourseRow> rows_;
  int decimals_ = 0;  // of the column kBest
};

inline constexpr int kAttemptsAtOnce = 100;  // rows that a table of attempts fetches at once: several screens

/// Attempts of one or of all students: the newest first, fetched page by page as one scrolls.
class AttemptsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kDate, kStudent, kExercise, kAttempt, kScore, kResult, kTime, kDevice, kOpen, kColumns };
  explicit AttemptsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  /// Reads the page after a key; nullopt if that failed: no further page is then asked for before fetch_again().
  using Fetch = std::function<std::optional<HistoryPage>(const HistoryKey& after)>;
  void set_rows(std::vector<HistoryRow> rows);
  void set_pages(HistoryPage first, Fetch fetch);
  bool canFetchMore(const QModelIndex& parent = {}) const override;
  void fetchMore(const QModelIndex& parent = {}) override;
  /// The newest page could not be read: rows are missing after the last one.
  bool failed() const { return failed_; }
  /// Asks for the page that failed.
  void fetch_again();
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const HistoryRow& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  const std::vector<HistoryRow>& rows() const { return rows_; }

 private:
  int decimals_of_rows() const;
  std::vector<HistoryRow> rows_;
  int decimals_ = 0;                 // of the column kScore
  std::optional<HistoryKey> after_;  // none: all rows are here
  bool failed_ = false;
  Fetch fetch_;
};

/// "Passed", "Not passed", "Not released", "Interrupted" or "Not graded"; and int(Chip::Kind) for the table.
QString result_text(const HistoryRow& row);
int result_chip(const HistoryRow& row);

}  // namespace cusp::ui
