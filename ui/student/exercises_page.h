/// All exercises with the student's results: search, sorting by column, Enter opens the briefing. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/student/course.h"

class QLineEdit;

namespace cusp::ui {

class Table;

class ExercisesPage : public QWidget {
  Q_OBJECT

 public:
  ExercisesPage(Store& store, const Actor& actor, QWidget* parent = nullptr);
  Table* table() const { return table_; }
  QLineEdit* search() const { return search_; }

 Q_SIGNALS:
  void briefing_wanted(const Exercise& exercise);

 private:
  Table* table_ = nullptr;
  QLineEdit* search_ = nullptr;
};

}  // namespace cusp::ui
