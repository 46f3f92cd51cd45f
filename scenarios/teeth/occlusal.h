/// The biting surface as a height over (x, y): ridges joined by a smooth maximum, so that the developmental grooves are
/// the valleys between them; then blurred, then the fissures and pits cut in.
#pragma once

#include <cstdint>

#include "scenarios/teeth/height_field.h"
#include "scenarios/teeth/tables.h"

namespace cusp::scenarios {

class Occlusal {
 public:
  /// No groove is narrower than min_half_width_mm on each side. seed 0: the average surface.
  Occlusal(const ToothTable& table, std::uint64_t seed, double min_half_width_mm);

  double height(double x, double y) const noexcept { return height_.at(x, y); }
  /// Signed distance to the surface, first order, negative below.
  double distance(Vec3 p) const noexcept { return (p.z - height_.at(p.x, p.y)) * steepness_.at(p.x, p.y); }
  /// The same to the surface that the dentine follows: without fissures, rounded.
  double soft_distance(Vec3 p) const noexcept { return (p.z - soft_.at(p.x, p.y)) * soft_steepness_.at(p.x, p.y); }
  double lowest() const noexcept { return lowest_; }

 private:
  HeightField height_, steepness_, soft_, soft_steepness_;  // steepness: 1 / sqrt(1 + slope²)
  double lowest_ = 0.0;
};

}  // namespace cusp::scenarios
