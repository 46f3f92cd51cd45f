// `heads --shape cavity`: a head mills a cavity as a trembling hand does (cavity.h), then slides over its floor and walls.
#include <stdexcept>

#include "engine/contact/surface_contact.h"
#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/bur_mill.h"
#include "tests/bench/candidates.h"
#include "tests/bench/heads.h"
#include "tests/bench/swept_heads.h"

namespace cusp::bench {

namespace {

constexpr double kOtherMm = 0.05;       // proxies further apart stand in different minima
constexpr double kPathRadiusMm = 0.4;   // of exploring_points(): device points beyond the milled path, for every head
const Vec3 kMiddle(0.0, 0.0, -0.8);     // free, in the frame's own axes

/// Mills for so long. What the head has swept.
std::vector<HeadSweep> mill_cavity(BurMill& mill, double minutes) {
  std::vector<HeadSweep> swept;
  for (double t = 0.0; t < minutes * 60e3; t += 1.0) {
    HeadSweep now{{}, {}, mill.mill_tick().axis};
    if (!newest_sweep(mill.state(), now.a, now.b)) continue;
    if (!swept.empty() && swept.back().a == now.a) {
      swept.back().b = now.b;
    } else {
      swept.push_back(now);
    }
  }
  return swept;
}

/// Up, over the middle, and down into it.
void enter(BurMill& mill) {
  Vec3 above = oblique_frame().to_local(mill.state().last().device_mm);
  above.z = BurMill::kOverMm;
  mill.lead_to(oblique_frame().to_world(above));
  mill.lead_to(oblique_frame().to_world({0.0, 0.0, BurMill::kOverMm}));
  mill.lead_to(oblique_frame().to_world(kMiddle));
}

}  // namespace

Row measure_head_cavity(const HeadCase& of, const Measure& what, const HeadCavity& cavity) {
  const CatalogueBur* entry = catalogue_bur(of.bur);
  if (entry == nullptr || entry->bur.head.ball()) throw std::runtime_error("no head " + std::string(of.bur));
  MillHand hand;
  hand.tremor_mm = cavity.tremor_mm;
  hand.seed = what.seed;
  BurMill mill(entry->bur, of.axis, hand);
  const std::vector<HeadSweep> swept = mill_cavity(mill, cavity.minutes);
  if (swept.empty()) throw std::runtime_error("nothing is milled");
  enter(mill);
  mill.start_measuring();

  // All ticks first: the proxy's search between two of them would empty the caches.
  std::vector<StepOutput> made;
  Errors errors;
  for (const Vec3 device : exploring_points(kPathRadiusMm, what.speed_mm_s, what.seed, cavity.ticks)) {
    made.push_back(mill.tick(device));
    errors.note(made.back());
  }
  const SweptHeads truth(entry->bur, swept, oblique_frame());
  std::int64_t compared = 0, apart = 0;
  for (std::size_t i = 0; i < made.size(); i += static_cast<std::size_t>(cavity.every)) {
    const StepOutput& out = made[i];
    errors.skip();
    if (!out.contact) continue;
    const std::optional<Vec3> exact =
        truth.proxy_from(out.proxy_mm, out.axis, out.device_mm, SurfaceContact::kHeadClearanceMm);
    if (!exact || length(*exact - out.device_mm) < kLeastSpringMm) {
      errors.skip_small();
      continue;
    }
    ++compared;
    apart += length(*exact - out.proxy_mm) > kOtherMm;
    errors.add(out, {*exact, true, false},
               SurfaceContact::kHeadClearanceMm - truth.deepest_mm(out.proxy_mm, out.axis));
  }
  Row row;
  row.method = key_of(Method::surface);
  row.bur = entry->shape + ' ' + entry->bur.name;
  row.shape = of.shape;
  row.axis = of.axis;
  row.motion = "slide";
  row.speed_mm_s = what.speed_mm_s;
  row.bur_radius_mm = entry->bur.radius_mm;
  row.voxel_mm = kCavityVoxelMm;
  row.seed = static_cast<std::int64_t>(what.seed);
  row.minutes = cavity.minutes;
  row.tremor_mm = cavity.tremor_mm;
  errors.fill(row);
  if (compared > 0) row.apart_percent = 100.0 * static_cast<double>(apart) / static_cast<double>(compared);
  mill.times().fill(row);
  return row;
}

}  // namespace cusp::bench
