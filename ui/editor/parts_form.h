/// The shapes of which the target is made: a list in which one is chosen, added or removed, and the numbers of a shape that is no
/// outline. Thread: GUI.
#pragma once

#include <QWidget>
#include <functional>
#include <string_view>
#include <vector>

#include "ui/editor/editor_model.h"
#include "ui/text/names.h"

class QComboBox;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class PartsForm : public QWidget {
  Q_OBJECT

 public:
  explicit PartsForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  /// Rows that stand only where `of` holds.
  struct Group {
    QWidget* box;
    std::function<bool(const Region&)> of;
  };
  /// A number of the chosen part.
  struct Number {
    NumberBox* box;
    std::function<double(Region&)> of;
  };
  void make_list(QVBoxLayout* column);
  void make_numbers(QVBoxLayout* column);
  QVBoxLayout* add_group(QVBoxLayout* column, const QString& title, std::function<bool(const Region&)> of);
  /// `range`: the place of a number in a document, of scenarios/format/ranges.h.
  void add_number(QVBoxLayout* group, const QString& name, std::string_view range, std::function<double&(Region&)> in);
  void add_point(QVBoxLayout* group, const QString& title, std::string_view range, std::function<Vec3&(Region&)> in);
  /// Of a node: the middle of its leaves, which moves them.
  void add_middle(QVBoxLayout* group, const QString& title);
  void add_box(QVBoxLayout* group, const QString& name, std::string_view range, std::function<double(Region&)> of, std::function<bool(double)> take);
  void follow_model();
  void show_list();

  EditorModel& model_;
  QTreeWidget* list_ = nullptr;
  QPushButton *add_ = nullptr, *remove_ = nullptr;
  QComboBox* joined_ = nullptr;
  std::vector<Group> groups_;
  std::vector<Number> numbers_;
};

/// "Box, gingival floor", "Cuboid", "Union". `own`: the specimen's names of its tissues.
QString part_name(const Region& part, const TissueNames& own);

}  // namespace cusp::ui
