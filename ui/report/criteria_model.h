/// The criteria of a report as a table: value, band of full points, points. No widget.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/grading/grade.h"
#include "scenarios/grading/maxima.h"
#include "storage/records/self_assessment.h"
#include "ui/modules.h"
#include "ui/text/names.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/table.h"

namespace cusp::ui {

/// Points of one criterion that an examiner changed.
struct PointsChange {
  std::string criterion;  // its id
  QString text;           // who, from what to what, and the reason
};

class CriteriaModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kSign, kName, kMeasured, kWanted, kPoints, kOwn, kPlace, kColumns };
  CriteriaModel(const Grade& grade, const Scenario& scenario, std::vector<PointsChange> changes = {}, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Beside the points; a table without one hides the column kOwn.
  void set_own(std::optional<SelfAssessment> own) { own_ = std::move(own); }
  /// The names that the tooth's volume gives its tissues.
  void set_tissue_names(TissueNames names) { tissue_names_ = std::move(names); }
  /// A narrow table has neither bars nor ±. The card of the chosen row still gives the ±.
  enum class Detail { whole, narrow };
  void set_detail(Detail detail);
  const CriterionGrade& criterion(int row) const { return grade_.criteria[static_cast<std::size_t>(row)]; }
  /// What an examiner changed in the row; empty: nothing.
  QString change(int row) const;
  Bar::Role bar_role(int row) const;
  /// Scaled for the screen: their maxima sum to the grade's.
  const ScaledPoints& points(int row) const { return points_[static_cast<std::size_t>(row)]; }

 private:
  /// No points were lost here, or none could be: the table shows a dash.
  bool neutral(int row) const;
  QString text_of(const QModelIndex& index) const;
  /// "/ 33.3", as wide as the widest of its column: the decimal signs of the points before it stand below each other.
  QString most_text(int row) const;
  std::optional<OwnRating> own_rating(int row) const;
  QVariant own_data(int row, int role) const;
  /// How it compares with what was measured; empty if nothing was measured or marked.
  QString own_against_measured(int row) const;
  Grade grade_;
  std::vector<ScaledPoints> points_;
  int decimals_ = 0, most_decimals_ = 0;  // of the column's points, and of what they are out of
  qsizetype most_size_ = 0;               // characters of the widest of the latter
  Rubric rubric_;
  Region target_;  // of the exercise: titles of several targets
  TissueNames tissue_names_;
  std::vector<PointsChange> changes_;
  std::optional<SelfAssessment> own_;
  Detail detail_ = Detail::whole;
};

}  // namespace cusp::ui
