/// All exercises with one's own standing; Enter opens the briefing.
#pragma once

#include <QWidget>

#include "ui/student/course.h"

namespace cusp {

class Table;

class ExercisesPage : public QWidget {
  Q_OBJECT

 public:
  ExercisesPage(Store& store, const Actor& actor, QWidget* parent = nullptr);
  Table* table() const { return table_; }

 Q_SIGNALS:
  void briefing_wanted(const cusp::Exercise& exercise);

 private:
  Table* table_ = nullptr;
};

}  // namespace cusp
