/// Attempts by criterion: how often each one has its points, the hardest first. Thread: GUI.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "scenarios/format/scenario.h"
#include "storage/summary/history.h"
#include "ui/modules.h"
#include "ui/text/names.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

class Table;

class CriterionFiguresModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kShare, kFull, kAttempts, kColumns };
  using QAbstractTableModel::QAbstractTableModel;
  /// `target`: of the exercise, for the titles of several targets. `tissues`: of its specimen, for its own tissues.
  void set_rows(std::vector<CriterionFigures> rows, const Region& target, const TissueNames& tissues);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<CriterionFigures> rows_;
  Region target_;
  TissueNames tissues_;
};

class CriteriaCard : public Card {
  Q_OBJECT

 public:
  explicit CriteriaCard(QWidget* parent = nullptr);
  void show_figures(std::vector<CriterionFigures> figures, const Region& target, const TissueNames& tissues);
  const CriterionFiguresModel& model() const { return *model_; }

 private:
  CriterionFiguresModel* model_;
  Table* table_;
};

}  // namespace cusp::ui
