/// One's own attempts: chart and table, by exercise. Enter opens the report. The table fetches a page at a time.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/student/course.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/rereads.h"

class QBoxLayout;
class QComboBox;
class QLabel;

namespace cusp::ui {

class Band;
class Chart;
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
  void make_choice(std::vector<PractisedScenario> scenarios);
  void offer(std::vector<PractisedScenario> scenarios);
  QBoxLayout* make_charts();
  void make_table();
  void show_attempts();
  void draw(const std::optional<HistoryRow>& newest);
  void show_failure(const Message& message);
  HistoryFilter filter() const;
  Store& store_;
  Actor student_;
  AttemptsModel* model_ = nullptr;
  Table* table_ = nullptr;
  QComboBox* exercise_ = nullptr;
  Band* unread_ = nullptr;  // shows after a further page that could not be read
  QLabel* charted_ = nullptr;  // the device of the charts, and their exercise while the table lists all
  Chart *by_attempt_ = nullptr, *by_time_ = nullptr;
  Chart* by_rating_ = nullptr;  // its card shows with an attempt that was rated
};

}  // namespace cusp::ui
