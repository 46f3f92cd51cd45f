#include "scenarios/import/image.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

namespace cusp::scenarios {
namespace {

constexpr double kMaxStepMm = 1e4;     // ten metres between voxels is no specimen
constexpr double kRightAngle = 1e-3;   // cosine: headers print six digits, scanners know less
constexpr float kMostValue = 1e9f;

bool is_measured(float value) noexcept { return std::abs(value) <= kMostValue; }

/// Which axis of the specimen each file axis runs along, and which way: the nearest turn that mirrors nothing.
struct Turn {
  std::array<int, 3> axis{0, 1, 2};
  std::array<double, 3> sign{1.0, 1.0, 1.0};
  double along = -1.0;  // sum of the cosines
};

Turn nearest_turn(const std::array<Vec3, 3>& unit) {
  const double handed = glm::dot(unit[0], glm::cross(unit[1], unit[2]));
  constexpr std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  Turn best;
  for (std::size_t n = 0; n < orders.size(); ++n) {
    Turn turn{orders[n], {}, 0.0};
    double parity = n < 3 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double c = unit[i][turn.axis[i]];
      turn.sign[i] = c < 0.0 ? -1.0 : 1.0;
      parity *= turn.sign[i];
      turn.along += std::abs(c);
    }
    if (parity * handed > 0.0 && turn.along > best.along) best = turn;
  }
  return best;
}

}  // namespace

Result<ImageLayout, ImportError> lay_out(IVec3 file_size, const std::array<Vec3, 3>& step_mm, Vec3 first_mm,
                                         const VolumeLimits& limits) {
  std::size_t voxels = 1;
  for (int i = 0; i < 3; ++i) {
    if (file_size[i] < 1) return std::unexpected(ImportError::bad_sizes);
    if (file_size[i] > limits.max_edge_voxels) return std::unexpected(ImportError::too_large);
    voxels *= static_cast<std::size_t>(file_size[i]);
    if (voxels > limits.max_voxels) return std::unexpected(ImportError::too_large);
  }
  std::array<Vec3, 3> unit{};
  std::array<double, 3> length{};
  for (std::size_t i = 0; i < 3; ++i) {
    length[i] = std::sqrt(glm::dot(step_mm[i], step_mm[i]));
    if (!(length[i] > 1e-9 && length[i] <= kMaxStepMm)) return std::unexpected(ImportError::bad_spacing);
    unit[i] = step_mm[i] / length[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(glm::dot(unit[i], unit[(i + 1) % 3])) > kRightAngle) return std::unexpected(ImportError::bad_orientation);
  }
  if (!(std::abs(first_mm.x) + std::abs(first_mm.y) + std::abs(first_mm.z) < 1e9))
    return std::unexpected(ImportError::bad_header);

  const Turn turn = nearest_turn(unit);
  if (turn.along < 0.0) return std::unexpected(ImportError::bad_orientation);
  ImageLayout out;
  out.file_size = file_size;
  Vec3 middle = first_mm;
  for (std::size_t i = 0; i < 3; ++i) {
    out.size[turn.axis[i]] = file_size[static_cast<int>(i)];
    out.spacing_mm[turn.axis[i]] = length[i];
    middle += 0.5 * (file_size[static_cast<int>(i)] - 1) * step_mm[i];
  }
  const std::array<std::ptrdiff_t, 3> stride = {1, out.size.x, static_cast<std::ptrdiff_t>(out.size.x) * out.size.y};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::ptrdiff_t s = stride[static_cast<std::size_t>(turn.axis[i])];
    out.step[i] = turn.sign[i] < 0.0 ? -s : s;
    if (turn.sign[i] < 0.0) out.first += s * (file_size[static_cast<int>(i)] - 1);
  }
  out.origin_mm = middle - 0.5 * Vec3(out.size - 1) * out.spacing_mm;
  const double cosine = std::clamp((turn.along - 1.0) / 2.0, -1.0, 1.0);
  out.turned_degrees = turn.along > 3.0 - 1e-9 ? 0.0 : std::acos(cosine) * 180.0 / std::numbers::pi;
  return out;
}

Result<void, ImportError> tidy_values(Image& image) {
  float least = kMostValue, most = -kMostValue;
  std::size_t measured = 0;
  for (const float v : image.value) {
    if (!is_measured(v)) continue;
    ++measured;
    least = std::min(least, v);
    most = std::max(most, v);
  }
  if (measured == image.value.size()) return {};
  if (measured == 0) return std::unexpected(ImportError::nothing_solid);
  const bool labels = kind_of_values(image.value) == ImageKind::labels;
  const float nothing = labels ? 0.0f : least - std::max({most - least, std::abs(least), 1.0f});
  image.measured_from = 0.5 * (static_cast<double>(nothing) + static_cast<double>(least));
  for (float& v : image.value)
    if (!is_measured(v)) v = nothing;
  return {};
}

ImageKind kind_of_values(const std::vector<float>& values) {
  std::vector<bool> seen(65536);
  std::size_t different = 0;
  for (const float v : values) {
    if (!is_measured(v)) continue;
    if (!(v >= 0.0f && v <= 65535.0f) || v != std::floor(v)) return ImageKind::grey;
    const auto i = static_cast<std::size_t>(v);
    if (seen[i]) continue;
    seen[i] = true;
    if (++different > kMaxLabels) return ImageKind::grey;
  }
  return ImageKind::labels;
}

namespace {

constexpr std::size_t kBins = 512;

/// Where the variance between the two sides of bins [first, kBins) is greatest (Otsu 1979): the middle of an empty stretch.
std::size_t otsu(const std::array<double, kBins>& count, std::size_t first) {
  double all = 0.0, moment = 0.0;
  for (std::size_t i = first; i < kBins; ++i) {
    all += count[i];
    moment += count[i] * static_cast<double>(i);
  }
  double below = 0.0, moment_below = 0.0, best = -1.0;
  std::size_t at = first, last = first;
  for (std::size_t i = first; i + 1 < kBins; ++i) {
    below += count[i];
    moment_below += count[i] * static_cast<double>(i);
    if (below <= 0.0 || below >= all) continue;
    const double apart = moment_below / below - (moment - moment_below) / (all - below);
    const double between = below * (all - below) * apart * apart;
    if (between > best) {
      best = between;
      at = i + 1;
    }
    if (between == best) last = i + 1;
  }
  return (at + last) / 2;
}

}  // namespace

std::array<double, 2> suggested_thresholds(const std::vector<float>& values) {
  if (values.empty()) return {0.0, 0.0};
  const auto [least, most] = std::ranges::minmax(values);
  const double low = static_cast<double>(least), wide = static_cast<double>(most) - low;
  if (!(wide > 0.0)) return {low, low};
  std::array<double, kBins> count{};
  for (const float v : values)
    count[std::min(kBins - 1, static_cast<std::size_t>((static_cast<double>(v) - low) / wide * kBins))] += 1.0;
  const std::size_t first = otsu(count, 0), second = otsu(count, first);
  const auto value = [&](std::size_t bin) { return low + wide * static_cast<double>(bin) / kBins; };
  return {value(first), value(second)};
}

}  // namespace cusp::scenarios
