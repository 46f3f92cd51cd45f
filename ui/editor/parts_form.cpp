#include "ui/editor/parts_form.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <algorithm>
#include <array>

#include "scenarios/format/ranges.h"
#include "ui/editor/form_parts.h"
#include "ui/editor/node_handles.h"
#include "ui/editor/shape_form.h"
#include "ui/editor/target_name_form.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kRowsShown = 7;
constexpr std::array kAddable = {RegionKind::outline, RegionKind::box, RegionKind::cylinder, RegionKind::cone, RegionKind::sphere,
                                 RegionKind::capsule, RegionKind::ellipsoid, RegionKind::half_space};
constexpr std::array kJoins = {RegionKind::joined, RegionKind::common, RegionKind::difference};

QString kind_name(RegionKind kind) {
  switch (kind) {
    case RegionKind::outline: return PartsForm::tr("Outline");
    case RegionKind::box: return PartsForm::tr("Cuboid");
    case RegionKind::cylinder: return PartsForm::tr("Cylinder");
    case RegionKind::cone: return PartsForm::tr("Cone");
    case RegionKind::sphere: return PartsForm::tr("Sphere");
    case RegionKind::capsule: return PartsForm::tr("Capsule");
    case RegionKind::ellipsoid: return PartsForm::tr("Ellipsoid");
    case RegionKind::half_space: return PartsForm::tr("Half-space");
    case RegionKind::tissue: return PartsForm::tr("Tissue");
    case RegionKind::lesion: return PartsForm::tr("Carious lesion");
    case RegionKind::joined: return PartsForm::tr("Union");
    case RegionKind::common: return PartsForm::tr("Intersection");
    case RegionKind::difference: return PartsForm::tr("The first less the others");
    case RegionKind::offset: break;
  }
  return PartsForm::tr("Offset");
}

/// Of an outline and a cuboid: what its floor is.
QString floor_name(const Region& part) {
  const auto floor = part.faces.find(part.kind == RegionKind::box ? "z_low" : "floor");
  return floor != part.faces.end() && floor->second == FaceName::gingival_floor ? face_name("gingival_floor") : QString();
}

bool is_join(const Region& part) { return std::ranges::find(kJoins, part.kind) != kJoins.end(); }
bool has_place(const Region& part) { return !is_node(part.kind) && !is_of_voxels(part.kind) && part.kind != RegionKind::outline; }
bool has_leaves_to_move(const Region& part) { return is_node(part.kind) && middle_of_leaves(part).has_value(); }

QString axis_name(int axis) {
  return axis == 0 ? PartsForm::tr("Along the arch") : axis == 1 ? PartsForm::tr("Towards buccal") : PartsForm::tr("Height");
}

}  // namespace

QString part_name(const Region& part, const TissueNames& own) {
  const QString name = part.kind == RegionKind::outline  ? shape_name(part.outline.shape)
                       : part.kind == RegionKind::tissue ? tissue_name(part.tissue, own)
                                                         : kind_name(part.kind);
  const QString floor = floor_name(part);
  return floor.isEmpty() ? name : PartsForm::tr("%1, %2").arg(name, floor);
}

PartsForm::PartsForm(EditorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(6));
  make_list(column);
  column->addWidget(new TargetNameForm(model_));
  make_numbers(column);
  connect(&model_, &EditorModel::changed, this, &PartsForm::follow_model);
  connect(&model_, &EditorModel::part_chosen, this, &PartsForm::follow_model);
  follow_model();
}

void PartsForm::make_list(QVBoxLayout* column) {
  add_section(column, tr("Shapes of the target"));
  list_ = new QTreeWidget;
  list_->setAccessibleName(tr("Shapes of the target"));
  list_->setHeaderHidden(true);
  list_->setIndentation(px(14));
  list_->setRootIsDecorated(false);
  list_->setItemsExpandable(false);
  list_->setUniformRowHeights(true);
  list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);  // else it claims height that goes to its title
  column->addWidget(list_);
  connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    PartPath path;
    for (; item != nullptr && item->parent() != nullptr; item = item->parent())
      path.insert(path.begin(), static_cast<std::size_t>(item->parent()->indexOfChild(item)));
    model_.choose_part(path);
  });
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(px(6));
  add_ = make_button(tr("Shape"), ButtonKind::standard, u"plus"_qs);
  add_->setAccessibleName(tr("Add a shape"));
  auto* menu = new QMenu(add_);
  for (const RegionKind kind : kAddable) connect(menu->addAction(kind_name(kind)), &QAction::triggered, this, [this, kind] { model_.add_part(kind); });
  add_->setMenu(menu);
  remove_ = make_button({}, ButtonKind::standard, u"trash"_qs);
  remove_->setAccessibleName(tr("Remove the shape"));
  remove_->setToolTip(tr("Remove the shape"));
  connect(remove_, &QPushButton::clicked, this, [this] { model_.remove_part(); });
  buttons->addWidget(add_);
  buttons->addStretch();
  buttons->addWidget(remove_);
  column->addLayout(buttons);
}

QVBoxLayout* PartsForm::add_group(QVBoxLayout* column, const QString& title, std::function<bool(const Region&)> of) {
  auto* box = new QWidget;
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, px(4), 0, 0);
  rows->setSpacing(px(6));
  if (!title.isEmpty()) rows->addWidget(make_label(title, TextRole::body, Weight::bold));
  column->addWidget(box);
  groups_.push_back({box, std::move(of)});
  return rows;
}

void PartsForm::add_box(QVBoxLayout* group, const QString& name, std::string_view range, std::function<double(Region&)> of, std::function<bool(double)> take) {
  const NumberRange& mm = *range_of(range);
  auto* box = new NumberBox(model_, name, u"mm"_qs, mm.least, mm.most, 0.05, 2, std::move(take));
  add_row(group, name, box);
  numbers_.push_back({box, std::move(of)});
}

void PartsForm::add_number(QVBoxLayout* group, const QString& name, std::string_view range, std::function<double&(Region&)> in) {
  const QString field = u"part/"_qs + QString::number(numbers_.size());
  add_box(group, name, range, in, [this, in, field](double value) {
    Region part = model_.chosen();
    in(part) = value;
    return model_.set_part(part, field);
  });
}

void PartsForm::add_point(QVBoxLayout* group, const QString& title, std::string_view range, std::function<Vec3&(Region&)> in) {
  for (int axis = 0; axis < 3; ++axis) {
    add_number(group, axis_name(axis), range, [in, axis](Region& part) -> double& { return in(part)[axis]; });
    numbers_.back().box->setAccessibleName(tr("%1: %2").arg(title, axis_name(axis)));
  }
}

void PartsForm::add_middle(QVBoxLayout* group, const QString& title) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto of = [axis](const Region& part) { return middle_of_leaves(part).value_or(Vec3(0.0))[axis]; };
    add_box(group, axis_name(axis), "/target/from_mm/0", of, [this, of, axis](double value) {
      Vec3 by(0.0);
      by[axis] = on_handle_step(value - of(model_.chosen()));
      return model_.set_part(shifted(model_.chosen(), by), u"middle/%1"_qs.arg(axis));
    });
    numbers_.back().box->setAccessibleName(tr("%1: %2").arg(title, axis_name(axis)));
  }
}

void PartsForm::make_numbers(QVBoxLayout* column) {
  QVBoxLayout* rows = add_group(column, {}, is_join);
  joined_ = new QComboBox;
  joined_->setAccessibleName(tr("Joined as"));
  for (const RegionKind kind : kJoins) joined_->addItem(kind_name(kind), static_cast<int>(kind));
  rows->addWidget(joined_);
  connect(joined_, &QComboBox::activated, this, [this](int index) {
    Region part = model_.chosen();
    part.kind = static_cast<RegionKind>(joined_->itemData(index).toInt());
    model_.end_gesture();
    model_.set_part(part, u"joined"_qs);
    model_.end_gesture();
  });
  add_number(rows, tr("Rounding of the edges"), "/target/rounding_mm", [](Region& part) -> double& { return part.rounding_mm; });
  rows = add_group(column, {}, [](const Region& part) { return part.kind == RegionKind::offset; });
  add_number(rows, tr("Grown by"), "/target/by_mm", [](Region& part) -> double& { return part.by_mm; });
  rows = add_group(column, tr("Place of all shapes"), has_leaves_to_move);
  add_middle(rows, tr("Place of all shapes"));
  rows = add_group(column, tr("Place"), has_place);
  add_point(rows, tr("Place"), "/target/from_mm/0", [](Region& part) -> Vec3& { return part.from_mm; });
  rows = add_group(column, tr("Other end"), [](const Region& part) { return has_ends(part.kind); });
  add_point(rows, tr("Other end"), "/target/to_mm/0", [](Region& part) -> Vec3& { return part.to_mm; });
  rows = add_group(column, tr("Size"), [](const Region& part) { return part.kind == RegionKind::box || part.kind == RegionKind::ellipsoid; });
  add_point(rows, tr("Size"), "/target/size_mm/0", [](Region& part) -> Vec3& { return part.size_mm; });
  rows = add_group(column, {}, [](const Region& part) { return has_ends(part.kind) || part.kind == RegionKind::sphere; });
  add_number(rows, tr("Radius"), "/target/radius_mm", [](Region& part) -> double& { return part.radius_mm; });
  rows = add_group(column, {}, [](const Region& part) { return part.kind == RegionKind::cone; });
  add_number(rows, tr("Radius at the other end"), "/target/end_radius_mm", [](Region& part) -> double& { return part.end_radius_mm; });
}

void PartsForm::show_list() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  const Region& root = model_.scenario().target;
  std::vector<QTreeWidgetItem*> line;  // the item of each level on the way to the present one
  int rows = 0;
  for (const PartPath& path : parts_of(root)) {
    line.resize(path.size());
    auto* item = path.empty() ? new QTreeWidgetItem(list_) : new QTreeWidgetItem(line.back());
    const Region& part = *part_at(root, path);
    const QString name = part_name(part, model_.tissue_names());
    item->setText(0, part.name.empty() ? name : tr("%1: %2").arg(target_title(part.name, &root), name));
    line.push_back(item);
    ++rows;
    if (path == model_.part()) list_->setCurrentItem(item);
  }
  list_->expandAll();
  list_->setFixedHeight(std::min(rows, kRowsShown) * px(26) + px(8));
  list_->scrollToItem(list_->currentItem());
}

void PartsForm::follow_model() {
  show_list();
  const Region& chosen = model_.chosen();
  remove_->setEnabled(!model_.part().empty());
  for (const Group& group : groups_) group.box->setVisible(group.of(chosen));
  Region shown = chosen;
  for (const Number& number : numbers_) number.box->show_value(number.of(shown));
  const QSignalBlocker quiet(joined_);
  joined_->setCurrentIndex(std::max(joined_->findData(static_cast<int>(chosen.kind)), 0));
}

}  // namespace cusp::ui
