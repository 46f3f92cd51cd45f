#include "ui/render/tissue_plane.h"

#include <algorithm>
#include <cmath>

namespace cusp::ui {

TissuePlane::TissuePlane(const Specimen& specimen, const SectionSettings& settings) {
  const Grid& grid = specimen.grid();
  px_per_sample_ = grid.voxel_mm / settings.mm_per_px;
  const int width = std::max(settings.width, 1), height = std::max(settings.height, 1);
  columns_ = static_cast<int>(std::ceil(width / px_per_sample_)) + 2 * kMargin;
  rows_ = static_cast<int>(std::ceil(height / px_per_sample_)) + 2 * kMargin;
  tissue_.resize(index(0, rows_));
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const double right = ((x - kMargin) * px_per_sample_ - (width - 1) / 2.0) * settings.mm_per_px;
      const double down = ((y - kMargin) * px_per_sample_ - (height - 1) / 2.0) * settings.mm_per_px;
      const Vec3 mm = settings.plane.centre_mm + right * settings.plane.right - down * settings.plane.up;
      const Vec3 p = (mm - grid.origin_mm) / grid.voxel_mm + 0.5;
      tissue_[index(x, y)] = specimen.tissue({static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z))});
    }
  alone_.resize(tissue_.size(), Tissue::empty);
  for (int y = kMargin - 1; y + kMargin < rows_; ++y)
    for (int x = kMargin - 1; x + kMargin < columns_; ++x) alone_[index(x, y)] = only_about(x, y);
}

/// The one tissue of the neighbourhood, whatever of it is empty.
Tissue TissuePlane::only_about(int x, int y) const {
  Tissue only = Tissue::empty;
  for (int j = y - kMargin + 1; j <= y + kMargin; ++j)
    for (int i = x - kMargin + 1; i <= x + kMargin; ++i) {
      const Tissue t = tissue_[index(i, j)];
      if (t == Tissue::empty) continue;
      if (only != Tissue::empty && t != only) return Tissue::empty;
      only = t;
    }
  return only;
}

Colour TissuePlane::at(int x_px, int y_px, const std::array<Colour, kTissueCodes>& colours) const {
  const double x = x_px / px_per_sample_ + kMargin, y = y_px / px_per_sample_ + kMargin;
  const int cx = std::clamp(static_cast<int>(x), kMargin - 1, columns_ - kMargin - 1);
  const int cy = std::clamp(static_cast<int>(y), kMargin - 1, rows_ - kMargin - 1);
  if (const Tissue alone = alone_[index(cx, cy)]; alone != Tissue::empty) return colours[index_of(alone) % kTissueCodes];
  const auto bell = [](double apart) {
    const double t = std::max(1.0 - apart * apart / (kMargin * kMargin), 0.0);
    return static_cast<float>(t * t);
  };
  std::array<float, kTissueCodes> share{};
  for (int j = cy - kMargin + 1; j <= cy + kMargin; ++j) {
    const float weight = bell(j - y);
    for (int i = cx - kMargin + 1; i <= cx + kMargin; ++i)
      share[index_of(tissue_[index(i, j)]) % kTissueCodes] += weight * bell(i - x);
  }
  share[0] = 0.0f;  // outside: the surface's own line marks it
  const float most = *std::max_element(share.begin(), share.end());
  if (most <= 0.0f) return colours[index_of(Tissue::enamel)];
  // To the eighth power: the mixing stays within a pixel or two of the border.
  Colour out{0, 0, 0, 1};
  float sum = 0.0f;
  for (std::size_t t = 1; t < share.size(); ++t) {
    const float square = (share[t] / most) * (share[t] / most), w = square * square * square * square;
    if (w <= 0.0f) continue;
    out.r += w * colours[t].r;
    out.g += w * colours[t].g;
    out.b += w * colours[t].b;
    sum += w;
  }
  return {out.r / sum, out.g / sum, out.b / sum, 1};
}

}  // namespace cusp::ui
