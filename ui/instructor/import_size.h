/// How large an imported specimen becomes: the length of the file's unit, the edge of a voxel, which way is up; and the
/// question that a length which is no tooth's raises, with the answers beside it. Thread: GUI.
#pragma once

#include <QWidget>
#include <optional>

#include "scenarios/import/up_axis.h"
#include "ui/modules.h"

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace cusp::ui {

class NumberField;

class ImportSize : public QWidget {
  Q_OBJECT

 public:
  explicit ImportSize(QWidget* parent = nullptr);
  /// For a new file: whether it says nothing of its unit, the unit to begin with, and its own voxels where it has any.
  void begin(bool asks_unit, double unit_mm, std::optional<double> voxel_mm);
  void set_changeable(bool on);

  /// With the factor that was chosen as an answer.
  double unit_mm() const;
  double voxel_mm() const;
  UpAxis up() const;

  /// What is known of the size. A longest side that is no tooth's is questioned, until it was answered.
  void show_size(const QString& sentence, std::optional<double> longest_mm);
  /// A question waits for its answer.
  bool questioned() const { return questioned_; }

 Q_SIGNALS:
  /// The specimen would become another one.
  void changed();
  /// The length was confirmed: nothing else changed.
  void confirmed();

 private:
  void ask(double longest_mm);
  void forget_answers();
  void answer(double factor);

  bool asks_unit_ = false, own_voxels_ = false, questioned_ = false, believed_ = false;
  double scale_ = 1.0;
  QComboBox *unit_, *up_;
  NumberField *other_unit_, *voxel_;
  QWidget *unit_field_, *other_field_, *question_;
  QLabel *size_, *why_;
  QHBoxLayout* answers_;
};

}  // namespace cusp::ui
