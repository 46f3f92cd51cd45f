/// A cohort's students and its assignments as tables. No widget.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "storage/repositories/accounts.h"
#include "storage/repositories/assignments.h"
#include "storage/repositories/cohorts.h"
#include "ui/modules.h"

namespace cusp::ui {

class CohortsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kStudents, kColumns };
  explicit CohortsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_cohorts(std::vector<Cohort> cohorts);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const Cohort& cohort(int row) const { return cohorts_[static_cast<std::size_t>(row)]; }
  int row_of(CohortId id) const;

 private:
  std::vector<Cohort> cohorts_;
};

class CohortStudentsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kNumber, kColumns };
  explicit CohortStudentsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_students(std::vector<Account> students);  // sorts by name
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const Account& student(int row) const { return students_[static_cast<std::size_t>(row)]; }

 private:
  std::vector<Account> students_;
};

struct AssignmentRow {
  Assignment assignment;
  LocalText title;  // of the exercise
};

class AssignmentsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kExercise, kKind, kOpens, kDue, kAttempts, kColumns };
  explicit AssignmentsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_rows(std::vector<AssignmentRow> rows);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const AssignmentRow& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  /// Nil of row -1.
  AssignmentId id_at(int i) const { return i < 0 ? AssignmentId{} : row(i).assignment.id; }
  int row_of(AssignmentId id) const;

 private:
  std::vector<AssignmentRow> rows_;
};

}  // namespace cusp::ui
