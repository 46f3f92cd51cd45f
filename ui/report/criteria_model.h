/// The report's table: each criterion with its value, what earns full points, and its points.
#pragma once

#include <QAbstractTableModel>

#include "scenarios/grading/grade.h"
#include "scenarios/grading/maxima.h"
#include "ui/modules.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/table.h"

namespace cusp::ui {

class CriteriaModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kSign, kName, kYours, kWanted, kPoints, kPlace, kColumns };
  CriteriaModel(const Grade& grade, const Rubric& rubric, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Without bars and without ±: for a narrow table. The chosen row's card still gives the ±.
  void set_compact(bool compact);
  const CriterionGrade& criterion(int row) const { return grade_.criteria[static_cast<std::size_t>(row)]; }
  Bar::Role bar_role(int row) const;
  /// As they are shown: their maxima sum to the grade's.
  const ScaledPoints& points(int row) const { return points_[static_cast<std::size_t>(row)]; }

 private:
  /// Nothing went wrong here, or nothing could be lost: a dash stands for it.
  bool neutral(int row) const;
  Grade grade_;
  std::vector<ScaledPoints> points_;
  Rubric rubric_;
  bool compact_ = false;
};

}  // namespace cusp::ui
