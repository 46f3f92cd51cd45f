/// The verb `removal`: whether the cut obeys push, tissue and bur in the same measure, whatever the voxel, the tick and the
/// direction, read off the surface that is left. What --measure names:
/// speed: drilling speed over voxel, tick, direction, tissue, alpha and bur: all pairs, or --full the whole product for
/// one bur and voxel; depth: through three materials, as the paper's figure 15; hand: the same with a hand's push; mixed: half in one tissue, half in another; density: eq. (6);
/// shape, volume, order: what known strokes leave, with a bur of every shape in the catalogue (--full: with every bur), in
/// parts and other ticks; slide, ridge: cutting while sliding; tick: cost.
#pragma once

#include <array>
#include <string_view>

#include "tests/bench/options.h"
#include "tests/bench/removal_drill.h"
#include "tests/bench/rows.h"

namespace cusp::bench {

inline constexpr std::array<std::string_view, 9> kMeasures = {
    "speed", "mixed", "depth", "shape", "volume", "order", "slide", "ridge", "tick"};

/// The paper's materials, "respectively dentin, bone and enamel", with their speeds in mm/s.
struct RemovalTissue {
  Tissue tissue;
  double speed_mm_s;
};
inline constexpr std::array<std::string_view, 3> kRemovalTissues = {"dentine", "bone", "enamel"};
inline constexpr std::array<RemovalTissue, 3> kRemovalMaterials = {
    {{Tissue::dentine, 1.2}, {Tissue::bone, 0.8}, {Tissue::enamel, 0.5}}};

/// The 26 directions of a voxel's neighbours, by name: "-z", "+x-y", "-x+y+z".
struct Direction {
  std::string name;
  Vec3 unit{0.0};
  int axes = 1;  // that it goes along at once
};
const std::vector<Direction>& directions();
std::vector<std::string> direction_names();

/// Burs whose speed is measured: 0.5, 1.0 and 2.3 mm round ones, led tip first, and a fissure of 1.0 mm, tip first and
/// sideways.
std::vector<Cutter> removal_cutters();

/// The burs whose shape and volume are looked at: the round ones of `speed`, and of every other shape in the catalogue
/// one of middling size; or all of the catalogue. Their names hold the shape's key.
enum class BurSet : std::uint8_t { one_per_shape, whole_catalogue };
std::vector<Cutter> shape_cutters(BurSet burs);

/// A ball of every diameter that the catalogue has round burs of, smallest first: the ridge is kept under each.
std::vector<Cutter> ridge_cutters();

inline constexpr double kPaperVoxelMm = 10.0 / 128;
inline constexpr double kLargestBurMm = 2.3;

/// A run in one material all over, at one push.
DrillRun run_in(Method method, const Cutter& cutter, double voxel_mm, const RemovalTissue& material, double alpha);

/// The runs of `speed`, before they are run: every pair of factors, or the full product.
std::vector<DrillRun> speed_runs(const Options& options, Method method);

/// The paper's perforation: through 3.33 mm of each material in a cube of 10 mm, every 25 ms. No clock: the same everywhere.
inline constexpr double kLayerMm = 10.0 / 3.0;
inline constexpr double kDepthBurMm = 0.5;  // "0.5 mm spherical drill bit", read as the larger of the two that it can mean
void add_depths(Method method, std::vector<Row>& rows);

std::vector<Row> removal_rows(const Options& options);
int run_removal(const Options& options);

}  // namespace cusp::bench
