#include "scenarios/teeth/noise.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {
namespace {

/// splitmix64's finaliser.
std::uint64_t mix(std::uint64_t x) noexcept {
  x += 0x9E3779B97F4A7C15ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return x ^ (x >> 31);
}
double unit(std::uint64_t bits) noexcept { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace

ValueNoise::ValueNoise(std::uint64_t seed, double wavelength_mm, Vec3 reach_mm)
    : seed_(seed), scale_(1.0 / wavelength_mm), far_(glm::ceil(reach_mm * scale_)) {
  IVec3 i;
  for (i.z = -far_.z; i.z <= far_.z; ++i.z) {
    for (i.y = -far_.y; i.y <= far_.y; ++i.y) {
      for (i.x = -far_.x; i.x <= far_.x; ++i.x) corners_.push_back(corner(i));
    }
  }
}

double ValueNoise::corner(IVec3 at) const noexcept {
  std::uint64_t h = mix(seed_ ^ static_cast<std::uint32_t>(at.x));
  h = mix(h ^ static_cast<std::uint32_t>(at.y));
  h = mix(h ^ static_cast<std::uint32_t>(at.z));
  return 2.0 * unit(h) - 1.0;
}

double ValueNoise::at(Vec3 p) const noexcept {
  const Vec3 q = p * scale_, base = glm::floor(q), f = q - base;
  const IVec3 i(base);
  const auto fade = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
  const double fx = fade(f.x), fy = fade(f.y), fz = fade(f.z);
  const bool kept = glm::all(glm::lessThanEqual(-far_, i)) && glm::all(glm::lessThan(i, far_));
  double value = 0.0;
  for (int dz = 0; dz < 2; ++dz) {
    for (int dy = 0; dy < 2; ++dy) {
      for (int dx = 0; dx < 2; ++dx) {
        const IVec3 at = i + IVec3(dx, dy, dz);
        value += (dx ? fx : 1.0 - fx) * (dy ? fy : 1.0 - fy) * (dz ? fz : 1.0 - fz) * (kept ? corners_[index(at)] : corner(at));
      }
    }
  }
  return value;
}

double normal_draw(std::uint64_t seed, std::uint64_t n) noexcept {
  double sum = 0.0;  // twelve uniforms: variance 1
  for (std::uint64_t k = 0; k < 12; ++k) sum += unit(mix(mix(seed) ^ (n * 12 + k)));
  return std::clamp(sum - 6.0, -2.0, 2.0);
}

}  // namespace cusp::scenarios
