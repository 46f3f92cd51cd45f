// Time of grading, in milliseconds of the processor, in brackets by the clock: `grade_times [--values] [EXERCISE|volume-512]...`. One line for each
// exercise of the library, cut by the reference, the competent and the novice operator, and one for a tree of 50 mm³ in 512³ voxels.
// --values prints every measure bit for bit instead: two builds grade alike if their outputs are the same.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/fp_guard.h"
#include "engine/removal/carve.h"
#include "scenarios/format/keys.h"
#include "scenarios/library/library.h"
#include "scenarios/metrics/live.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/operators/fast_cut.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// Of all threads, and by the clock.
struct Taken {
  double processor_ms, clock_ms;
};

double ms_by(clockid_t clock) {
  std::timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

template <class Work>
Taken ms_of(Work&& work) {
  const Taken start{ms_by(CLOCK_PROCESS_CPUTIME_ID), ms_by(CLOCK_MONOTONIC)};
  work();
  return {ms_by(CLOCK_PROCESS_CPUTIME_ID) - start.processor_ms, ms_by(CLOCK_MONOTONIC) - start.clock_ms};
}

/// Keys of one group of groups.h; of all groups where there is none.
Rubric rubric_of(std::initializer_list<std::string_view> starts) {
  Rubric out;
  for (const MetricKey& key : kMetricKeys)
    if (std::ranges::any_of(starts, [&](std::string_view start) { return key.key.starts_with(start); }))
      out.criteria.push_back({std::string(key.key), 1, {}});
  return out;
}

struct Group {
  const char* name;
  Rubric rubric;
};
std::vector<Group> groups() {
  return {{"none", {}},
          {"over-cut by face", rubric_of({"overcut_leeway_pulpal_floor"})},
          {"surface", rubric_of({"surface_"})},
          {"box", rubric_of({"gingival_above_cej", "box_height", "axial_past_junction_"})},
          {"margin", rubric_of({"cavosurface_"})},
          {"proximal", rubric_of({"contact_broken", "clearance_", "gingival_floor_"})},
          {"caries", rubric_of({"caries_left_", "sound_lost"})},
          {"all", rubric_of({""})}};
}

void print_values(const std::string& name, const std::vector<Measure>& all) {
  for (const Measure& m : all) {
    std::printf("%s %s %d %a %a", name.c_str(), m.metric.c_str(), m.measured, m.value, m.uncertainty);
    if (m.where_mm) std::printf(" %a %a %a", m.where_mm->x, m.where_mm->y, m.where_mm->z);
    std::printf("\n");
  }
}

/// With the reference, which a desktop makes once an exercise.
Taken ms_to_grade(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, const Volume& volume) {
  return ms_of([&] { static_cast<void>(measure(Reference(scenario, specimen), volume, {})); });
}

/// Times of the live scores while the plan is cut a millimetre at a time.
void print_live(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, const Plan& plan) {
  constexpr double kStepMm = 1.0;
  if (specimen->reading() == Reading::filled) return;
  LiveMetrics live(std::make_shared<Reference>(scenario, specimen));
  Volume volume(specimen);
  const IVec3 bricks = specimen->brick_count();
  std::vector<std::uint32_t> seen(static_cast<std::size_t>(bricks.x) * static_cast<std::size_t>(bricks.y) * static_cast<std::size_t>(bricks.z));
  std::vector<double> ms;
  Vec3 at = plan.start_mm;
  for (const Stroke& stroke : plan.strokes) {
    const int parts = std::max(1, static_cast<int>(std::ceil(glm::length(stroke.to_mm - at) / kStepMm)));
    for (int i = 1; stroke.cut && i <= parts; ++i) {
      const Vec3 from = at + (stroke.to_mm - at) * ((i - 1.0) / parts), to = at + (stroke.to_mm - at) * (1.0 * i / parts);
      if (carve_sweep(volume, from, to, scenario.instruments[plan.bur], Vec3(0.0, 0.0, 1.0)).overflow) return;
      std::vector<std::int32_t> changed;
      for (const std::int32_t brick : volume.cut_bricks()) {
        std::uint32_t& last = seen[static_cast<std::size_t>(brick)];
        if (volume.revision(brick) != last) changed.push_back(brick);
        last = volume.revision(brick);
      }
      if (!changed.empty()) ms.push_back(ms_of([&] { live.update(volume, changed); }).processor_ms);
    }
    at = stroke.to_mm;
  }
  if (ms.empty()) return;
  std::ranges::sort(ms);
  std::printf(" live %.1f, %.1f", ms[ms.size() / 2], ms.back());
}

void grade_one(const std::string& name, Scenario scenario, const std::shared_ptr<const Specimen>& specimen, const Volume& volume, bool values) {
  if (values) {
    print_values(name, measure(Reference(scenario, specimen), volume, {}));
    scenario.rubric = rubric_of({""});
    return print_values(name + "/all", measure(Reference(scenario, specimen), volume, {}));
  }
  const auto print = [](const char* what, const Taken& taken) {
    std::printf("%s %.0f (%.0f)", what, taken.processor_ms, taken.clock_ms);
    std::fflush(stdout);
  };
  std::printf("%s:", name.c_str());
  print(" reference", ms_of([&] { Reference(scenario, specimen); }));
  print(", its rubric", ms_to_grade(scenario, specimen, volume));
  for (const Group& group : groups()) {
    scenario.rubric = group.rubric;
    std::printf(", ");
    print(group.name, ms_to_grade(scenario, specimen, volume));
  }
}

bool grade_exercise(std::string_view key, bool values) {
  const auto scenario = load_builtin(key);
  if (!scenario) return false;
  const auto dense = make_specimen(scenario->specimen, {});
  if (!dense) return false;
  const auto specimen = Specimen::build(*dense, reading_of(scenario->method));
  for (const char* who : {"reference", "competent", "novice"}) {
    const auto plan = plan_by_name(who, *scenario, *specimen);
    Volume volume(specimen);
    if (!plan || !cut_along(*plan, *scenario, volume)) continue;
    grade_one(std::string(key) + "/" + who, *scenario, specimen, volume, values);
    if (!values) print_live(*scenario, specimen, *plan);
    if (!values) std::printf("\n");
  }
  return true;
}

Region box_at(Vec3 centre, Vec3 size) {
  Region out;
  out.kind = RegionKind::box;
  out.from_mm = centre;
  out.size_mm = size;
  return out;
}

/// A block of enamel over dentine in 512³ voxels of 0.02 mm, and a step and a box in it.
void grade_512(bool values) {
  constexpr double kVoxelMm = 0.02, kHalfMm = 5.0;
  Scenario scenario;
  scenario.tissues = {{Tissue::enamel, 3, 0.5}, {Tissue::dentine, 2, 1}};
  scenario.leeway = {0.2, 0.2};
  scenario.target.kind = RegionKind::joined;
  scenario.target.parts = {box_at({0, 0, kHalfMm - 1.0}, {7, 2.6, 2}), box_at({-2.5, 0, kHalfMm - 1.75}, {2, 4, 3.5})};
  scenario.target.rounding_mm = 0.2;
  const Grid grid{IVec3(512), kVoxelMm, Vec3(-255.5 * kVoxelMm)};
  const auto distance = [](Vec3 p) { return box_distance(p, Vec3(0.0), Vec3(kHalfMm)); };
  const auto tissue = [](Vec3 p) { return p.z > kHalfMm - 1.5 ? Tissue::enamel : Tissue::dentine; };
  const auto specimen = Specimen::build(grid, Reading::banded, [&](IVec3 brick, BrickVoxels& voxels) -> std::optional<Tissue> {
    const Vec3 low = grid.centre_mm(brick * kBrickEdge), high = grid.centre_mm(brick * kBrickEdge + (kBrickEdge - 1));
    const double middle = distance(0.5 * (low + high)), reach = 0.5 * glm::length(high - low) + kBandVoxels * kVoxelMm;
    if (middle > reach) return Tissue::empty;
    if (middle < -reach && tissue(low) == tissue(high)) return tissue(low);
    for (int o = 0; o < kBrickVoxels; ++o) {
      const Vec3 p = grid.centre_mm(brick * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6));
      voxels.s[static_cast<std::size_t>(o)] = solid_from_distance(distance(p) / kVoxelMm);
      voxels.tissue[static_cast<std::size_t>(o)] = tissue(p);
    }
    return std::nullopt;
  });
  Volume volume(specimen);
  scenario.instruments = {{}};
  const auto cut = [](Vec3 p) {
    return std::min(box_distance(p, {0.1, 0, kHalfMm - 1.0}, {3.5, 1.4, 1.05}), box_distance(p, {-2.5, 0.1, kHalfMm - 1.75}, {1.1, 2, 1.9}));
  };
  const IVec3 bricks = specimen->brick_count();
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    const IVec3 corner = specimen->brick_at(b) * kBrickEdge;
    if (cut(grid.centre_mm(corner) + 3.5 * kVoxelMm) > 10.0 * kVoxelMm) continue;
    std::uint16_t* const to = volume.cut_for_writing(b);
    for (int o = 0; to != nullptr && o < kBrickVoxels; ++o)
      to[o] = solid_from_distance(-cut(grid.centre_mm(corner + IVec3(o & 7, o >> 3 & 7, o >> 6))) / kVoxelMm);
    if (to != nullptr) volume.touched(b);
  }
  grade_one("volume-512", scenario, specimen, volume, values);
  if (!values) std::printf("\n");
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  const cusp::FpGuard fp;
  std::vector<std::string_view> wanted(argv + 1, argv + argc);
  const bool values = std::erase(wanted, "--values") > 0;
  const auto asked = [&](std::string_view key) { return wanted.empty() || std::ranges::find(wanted, key) != wanted.end(); };
  for (const std::string_view key : cusp::scenarios::builtin_scenarios())
    if (asked(key) && !cusp::test::grade_exercise(key, values)) return 1;
  if (asked("volume-512")) cusp::test::grade_512(values);
  return 0;
}
