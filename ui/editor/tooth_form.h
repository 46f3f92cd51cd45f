/// What a grown tooth is like beyond its number: plastic or not, what stands round it, its carious lesions. Every change is an edit
/// of the exercise at once, and the tooth is grown again while one looks.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/editor/editor_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace cusp::ui {

class NumberBox;

class ToothForm : public QWidget {
  Q_OBJECT

 public:
  explicit ToothForm(EditorModel& model, QWidget* parent = nullptr);

 private:
  struct LesionRow {
    QComboBox *kind, *site;
    NumberBox *size, *depth, *softness;
    QLabel* depth_label;
  };
  void follow_model();
  LesionRow make_row(std::size_t index);
  void fill_sites(QComboBox& box, const LesionSource& lesion) const;
  void add_lesion();
  void set_around(const char* key, bool on);
  /// One step of undo of its own.
  void edit_at_once(const QString& field, const std::function<void(SpecimenSource&)>& change);
  /// A number that is still being turned.
  bool edit(const QString& field, const std::function<void(SpecimenSource&)>& change);

  EditorModel& model_;
  QCheckBox *plastic_, *neighbours_, *gums_, *bone_, *jaw_;
  QWidget* lesions_;
  QVBoxLayout* list_;
  QPushButton* add_;
  std::vector<LesionRow> rows_;
};

/// The sites of a tooth's lesions that still stand when it becomes another tooth.
void keep_possible_lesions(SpecimenSource& source);

}  // namespace cusp::ui
