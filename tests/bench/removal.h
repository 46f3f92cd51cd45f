/// The verb `removal`: does the cut depend on push, tissue and bur alone, and not on voxel, tick and direction?
/// The remaining surface gives the answer. --measure names:
///   speed   drilling speed over all pairs of voxel, tick, direction, tissue, alpha and bur; --full: the whole product
///           for one bur and voxel
///   depth   through three materials, as the paper's figure 15
///   mixed   half of the bur in one tissue, half in another
///   shape, volume, order   known strokes of a bur of every shape (--full: every bur), in halves and at other ticks
///   slide, ridge   cutting while sliding
///   hole    widened in circles by each ball of the catalogue with its own neck: for how long a search does not end
///   tick    cost of a cutting tick
#pragma once

#include <array>
#include <string_view>

#include "tests/bench/options.h"
#include "tests/bench/removal_drill.h"
#include "tests/bench/rows.h"

namespace cusp::bench {

inline constexpr std::array<std::string_view, 10> kMeasures = {
    "speed", "mixed", "depth", "shape", "volume", "order", "slide", "ridge", "hole", "tick"};

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
  int axes = 1;  // number of axes with a component
};
const std::vector<Direction>& directions();
std::vector<std::string> direction_names();

/// Burs of `speed`: round ones of 0.5, 1.0 and 2.3 mm, tip first, and a fissure of 1.0 mm, tip first and sideways.
std::vector<Cutter> removal_cutters();

/// Burs of `shape` and `volume`. one_per_shape: the round ones of `speed` and one of middle size of every other shape.
/// Names contain the shape's key.
enum class BurSet : std::uint8_t { one_per_shape, whole_catalogue };
std::vector<Cutter> shape_cutters(BurSet burs);

/// A ball of every diameter of the catalogue's round burs, smallest first.
std::vector<Cutter> ridge_cutters();

inline constexpr double kPaperVoxelMm = 10.0 / 128;
inline constexpr double kLargestBurMm = 2.3;

/// A run in one material at one push.
DrillRun run_in(Method method, const Cutter& cutter, double voxel_mm, const RemovalTissue& material, double alpha);

/// The runs of `speed`: every pair of factors, or with --full the full product.
std::vector<DrillRun> speed_runs(const Options& options, Method method);

/// The paper's perforation: 3.33 mm of each material in a cube of 10 mm, a row every 25 ms. Deterministic.
inline constexpr double kLayerMm = 10.0 / 3.0;
inline constexpr double kDepthBurMm = 0.5;  // "0.5 mm spherical drill bit", read as the larger of the two that it can mean
void add_depths(Method method, std::vector<Row>& rows);
/// A block of plastic of 5 x 5 x 3.6 mm with its face at z = 0, and a bur with its own neck.
std::shared_ptr<Scene> hole_scene(const Bur& bur);
void add_holes(std::vector<Row>& rows);

std::vector<Row> removal_rows(const Options& options);
int run_removal(const Options& options);

}  // namespace cusp::bench
