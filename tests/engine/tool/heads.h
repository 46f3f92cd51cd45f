/// One bur of each shape that the catalogue has, and places at random about them.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "engine/tool/heads.h"
#include "engine/tool/swept.h"
#include "tests/modules.h"

namespace cusp::test {

inline Bur bur_of(std::string name, double radius, const std::optional<Profile>& head) {
  Bur out;
  out.name = std::move(name);
  out.radius_mm = radius;
  out.head = head.value();
  return out;
}

inline std::vector<Bur> all_shapes() {
  return {bur_of("straight", 0.5, flat_head(0.5, 0.5, 4.0)),
          bur_of("tapered", 0.6, flat_head(0.4, 0.6, 4.2)),
          bur_of("inverted cone", 0.6, flat_head(0.6, 0.35, 1.2)),
          bur_of("dome", 0.6, round_end_head(0.6, 0.6, 4.0)),
          bur_of("round-end taper", 0.9, round_end_head(0.5, 0.9, 8.0)),
          bur_of("pear", 0.4, pear_head(0.4, 0.3, 0.25, 1.8)),
          bur_of("half a ball", 0.5, pear_head(0.5, 0.5, 0.3, 2.0)),
          bur_of("flame", 0.6, oval_head(0.6, 0.1, 5.0, 0.45, 8.0)),
          bur_of("football", 1.15, oval_head(1.15, 0.5, 2.5, 0.4, 5.0))};
}

/// Numbers from -1 to 1, the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_{seed} {}
  double operator()() {
    seed_ = seed_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed_ >> 33) / 1073741824.0 - 1.0;
  }
  Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector();
      const double square = glm::dot(v, v);
      if (square > 0.01 && square <= 1.0) return v / std::sqrt(square);
    }
  }

 private:
  std::uint64_t seed_;
};

}  // namespace cusp::test
