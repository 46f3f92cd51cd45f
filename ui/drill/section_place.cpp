#include "ui/drill/section_place.h"

namespace cusp::ui {

SectionPlace::SectionPlace(const TargetLook& look, const Box& specimen) : near_(specimen) {
  double top_mm = specimen.high.z;
  if (!look.empty()) {
    const TargetShape& shape = look.shape();
    top_mm = shape.top_mm();
    near_.low = {shape.low().x - kMarginMm, shape.low().y - kMarginMm, top_mm};
    near_.high = {shape.high().x + kMarginMm, shape.high().y + kMarginMm, top_mm};
  }
  last_mm_ = 0.5 * (near_.low + near_.high);
  last_mm_.z = top_mm;
}

Vec3 SectionPlace::follow(Vec3 pivot_mm) noexcept {
  const bool over = pivot_mm.x >= near_.low.x && pivot_mm.x <= near_.high.x && pivot_mm.y >= near_.low.y &&
                    pivot_mm.y <= near_.high.y;
  if (over) last_mm_ = {pivot_mm.x, pivot_mm.y, last_mm_.z};
  return last_mm_;
}

}  // namespace cusp::ui
