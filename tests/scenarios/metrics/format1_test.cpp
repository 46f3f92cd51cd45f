// Exercises of format 1 as their files stood (tests/scenarios/format/format1), measured and graded by this program. The
// figures of format1.golden were written by the last program of format 1 (evaluator 3), as bits: equal means equal.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>

#include "scenarios/format/read.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using Shape = std::function<double(Vec3)>;
using Lines = std::vector<std::vector<Vec2>>;

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(CUSP_SOURCE_DIR "/tests/scenarios/") + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A slot about lines, of this width, down to this height.
Shape slot(Lines lines, double width, double floor) {
  return [=](Vec3 p) {
    double d = 1e9;
    for (const auto& line : lines)
      for (std::size_t i = 0; i < line.size(); ++i)
        d = std::min(d, segment_distance({p.x, p.y}, line[i], line[std::min(i + 1, line.size() - 1)]));
    return std::max(d - 0.5 * width, floor - p.z);
  };
}

/// Enamel over dentine over pulp below `top`, in a box of 8 x 6 x 5 mm.
std::shared_ptr<const Specimen> layers(double top, Reading reading) {
  Grid grid;
  grid.voxel_mm = 0.125;
  grid.size = IVec3(72, 56, 48);
  grid.origin_mm = Vec3(-4.43, -3.45, top - 5.21);
  return carved::specimen(
      grid, reading, [top](Vec3 p) { return box_distance(p, Vec3(0, 0, top - 2.5), Vec3(4, 3, 2.5)); },
      [top](Vec3 p) { return p.z > top - 1.5 ? Tissue::enamel : p.z > top - 3.0 ? Tissue::dentine : Tissue::pulp; });
}

struct Case {
  const char* file;
  double top;
  Reading reading;
  std::vector<Shape> cuts;
};

std::vector<Case> cases() {
  const Lines channel = {{{-3.0, 0.0}, {3.0, 0.0}}};
  const Lines fissures = {{{-3.1, -0.43}, {-0.89, -0.15}, {0.74, 0.05}, {3.0, -0.18}}, {{0.74, 0.05}, {0.94, 1.2}}};
  const Lines box = {{{-0.9, 0.0}, {0.9, 0.0}}};
  return {{"channel-1", 0.0, Reading::banded, {slot(channel, 1.6, -2.0), slot(channel, 2.1, -2.45)}},
          {"class-1-36", 4.2, Reading::banded, {slot(fissures, 1.2, 2.4), slot(fissures, 1.9, 1.1), slot({fissures[1]}, 1.0, 2.9)}},
          {"box", 0.0, Reading::banded, {slot(box, 1.0, -1.8), slot(box, 1.5, -1.5)}},
          {"outline", 0.0, Reading::filled, {slot(fissures, 1.3, -1.7)}}};
}

std::string bits(double value) {
  char out[40];
  std::snprintf(out, sizeof out, "%a", value);
  return out;
}

/// The name that format 1 has for a metric.
std::string name_in_format_1(const std::string& metric) { return metric == "uncut_remainder" ? "undercut" : metric; }

std::string figures_of(const Case& c) {
  const auto scenario = read_scenario(text_of("format/format1/" + std::string(c.file) + ".json"));
  if (!scenario) return scenario.error().where;
  const auto specimen = layers(c.top, c.reading);
  const Reference reference(*scenario, specimen);
  std::ostringstream out;
  for (std::size_t i = 0; i < c.cuts.size(); ++i) {
    Volume volume(specimen);
    carved::carve(volume, c.cuts[i]);
    const std::vector<Measure> measures = measure(reference, volume, {});
    const Grade graded = grade(*scenario, measures);
    out << c.file << " cut " << i << " score " << bits(graded.score) << (graded.passed ? " passed" : " failed");
    for (const std::string& critical : graded.critical) out << ' ' << critical;
    out << '\n';
    for (const CriterionGrade& one : graded.criteria)
      out << "  points " << name_in_format_1(one.id) << ' ' << bits(one.points) << ' ' << bits(one.points_max) << ' ' << one.band << ' ' << one.reason_code << '\n';
    for (const Measure& m : measures)
      if (m.measured && !m.metric.starts_with("protected_"))  // format 1 did not measure damage
        out << "  value " << name_in_format_1(m.metric) << ' ' << bits(m.value) << ' ' << bits(m.uncertainty) << '\n';
  }
  return out.str();
}

TEST(Format1, GradesBitForBitAsTheProgramOfFormat1) {
  std::string all;
  for (const Case& c : cases()) all += figures_of(c);
  EXPECT_EQ(all, text_of("metrics/format1.golden"));
}

}  // namespace
}  // namespace cusp::test
