/// All exercises with the student's results: search, sorting by column, Enter opens the briefing. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/student/course.h"

class QLineEdit;
class QSortFilterProxyModel;
class QStackedWidget;

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
  void make_table(const Course& course);
  QWidget* make_shown();
  void make_search();
  void open(const QModelIndex& index);

  CourseModel* model_ = nullptr;
  QSortFilterProxyModel* sorted_ = nullptr;
  QStackedWidget* shown_ = nullptr;  // the table, or that nothing fits
  Table* table_ = nullptr;
  QLineEdit* search_ = nullptr;
};

}  // namespace cusp::ui
