/// Size of an imported specimen: unit of the file, voxel size, up axis. If the length is not a tooth's, asks whether the unit is
/// right, with the likely answers as buttons. Thread: GUI.
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
  /// Settings of a new file.
  struct FileSize {
    enum class Unit { unknown, stated } unit = Unit::unknown;  // an unknown one is asked for
    double unit_mm = 1.0;                                      // first choice
    std::optional<double> voxel_mm{};                          // nullopt for meshes
  };
  void begin(const FileSize& file);
  /// Whether unit or size was chosen since begin().
  bool chosen() const { return chosen_; }
  /// Enables voxel size and up axis.
  void set_changeable(bool on);

  /// Millimetres in one unit of the file, times the factor of the answer.
  double unit_mm() const;
  double voxel_mm() const;
  UpAxis up() const;

  /// Shows `sentence`, and asks about a longest side that is not a tooth's until it is answered.
  void show_size(const QString& sentence, std::optional<double> longest_mm);
  /// True while a question waits for its answer.
  bool questioned() const { return questioned_; }

 Q_SIGNALS:
  /// A setting changed: the import would make another specimen.
  void changed();
  /// The length was confirmed; no setting changed.
  void confirmed();

 private:
  void ask(double longest_mm);
  /// The fineness of a volume is its own voxels in the present unit, or what was typed in it.
  void follow_unit();
  void forget_answers();
  void answer(double factor);

  bool unit_unknown_ = false, questioned_ = false, believed_ = false, chosen_ = false;
  double scale_ = 1.0;
  std::optional<double> file_voxel_;  // edge in the file's unit; nullopt for meshes
  QComboBox *unit_, *up_;
  NumberField *other_unit_, *voxel_;
  QWidget *unit_field_, *other_field_, *question_;
  QLabel *size_, *why_;
  QHBoxLayout* answers_;
};

}  // namespace cusp::ui
