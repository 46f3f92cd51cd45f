#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "scenarios/format/keys.h"
#include "scenarios/shapes/target.h"
#include "ui/editor/band_scale.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/first_bands.h"
#include "ui/editor/target_handles.h"

namespace cusp::ui {
namespace {

constexpr double kNewSegmentMm = 1.0;  // length of a branch, about that of a fissure's arm
constexpr double kLeastNewWidthMm = 0.5, kLeastNewLengthMm = 2.0;  // of a shape after set_shape()

/// Bounding rectangle of all points.
void bounds(const Outline& target, Vec3& low, Vec3& high) {
  low = high = target.paths.front().front();
  for (const auto& path : target.paths) {
    for (const Vec3& p : path) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
}

/// Whether the floor of an outline is the pulpal floor, from which depth is measured.
bool has_pulpal_floor(const Region& outline) {
  const auto floor = outline.faces.find("floor");
  return floor == outline.faces.end() || floor->second == FaceName::pulpal_floor;
}

void add_pulpal_floors(const Region& region, std::vector<const Outline*>& out) {
  if (region.kind == RegionKind::outline && has_pulpal_floor(region)) out.push_back(&region.outline);
  for (const Region& part : region.parts) add_pulpal_floors(part, out);
}

/// What the whole of several targets reads where each is cut exactly; 0 where no single outline decides it.
double read_of_whole(std::string_view metric, const Region& whole) {
  std::vector<const Outline*> floors;
  add_pulpal_floors(whole, floors);
  if (floors.empty()) return 0.0;
  const double plane = outlines_of(whole).front()->top_mm;  // floor_depth() measures from it
  std::vector<double> read;
  for (const Outline* one : floors) {
    read.push_back(metric == "isthmus_width" ? isthmus_mm(*one) : one->depth_mm + (plane - one->top_mm));
  }
  if (metric == "depth_most") return *std::ranges::max_element(read);
  return metric == "depth_least" || metric == "isthmus_width" ? *std::ranges::min_element(read) : 0.0;
}

/// Moves the bands of each measurement that begins with `metric`: of the named target that `part` lies in, else of the whole. Where
/// `part` lies in a named target, those of the whole move with the outline that decides them. `before`: the target until now.
void move_bands(Scenario& s, const Region& before, const PartPath& part, std::string_view metric, double by_mm) {
  const std::string own = part.empty() ? std::string() : part_at(s.target, {part.front()})->name;
  for (Criterion& c : s.rubric.criteria) {
    const auto [measured, target] = scenarios::split_metric(c.metric);
    if (!measured.starts_with(metric) || (target != own && !target.empty())) continue;
    const double by = target == own ? by_mm : read_of_whole(measured, s.target) - read_of_whole(measured, before);
    if (by != 0.0) c.bands = with_edges(c.bands, [by](double edge) { return edge + by; });
  }
}

/// The bands of the isthmus follow the outline's width, whatever shape it has.
void move_isthmus(Scenario& s, const Region& before, const PartPath& part) {
  const Region& now = *part_at(s.target, part);
  const double by = isthmus_mm(now.outline) - isthmus_mm(part_at(before, part)->outline);
  if (std::isfinite(by) && by != 0.0 && has_pulpal_floor(now)) move_bands(s, before, part, "isthmus_width", by);
}

}  // namespace

void settle_on_floor(Outline& target) {
  const double floor = tidy(target.top_mm - target.depth_mm);
  for (auto& path : target.paths) {
    for (Vec3& p : path) p = tidy(Vec3(p.x, p.y, floor));
  }
}

void EditorModel::choose_part(const PartPath& path) {
  const PartPath there = clamped(scenario_.target, path);
  if (there == part_) return;
  end_gesture();
  part_ = there;
  Q_EMIT part_chosen();
}

bool EditorModel::edit_outline(const QString& text, const QString& field, const std::function<void(Scenario&, Outline&)>& change) {
  if (!has_outline()) return false;
  return edit(text, field, [&](Scenario& s) { change(s, part_at(s.target, part_)->outline); });
}

bool EditorModel::set_part(const Region& part, const QString& field) {
  return edit(tr("Shape"), field, [&](Scenario& s) { *part_at(s.target, part_) = part; });
}

bool EditorModel::add_part(RegionKind kind) {
  end_gesture();
  const TargetShape shape(scenario_.target);
  const Vec3 middle = tidy(Vec3(0.5 * (shape.low() + shape.high()), 0.5 * (shape.top_mm() + shape.floor_mm())));
  PartPath path = part_;
  const Region whole = with_part(scenario_.target, path, new_part(kind, middle));
  if (!edit(tr("Add a shape"), u"parts"_qs, [&](Scenario& s) { s.target = whole; })) return false;
  choose_part(path);
  end_gesture();
  return true;
}

bool EditorModel::remove_part() {
  PartPath path = part_;
  const auto rest = without_part(scenario_.target, path);
  if (!rest) return false;
  end_gesture();
  const PartPath before = part_;
  part_ = clamped(*rest, path);
  if (!edit(tr("Remove a shape"), u"parts"_qs, [&](Scenario& s) { s.target = *rest; })) {
    part_ = before;
    return false;
  }
  end_gesture();
  Q_EMIT part_chosen();
  return true;
}

bool EditorModel::set_outline(const Outline& outline, const QString& field) {
  return edit_outline(tr("Target"), field, [&](Scenario&, Outline& t) { t = outline; });
}

bool EditorModel::set_taper_deg(std::size_t side, double deg) {
  return edit_outline(tr("Taper"), u"taper/%1"_qs.arg(side), [&](Scenario&, Outline& t) { t.taper_deg[side] = deg; });
}

bool EditorModel::set_shape(const std::string& shape) {
  end_gesture();
  return edit_outline(tr("Shape"), u"shape"_qs, [&](Scenario& s, Outline& t) {
    const Region before = s.target;
    if (t.shape == shape || t.paths.empty() || t.paths.front().empty()) return;
    Vec3 low, high;
    bounds(t, low, high);
    const Vec3 middle = tidy((low + high) / 2.0);
    if (shape == "box") {
      const double w = std::max(t.width_mm, kLeastNewWidthMm);
      t.box_size_mm = tidy(Vec3(high.x - low.x + w, high.y - low.y + w, 0));
      t.paths = {{middle}};
    } else {
      if (t.shape == "box") {
        const double wide = t.box_size_mm.x, high_y = t.box_size_mm.y;
        t.width_mm = tidy(std::max(std::min(wide, high_y), kLeastNewWidthMm));
        const double half = std::max(std::max(wide, high_y) - t.width_mm, kLeastNewLengthMm) / 2;
        const Vec3 along = wide >= high_y ? Vec3(half, 0, 0) : Vec3(0, half, 0);
        t.paths = {{tidy(middle - along), tidy(middle + along)}};
      } else if (shape == "channel") {
        t.paths = {{t.paths.front().front(), t.paths.front().back()}};
      }
      t.box_size_mm = Vec3(0.0);
    }
    t.shape = shape;
    settle_on_floor(t);
    move_isthmus(s, before, part_);
  });
}

bool EditorModel::set_depth_mm(double mm) {
  return edit_outline(tr("Depth"), u"depth"_qs, [&](Scenario& s, Outline& t) {
    const Region before = s.target;
    const double by = mm - t.depth_mm;
    t.depth_mm = mm;
    settle_on_floor(t);
    if (!std::isfinite(by) || !has_pulpal_floor(*part_at(s.target, part_))) return;
    move_bands(s, before, part_, "depth_", by);
  });
}

bool EditorModel::set_width_mm(double mm) {
  return edit_outline(tr("Width"), u"width"_qs, [&](Scenario& s, Outline& t) {
    const Region before = s.target;
    t.width_mm = mm;
    move_isthmus(s, before, part_);
  });
}

bool EditorModel::set_top_mm(double mm) {
  return edit_outline(tr("Height"), u"top"_qs, [&](Scenario&, Outline& t) {
    t.top_mm = mm;
    settle_on_floor(t);
  });
}

bool EditorModel::set_corner_radius_mm(double mm) {
  return edit_outline(tr("Corner radius"), u"corner"_qs, [&](Scenario&, Outline& t) { t.corner_radius_mm = mm; });
}

bool EditorModel::set_box_size_mm(double x, double y) {
  if (!(x > 0) || !(y > 0)) return false;
  return edit_outline(tr("Size"), u"size"_qs, [&](Scenario& s, Outline& t) {
    const Region before = s.target;
    t.box_size_mm = {x, y, 0};
    move_isthmus(s, before, part_);
  });
}

bool EditorModel::set_point_mm(std::size_t path, std::size_t point, double x, double y) {
  if (path >= outline().paths.size() || point >= outline().paths[path].size()) return false;
  return edit_outline(tr("Point"), u"point/%1/%2"_qs.arg(path).arg(point), [&](Scenario&, Outline& t) {
    Vec3& p = t.paths[path][point];
    p = Vec3(x, y, p.z);
  });
}

bool EditorModel::add_point(std::size_t path) {
  if (path >= outline().paths.size() || outline().shape != "outline") return false;
  end_gesture();
  return edit_outline(tr("Add a point"), u"points"_qs, [&](Scenario&, Outline& t) {
    auto& points = t.paths[path];
    const Vec3 last = points.back();
    const Vec3 step = points.size() > 1 ? last - points[points.size() - 2] : Vec3(kNewSegmentMm, 0, 0);
    points.push_back(tidy(last + step));
  });
}

bool EditorModel::remove_point(std::size_t path, std::size_t point) {
  const auto& paths = outline().paths;
  if (path >= paths.size() || point >= paths[path].size() || outline().shape != "outline") return false;
  if (paths.size() == 1 && paths[0].size() <= 2) return false;  // the target keeps one segment
  end_gesture();
  return edit_outline(tr("Remove a point"), u"points"_qs, [&](Scenario&, Outline& t) {
    auto& points = t.paths[path];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(point));
    if (points.size() < 2) t.paths.erase(t.paths.begin() + static_cast<std::ptrdiff_t>(path));
  });
}

bool EditorModel::add_path() {
  const Outline& drawn = outline();
  if (drawn.shape != "outline" || drawn.paths.empty() || drawn.paths.front().empty()) return false;
  end_gesture();
  return edit_outline(tr("Add a branch"), u"points"_qs, [&](Scenario&, Outline& t) {
    const auto& first = t.paths.front();
    const Vec3 root = first[first.size() / 2];
    t.paths.push_back({root, tidy(root + Vec3(0, kNewSegmentMm, 0))});
  });
}

}  // namespace cusp::ui
