/// Forms of an import: the tissue of each mesh, label or range of grey. Thread: GUI.
#pragma once

#include <QWidget>
#include <vector>

#include "scenarios/import/import.h"
#include "ui/modules.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace cusp::ui {

class NumberField;
class SliceView;

/// A box of tissues with their codes as data; `none` has the code 0 and comes first.
QComboBox* make_tissue_box(const QString& none, const QString& name);

/// The meshes of a file: size, gaps and tissue.
class MeshForm : public QWidget {
  Q_OBJECT

 public:
  MeshForm(std::vector<MeshInfo> meshes, QWidget* parent = nullptr);
  /// Millimetres in one unit of the file, for the lengths shown.
  void set_unit_mm(double unit_mm);
  /// Takes what was chosen in `before`, whose meshes are the first of these.
  void take_choices(const MeshForm& before);
  std::vector<std::pair<std::string, Tissue>> chosen() const;
  /// Size of the bounding box of the chosen meshes, or of all if none is chosen. Units: of the file.
  Vec3 size() const;
  /// Likewise of all meshes.
  Vec3 whole_size() const;
  /// Widest hole that is closed; nullopt without mending.
  std::optional<double> mend_mm() const;
  PartPrecedence precedence() const;

 Q_SIGNALS:
  void changed();

 private:
  struct Row {
    MeshInfo info;
    QLabel *size, *state;
    QComboBox* tissue;
    int likely;           // code of the tissue that its name says; 0: none
    int wanted;           // code that stands while it is usable
    bool usable = false;  // closed, or mended
  };
  void add_mending(QVBoxLayout& column);
  void add_precedence(QVBoxLayout& column);
  void show_states();
  Vec3 size_of(bool chosen_alone) const;

  double unit_mm_ = 1.0;
  std::vector<Row> rows_;
  QCheckBox* mend_ = nullptr;
  QComboBox* precedence_ = nullptr;  // nullptr with one mesh
  NumberField* width_ = nullptr;
};

/// A volume: tissues of its labels, colours or ranges of grey, and a slice with the tissues in colour.
class VolumeForm : public QWidget {
  Q_OBJECT

 public:
  VolumeForm(const ImageInfo& info, std::shared_ptr<const ImagePreview> preview, QWidget* parent = nullptr);
  /// Labels or thresholds and the two options, without unit and voxel size.
  ImageTissues tissues() const;
  bool ready() const;
  SliceView* view() const { return view_; }

 Q_SIGNALS:
  void changed();

 private:
  QWidget* make_labels();
  QWidget* make_ranges(const ImagePreview& preview);
  void show_tissues();

  struct Label {
    std::uint32_t value;
    QComboBox* tissue;
  };
  struct Range {
    QComboBox* tissue;
    NumberField* from;
  };
  ImageInfo info_;
  std::vector<Label> labels_;
  std::vector<Range> ranges_;
  QCheckBox *hollows_ = nullptr, *largest_ = nullptr;
  SliceView* view_ = nullptr;
};

}  // namespace cusp::ui
