/// Options of a grown tooth: plastic or not, neighbours, carious lesions. Each change is an edit at once, and the tooth grows
/// again. Thread: GUI.
#pragma once

#include <QWidget>
#include <string_view>
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
  void add_figures(LesionRow& row, QVBoxLayout* column, std::size_t index);
  void fill_kinds(QComboBox& box, const LesionSource& lesion) const;
  void fill_sites(QComboBox& box, const LesionSource& lesion) const;
  void add_lesion();
  void surround_with(std::string_view key);
  void take_away(std::string_view key);
  /// An edit as one step of undo.
  void edit_at_once(const QString& field, const std::function<void(SpecimenSource&)>& change);
  /// An edit of a spin box that is being turned: merges with the last one.
  bool edit(const QString& field, const std::function<void(SpecimenSource&)>& change);

  EditorModel& model_;
  QCheckBox *plastic_, *neighbours_, *gums_, *bone_, *jaw_;
  QWidget* lesions_;
  QVBoxLayout* list_;
  QPushButton* add_;
  std::vector<LesionRow> rows_;
};

/// The carious lesions that another tooth can have too.
void keep_possible_lesions(SpecimenSource& source);

}  // namespace cusp::ui
