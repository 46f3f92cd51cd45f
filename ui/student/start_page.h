/// What a student sees first: an attempt that broke off, the next exercise, the list, the last result with what to do next time, and time against
/// score. Everything from the records; where nothing is yet it says so.
#pragma once

#include <QWidget>
#include <string>

#include "ui/student/course.h"
#include "ui/student/thumbnail_cache.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace cusp::ui {

class Card;
class InterruptedCard;
class Table;

class StartPage : public QWidget {
  Q_OBJECT

 public:
  /// `device_class`: of the device that this station drills with.
  StartPage(Store& store, const Account& account, ThumbnailCache& pictures, const QDateTime& now,
            std::string device_class = "pointer", QWidget* parent = nullptr);
  QPushButton* start_button() const { return start_; }
  /// nullptr without an attempt that broke off.
  InterruptedCard* interrupted() const { return interrupted_; }
  Table* table() const { return table_; }

 Q_SIGNALS:
  void start_wanted(const Exercise& exercise);
  void briefing_wanted(const Exercise& exercise);
  void report_wanted(const SessionId& session);
  void exercises_wanted();
  void resume_wanted(const SessionId& session);
  void grade_wanted(const SessionId& session);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_interrupted(QBoxLayout& column);
  QWidget* make_next(const CourseRow& row);
  QWidget* make_list();
  QWidget* make_last(const Account& account);
  /// Returns false where there is nothing to do better.
  bool add_advice(Card& card, const HistoryRow& last, const Account& account);
  QWidget* make_chart();
  QWidget* make_word(const Account& account);
  void show_picture();

  Store& store_;
  ThumbnailCache& pictures_;
  std::string device_class_;
  Course course_;
  InterruptedCard* interrupted_ = nullptr;
  std::optional<CourseRow> next_;
  QBoxLayout* columns_ = nullptr;
  QWidget* side_ = nullptr;
  QLabel* picture_ = nullptr;
  QPushButton* start_ = nullptr;
  Table* table_ = nullptr;
};

}  // namespace cusp::ui
