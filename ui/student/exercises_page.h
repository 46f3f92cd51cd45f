/// All exercises as cards with the student's best result, by group with what is passed of it; search, filter; Enter opens the briefing. Thread: GUI.
#pragma once

#include <QSortFilterProxyModel>
#include <QWidget>
#include <filesystem>
#include <map>
#include <vector>

#include "ui/student/course.h"
#include "ui/student/exercise_groups.h"
#include "ui/student/thumbnail_cache.h"
#include "ui/widgets/rereads.h"

class QComboBox;
class QLineEdit;
class QStackedWidget;

namespace cusp::ui {

class ExerciseCards;

class ExercisesPage : public QWidget, public Rereads {
  Q_OBJECT

 public:
  /// `volumes`: where files of exercises are written.
  ExercisesPage(Store& store, const Actor& actor, ThumbnailCache& pictures, std::filesystem::path volumes, QWidget* parent = nullptr);
  /// The card that was opened is the current one again.
  bool read_again() override;
  /// The cards of a group; nullptr if it has no exercise.
  ExerciseCards* cards(ExerciseGroup group) const;
  QLineEdit* search() const { return search_; }
  /// Which standing is shown: all, not passed yet, passed.
  QComboBox* standing() const { return standing_; }

 Q_SIGNALS:
  void briefing_wanted(const Exercise& exercise);
  /// Nothing could be read: the page is to be made anew.
  void again_wanted();

 private:
  struct Section {
    ExerciseGroup group;
    QWidget* box;
    QSortFilterProxyModel* shown;
    ExerciseCards* cards;
  };
  void make_section(ExerciseGroup group, QWidget& body);
  QWidget* make_shown(const Course& course);
  void make_search();
  void filter();
  QImage picture_of(const QSortFilterProxyModel& shown, const QModelIndex& index);
  void open(const QSortFilterProxyModel& shown, const QModelIndex& index);

  Store& store_;
  Actor actor_;
  ThumbnailCache& pictures_;
  std::filesystem::path volumes_;
  CourseModel* model_ = nullptr;
  std::vector<Section> sections_;
  ScenarioId opened_;  // last; nil: none was
  std::map<int, QImage> drawn_;  // by row of the course: a card is painted often
  QStackedWidget* shown_ = nullptr;  // the sections, or that nothing fits
  QLineEdit* search_ = nullptr;
  QComboBox* standing_ = nullptr;
};

}  // namespace cusp::ui
