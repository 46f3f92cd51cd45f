#include "tests/bench/cavity.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "engine/contact/surface_contact.h"
#include "tests/bench/cavity_truth.h"
#include "tests/bench/frame.h"
#include "tests/bench/measure.h"
#include "tests/bench/names.h"
#include "tests/bench/pin.h"

namespace cusp::bench {

namespace {

constexpr double kSlideTicksPerS = 2000.0;  // samples of a row, by its budget
constexpr double kPressesPerS = 60.0;
constexpr double kOtherMinimumMm = 0.05;    // poses further apart stand in different minima
constexpr int kPressRest = 10;
constexpr double kLeastFreeMm = 0.02;       // where a press starts
constexpr double kCutTicksPerS = 200.0;     // compared, of every kCutEvery that cut
constexpr int kCutEvery = 10;
constexpr double kLeastCutSpringMm = 0.01;  // of the exact force: a bur that cuts trails its device point by 0.06 mm at most
constexpr double kCutReachMm = 0.15;        // of the surface built beyond the bur, for a tick that cuts

/// One hand and sensor at which cavities are milled.
struct CavityCase {
  MillHand hand;
  std::vector<double> minutes;
};

std::vector<CavityCase> cases_of(const Options& options) {
  std::vector<CavityCase> out;
  const std::vector<double> usual = chosen(options.minutes, {1.0, 2.0, 5.0, 20.0});
  for (const double tremor : chosen(options.tremors_mm, {0.05, 0.0, 0.1})) {
    const bool main = tremor == 0.05;
    out.push_back({{tremor, 0.0, options.seed}, main || !options.minutes.empty() ? usual : std::vector<double>{2.0}});
  }
  if (options.tremors_mm.empty())
    out.push_back({{0.05, 0.05, options.seed}, options.minutes.empty() ? std::vector<double>{2.0} : usual});
  return out;
}

Row cavity_row(const CavityCase& what, double minutes, std::string_view method, std::string_view motion, double radius_mm) {
  Row row;
  row.method = method;
  row.shape = "cavity";
  row.motion = motion;
  row.minutes = minutes;
  row.tremor_mm = what.hand.tremor_mm;
  row.encoder_mm = what.hand.encoder_mm;
  row.bur_radius_mm = radius_mm;
  row.voxel_mm = kCavityVoxelMm;
  row.seed = static_cast<std::int64_t>(what.hand.seed);
  return row;
}

/// Compares tick by tick; in another minimum than the truth's, nothing but the count.
class Comparison {
 public:
  explicit Comparison(Row& row, double least_spring_mm = kLeastSpringMm) : row_(row), least_spring_mm_(least_spring_mm) {}
  void add(const StepOutput& out, const Exact& exact, const CavityTruth& truth, double spent_s) {
    times_.add_ns(static_cast<std::int64_t>(spent_s * 1e9));
    errors_.note(out);
    ++ticks_;
    const bool due = exact.contact && length(exact.pose_mm - out.device_mm) > kSure;
    const bool has = out.contact && length(out.force_raw_n) > kSure;
    missing_ += due && !has;
    spurious_ += has && !exact.contact;
    if (exact.vanished) following_ = 0;
    const bool apart = length(out.proxy_mm - exact.pose_mm) > kOtherMinimumMm;
    apart_ += apart;
    if (following_ >= 0) {
      if (!apart) {
        errors_.followed(following_);
        following_ = -1;
      } else {
        ++following_;
      }
    }
    if (apart) {
      errors_.skip();
    } else if (!exact.contact || length(exact.pose_mm - out.device_mm) < least_spring_mm_) {
      errors_.skip_small();
    } else {
      errors_.add(out, exact, truth.clearance_mm(out.proxy_mm));
    }
  }
  void interrupt() { errors_.skip(); }
  void fill() {
    errors_.fill(row_);
    times_.fill(row_);
    const double all = std::max<double>(1.0, static_cast<double>(ticks_));
    row_.other_minimum_percent = 100.0 * static_cast<double>(apart_) / all;
    row_.force_missing_percent = 100.0 * static_cast<double>(missing_) / all;
    row_.force_spurious_percent = 100.0 * static_cast<double>(spurious_) / all;
  }

 private:
  static constexpr double kSure = 1e-3;  // N at 1 N/mm: below, rounding decides
  Row& row_;
  double least_spring_mm_;
  Errors errors_;
  TickTimes times_;
  std::int64_t ticks_ = 0, missing_ = 0, spurious_ = 0, apart_ = 0;
  int following_ = -1;
};

StepOutput explore(StepState& state, std::uint16_t bur, Vec3 device, double& spent_s) {
  StepInput input = input_at(device);
  input.bur = bur;
  const double before = core_time_s();
  const StepOutput out = step(state, input);
  spent_s = core_time_s() - before;
  return out;
}

void slide_row(StepState& state, CavityTruth& truth, const Options& options, Row& row) {
  const std::uint16_t bur = Cavity::bur_of(row.bur_radius_mm);
  enter_cavity(state, bur);
  truth.start(state.last().proxy_mm);
  Comparison comparison(row);
  const int ticks = static_cast<int>(kSlideTicksPerS * options.budget_s);
  // All ticks first: the truth's search between two of them would empty the caches.
  std::vector<std::pair<StepOutput, double>> made;
  made.reserve(static_cast<std::size_t>(ticks));
  for (const Vec3 device : exploring_points(row.bur_radius_mm, row.speed_mm_s, options.seed, ticks)) {
    double spent = 0.0;
    const StepOutput out = explore(state, bur, device, spent);
    made.emplace_back(out, spent);
  }
  for (const auto& [out, spent] : made) comparison.add(out, truth.follow(out.device_mm), truth, spent);
  comparison.fill();
}

/// From random free places straight into floor or wall at 50 mm/s, kDepthMm deep; the last tick counts.
void press_row(StepState& state, CavityTruth& truth, const Options& options, Row& row) {
  const std::uint16_t bur = Cavity::bur_of(row.bur_radius_mm);
  const Frame frame = oblique_frame();
  Random random(options.seed);
  Comparison comparison(row);
  const int presses = static_cast<int>(kPressesPerS * options.budget_s);
  for (int k = 0; k < presses; ++k) {
    enter_cavity(state, bur);
    const Vec3 from = frame.to_world({random.between(-1.6, 1.6), random.between(-0.2, 0.2), random.between(-1.0, -0.6)});
    const double z = random.between(-1.0, 0.1), phi = random.between(0.0, 6.283185307179586), rho = std::sqrt(1.0 - z * z);
    const Vec3 way = frame.direction({rho * std::cos(phi), rho * std::sin(phi), z});
    if (truth.clearance_mm(from) < kLeastFreeMm) continue;
    double whole = 0.0;
    while (truth.clearance_mm(from + way * whole) > 0.0 && whole < 4.0) whole += 0.02;
    whole += kDepthMm;
    // One that would end near the mouth is left out: the truth ends there.
    if (frame.to_local(from + way * whole).z > -0.4) continue;
    double spent = 0.0;
    lead_bur(state, bur, from, 0.05);
    truth.start(state.last().device_mm);
    const int ticks = static_cast<int>(whole / 0.05) + 1;
    StepOutput out;
    Exact exact;
    for (int t = 1; t <= ticks + kPressRest; ++t) {
      out = explore(state, bur, from + way * (whole * std::min(1.0, static_cast<double>(t) / ticks)), spent);
      exact = truth.follow(out.device_mm);
    }
    comparison.interrupt();
    comparison.add(out, exact, truth, spent);
  }
  comparison.fill();
}

/// Mills on and compares ticks that have lengthened the path.
void cutting_row(Cavity& cavity, const Options& options, Row& row) {
  Comparison comparison(row, kLeastCutSpringMm);
  const int wanted = static_cast<int>(std::ceil(kCutTicksPerS * options.budget_s));
  const int most = 20 * kCutEvery * wanted;
  for (int tick = 0, cut = 0, compared = 0; tick < most && compared < wanted; ++tick) {
    const Sweep before = cavity.sweeps().back();
    const double spent = cavity.mill_tick();
    const Sweep& now = cavity.sweeps().back();
    if ((now.a == before.a && now.b == before.b) || ++cut % kCutEvery != 0) continue;
    const StepOutput& out = cavity.state().last();
    CavityTruth truth(cavity_surface_about(cavity.sweeps(), now.b, kMillRadiusMm + kCutReachMm), kMillRadiusMm,
                      SurfaceContact::kClearanceMm);
    truth.start(now.b);
    comparison.interrupt();
    comparison.add(out, truth.follow(out.device_mm), truth, spent);
    ++compared;
  }
  comparison.fill();
}

void exploring_rows(Cavity& cavity, const CavityCase& what, double minutes, const Options& options, std::vector<Row>& rows) {
  const auto surface = cavity_surface(cavity.sweeps());
  for (const double radius : chosen(options.bur_radii_mm, {0.25, 0.4, 0.5})) {
    CavityTruth truth(surface, radius, SurfaceContact::kClearanceMm);
    if (asked(options.motions, "slide"))
      for (const double speed : chosen(options.speeds_mm_s, {5.0, 50.0})) {
        Row row = cavity_row(what, minutes, key_of(Method::surface), "slide", radius);
        row.speed_mm_s = speed;
        slide_row(cavity.state(), truth, options, row);
        rows.push_back(row);
      }
    if (!asked(options.motions, "press")) continue;
    Row row = cavity_row(what, minutes, key_of(Method::surface), "press", radius);
    press_row(cavity.state(), truth, options, row);
    rows.push_back(row);
  }
}

/// The surface method's cavity, explored at the times asked.
void accuracy_in_cavity(const CavityCase& what, const Options& options, std::vector<Row>& rows) {
  cavity_scene(Method::surface);  // the specimen stays in memory and is not counted
  const std::optional<double> before = resident_mb();
  Cavity cavity(Method::surface, what.hand);
  for (const double minutes : what.minutes) {
    cavity.mill_until(minutes, [](double) {});
    if (cavity.sweeps().empty()) throw std::runtime_error(fmt::format("nothing is milled after {} minutes", minutes));
    const std::size_t first = rows.size();
    const std::optional<double> resident = resident_mb();
    const double memory_mb = resident.value_or(kAbsent) - before.value_or(kAbsent) -
                             1e-6 * static_cast<double>(cavity.sweeps().capacity() * sizeof(Sweep));
    exploring_rows(cavity, what, minutes, options, rows);
    cavity.resume();
    if (asked(options.motions, "cutting")) {
      Row row = cavity_row(what, minutes, key_of(Method::surface), "cutting", kMillRadiusMm);
      row.speed_mm_s = kMillSpeedMmS;
      cutting_row(cavity, options, row);
      rows.push_back(row);
    }
    for (std::size_t i = first; i < rows.size(); ++i) rows[i].memory_mb = memory_mb;
  }
}

void print_cavity(const std::vector<Row>& rows) {
  fmt::print("{:<16}{:>6}{:>7}{:>7} {:<8}{:>5}{:>6}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>7}{:>9}{:>9}{:>7}\n", "method", "min",
             "tremor", "enc", "motion", "r", "mm/s", "samples", "deg", "p99", "pose um", "p95", "other%", "depth", "max", "stepp99",
             "max", "miss%", "p50 us", "p99.9", "MB");
  for (const Row& r : rows)
    fmt::print("{:<16}{:>6.1f}{:>7.2f}{:>7.2f} {:<8}{:>5.2f}{:>6.0f}{:>8}{:>8.3f}{:>8.2f}{:>8.2f}{:>8.1f}{:>8.2f}{:>8.3f}{:>8.2f}{:>8.1f}{:>8.1f}{:>7.2f}{:>9.1f}{:>9.1f}{:>7.1f}\n",
               r.method, r.minutes, r.tremor_mm, r.encoder_mm, r.motion, r.bur_radius_mm, r.speed_mm_s, r.samples, r.angle_deg_mean,
               r.angle_deg_p99, r.pose_um_mean, r.pose_um_p95, r.other_minimum_percent, r.depth_um_mean, r.depth_um_max,
               r.force_step_excess_mn_p99, r.force_step_excess_mn_max, r.force_missing_percent, r.tick_us_p50, r.tick_us_p999, r.memory_mb);
}

}  // namespace

std::vector<Row> cavity_rows(const Options& options) {
  std::vector<Row> rows;
  for (const CavityCase& what : cases_of(options))
    if (asked(options.methods, key_of(Method::surface))) accuracy_in_cavity(what, options, rows);
  return rows;
}

int run_cavity(const Options& options) {
  if (!pin_to_core()) std::cerr << "cusp-bench: this thread could not be kept on one core\n";
  Report report = empty_report();
  report.rows = cavity_rows(options);
  return write_report(report, options.json, print_cavity);
}

}  // namespace cusp::bench
