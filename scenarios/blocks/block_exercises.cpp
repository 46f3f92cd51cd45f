#include "scenarios/blocks/block_exercises.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace cusp::scenarios {
namespace {

constexpr double kPi = std::numbers::pi;

/// Bounds that a value above them loses points at: full points up to `ideal`, half at `acceptable`, none at `fail`.
struct Upper {
  double ideal, acceptable, fail;
};

/// The same for every exercise. Sources: facts/dental.md 2.1 (depth), 3.4 (burs); the rest [M].
constexpr double kDepthMm = 2.0;
constexpr double kWidthMm = 1.6;       // channel, arm of the cross, ring
constexpr double kLineWidthMm = 1.2;
constexpr double kLengthMm = 6.0;      // channel and line
constexpr double kArmLengthMm = 5.0;   // of the cross
constexpr double kDiscMm = 4.0;        // diameter
constexpr double kRingRadiusMm = 2.4;  // of the middle line
constexpr int kRingSides = 32;

/// Over-cut bounds, mm of depth: times the floor's area, or the wall's, in mm² they are mm³ [M].
constexpr Upper kToleratedFloorMm{0.086, 0.215, 0.43};
constexpr Upper kToleratedSideMm{0.073, 0.18, 0.35};
constexpr Upper kBeyondFloorMm{0.0086, 0.086, 0.34};
constexpr Upper kBeyondSideMm{0.009, 0.06, 0.18};

struct LevelTable {
  double tolerated_mm;
  double share;  // of the over-cut bounds of level 1
  Bands removed, depth_mean, depth_most;
  const char* tolerated_en;
  const char* tolerated_de;
};
constexpr LevelTable kLevels[] = {
    {0.5, 1.0, {80, 90, 97, 100, 100, 100}, {1.3, 1.7, 1.85, 2.15, 2.35, 2.8}, {0, 0, 0, 2.25, 2.5, 3},
     "Half a millimetre", "Ein halber Millimeter"},
    {0.3, 0.7, {85, 92, 97, 100, 100, 100}, {1.45, 1.75, 1.88, 2.12, 2.25, 2.6}, {0, 0, 0, 2.2, 2.4, 2.75}, "0.3 mm", "0,3 mm"},
    {0.2, 0.5, {88, 94, 97.5, 100, 100, 100}, {1.55, 1.8, 1.9, 2.1, 2.2, 2.45}, {0, 0, 0, 2.15, 2.3, 2.55}, "0.2 mm", "0,2 mm"},
};

/// What is published of one exercise. A change of any value that it builds raises its version (tests/scenarios/library).
struct Published {
  const char* id;
  int version;
  double voxel_mm;  // by `cusp audit` where it is not 0.1 (scenarios/audit/library.md)
};

struct ShapeTable {
  const char* title_en;
  const char* title_de;
  const char* task_en;
  const char* task_de;
  double expected_time_s;  // [M], at each level
  std::array<Published, 3> levels;
};
constexpr ShapeTable kShapes[] = {
    {"Straight channel", "Gerade Rinne", "Cut the marked channel to its floor, 2.0 mm deep, with upright walls.",
     "Präparieren Sie die markierte Rinne bis zu ihrem Boden, 2,0 mm tief, mit senkrechten Wänden.", 480,
     {{{"019a9f3c-6a00-7c41-9b1e-5d0f6a3c2e02", 3, 0.1},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c3005", 3, 0.1},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c3006", 5, 0.125}}}},
    {"Line", "Linie",
     "Cut the marked line to its floor, 2.0 mm deep, in one even stroke after another. It is only 0.2 mm wider than the bur.",
     "Präparieren Sie die markierte Linie bis zu ihrem Boden, 2,0 mm tief, in gleichmäßigen Zügen. Sie ist nur 0,2 mm breiter "
     "als der Bohrer.", 300,
     {{{"019aa0e2-4b00-7d10-8c00-5d0f6a3c3001", 6, 0.08},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c3002", 6, 0.08},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c3003", 6, 0.1}}}},
    {"Cross", "Kreuz",
     "Cut both arms of the marked cross to one even floor, 2.0 mm deep. Keep the four inner corners sharp.",
     "Präparieren Sie beide Arme des markierten Kreuzes bis zu einem gemeinsamen, ebenen Boden, 2,0 mm tief. Erhalten Sie die "
     "vier inneren Ecken.", 720,
     {{{"019aa0e2-4b00-7d10-8c00-5d0f6a3c3007", 5, 0.1},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c3008", 5, 0.1},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c3009", 3, 0.1}}}},
    {"Circle", "Kreis", "Remove the marked disc, 4.0 mm across, to an even floor, 2.0 mm deep, with a round upright wall.",
     "Tragen Sie die markierte Scheibe von 4,0 mm Durchmesser bis zu einem ebenen Boden ab, 2,0 mm tief, mit runder, "
     "senkrechter Wand.", 480,
     {{{"019aa0e2-4b00-7d10-8c00-5d0f6a3c300a", 4, 0.15},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c300b", 3, 0.1},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c300c", 3, 0.1}}}},
    {"Hollow circle", "Hohlkreis", "Cut the marked ring to its floor, 2.0 mm deep, and leave the island in its middle standing.",
     "Präparieren Sie den markierten Ring bis zu seinem Boden, 2,0 mm tief, und lassen Sie die Insel in der Mitte stehen.", 720,
     {{{"019aa0e2-4b00-7d10-8c00-5d0f6a3c300d", 4, 0.15},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c300e", 3, 0.1},
       {"019aa0e2-4b00-7d10-8c00-5d0f6a3c300f", 3, 0.1}}}},
};

constexpr BlockExercise kExercises[] = {
    {"channel-1", BlockShape::channel, BlockLevel::first}, {"channel-2", BlockShape::channel, BlockLevel::second},
    {"channel-3", BlockShape::channel, BlockLevel::third}, {"line-1", BlockShape::line, BlockLevel::first},
    {"line-2", BlockShape::line, BlockLevel::second},      {"line-3", BlockShape::line, BlockLevel::third},
    {"cross-1", BlockShape::cross, BlockLevel::first},     {"cross-2", BlockShape::cross, BlockLevel::second},
    {"cross-3", BlockShape::cross, BlockLevel::third},     {"circle-1", BlockShape::circle, BlockLevel::first},
    {"circle-2", BlockShape::circle, BlockLevel::second},  {"circle-3", BlockShape::circle, BlockLevel::third},
    {"ring-1", BlockShape::ring, BlockLevel::first},       {"ring-2", BlockShape::ring, BlockLevel::second},
    {"ring-3", BlockShape::ring, BlockLevel::third},
};

/// The nearest decimal: files hold short numbers. Adding zero keeps -0 out of them.
double rounded(double value, double per_unit) noexcept { return std::round(value * per_unit) / per_unit + 0.0; }

Outline target_of(BlockShape shape) {
  Outline out;
  out.shape = shape == BlockShape::channel || shape == BlockShape::line ? "channel" : "outline";
  out.width_mm = shape == BlockShape::line ? kLineWidthMm : shape == BlockShape::circle ? kDiscMm : kWidthMm;
  out.depth_mm = kDepthMm;
  out.corner_radius_mm = shape == BlockShape::line ? 0.5 : 0.7;  // of the largest bur that fits
  const double half = 0.5 * (shape == BlockShape::cross ? kArmLengthMm : kLengthMm);
  const std::vector<Vec3> along_x = {{-half, 0, -kDepthMm}, {half, 0, -kDepthMm}};
  const std::vector<Vec3> along_y = {{0, -half, -kDepthMm}, {0, half, -kDepthMm}};
  switch (shape) {
    case BlockShape::channel: out.paths = {along_x}; break;
    case BlockShape::line: out.paths = {along_y}; break;
    case BlockShape::cross: out.paths = {along_x, along_y}; break;
    case BlockShape::circle: out.paths = {{{0, 0, -kDepthMm}}}; break;
    case BlockShape::ring:
      out.paths.emplace_back();
      for (int i = 0; i <= kRingSides; ++i) {
        const double angle = 2.0 * kPi * (i % kRingSides) / kRingSides;
        out.paths[0].push_back({rounded(kRingRadiusMm * std::cos(angle), 1e3), rounded(kRingRadiusMm * std::sin(angle), 1e3), -kDepthMm});
      }
      break;
  }
  return out;
}

/// Areas of the target's floor and wall, mm².
struct Areas {
  double floor = 0, wall = 0;
};
Areas areas_of(BlockShape shape, double width) noexcept {
  const double cap = kPi * width * width / 4.0;
  Areas out;
  switch (shape) {
    case BlockShape::channel:
    case BlockShape::line: out = {kLengthMm * width + cap, 2.0 * kLengthMm + kPi * width}; break;
    case BlockShape::cross:
      out = {2.0 * (kArmLengthMm * width + cap) - width * width, 2.0 * (2.0 * kArmLengthMm + kPi * width) - 4.0 * width};
      break;
    case BlockShape::circle: out = {cap, kPi * width}; break;
    case BlockShape::ring: out = {2.0 * kPi * kRingRadiusMm * width, 4.0 * kPi * kRingRadiusMm}; break;
  }
  out.wall *= kDepthMm;
  return out;
}

/// A line is narrower than a channel: its shares lose 1.6 / 1.2 as much, so that a wall 0.1 mm short costs as many points.
Bands removed_bands(BlockShape shape, Bands bands) noexcept {
  if (shape != BlockShape::line) return bands;
  for (double* share : {&bands.fail_lo, &bands.acc_lo, &bands.ideal_lo})
    *share = rounded(100.0 - (100.0 - *share) * kWidthMm / kLineWidthMm, 10.0);
  return bands;
}

Bands upper_bands(const Upper& most) noexcept { return {0, 0, 0, most.ideal, most.acceptable, most.fail}; }
Bands scaled_bands(const Upper& depth_mm, double mm2) noexcept {
  return upper_bands({rounded(depth_mm.ideal * mm2, 100.0), rounded(depth_mm.acceptable * mm2, 100.0), rounded(depth_mm.fail * mm2, 100.0)});
}

Rubric rubric_of(BlockShape shape, const LevelTable& level, const Areas& areas) {
  Rubric out;
  out.pass = 70;
  out.criteria = {{"target_removed", 35, removed_bands(shape, level.removed)},
                  {"depth_mean", 15, level.depth_mean},
                  {"depth_most", 10, level.depth_most},
                  {"overcut_leeway_floor", 10, scaled_bands(kToleratedFloorMm, level.share * areas.floor)},
                  {"overcut_leeway_side", 10, scaled_bands(kToleratedSideMm, level.share * areas.wall)},
                  {"overcut_beyond_floor", 10, scaled_bands(kBeyondFloorMm, level.share * areas.floor)},
                  {"overcut_beyond_side", 10, scaled_bands(kBeyondSideMm, level.share * areas.wall)}};
  return out;
}

/// channel-1 is published with these round bounds, from which the depths per area above were taken.
void set_first_channel_bounds(Rubric& rubric) {
  constexpr Upper bounds[] = {{1, 2.5, 5}, {2.5, 6, 12}, {0.1, 1, 4}, {0.3, 2, 6}};
  for (std::size_t i = 0; i < std::size(bounds); ++i) rubric.criteria[3 + i].bands = upper_bands(bounds[i]);
}

LocalText briefing_of(const ShapeTable& shape, const LevelTable& level, BlockLevel which) {
  std::string en = std::string(shape.task_en) + " " + level.tolerated_en + " round it is tolerated; anything beyond is over-cut.";
  std::string de = std::string(shape.task_de) + " " + level.tolerated_de + " ringsum wird geduldet; darüber hinaus ist zu weit geschliffen.";
  if (which == BlockLevel::third) {
    en += " The block is of two materials: a hard layer of 1.0 mm and a softer one below it. Push less when you feel the bur "
          "break through.";
    de += " Der Block besteht aus zwei Materialien: einer harten Schicht von 1,0 mm und einer weicheren darunter. Drücken Sie "
          "schwächer, sobald der Bohrer durchbricht.";
  }
  return {{"de", de}, {"en", en}};
}

std::vector<Bur> burs_of(BlockShape shape) {
  std::vector<Bur> out = {{"2", 0.5, 0.3, 4.0, 0.8, 12.0}};
  if (shape != BlockShape::line) out.push_back({"4", 0.7, 0.4, 4.0, 0.8, 12.0});
  return out;
}

}  // namespace

std::span<const BlockExercise> block_exercises() noexcept { return kExercises; }

Scenario block_exercise(BlockShape shape, BlockLevel level) {
  const std::size_t number = static_cast<std::size_t>(level) + 1;
  const ShapeTable& of_shape = kShapes[static_cast<std::size_t>(shape)];
  const LevelTable& of_level = kLevels[number - 1];
  const Published& published = of_shape.levels[number - 1];
  Scenario out;
  out.id = ScenarioId::parse(published.id).value();
  out.version = published.version;
  for (const BlockExercise& e : kExercises)
    if (e.shape == shape && e.level == level) out.key = e.key;
  out.title = {{"de", of_shape.title_de + std::string(", Stufe ") + std::to_string(number)},
               {"en", of_shape.title_en + std::string(", level ") + std::to_string(number)}};
  out.briefing = briefing_of(of_shape, of_level, level);
  out.level = static_cast<Level>(level);
  out.expected_time_s = of_shape.expected_time_s;
  out.specimen.generator = level == BlockLevel::third ? "layered-block" : "block";
  out.specimen.voxel_mm = published.voxel_mm;
  if (level == BlockLevel::third) out.tissues.push_back({Tissue::composite, 3.0, 1.5});
  out.tissues.push_back({Tissue::plastic, 2.0, 3.0});
  out.instruments = burs_of(shape);
  out.target = region_of(target_of(shape));
  out.leeway = {of_level.tolerated_mm, of_level.tolerated_mm};
  out.rubric = rubric_of(shape, of_level, areas_of(shape, out.target.outline.width_mm));
  if (shape == BlockShape::channel && level == BlockLevel::first) set_first_channel_bounds(out.rubric);
  return out;
}

}  // namespace cusp::scenarios
