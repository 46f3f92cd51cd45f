/// Places of the pins: every place of a measure lies on the surface that its definition names. Final volumes are the
/// operators' own paths, shaken, as sweeps without a step: every operator on the teeth, each on one of the blocks, and
/// too_deep on all. With CUSP_FULL every operator drills every exercise itself.
#include "scenarios/metrics/evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/volume/cell_field.h"
#include "scenarios/operators/faults.h"
#include "scenarios/library/library.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/tooth.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/scenarios/operators/attempt.h"

namespace cusp::test {
namespace {

constexpr const char* kOperators[] = {"expert", "novice", "competent", "too_deep", "too_shallow", "shaky", "off_outline", "pulp", "dry"};

struct Exercise {
  std::string name;
  Scenario scenario;
  std::shared_ptr<const Specimen> specimen;
  bool tooth() const { return scenario.specimen.generator == "tooth"; }
};

Exercise prepared(std::string name, Scenario scenario) {
  auto specimen = Specimen::build(make_specimen(scenario.specimen, {}).value(), reading_of(scenario.method));
  return {std::move(name), std::move(scenario), std::move(specimen)};
}

/// The class I on another molar: its fissures, 1.8 mm below its central pit's mouth.
Scenario class_one_on(int fdi) {
  Scenario s = load_builtin("class-1-36").value();
  s.specimen.fdi = fdi;
  s.specimen.voxel_mm = 0.2;
  const Vec3 pit = tooth_landmarks(tooth_request(s.specimen)).value().central;
  s.target.outline.shape = "channel";
  s.target.outline.top_mm = pit.z + 0.8;
  s.target.outline.depth_mm = 1.8;
  const double floor = s.target.outline.top_mm - s.target.outline.depth_mm;
  s.target.outline.paths = {{Vec3(pit.x - 1.5, pit.y, floor), Vec3(pit.x + 1.5, pit.y, floor)}};
  return s;
}


/// Two teeth and three blocks, in coarse voxels.
const std::vector<Exercise>& exercises() {
  static const std::vector<Exercise> all = [] {
    std::vector<Exercise> out;
    for (const char* key : {"class-1-36", "channel-1", "ring-2", "cross-3"}) {
      Scenario s = load_builtin(key).value();
      s.specimen.voxel_mm = 0.2;
      out.push_back(prepared(key, std::move(s)));
    }
    out.push_back(prepared("class-1-16", class_one_on(16)));
    return out;
  }();
  return all;
}

/// Removes a capsule, in the bricks that it reaches.
void carve_capsule(Volume& volume, Vec3 a, Vec3 b, double radius) {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = specimen.grid();
  const double reach = radius + 3.0 * grid.voxel_mm;
  const auto voxel = [&](Vec3 p) { return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm)); };
  const IVec3 low = glm::max(voxel(glm::min(a, b) - reach), IVec3(0)) / kBrickEdge;
  const IVec3 high = glm::min(voxel(glm::max(a, b) + reach), grid.size - 1) / kBrickEdge;
  IVec3 at;
  for (at.z = low.z; at.z <= high.z; ++at.z)
    for (at.y = low.y; at.y <= high.y; ++at.y)
      for (at.x = low.x; at.x <= high.x; ++at.x) {
        const int brick = specimen.brick_index(at);
        std::uint16_t* cut = nullptr;
        for (int o = 0; o < kBrickVoxels; ++o) {
          const IVec3 v = at * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6);
          const std::uint16_t value = solid_from_distance(-capsule_distance(grid.centre_mm(v), a, b, radius) / grid.voxel_mm);
          if (value == kSolid) continue;
          if (cut == nullptr) cut = volume.cut_for_writing(brick);
          if (cut == nullptr) break;
          cut[o] = std::min(cut[o], value);
        }
        if (cut != nullptr) volume.touched(brick);
      }
}

struct Final {
  Volume volume;
  Process process;
};

/// The operator's path with its strokes shaken sideways, so that walls overhang.
Final swept(const Exercise& e, const std::string& name, const ScriptedOperator& scripted, double share_done) {
  Final out{Volume(e.specimen), {}};
  std::mt19937_64 random(7);
  const double shake = name == "novice" || name == "shaky" ? 0.3 : name == "expert" ? 0.0 : 0.05;
  std::uniform_real_distribution<double> off(-shake, shake);
  const double radius = e.scenario.instruments[scripted.plan().bur].radius_mm;
  Vec3 from = scripted.plan().start_mm;
  auto left = static_cast<std::size_t>(share_done * static_cast<double>(scripted.plan().strokes.size()));
  for (const Stroke& stroke : scripted.plan().strokes) {
    if (left-- == 0) break;
    const Vec3 to = stroke.to_mm + (shake > 0.0 ? Vec3(off(random), off(random), 0.3 * off(random)) : Vec3(0.0));
    if (stroke.cut) carve_capsule(out.volume, from, to, radius);
    from = to;
  }
  return out;
}

Final drilled(const Exercise& e, ScriptedOperator scripted) {
  StepState state(attempt::scene_of(e.scenario, e.specimen));
  OperatorPort port(std::move(scripted), 0.004);
  StepInput last;
  Final out{Volume(e.specimen), {}};
  while (true) {
    const Sample sample = port.wait({});
    if (sample.status == Sample::Status::gone) break;
    last = quantise(sample, 4000, last);
    const StepOutput o = step(state, last);
    out.process.add(o);
    port.write({o.force_n, o.proxy_mm, o.stiffness_n_per_mm, Vec3(0, 0, 1), o.contact, o.faulted});
  }
  out.volume = state.volume();
  return out;
}

/// What lies at a place: distances in voxels, and how the cut surface leans.
struct Look {
  double original;  // from the original surface, negative inside
  double cut;       // from the cut surface, positive in the removed part
  double level;     // of the cut surface there: cosine to straight up, negative under an overhang
  bool open_above;
};

Look look_at(const Volume& volume, Vec3 p) {
  const Grid& grid = volume.grid();
  const Vec3 q = (p - grid.origin_mm) / grid.voxel_mm;
  const IVec3 cell(glm::floor(q));
  CellField base, cut;
  base.load(volume, Field::base, cell);
  cut.load(volume, Field::cut, cell);
  Vec3 ignored, up;
  Look out{base.eval(q - Vec3(cell), ignored), cut.eval(q - Vec3(cell), up), 0.0, true};
  const double length = glm::length(up);
  if (length > 0.0) out.level = up.z / length;
  IVec3 v(glm::floor(q + 0.5 + (length > 0.0 ? up / length : Vec3(0, 0, 1))));
  for (; v.z < grid.size.z; ++v.z) out.open_above = out.open_above && !volume.occupied(v);
  return out;
}

/// What one measure's place must fulfil; counts what only most places can.
struct Counts {
  int floors = 0, floors_shown = 0, walls = 0, walls_inside = 0, remaining = 0, exposed = 0, standing = 0;
};

void check_floor(const Reference& reference, const Measure& m, const Look& look, Counts& counts) {
  EXPECT_LE(std::fabs(look.cut), 1.0) << "off the cut surface";
  EXPECT_LE(look.original, 0.5) << "beside the original surface";
  if (!m.metric.starts_with("overcut_beyond")) return;
  ++counts.floors;
  if (look.level >= 0.6 && look.open_above && look.original <= -0.5) {
    ++counts.floors_shown;
    EXPECT_GT(reference.shape().below_floor_mm(m.where_mm->z), 0.0) << "not below the target's floor";
  }
}

void check_place(const Reference& reference, const Volume& volume, const Measure& m, Counts& counts) {
  SCOPED_TRACE(m.metric + " at " + std::to_string(m.where_mm->x) + " " + std::to_string(m.where_mm->y) + " " +
               std::to_string(m.where_mm->z));
  const Look look = look_at(volume, *m.where_mm);
  const double voxel = volume.grid().voxel_mm;
  if (m.metric.ends_with("_floor")) return check_floor(reference, m, look, counts);
  if (m.metric.ends_with("_side")) {
    EXPECT_LE(std::fabs(look.cut), 1.0) << "off the cut surface";
    EXPECT_LE(look.original, 0.5);
    ++counts.walls;
    counts.walls_inside += look.original <= -0.8 && std::fabs(look.level) < 0.8;
  } else if (m.metric == "target_removed" || m.metric == "uncut_remainder") {
    EXPECT_LE(std::fabs(std::max(look.original, look.cut)), 1.0) << "not on the free surface of what still stands";
    EXPECT_LT(reference.shape().outline_mm({m.where_mm->x, m.where_mm->y}), 0.0) << "outside the outline";
    ++counts.standing;
  } else if (m.metric.starts_with("depth_")) {
    EXPECT_LE(std::fabs(look.cut), 1.0);
    EXPECT_NEAR(reference.shape().top_mm() - m.where_mm->z, m.value, 1e-9);
  } else if (m.metric == "remaining_over_pulp") {
    EXPECT_LE(std::fabs(look.cut), 1.0);
    EXPECT_LE(look.original, 0.5);
    EXPECT_LE(reference.pulp().distance_mm(*m.where_mm, 100.0), m.value + m.uncertainty);
    ++counts.remaining;
  } else if (m.metric == "pulp_exposure") {
    EXPECT_LE(std::fabs(look.cut), 1.0) << "in what is gone, or under tissue that still stands";
    EXPECT_LE(reference.pulp().distance_mm(*m.where_mm, 100.0), voxel);
    ++counts.exposed;
  }
}

TEST(Evidence, OfWhatIsLeftLiesOnItsSurfaceThoughNobodyHasBeenThere) {
  Counts counts;
  int measured = 0;
  for (const Exercise& e : exercises()) {
    SCOPED_TRACE(e.name);
    const Reference reference(e.scenario, e.specimen);
    for (const double share : {0.0, 0.2, 0.4}) {
      if (!e.tooth() && share != 0.2 && !full_run()) continue;
      ++measured;
      const Final end = swept(e, "expert", operator_by_name("expert", e.scenario, *e.specimen, 1).value(), share);
      for (const Measure& m : measure(reference, end.volume, end.process))
        if (m.where_mm) check_place(reference, end.volume, m, counts);
    }
  }
  EXPECT_EQ(counts.standing, 2 * measured);
}

TEST(Evidence, LiesOnTheSurfaceThatItsMeasureNames) {
  Counts counts;
  for (std::size_t i = 0; i < exercises().size(); ++i) {
    const Exercise& e = exercises()[i];
    const Reference reference(e.scenario, e.specimen);
    for (std::size_t h = 0; h < std::size(kOperators); ++h) {
      const char* const name = kOperators[h];
      // Of a floor most is seen where it was cut too deep.
      const bool drills = e.tooth() || h % 3 == i % 3 || std::string_view(name) == "too_deep";
      if (!drills && !full_run()) continue;
      SCOPED_TRACE(e.name + " by " + name);
      ScriptedOperator scripted = operator_by_name(name, e.scenario, *e.specimen, 1).value();
      const Final end = full_run() ? drilled(e, std::move(scripted)) : swept(e, name, scripted, 1.0);
      for (const Measure& m : measure(reference, end.volume, end.process)) {
        if (m.where_mm && m.unit != "N" && m.unit != "K") check_place(reference, end.volume, m, counts);
      }
    }
  }
  std::printf("floors %d shown %d, walls %d inside %d, remaining %d, exposed %d, standing %d\n", counts.floors,
              counts.floors_shown, counts.walls, counts.walls_inside, counts.remaining, counts.exposed, counts.standing);
  EXPECT_GT(counts.floors, 10);
  EXPECT_GE(counts.floors_shown, counts.floors * 9 / 10);
  EXPECT_GE(counts.walls_inside, counts.walls * 8 / 10);
  EXPECT_GT(counts.remaining, 10);
  EXPECT_GT(counts.exposed, 0);
  EXPECT_GT(counts.standing, 10);
}

}  // namespace
}  // namespace cusp::test
