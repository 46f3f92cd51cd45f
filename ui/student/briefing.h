/// Briefing of one exercise: what to do, with what, what earns points, and Start.
#pragma once

#include <QWidget>

#include "ui/student/course.h"
#include "ui/student/thumbnail_cache.h"

class QLabel;
class QPushButton;

namespace cusp::ui {

class Briefing : public QWidget {
  Q_OBJECT

 public:
  Briefing(const Exercise& exercise, ThumbnailCache& pictures, const std::filesystem::path& folder,
           QWidget* parent = nullptr);
  QPushButton* start_button() const { return start_; }

 Q_SIGNALS:
  void start_wanted(const Exercise& exercise);
  void back_wanted();

 private:
  void show_picture();
  Exercise exercise_;
  ThumbnailCache& pictures_;
  std::filesystem::path folder_;
  QLabel* picture_;
  QPushButton* start_;
};

/// "2 (1.0 mm), 330 (0.8 mm)": the burs that an exercise lends.
QString burs_text(const Scenario& scenario);

/// A label that shows a picture with round corners, filling its size.
void show_covering(QLabel* label, const QImage& image, double radius);

}  // namespace cusp::ui
