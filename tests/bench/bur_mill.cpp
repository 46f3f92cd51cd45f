#include "tests/bench/bur_mill.h"

#include <stdexcept>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/candidates.h"
#include "tests/bench/mill.h"
#include "tests/bench/names.h"
#include "tests/bench/pin.h"

namespace cusp::bench {

namespace {

constexpr double kNeckMm = 0.1;         // radius
constexpr double kNeckFreeMm = 2.0;     // of its length beyond the head: the cavity is 1.8 mm deep
constexpr double kThroughAirMm = 0.05;  // a tick, through free space

std::shared_ptr<Scene> scene_with(const Bur& head) {
  std::shared_ptr<Scene> scene = cavity_scene(Method::surface);
  Bur bur = head;
  bur.neck_radius_mm = bur.shank_radius_mm = kNeckMm;
  bur.neck_length_mm = (head.head.ball() ? head.radius_mm : head.head.high()) + kNeckFreeMm;
  scene->burs = {bur};
  scene->tool_axis = oblique_frame().z;
  scene->tilt_cosine = 0.5;
  return scene;
}

Row bur_mill_row(const CatalogueBur& entry, std::string_view axis, double minutes, const MillHand& hand) {
  BurMill mill(entry.bur, axis, hand);
  const auto ticks = std::max<std::int64_t>(1, static_cast<std::int64_t>(minutes * 60e3));
  std::int64_t deferred = 0;
  for (std::int64_t k = 0; k < ticks; ++k)
    deferred += mill.mill_tick().deferred;
  Row row;
  row.sweep = kFullSweep;
  row.method = key_of(Method::surface);
  row.shape = "cavity";
  row.task = "mill";
  row.bur = entry.shape + ' ' + entry.bur.name;
  row.axis = axis;
  row.speed_mm_s = kMillSpeedMmS;
  row.bur_radius_mm = entry.bur.radius_mm;
  row.voxel_mm = kCavityVoxelMm;
  row.minutes = minutes;
  row.tremor_mm = hand.tremor_mm;
  row.seed = static_cast<std::int64_t>(hand.seed);
  row.samples = static_cast<std::int64_t>(mill.times().count());
  mill.times().fill(row);
  row.tick_us_mean = 1e6 / row.updates_per_s;
  row.work_us_max = mill.work().most_us();
  row.deferred_percent = 100.0 * static_cast<double>(deferred) / static_cast<double>(ticks);
  return row;
}

}  // namespace

BurMill::BurMill(const Bur& bur, std::string_view axis, const MillHand& hand)
    : state_(scene_with(bur)),
      axis_(axis, Frame::of(oblique_frame().z, oblique_frame().x, Vec3(0.0)), AxisMotion::Span::slot, hand.seed),
      motion_(hand) {}

void BurMill::Work::add(std::int64_t units, double tick_us) noexcept {
  const auto w = static_cast<double>(units);
  most = std::max(most, units);
  ticks += 1.0;
  sum += w;
  squares += w * w;
  us += tick_us;
  with_us += w * tick_us;
}

double BurMill::Work::most_us() const noexcept {
  const double spread = ticks * squares - sum * sum;
  if (!(spread > 0.0)) return kAbsent;
  const double per_unit = (ticks * with_us - sum * us) / spread;
  return (us + per_unit * (ticks * static_cast<double>(most) - sum)) / ticks;
}

StepOutput BurMill::timed(Vec3 device, Vec3 wanted_axis, std::uint16_t buttons) {
  StepInput input = turned_input(device, oblique_frame().z, wanted_axis);
  input.buttons = buttons;
  const std::int64_t worked = counted_work(state_);
  const double before = core_time_s();
  const StepOutput out = step(state_, input);
  const double seconds = core_time_s() - before;
  times_.add_ns(static_cast<std::int64_t>(seconds * 1e9));
  work_.add(counted_work(state_) - worked, seconds * 1e6);
  return out;
}

void BurMill::lead_to(Vec3 to) {
  lead(state_, [](StepState& state, const StepInput& input) { return step(state, input); }, to, kThroughAirMm);
}

StepOutput BurMill::mill_tick() {
  const Vec3 device = motion_.next();
  if (!milling_) {
    lead_to(oblique_frame().to_world({0.0, 0.0, kOverMm}));
    lead_to(device);
    milling_ = true;
  }
  return timed(device, axis_.next(), StepInput::kCut);
}

std::vector<Row> bur_mill_rows(const Options& options) {
  std::vector<std::string> numbers = options.burs;
  if (numbers.empty())
    for (const CatalogueBur& entry : bur_catalogue()) numbers.push_back(entry.bur.name);
  std::vector<Row> rows;
  if (!asked(options.methods, key_of(Method::surface))) return rows;
  for (const std::string& number : numbers) {
    const CatalogueBur* entry = catalogue_bur(number);
    if (entry == nullptr) throw std::runtime_error("no bur " + number);
    for (const std::string_view axis : {"fixed", "jitter"})
      for (const double tremor : chosen(options.tremors_mm, {0.05}))
        for (const double minutes : chosen(options.minutes, {kMillMinutes}))
          if (asked(options.axes, axis)) rows.push_back(bur_mill_row(*entry, axis, minutes, {tremor, 0.0, options.seed}));
  }
  return rows;
}

}  // namespace cusp::bench
