/// What an import must be told of a file: what each mesh, label or range of grey is made of.
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

/// A list of tissues with their codes as data, `none` (0) first.
QComboBox* make_tissue_box(const QString& none, const QString& name);

/// The meshes of a file: size, whether they are closed and where not, and what they are made of.
class MeshForm : public QWidget {
  Q_OBJECT

 public:
  MeshForm(std::vector<MeshInfo> meshes, QWidget* parent = nullptr);
  /// Lengths are told in millimetres by this.
  void set_unit_mm(double unit_mm);
  std::vector<std::pair<std::string, Tissue>> chosen() const;
  /// The box of what is chosen, of all when nothing is; in the file's units.
  Vec3 size() const;
  /// Width up to which holes are closed; none: nothing is mended.
  std::optional<double> mend_mm() const;
  PartPrecedence precedence() const;

 Q_SIGNALS:
  void changed();

 private:
  struct Row {
    MeshInfo info;
    QLabel *size, *state;
    QComboBox* tissue;
  };
  void add_precedence(QVBoxLayout& column);
  void describe();

  double unit_mm_ = 1.0;
  std::vector<Row> rows_;
  QCheckBox* mend_ = nullptr;
  QComboBox* precedence_ = nullptr;  // of several meshes
  NumberField* width_ = nullptr;
};

/// A volume: its labels, colours or ranges of grey, and a slice that shows what they become.
class VolumeForm : public QWidget {
  Q_OBJECT

 public:
  VolumeForm(const ImageInfo& info, std::shared_ptr<const ImagePreview> preview, QWidget* parent = nullptr);
  /// Labels or thresholds, and the two choices; not the unit and the fineness.
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
