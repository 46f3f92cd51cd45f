#include "ui/widgets/burr_silhouette.h"

#include <cmath>
#include <vector>

namespace cusp {

double burr_head_top_mm(const Burr& burr) { return burr.head.ball() ? burr.radius_mm : burr.head.high(); }

QPainterPath burr_head_path(const Burr& burr, double scale) {
  QPainterPath path;
  if (burr.head.ball()) {
    path.addEllipse(QPointF(0, 0), burr.radius_mm * scale, burr.radius_mm * scale);
    return path;
  }
  std::vector<OnHalf> outline;
  constexpr int kArcSteps = 12;
  for (int i = 0; i < burr.head.size(); ++i) {
    const OutlinePiece& p = burr.head.piece(i);
    const int steps = p.radius > 0.0 ? kArcSteps : 1;
    const double from = std::atan2(p.from.rho - p.centre.rho, p.from.t - p.centre.t);
    const double to = std::atan2(p.to.rho - p.centre.rho, p.to.t - p.centre.t);
    if (i == 0) outline.push_back(p.from);
    for (int k = 1; k < steps; ++k) {
      const double angle = from + (to - from) * k / steps;
      outline.push_back({p.centre.t + p.radius * std::cos(angle), p.centre.rho + p.radius * std::sin(angle)});
    }
    outline.push_back(p.to);
  }
  path.moveTo(outline.front().rho * scale, -outline.front().t * scale);
  for (const OnHalf& at : outline) path.lineTo(at.rho * scale, -at.t * scale);
  for (auto at = outline.rbegin(); at != outline.rend(); ++at) path.lineTo(-at->rho * scale, -at->t * scale);
  path.closeSubpath();
  return path;
}

}  // namespace cusp
