#include "ui/view/start_view.h"

#include <algorithm>

namespace cusp::ui {

StartView start_view(const Grid& specimen, const TargetLook& look) {
  const Vec3 low = specimen.origin_mm, high = specimen.centre_mm(specimen.size);
  if (look.empty()) return {0.5 * (low + high), 0.35 * glm::length(high - low)};
  const TargetShape& shape = look.shape();
  const Vec3 centre(0.5 * (shape.low() + shape.high()), shape.top_mm() - 0.4);
  // Never closer than a hand can aim.
  return {centre, std::max(0.5 * glm::length(shape.high() - shape.low()) + 1.6, 3.5)};
}

}  // namespace cusp::ui
