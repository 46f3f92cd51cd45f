// The search for the closest admissible point where it is ill conditioned: a bur that all sides hold, pushed far.
#include "engine/contact/solver/plane_search.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

namespace cusp::test {
namespace {

/// By trying every three planes: of the places where three meet and none is violated, the nearest to q.
Vec3 nearest_corner(Vec3 q, std::span<const Plane> planes, double tolerance_mm) {
  Vec3 best(1e9);
  for (const Plane& a : planes)
    for (const Plane& b : planes)
      for (const Plane& c : planes) {
        if (!(&a < &b && &b < &c)) continue;
        const Vec3 ab = glm::cross(a.n, b.n), bc = glm::cross(b.n, c.n), ca = glm::cross(c.n, a.n);
        const Vec3 at = (bc * a.c + ca * b.c + ab * c.c) / glm::dot(a.n, bc);
        bool admissible = true;
        for (const Plane& p : planes) admissible = admissible && glm::dot(p.n, at) - p.c > -tolerance_mm;
        if (admissible && length_of(at - q) < length_of(best - q)) best = at;
      }
  return best;
}

TEST(PlaneSearch, holds_a_bur_in_its_own_hole_however_far_the_device_pushes_on) {
  // Five of the 95 planes about a bur at the bottom of its hole, with the device 19 mm deep. Steps reach 300 mm, so
  // rounding leaves three planes by 1e-6 mm, more than the tolerance.
  const Plane planes[] = {{{-0.28539279776031773, 0.80322380624085665, 0.52285989335049332}, -0.27366870567520102},
                          {{0.65902137756347656, -0.35563081502914429, 0.66273486614227295}, -1.0886641658412324},
                          {{0.3610629813844729, -0.79325690179839292, -0.49028258303040972}, 0.18096292008239939},
                          {{0.046830598091247129, -0.8625116302981346, -0.50386563951401764}, 0.46535522352505376},
                          {{0.28134673091881751, -0.64415624242439284, -0.71127122277439381}, 0.4223120624587699}};
  const Vec3 device(-13.6472, 4.2958, -14.2964);
  PlaneSet set(8);
  for (const Plane& p : planes) set.add(p.n, p.c);
  for (const PlaneSearch& found : {closest_point(device, planes, 1e-7), closest_point(device, set, 1e-7, {})}) {
    EXPECT_TRUE(found.feasible);
    EXPECT_GT(found.active, 0);
    for (const Plane& p : planes) EXPECT_GT(glm::dot(p.n, found.y) - p.c, -2e-7);
    EXPECT_LE(length_of(found.y - nearest_corner(device, planes, 1e-7)), 1e-5);  // a tolerance of 1e-7 across walls so steep
  }
}

}  // namespace
}  // namespace cusp::test
