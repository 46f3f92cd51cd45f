// `heads --shape cavity`: a head mills a cavity as a trembling hand does (cavity.h), then slides over its floor and walls.
#include <stdexcept>

#include "engine/contact/surface_contact.h"
#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/candidates.h"
#include "tests/bench/cavity.h"
#include "tests/bench/head_courses.h"
#include "tests/bench/heads.h"
#include "tests/bench/pin.h"
#include "tests/bench/swept_heads.h"
#include "tests/bench/tick_times.h"

namespace cusp::bench {

namespace {

constexpr double kNeckMm = 0.1;         // radius; long enough that neither neck nor shank touches
constexpr double kOverMm = 5.0;         // of the pivot over the face, between milling and exploring
constexpr double kThroughAirMm = 0.05;        // a tick, through free space
constexpr double kOtherMm = 0.05;       // proxies further apart stand in different minima
constexpr double kPathRadiusMm = 0.4;   // of exploring_points(): device points beyond the milled path, for every head
const Vec3 kMiddle(0.0, 0.0, -0.8);     // free, in the frame's own axes

std::shared_ptr<Scene> scene_with(const Bur& head) {
  std::shared_ptr<Scene> scene = cavity_scene(Method::surface);
  Bur bur = head;
  bur.neck_radius_mm = bur.shank_radius_mm = kNeckMm;
  bur.neck_length_mm = bur.head.high() + 2.0;
  scene->burs = {bur};
  scene->tool_axis = oblique_frame().z;
  scene->tilt_cosine = 0.5;
  return scene;
}

/// A head in a block, and what it has swept.
struct HeadMill {
  HeadMill(const Bur& bur, std::string_view axis_kind, std::uint64_t seed)
      : state(scene_with(bur)),
        axis(axis_kind, Frame::of(oblique_frame().z, oblique_frame().x, Vec3(0.0)), AxisMotion::Span::slot, seed) {}

  StepOutput tick(Vec3 device, Vec3 wanted, std::uint16_t buttons = 0) {
    StepInput input = turned_input(device, oblique_frame().z, wanted);
    input.buttons = buttons;
    const double before = core_time_s();
    const StepOutput out = step(state, input);
    times.add_ns(static_cast<std::int64_t>((core_time_s() - before) * 1e9));
    return out;
  }
  void lead(Vec3 to) {
    const Vec3 from = state.last().tick == 0 ? to : state.last().device_mm;
    const int ticks = static_cast<int>(length(to - from) / kThroughAirMm) + 1;
    for (int k = 1; k <= ticks; ++k) tick(from + (to - from) * (static_cast<double>(k) / ticks), oblique_frame().z);
  }
  void mill(const MillHand& hand, double minutes) {
    MillMotion motion(hand);
    Vec3 device = motion.next();
    lead(oblique_frame().to_world({0.0, 0.0, kOverMm}));
    lead(device);
    for (double t = 0.0; t < minutes * 60e3; t += 1.0, device = motion.next()) {
      const StepOutput out = tick(device, axis.next(), StepInput::kCut);
      HeadSweep now{{}, {}, out.axis};
      if (!newest_sweep(state, now.a, now.b)) continue;
      if (!swept.empty() && swept.back().a == now.a) {
        swept.back().b = now.b;
      } else {
        swept.push_back(now);
      }
    }
  }
  /// Up, over the middle, and down into it.
  void enter() {
    Vec3 above = oblique_frame().to_local(state.last().device_mm);
    above.z = kOverMm;
    lead(oblique_frame().to_world(above));
    lead(oblique_frame().to_world({0.0, 0.0, kOverMm}));
    lead(oblique_frame().to_world(kMiddle));
    times = {};
  }

  StepState state;
  AxisMotion axis;
  TickTimes times;
  std::vector<HeadSweep> swept;
};

}  // namespace

Row measure_head_cavity(const HeadCase& of, const Measure& what, const HeadCavity& cavity) {
  const CatalogueBur* entry = catalogue_bur(of.bur);
  if (entry == nullptr || entry->bur.head.ball()) throw std::runtime_error("no head " + std::string(of.bur));
  MillHand hand;
  hand.tremor_mm = cavity.tremor_mm;
  hand.seed = what.seed;
  HeadMill mill(entry->bur, of.axis, what.seed);
  mill.mill(hand, cavity.minutes);
  if (mill.swept.empty()) throw std::runtime_error("nothing is milled");
  mill.enter();

  // All ticks first: the proxy's search between two of them would empty the caches.
  std::vector<StepOutput> made;
  Errors errors;
  for (const Vec3 device : exploring_points(kPathRadiusMm, what.speed_mm_s, what.seed, cavity.ticks)) {
    made.push_back(mill.tick(device, mill.axis.next()));
    errors.note(made.back());
  }
  const SweptHeads truth(entry->bur, mill.swept, oblique_frame());
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
  mill.times.fill(row);
  return row;
}

}  // namespace cusp::bench
