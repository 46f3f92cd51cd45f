/// The student's start page: interrupted attempt, next exercise, list of exercises, last result with advice, time against score.
/// All from the records; empty parts give the cause. Thread: GUI.
#pragma once

#include <QWidget>
#include <string>

#include "ui/student/assessments.h"
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
  /// `device_class`: of this station's device. `volumes`: where exercise_folder() unpacks imported specimens.
  StartPage(Store& store, const Account& account, ThumbnailCache& pictures, const QDateTime& now,
            std::string device_class = "pointer", std::filesystem::path volumes = {}, QWidget* parent = nullptr);
  QPushButton* start_button() const { return start_; }
  /// The first card of an interrupted attempt; nullptr without one.
  InterruptedCard* interrupted() const { return interrupted_; }
  Table* table() const { return table_; }
  /// Whoever shows the page asks now and then: the page's own timer stands still while the computer sleeps.
  void look_at_clock(const QDateTime& now);

 Q_SIGNALS:
  void assessment_wanted(const AssignedAssessment& assessment);
  /// One that opened later than the page was made opens now, or what could not be read is tried again: a page made anew shows it.
  void assessment_opened();
  void start_wanted(const Exercise& exercise);
  void briefing_wanted(const Exercise& exercise);
  void report_wanted(const SessionId& session);
  void exercises_wanted();
  void resume_wanted(const SessionId& session);
  void grade_wanted(const SessionId& session);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_main(const Account& account);
  void make_assessments(QBoxLayout& column, const Account& account);
  void wait_for_opening(const QDateTime& now);
  void note_opened();
  /// An assessment can be started now.
  bool assessed() const {
    return std::ranges::any_of(assessments_, [](const auto& a) { return a.state == AssignedAssessment::State::open; });
  }
  QWidget* make_side(const Account& account);
  void make_interrupted(QBoxLayout& column);
  QWidget* make_next(const CourseRow& row);
  /// Why it cannot be practised now, and that its assignment does not admit this station's device.
  void add_notes(class QVBoxLayout& text, const CourseRow& row);
  QWidget* make_list();
  QWidget* make_last(const Account& account);
  /// What to do next time, or why nothing stands there.
  void add_advice(Card& card, const HistoryRow& last, const Account& account);
  QWidget* make_chart();
  /// The newest comment of an instructor; nullptr without one.
  void add_comment(QBoxLayout& column, const Account& account);
  void show_picture();

  Store& store_;
  ThumbnailCache& pictures_;
  std::string device_class_;
  std::filesystem::path volumes_;
  Course course_;
  std::vector<AssignedAssessment> assessments_;
  std::optional<std::int64_t> opens_ms_;  // of the first one that opens later, since 1970; nullopt: none, or assessment_opened() was emitted
  InterruptedCard* interrupted_ = nullptr;
  std::optional<CourseRow> next_;
  QString refusal_;  // why next_ cannot be practised now; empty: it can
  QBoxLayout* columns_ = nullptr;
  QWidget* side_ = nullptr;
  QLabel* picture_ = nullptr;
  QPushButton* start_ = nullptr;
  Table* table_ = nullptr;
};

}  // namespace cusp::ui
