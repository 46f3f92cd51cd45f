#include "ui/render/target_look.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "scenarios/metrics/deviation.h"
#include "scenarios/shapes/place.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {
constexpr double kRegionMarginMm = 0.4;  // what a bur reaches beyond it becomes fine anyway
}

TargetLook::TargetLook(const Region& target, const Leeway& leeway, std::shared_ptr<const Specimen> specimen)
    : shape_(std::make_shared<TargetShape>(target, std::move(specimen))), leeway_(leeway) {}

DeviationAt TargetLook::deviation() const {
  if (empty()) return {};
  return [shape = shape_, leeway = leeway_](Vec3 mm, SurfaceKind kind) {
    Deviation out;
    const std::optional<double> d = deviation_mm(*shape, mm, kind);
    if (!d) return out;
    out.mm = static_cast<float>(*d);
    if (kind == SurfaceKind::cut && *d > 0.0) {
      const Place place = place_of(*shape, leeway, mm);
      out.beyond = place == Place::beyond_floor || place == Place::beyond_side;
    }
    return out;
  };
}

FeedSettings TargetLook::feed() const {
  FeedSettings out;
  if (empty()) return out;
  out.deviation = deviation();
  // Cusps above the reference plane belong to it as far as they go.
  out.region = box(shape_->top_mm() + 10.0);
  return out;
}

Box TargetLook::box(double highest_mm) const {
  const double side = (leeway_.faces.empty() ? leeway_.side_mm : leeway_.most()) + kRegionMarginMm;
  const double below = (leeway_.faces.empty() ? leeway_.floor_mm : leeway_.most()) + kRegionMarginMm;
  return {Vec3(shape_->low() - side, shape_->floor_mm() - below),
          Vec3(shape_->high() + side, std::max(highest_mm, shape_->top_mm()))};
}

std::vector<OverlayLine> TargetLook::lines(const Volume& uncut) const {
  if (empty()) return {};
  const auto in_plan = [shape = shape_](Vec3 p) { return shape->outline_mm({p.x, p.y}); };
  const auto in_space = [shape = shape_](Vec3 p) { return shape->distance_mm(p); };
  if (shape_->upright() != nullptr) return target_lines(uncut, in_plan, leeway_.side_mm);
  return target_lines(uncut, in_space, leeway_.side_mm);
}

void TargetLook::put_into(SectionSettings& section) const {
  if (empty()) return;
  section.target = [shape = shape_](Vec3 p) { return shape->distance_mm(p); };
  if (shape_->upright() == nullptr || !leeway_.faces.empty()) {
    section.leeway = [shape = shape_, leeway = leeway_](Vec3 p) {
      const Near near = shape->near(p);
      return near.distance_mm - leeway.of(near.face);
    };
    return;
  }
  section.leeway = [shape = shape_, leeway = leeway_](Vec3 p) {
    const double u = shape->outline_mm({p.x, p.y}), v = shape->below_floor_mm(p.z);
    return rounded_corner(u - leeway.side_mm, v - leeway.floor_mm, shape->corner_mm());
  };
}

}  // namespace cusp::ui
