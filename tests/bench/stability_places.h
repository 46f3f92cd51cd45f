/// The six kinds of place for k_max, on which a pressed bur stays, with the exact proxy of each.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "tests/bench/shapes.h"

namespace cusp::bench {

/// The places of kPressCases:
///   edge     on a face, the centre 0.05 to 0.2 mm beside the outer edge of 90 degrees. On the edge itself no press is
///            steady for any method, because a ridge is no minimum.
///   corner   of three walls, along their diagonal and up to 11 degrees off it
///   groove   of 60 degrees, on both walls
///   pit      a bowl 2 % wider than the bur, with hundreds of contact points
///   channel  the bottom and wall of the hole that the bur has cut
/// One press, by seed.
struct Press {
  Vec3 touch{0.0};                // exact proxy under the press
  Vec3 approach{0.0};             // unit, direction of the approach
  Vec3 into{0.0};                 // unit, direction of the push
  Vec3 free_a{0.0}, free_b{0.0};  // unit directions without constraint; zero: none
};

/// A shape with its places.
class PressPlace {
 public:
  /// nullptr for another name.
  static std::unique_ptr<PressPlace> make(std::string_view name, double bur_radius_mm);
  virtual ~PressPlace() = default;
  virtual const Shape& shape() const = 0;
  virtual Press press(std::uint64_t seed) const = 0;
  /// The exact proxy in closed form, fast enough for a closed loop.
  virtual std::unique_ptr<Truth> truth() const = 0;
};

}  // namespace cusp::bench
