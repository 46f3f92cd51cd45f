// Exercises of format 1 as their files stood (tests/scenarios/format/format1), measured and graded by this program. The
// figures of format1.golden were written by the last program of format 1 (evaluator 3), as bits: equal means equal.
// Evaluator 4 marks less of an attempt that leaves part of the target (scenarios/grading/grader.h). Evaluator 5 has another
// isthmus, evaluator 7 another distance to the pulp: those two are left out. Evaluator 8 is less sure of the target: its uncertainty is.
// Evaluator 13 measures a ridge at the foot of its wall: ridges have a test of their own.

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
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

using Shape = std::function<double(Vec3)>;
using Lines = std::vector<std::vector<Vec2>>;

std::string text_of(const std::string& path) {
  std::ifstream file(source_dir() / "tests/scenarios" / path, std::ios::binary);
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

/// Format 1 did not measure damage. It measured the isthmus at all heights of the walls, evaluator 5 at the cavosurface alone.
bool as_in_format_1(std::string_view metric) { return !metric.starts_with("protected_") && metric != "isthmus_width" && metric != "remaining_over_pulp"; }

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
      if (m.measured && as_in_format_1(m.metric))
        out << "  value " << name_in_format_1(m.metric) << ' ' << bits(m.value) << ' ' << bits(m.uncertainty) << '\n';
  }
  return out.str();
}

/// Lines of one attempt: its score, then its points and values.
struct Attempt {
  std::string score;
  std::vector<std::string> points, values, ridges;
};

std::vector<Attempt> attempts_of(const std::string& figures) {
  std::vector<Attempt> out;
  std::istringstream lines(figures);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ")) out.push_back({line, {}, {}, {}});
    else if (line.starts_with("  points")) out.back().points.push_back(line);
    else if (line.starts_with("  value target_removed ") || line.starts_with("  value undercut ")) out.back().values.push_back(line.substr(0, line.rfind(' ')));
    else if (line.starts_with("  value ridge_")) out.back().ridges.push_back(line);
    else if (!line.starts_with("  value isthmus_width ") && !line.starts_with("  value remaining_over_pulp ")) out.back().values.push_back(line);
  }
  return out;
}

double score_of(const Attempt& attempt) { return std::strtod(attempt.score.c_str() + attempt.score.find("score ") + 6, nullptr); }

struct Both {
  std::vector<Attempt> now, then;
};
const Both& both() {
  static const Both out = [] {
    std::string all;
    for (const Case& c : cases()) all += figures_of(c);
    return Both{attempts_of(all), attempts_of(text_of("metrics/format1.golden"))};
  }();
  return out;
}

TEST(Format1, MeasuresBitForBitAsTheProgramOfFormat1) {
  ASSERT_EQ(both().now.size(), both().then.size());
  for (std::size_t i = 0; i < both().now.size(); ++i) EXPECT_EQ(both().now[i].values, both().then[i].values) << both().then[i].score;
}

TEST(Format1, MeasuresARidgeAtTheFootOfItsWallWithinWhatItIsKnownBy) {
  struct Ridge {
    char metric[16];
    double value, uncertainty;
  };
  const auto ridge_of = [](const std::string& line) {
    Ridge out{};
    EXPECT_EQ(std::sscanf(line.c_str(), "  value %15s %la %la", out.metric, &out.value, &out.uncertainty), 3) << line;
    return out;
  };
  for (std::size_t i = 0; i < both().now.size(); ++i) {
    const Attempt &now = both().now[i], &then = both().then[i];
    ASSERT_EQ(now.ridges.size(), then.ridges.size());
    for (std::size_t k = 0; k < now.ridges.size(); ++k) {
      const Ridge at_foot = ridge_of(now.ridges[k]), at_wall = ridge_of(then.ridges[k]);
      EXPECT_STREQ(at_foot.metric, at_wall.metric);
      EXPECT_LE(at_foot.value, at_wall.value) << "the foot stands no further in";
      EXPECT_NEAR(at_foot.value, at_wall.value, at_wall.uncertainty) << then.score << ": walls are upright";
      EXPECT_EQ(at_foot.uncertainty, at_wall.uncertainty);
    }
  }
}

TEST(Format1, MarksBitForBitAsEvaluator3WhereTheTargetIsOut) {
  int same = 0;
  for (std::size_t i = 0; i < both().now.size(); ++i) {
    const Attempt &now = both().now[i], &then = both().then[i];
    if (!then.points.front().ends_with("ideal full")) continue;  // the first criterion of each is target_removed
    EXPECT_EQ(now.score, then.score);
    EXPECT_EQ(now.points, then.points);
    ++same;
  }
  EXPECT_EQ(same, 2);
}

TEST(Format1, OfPartOfTheTargetMarksAllElseLowerThanEvaluator3) {
  for (std::size_t i = 0; i < both().now.size(); ++i) {
    const Attempt &now = both().now[i], &then = both().then[i];
    if (then.points.front().ends_with("ideal full")) continue;
    EXPECT_LT(score_of(now), score_of(then)) << then.score;
    ASSERT_EQ(now.points.size(), then.points.size());
    for (std::size_t k = 0; k < now.points.size(); ++k) {
      const bool of_the_whole = then.points[k].starts_with("  points target_removed") || then.points[k].starts_with("  points undercut");
      if (of_the_whole) {
        EXPECT_EQ(now.points[k], then.points[k]);
      }
    }
  }
}

}  // namespace
}  // namespace cusp::test
