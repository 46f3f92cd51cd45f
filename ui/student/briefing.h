/// Briefing of one exercise: task, burs, criteria and Start. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/student/course.h"
#include "ui/student/thumbnail_cache.h"
#include "ui/view/tooth_ahead.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace cusp::ui {

class Briefing : public QWidget {
  Q_OBJECT

 public:
  /// While it stands, the tooth is made ahead for Start. `teeth` null: it is not. `refusal`: why neither Start nor the reference is offered;
  /// empty: they are.
  Briefing(const Exercise& exercise, ThumbnailCache& pictures, const std::filesystem::path& folder,
           std::shared_ptr<ToothCache> teeth, const QString& refusal = {}, QWidget* parent = nullptr);
  QPushButton* start_button() const { return start_; }
  const Exercise& exercise() const { return exercise_; }
  /// uncounted_text(); empty: a further attempt counts.
  void show_uncounted(const QString& text);
  /// nullptr where the reference cannot be shown: no path, no pictures, no teeth made ahead, or a refusal.
  QPushButton* watch_button() const { return watch_; }

 Q_SIGNALS:
  void start_wanted(const Exercise& exercise);
  void back_wanted();
  /// The reference lies over the briefing, with a view of its own.
  void reference_opened(QWidget* page);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_briefing();
  QWidget* make_bar();
  void watch_reference();
  void fill_text(QVBoxLayout& text);
  void add_facts(QVBoxLayout& text);
  QWidget* make_points();
  QWidget* make_keys();
  void show_picture();
  Exercise exercise_;
  ThumbnailCache& pictures_;
  std::filesystem::path folder_;
  QString refusal_;
  std::shared_ptr<ToothCache> teeth_;
  std::optional<ToothAhead> ahead_;
  QStackedWidget* stack_;  // the briefing, and the reference over it
  QLabel *picture_, *uncounted_;
  QPushButton *back_, *start_;
  QPushButton* watch_ = nullptr;
};

/// "2 (1.0 mm), 330 (0.8 mm)": the burs of an exercise.
QString burs_text(const Scenario& scenario);

/// What limits an attempt: bold, in `look`, wrapped.
QLabel* make_limit_note(const QString& text);

/// Fills the label with the picture, with round corners; without a picture, with the colour behind the tooth.
void show_covering(QLabel* label, const QImage& image, double radius);

}  // namespace cusp::ui
