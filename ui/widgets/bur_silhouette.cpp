#include "ui/widgets/bur_silhouette.h"

#include <cmath>
#include <vector>

namespace cusp::ui {

double bur_head_top_mm(const Bur& bur) { return bur.head.ball() ? bur.radius_mm : bur.head.high(); }

QPainterPath bur_head_path(const Bur& bur, double scale) {
  QPainterPath path;
  if (bur.head.ball()) {
    path.addEllipse(QPointF(0, 0), bur.radius_mm * scale, bur.radius_mm * scale);
    return path;
  }
  std::vector<OnHalf> outline;
  constexpr int kArcSteps = 12;
  for (int i = 0; i < bur.head.size(); ++i) {
    const OutlinePiece& p = bur.head.piece(i);
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

}  // namespace cusp::ui
