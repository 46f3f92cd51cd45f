// The handles of a node, and of a shape that is no outline, in the editor's view.

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "ui/editor/handle_knob.h"
#include "ui/editor/part_handles.h"
#include "ui/editor/target_view.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

constexpr double kLeastSlopePx = 4.0;  // a millimetre along the line of sight is not dragged

QString part_mm(double value) { return format({value, {}, QStringLiteral("mm"), 2}); }

/// The frame's axis that is nearest to a way, towards it.
Vec3 nearest_axis(Vec3 way) {
  const Vec3 size = glm::abs(way);
  if (size.x >= size.y && size.x >= size.z) return {way.x >= 0 ? 1 : -1, 0, 0};
  if (size.y >= size.z) return {0, way.y >= 0 ? 1 : -1, 0};
  return {0, 0, way.z >= 0 ? 1 : -1};
}

QString part_field(const TargetHandle& handle) { return u"handle/part/"_qs + QString::number(static_cast<int>(handle.kind)); }

}  // namespace

Vec3 TargetView::moved_in_view(Vec3 from_mm, const Way& way) const {
  const Vec3 sight = view_->camera().forward();
  const auto on = [&](QPointF at) {
    const Ray ray = view_->ray(at);
    return ray.from_mm + glm::dot(from_mm - ray.from_mm, sight) / glm::dot(ray.along, sight) * ray.along;
  };
  return from_mm + on(way.to) - on(way.from);
}

Vec3 TargetView::way_of(glm::ivec2 keys) const {
  const Camera& camera = view_->camera();
  return static_cast<double>(keys.x) * nearest_axis(camera.right()) + static_cast<double>(keys.y) * nearest_axis(camera.up());
}

/// The search of an anchor takes too long for each turn of the camera.
std::vector<TargetHandle> TargetView::node_handles() {
  Region node = model_.chosen();
  node.rounding_mm = node.by_mm = 0;
  if (found_.grown != grown_ || !(found_.node == node)) {
    const std::shared_ptr<const Specimen> specimen(grown_->whole, &grown_->whole->specimen());
    std::optional<NodeAnchor> anchor = node_anchor(node, specimen);
    found_ = {std::move(node), grown_, anchor};
  }
  return handles_of_node(model_.chosen(), found_.anchor);
}

/// A radius, an extent, a rounding, a growth and a floor move along their line; a place moves in the plane that faces the viewer.
void TargetView::drag_part(const TargetHandle& handle, const Region& from, const Way& way) {
  Vec3 to = handle.at_mm;
  if (handle.along != Vec3(0.0)) {
    const auto a = view_->project(handle.at_mm), b = view_->project(handle.at_mm + handle.along);
    if (!a || !b) return;
    const QPointF mm = *b - *a;
    const double length2 = QPointF::dotProduct(mm, mm);
    if (length2 < kLeastSlopePx * kLeastSlopePx) return;
    to += QPointF::dotProduct(way.to - way.from, mm) / length2 * handle.along;
  } else {
    to = moved_in_view(to, way);
    if (way.snap == Snap::landmarks) to = snapped(to);
  }
  model_.set_part(moved_part(from, handle, to), part_field(handle));
}

void TargetView::place_part(const TargetHandle& handle, Vec3 to_mm) {
  model_.set_part(moved_part(model_.chosen(), handle, to_mm), part_field(handle));
}

void TargetView::step_part(const TargetHandle& handle, glm::ivec2 keys, double step_mm) {
  Vec3 by = static_cast<double>(keys.x + keys.y) * handle.along;
  if (handle.kind == TargetHandle::Kind::floor) by = -by;  // up is up
  if (handle.is_place()) by = way_of(keys);
  place_part(handle, handle.at_mm + step_mm * by);
}

void TargetView::name_part_handle(HandleKnob& knob, const TargetHandle& handle) {
  const Region& part = model_.chosen();
  const auto tagged = [&](const QString& name, const QString& value, const QString& tag) {
    knob.set_handle(handle, name, value);
    tag_of(handle)->setText(tag);
    show_tag(*tag_of(handle));
  };
  const auto place = [](Vec3 at) { return tr("%1 across, %2 along, %3 high").arg(part_mm(at.y), part_mm(at.x), part_mm(at.z)); };
  switch (handle.kind) {
    case TargetHandle::Kind::place: return knob.set_handle(handle, tr("Place"), place(part.from_mm));
    case TargetHandle::Kind::end: return knob.set_handle(handle, tr("Other end"), place(part.to_mm));
    case TargetHandle::Kind::radius: return knob.set_handle(handle, tr("Radius"), part_mm(part.radius_mm));
    case TargetHandle::Kind::end_radius: return knob.set_handle(handle, tr("Radius at the other end"), part_mm(part.end_radius_mm));
    case TargetHandle::Kind::extent_x: return knob.set_handle(handle, tr("Length"), part_mm(part.size_mm.x));
    case TargetHandle::Kind::extent_y: return knob.set_handle(handle, tr("Width"), part_mm(part.size_mm.y));
    case TargetHandle::Kind::floor: return knob.set_handle(handle, tr("Floor"), part_mm(handle.at_mm.z));
    case TargetHandle::Kind::whole: return knob.set_handle(handle, tr("Place of all shapes"), place(handle.at_mm));
    case TargetHandle::Kind::rounding:
      return tagged(tr("Rounding of the edges"), part_mm(part.rounding_mm), tr("Rounding %1").arg(part_mm(part.rounding_mm)));
    case TargetHandle::Kind::growth: return tagged(tr("Grown by"), part_mm(part.by_mm), tr("Grown by %1").arg(part_mm(part.by_mm)));
    default: return;
  }
}

}  // namespace cusp::ui
