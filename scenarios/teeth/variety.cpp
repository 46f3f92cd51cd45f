#include "scenarios/teeth/variety.h"

#include <algorithm>
#include <cmath>

#include "scenarios/teeth/noise.h"

namespace cusp::scenarios {
namespace {

constexpr double kCuspSpreadMm = 0.1;  // one sigma; draws are cut at two
constexpr double kCuspReachMm = 1.2;   // of a cusp's own share of the crests
constexpr std::uint64_t kCuspDraws = 20, kCarabelliDraw = 40;  // apart from those of the lengths

}  // namespace

ToothTable varied_table(ToothTable t, std::uint64_t seed) {
  if (seed == 0) return t;
  std::vector<double> higher;
  for (std::size_t i = 0; i < t.cusps.size(); ++i) higher.push_back(kCuspSpreadMm * normal_draw(seed, kCuspDraws + i));
  if (t.cusps.size() > 1) {
    for (RidgeTable& ridge : t.ridges) {
      for (Vec3& p : ridge.path) {
        double lift = 0.0;
        for (std::size_t i = 0; i < t.cusps.size(); ++i) {
          const Vec3 off = p - t.cusps[i].tip;
          lift += higher[i] * std::exp(-(off.x * off.x + off.y * off.y) / (kCuspReachMm * kCuspReachMm));
        }
        p.z += lift;
      }
    }
    for (std::size_t i = 0; i < t.cusps.size(); ++i) t.cusps[i].tip.z += higher[i];
  }
  // In half of the upper first molars, from a trace to a small cusp.
  const double carabelli = normal_draw(seed, kCarabelliDraw);
  for (FaceTable& face : t.faces) {
    if (face.name.starts_with("Carabelli")) face.outward_mm *= carabelli < 0.0 ? 0.0 : std::min(0.5 + carabelli, 1.5);
  }
  return t;
}

}  // namespace cusp::scenarios
