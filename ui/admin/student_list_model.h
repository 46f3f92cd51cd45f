/// The lines of a student list with what each of them will do. No widget.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/admin/people_csv.h"

namespace cusp::ui {

class StudentListModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kLine, kState, kName, kNumber, kPin, kCohort, kColumns };
  explicit StudentListModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_students(std::vector<ListedStudent> students);
  const std::vector<ListedStudent>& students() const { return students_; }
  int count(ListedStudent::State state) const;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<ListedStudent> students_;
};

}  // namespace cusp::ui
