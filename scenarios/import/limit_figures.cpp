#include "scenarios/import/limit_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cusp::scenarios {
namespace {

constexpr std::string_view kMark = "limit ";

std::string digits(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

double product(Vec3 v) { return v.x * v.y * v.z; }
double longest(Vec3 v) { return std::max({v.x, v.y, v.z}); }

/// The least voxel of two digits at or above `from_mm` that keeps the limits; 0: none within them does.
double fitting_voxel(Vec3 extent_mm, double from_mm, const VolumeLimits& limits) {
  const auto fits = [&](double mm) {
    const Vec3 n = glm::ceil(extent_mm / mm) + 2.0 * kPadVoxels + 1.0;  // one more, for a box that lies between voxels
    return longest(n) <= limits.max_edge_voxels && product(n) <= static_cast<double>(limits.max_voxels);
  };
  const double unit = std::pow(10.0, std::floor(std::log10(from_mm)) - 1.0);
  double at = std::ceil(from_mm / unit - 1e-9) * unit;
  while (at <= limits.max_voxel_mm && !fits(at)) at += std::pow(10.0, std::floor(std::log10(at) + 1e-9) - 1.0);
  return at <= limits.max_voxel_mm ? at : 0.0;
}

std::optional<LimitFigures> passed(Vec3 voxels, const VolumeLimits& limits, LimitKind edge, LimitKind all) {
  const double most = limits.max_edge_voxels, most_voxels = static_cast<double>(limits.max_voxels);
  if (!(longest(voxels) <= most)) return LimitFigures{edge, longest(voxels), most};
  if (!(product(voxels) <= most_voxels)) return LimitFigures{all, product(voxels), most_voxels};
  return std::nullopt;
}

}  // namespace

std::string text_of(const LimitFigures& f) {
  return std::string(kMark) + std::string(kLimitKeys[static_cast<std::size_t>(f.kind)]) + ' ' + digits(f.asked) + ' ' +
         digits(f.allowed) + ' ' + digits(f.fits_mm);
}

std::optional<LimitFigures> limit_figures(std::string_view detail) {
  detail = detail.substr(0, detail.find('\n'));
  if (!detail.starts_with(kMark)) return std::nullopt;
  detail.remove_prefix(kMark.size());
  const auto key = std::ranges::find(kLimitKeys, detail.substr(0, detail.find(' ')));
  if (key == kLimitKeys.end()) return std::nullopt;
  LimitFigures out;
  out.kind = static_cast<LimitKind>(key - kLimitKeys.begin());
  detail.remove_prefix(key->size());
  for (double* number : {&out.asked, &out.allowed, &out.fits_mm}) {
    if (!detail.starts_with(' ')) return std::nullopt;
    detail.remove_prefix(1);
    const auto [end, error] = std::from_chars(detail.data(), detail.data() + detail.size(), *number);
    if (error != std::errc{}) return std::nullopt;
    detail.remove_prefix(static_cast<std::size_t>(end - detail.data()));
  }
  return detail.empty() ? std::optional(out) : std::nullopt;
}

std::optional<LimitFigures> passed_limit(Vec3 voxels, Vec3 extent_mm, double voxel_mm, const VolumeLimits& limits) {
  auto out = passed(voxels, limits, LimitKind::edge, LimitKind::voxels);
  if (out && std::isfinite(longest(extent_mm))) out->fits_mm = fitting_voxel(extent_mm, voxel_mm, limits);
  return out;
}

std::string passed_file_limit(Vec3 voxels, const VolumeLimits& limits) {
  const auto figures = passed(voxels, limits, LimitKind::file_edge, LimitKind::file_voxels);
  return figures ? text_of(*figures) : std::string();
}

}  // namespace cusp::scenarios
