/// The attempts of one assignment, by candidate: state, result, confirmation, release. Thread: GUI.
#pragma once

#include <QAbstractTableModel>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "storage/export/gradebook.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/widgets/half_filled.h"
#include "ui/widgets/ports.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace cusp::ui {

class Band;
class NumberField;
class Table;

/// A candidate's attempt; without `attempt` the student has begun none.
struct CandidateRow {
  UserId student;
  QString candidate{}, name{};
  Adjustment adjustment{};
  std::optional<HistoryRow> attempt{};
  std::optional<EffectiveGrade> grade{};
  bool grade_read = true;  // false: whether there is one could not be read
};

class CandidatesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kCandidate, kName, kAdjusted, kDate, kScore, kResult, kMarked, kReleased, kOpen, kColumns };
  explicit CandidatesModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void set_rows(std::vector<CandidateRow> rows);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const CandidateRow& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<CandidateRow> rows_;
};

class AssessmentPage : public QWidget, public HalfFilled {
  Q_OBJECT

 public:
  AssessmentPage(Store& store, const Actor& actor, AssignmentId assignment, const Ports& ports, QWidget* parent = nullptr);
  const CandidatesModel& model() const { return *model_; }
  Table* table() const { return table_; }
  QString message() const;
  /// An adjustment is set that is not kept yet.
  bool half_filled() const override;
  /// Of the chosen candidate, for attempts that begin afterwards. One that another desk made since the page was read stays.
  void adjust(const Adjustment& adjustment);
  /// Asks for the file of a column of results.
  void export_gradebook(Gradebook system);
  /// Releases every graded result that needs no confirmation; asks first.
  void release_all();

 Q_SIGNALS:
  void back_wanted();
  void report_wanted(const SessionId& session);

 protected:
  /// What was marked meanwhile shows.
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_bar(const QString& title);
  QPushButton* make_gradebook_button();
  QWidget* make_adjustments();
  void show_chosen();
  void show_adjustment(const CandidateRow& row);
  Adjustment set_here() const;
  /// Asks first about an adjustment that is not kept yet.
  void leave_adjustment(std::function<void()> then);
  void leave();
  Stored<void> complete(CandidateRow& row);
  void read();
  void open_chosen();
  void release_now();
  void show_failure(const StorageFailure& failure);

  Store& store_;
  Actor actor_;
  const Ports& ports_;
  Assignment assignment_;
  CandidatesModel* model_;
  Band* band_ = nullptr;
  Table* table_ = nullptr;
  QPushButton *names_ = nullptr, *release_ = nullptr;
  QCheckBox* large_ = nullptr;
  NumberField* extra_ = nullptr;
  QLabel* extra_of_ = nullptr;
  QWidget* extra_row_ = nullptr;
  struct Edited {
    UserId student;
    Adjustment adjustment;  // as the records have it
  };
  std::optional<Edited> edited_;  // whose adjustment the fields hold
};

}  // namespace cusp::ui
