/// One's own attempts: chart and table, by exercise. Enter opens the report. The table fetches a page at a time.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/student/course.h"
#include "ui/widgets/rereads.h"

class QBoxLayout;
class QComboBox;
class QLabel;

namespace cusp::ui {

class Band;
class Chart;
class EmptyState;
class PageHead;
class Table;

class OwnHistory : public QWidget, public Rereads {
  Q_OBJECT

 public:
  OwnHistory(Store& store, const Actor& student, QWidget* parent = nullptr);
  bool read_again() override;
  Table* table() const { return table_; }
  QComboBox* exercise() const { return exercise_; }

 Q_SIGNALS:
  void report_wanted(const SessionId& session);
  void exercises_wanted();

 private:
  void fill();
  void show_instead(EmptyState* state);
  void make_choice(std::vector<PractisedScenario> scenarios);
  void offer(std::vector<PractisedScenario> scenarios);
  QBoxLayout* make_charts();
  void make_table();
  void show_attempts();
  Stored<std::optional<HistoryRow>> newest_in(const HistoryPage& first);
  /// Of the newest result; nullopt: no result yet.
  Stored<void> draw(const std::optional<HistoryRow>& newest);
  void hide_charts();
  void show_unread(const QString& what, const StorageFailure& why);
  void read_unread();
  HistoryFilter filter() const;
  Store& store_;
  Actor student_;
  PageHead* head_ = nullptr;
  EmptyState* instead_ = nullptr;  // of all below the head
  AttemptsModel* model_ = nullptr;
  Table* table_ = nullptr;
  QComboBox* exercise_ = nullptr;
  Band* unread_ = nullptr;  // shows what could not be read, rows or charts
  QLabel* charted_ = nullptr;  // the device of the charts, and their exercise while the table lists all; empty: they could not be read
  Chart *by_attempt_ = nullptr, *by_time_ = nullptr;
  Chart* by_rating_ = nullptr;  // its card shows with an attempt that was rated
  std::vector<SessionId> drawn_, rated_;  // whose the points of the first two are, and of the last one
};

}  // namespace cusp::ui
