/// Briefing of one exercise: task, burs, criteria and Start. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/student/course.h"
#include "ui/student/thumbnail_cache.h"
#include "ui/view/tooth_ahead.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class Briefing : public QWidget {
  Q_OBJECT

 public:
  /// While it stands, the tooth is made ahead for Start. `teeth` null: it is not.
  Briefing(const Exercise& exercise, ThumbnailCache& pictures, const std::filesystem::path& folder,
           std::shared_ptr<ToothCache> teeth, QWidget* parent = nullptr);
  QPushButton* start_button() const { return start_; }

 Q_SIGNALS:
  void start_wanted(const Exercise& exercise);
  void back_wanted();

 private:
  QWidget* make_bar();
  void fill_text(QVBoxLayout& text);
  void add_facts(QVBoxLayout& text);
  QWidget* make_points();
  QWidget* make_keys();
  void show_picture();
  Exercise exercise_;
  ThumbnailCache& pictures_;
  std::filesystem::path folder_;
  std::optional<ToothAhead> ahead_;
  QLabel* picture_;
  QPushButton* start_;
};

/// "2 (1.0 mm), 330 (0.8 mm)": the burs of an exercise.
QString burs_text(const Scenario& scenario);

/// Fills the label with the picture, with round corners; without a picture, with the colour behind the tooth.
void show_covering(QLabel* label, const QImage& image, double radius);

}  // namespace cusp::ui
