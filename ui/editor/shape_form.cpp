#include "ui/editor/shape_form.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <array>

#include "scenarios/format/ranges.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/parts_form.h"
#include "ui/text/names.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

// Tolerance zone of the three levels of block exercises, beginner to exam, mm.
constexpr std::array kStrictness = {0.5, 0.3, 0.2};
constexpr double kMostSizeMm = 30, kMostDepthMm = 15, kReachMm = 100;

QWidget* group(QVBoxLayout** column) {
  auto* box = new QWidget;
  *column = new QVBoxLayout(box);
  (*column)->setContentsMargins(0, 0, 0, 0);
  (*column)->setSpacing(px(6));
  return box;
}

/// "Lean, mesial wall"; by the direction where the side has no name.
QString side_name(const Region& part, std::size_t side) {
  const auto face = part.faces.find(kTaperKeys[side]);
  if (face != part.faces.end() && face->second != FaceName::side_wall) return ShapeForm::tr("Lean, %1").arg(face_name(key_of(face->second)));
  switch (side) {
    case 0: return ShapeForm::tr("Lean, back along the arch");
    case 1: return ShapeForm::tr("Lean, on along the arch");
    case 2: return ShapeForm::tr("Lean, towards lingual");
    default: return ShapeForm::tr("Lean, towards buccal");
  }
}

}  // namespace

QString shape_name(const std::string& shape) {
  if (shape == "channel") return ShapeForm::tr("Channel");
  if (shape == "outline") return ShapeForm::tr("Fissure outline");
  if (shape == "box") return ShapeForm::tr("Box");
  return QString::fromStdString(shape);
}

QString target_name(const Region& target) {
  return target.kind == RegionKind::outline ? shape_name(target.outline.shape) : ShapeForm::tr("Composed shape");
}

ShapeForm::ShapeForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(16), px(12), px(16), px(16));
  column->setSpacing(px(6));
  column->addWidget(new PartsForm(model_));
  column->addSpacing(px(8));
  title_ = make_label({}, TextRole::section, Weight::bold);
  column->addWidget(title_);
  QVBoxLayout* drawn = nullptr;
  drawn_ = group(&drawn);
  column->addWidget(drawn_);
  make_size(drawn);
  make_tapers(drawn);
  make_points(drawn);
  make_tolerances(column);
  column->addStretch();
  connect(&model_, &EditorModel::changed, this, &ShapeForm::follow_model);
  connect(&model_, &EditorModel::part_chosen, this, &ShapeForm::follow_model);
  follow_model();
}

NumberBox* ShapeForm::length(const QString& name, Range mm, std::function<bool(double)> take) {
  return new NumberBox(model_, name, u"mm"_qs, mm.least, mm.most, 0.05, 2, std::move(take));
}

void ShapeForm::make_size(QVBoxLayout* column) {
  const auto target = [this]() -> const Outline& { return model_.outline(); };
  depth_ = length(tr("Depth"), {0.05, kMostDepthMm}, [this](double v) { return model_.set_depth_mm(v); });
  add_row(column, tr("Depth"), depth_);
  QVBoxLayout* rows = nullptr;
  slot_rows_ = group(&rows);
  width_ = length(tr("Width"), {0.1, kMostSizeMm}, [this](double v) { return model_.set_width_mm(v); });
  add_row(rows, tr("Width"), width_);
  column->addWidget(slot_rows_);
  box_rows_ = group(&rows);
  length_ = length(tr("Length"), {0.1, kMostSizeMm},
                   [=, this](double v) { return model_.set_box_size_mm(v, target().box_size_mm.y); });
  box_width_ = length(tr("Width"), {0.1, kMostSizeMm},
                      [=, this](double v) { return model_.set_box_size_mm(target().box_size_mm.x, v); });
  add_row(rows, tr("Length"), length_);
  add_row(rows, tr("Width"), box_width_);
  column->addWidget(box_rows_);
  top_ = length(tr("Measured from height"), {-kReachMm, kReachMm}, [this](double v) { return model_.set_top_mm(v); });
  top_label_ = add_row(column, tr("Measured from height"), top_);
  corner_ = length(tr("Corner radius"), {0, 5}, [this](double v) { return model_.set_corner_radius_mm(v); });
  add_row(column, tr("Corner radius"), corner_);
}

void ShapeForm::make_tapers(QVBoxLayout* column) {
  for (std::size_t side = 0; side < tapers_.size(); ++side) {
    const NumberRange& deg = *range_of(std::string("/target/taper_deg/") + kTaperKeys[side]);
    auto* box = new NumberBox(model_, side_name({}, side), u"deg"_qs, deg.least, deg.most, 1, 1,
                              [this, side](double value) { return model_.set_taper_deg(side, value); });
    box->setToolTip(tr("Above 0 the wall opens upwards"));
    tapers_[side] = {box, add_row(column, side_name({}, side), box)};
  }
}

void ShapeForm::make_points(QVBoxLayout* column) {
  column->addSpacing(px(8));
  point_ = new QComboBox;
  point_->setAccessibleName(tr("Point"));
  point_->setFixedWidth(px(112));
  add_row(column, tr("Point"), point_);
  const auto path = [this] { return static_cast<std::size_t>(point_->currentData().toPoint().x()); };
  const auto at = [this] { return static_cast<std::size_t>(point_->currentData().toPoint().y()); };
  // The fields are rounded: the other number is the model's.
  const auto there = [=, this] { return model_.outline().paths[path()][at()]; };
  x_ = length(tr("Along the arch"), {-kReachMm, kReachMm}, [=, this](double v) {
    return point_->count() > 0 && model_.set_point_mm(path(), at(), v, there().y);
  });
  y_ = length(tr("Towards buccal"), {-kReachMm, kReachMm}, [=, this](double v) {
    return point_->count() > 0 && model_.set_point_mm(path(), at(), there().x, v);
  });
  add_row(column, tr("Along the arch"), x_);
  add_row(column, tr("Towards buccal"), y_);
  point_buttons_ = new QWidget;
  auto* buttons = new QHBoxLayout(point_buttons_);
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->setSpacing(px(6));
  add_ = make_button(tr("Point"), ButtonKind::standard, u"plus"_qs);
  add_->setAccessibleName(tr("Add a point"));
  branch_ = make_button(tr("Branch"), ButtonKind::standard, u"plus"_qs);
  branch_->setAccessibleName(tr("Add a branch"));
  remove_ = make_button({}, ButtonKind::standard, u"trash"_qs);
  remove_->setAccessibleName(tr("Remove the point"));
  remove_->setToolTip(tr("Remove the point"));
  buttons->addWidget(add_);
  buttons->addWidget(branch_);
  buttons->addStretch();
  buttons->addWidget(remove_);
  column->addWidget(point_buttons_);
  connect(point_, &QComboBox::currentIndexChanged, this, &ShapeForm::show_point);
  connect(add_, &QPushButton::clicked, this, [=, this] { model_.add_point(path()); });
  connect(branch_, &QPushButton::clicked, this, [this] { model_.add_path(); });
  connect(remove_, &QPushButton::clicked, this, [=, this] { model_.remove_point(path(), at()); });
}

void ShapeForm::make_tolerances(QVBoxLayout* column) {
  column->addSpacing(px(8));
  column->addWidget(make_rule());
  column->addSpacing(px(8));
  add_section(column, tr("Strictness"));
  strictness_ = new Segments({tr("Beginner"), tr("Standard"), tr("Exam")});
  strictness_->setAccessibleName(tr("Strictness"));
  column->addWidget(strictness_);
  connect(strictness_, &Segments::changed, this, [this](int index) {
    const double mm = kStrictness[static_cast<std::size_t>(index)];
    model_.end_gesture();
    model_.set_leeway(mm, mm);
    model_.end_gesture();
  });
  floor_ = length(tr("Tolerance zone, floor"), {0, 5},
                  [this](double v) { return model_.set_leeway(v, model_.scenario().leeway.side_mm); });
  side_ = length(tr("Tolerance zone, sides"), {0, 5},
                 [this](double v) { return model_.set_leeway(model_.scenario().leeway.floor_mm, v); });
  add_row(column, tr("Tolerance zone, floor"), floor_);
  add_row(column, tr("Tolerance zone, sides"), side_);
  faces_ = make_label(tr("Some faces have a tolerance zone of their own; it stays as it is."), TextRole::caption, Weight::regular, "text2");
  faces_->setWordWrap(true);
  column->addWidget(faces_);
  time_ = new NumberBox(model_, tr("Time limit"), u"s"_qs, 0, 7200, 30, 0,
                        [this](double v) { return model_.set_time_limit_s(v); });
  time_->setSpecialValueText(tr("none"));
  add_row(column, tr("Time limit"), time_);
}

void ShapeForm::follow_model() {
  const Scenario& s = model_.scenario();
  const Outline& t = model_.outline();
  const bool box = t.shape == "box", outline = t.shape == "outline";
  title_->setText(part_name(model_.chosen(), model_.tissue_names()));
  title_->setVisible(model_.has_outline());  // of the numbers below
  drawn_->setVisible(model_.has_outline());
  faces_->setVisible(!s.leeway.faces.empty());
  depth_->show_value(t.depth_mm);
  width_->show_value(t.width_mm);
  length_->show_value(t.box_size_mm.x);
  box_width_->show_value(t.box_size_mm.y);
  top_->show_value(t.top_mm);
  for (std::size_t side = 0; side < tapers_.size(); ++side) {
    const QString name = side_name(model_.chosen(), side);
    tapers_[side].label->setText(name);
    tapers_[side].box->setAccessibleName(name);
    tapers_[side].box->show_value(t.taper_deg[side]);
  }
  corner_->show_value(t.corner_radius_mm);
  floor_->show_value(s.leeway.floor_mm);
  side_->show_value(s.leeway.side_mm);
  time_->show_value(s.time_limit_s);
  slot_rows_->setVisible(!box);
  box_rows_->setVisible(box);
  point_buttons_->setVisible(outline);
  const QSignalBlocker silent(strictness_);  // showing a value is no edit
  int chosen = -1;
  for (std::size_t i = 0; i < kStrictness.size(); ++i) {
    if (s.leeway.floor_mm == kStrictness[i] && s.leeway.side_mm == kStrictness[i]) chosen = static_cast<int>(i);
  }
  if (chosen >= 0) {
    strictness_->choose(chosen);
  } else {
    // Any other tolerance is none of the three levels.
    QButtonGroup* group = strictness_->button(0)->group();
    group->setExclusive(false);
    for (std::size_t i = 0; i < kStrictness.size(); ++i) strictness_->button(static_cast<int>(i))->setChecked(false);
    group->setExclusive(true);
  }
  {
    const QSignalBlocker quiet(point_);
    const QPoint kept = point_->currentData().toPoint();
    point_->clear();
    for (std::size_t i = 0; i < t.paths.size(); ++i) {
      for (std::size_t k = 0; k < t.paths[i].size(); ++k) {
        const QString name = t.paths.size() > 1 ? tr("Line %1, %2").arg(i + 1).arg(k + 1) : QString::number(k + 1);
        point_->addItem(name, QPoint(static_cast<int>(i), static_cast<int>(k)));
      }
    }
    point_->setCurrentIndex(std::max(point_->findData(kept), 0));
  }
  show_point();
}

void ShapeForm::show_point() {
  if (point_->count() == 0) return;
  const QPoint which = point_->currentData().toPoint();
  const Outline& t = model_.outline();
  const Vec3 p = t.paths[static_cast<std::size_t>(which.x())][static_cast<std::size_t>(which.y())];
  x_->show_value(p.x);
  y_->show_value(p.y);
  remove_->setEnabled(t.paths.size() > 1 || t.paths.front().size() > 2);
}

}  // namespace cusp::ui
