/// Where stiffness is swept to its limit: six kinds of place on which a bur can be pressed and stays, with the exact
/// proxy of each.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "tests/bench/shapes.h"

namespace cusp::bench {

/// The places of kPressCases:
///   edge     on a face, the ball's centre 0.05 to 0.2 mm beside where it would begin to roll over an outer edge of 90
///            degrees. On the edge itself no press is steady for any method: what holds it there is a ridge.
///   corner   of three walls, along their diagonal and up to 11 degrees off it
///   groove   of 60 degrees, on both walls
///   pit      a bowl 2 % wider than the bur: the bur lies in it with hundreds of points about it
///   channel  the bur's own: at the bottom of the hole that it has cut, and against its wall
/// Where one presses, by seed.
struct Press {
  Vec3 touch{0.0};                // the exact proxy while pressed
  Vec3 approach{0.0};             // unit, on the way there
  Vec3 into{0.0};                 // unit, of the push
  Vec3 free_a{0.0}, free_b{0.0};  // unit directions in which nothing holds the bur; zero: none
};

/// A shape with its places.
class PressPlace {
 public:
  /// nullptr for another name.
  static std::unique_ptr<PressPlace> make(std::string_view name, double bur_radius_mm);
  virtual ~PressPlace() = default;
  virtual const Shape& shape() const = 0;
  virtual Press press(std::uint64_t seed) const = 0;
  /// The exact proxy, fast enough for a loop.
  virtual std::unique_ptr<Truth> truth() const = 0;
};

}  // namespace cusp::bench
