/// Everything that is wrong or doubtful about a scenario, at once: the schema's complaints, the reader's, and what only
/// shows when the values are seen together. The editor's checks, `cusp validate` and the tests of the library use it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

enum class Severity : std::uint8_t { warning, error };

struct Finding {
  Severity severity = Severity::error;
  std::string path;                    // JSON pointer
  std::string code;                    // "bands_not_ordered", or a key of FormatError
  std::map<std::string, double> args;  // numbers of the sentence: "value", "limit"; of out_of_range "least", "most"
  std::string detail;                  // a key that the sentence names, or the schema library's message
};

/// What is known of the specimen when it has been built; without it the checks that need it are left out.
struct SpecimenFacts {
  Vec3 low_mm{0.0}, high_mm{0.0};  // box of the tissue, specimen frame
  double voxel_mm = 0.1;
  std::vector<Tissue> tissues;  // that occur in it
};

/// Facts of a dense volume; one pass over it.
SpecimenFacts facts_of(const VoxelVolume& volume);

/// The voxel size that an exercise on a volume of these voxels states, mm; nullopt if an exercise can hold none of them.
/// A file's 32-bit 0.04 lies 9e-10 below the least of ranges.h: it is that least.
std::optional<double> stated_voxel_mm(double voxel_mm) noexcept;

/// Errors first, then warnings; empty when all is well. Every number is held against ranges.h (out_of_range, not_finite).
/// Codes besides those of FormatError and "schema":
/// errors: no_instrument, no_target, path_count, point_count, empty_target, no_direction (an axis of no length, or a box
///   whose axes are parallel), target_endless (a half-space alone), target_tissue_missing (a leaf of a tissue that the exercise or
///   the specimen does not have), lesion_missing (a leaf of a lesion without one),
///   nothing_protected (protected_damage fails the attempt, and nothing is protected), critical_twice (detail: the event that the
///   rubric names twice), no_criteria, weight_zero, bands_not_ordered,
///   pass_unreachable, protected_missing (pulp_exposure needs pulp protected; a protected tissue must be a tissue of
///   the exercise and occur in the specimen), two_spindles, spindle_missing (vibration and sound need one), heat_missing (a
///   criterion or critical event of coolant in an exercise without heat), ridge_of_plastic (a marginal ridge is
///   graded on a tooth of plastic between neighbours of plastic); with a specimen: tissue_missing, target_outside,
///   voxel_mismatch, landmark_outside (more than 1 mm beside the tooth's box);
/// warnings: bur_not_of_number (named by a number of the catalogue that has another head or diameter; "limit": that
///   diameter, mm), feature_thin (below 2.5 voxels), bur_small (radius below 3 voxels), head_short (below 6),
///   neck_wider_than_ball, bur_wider_than_target, bur_short (no shank goes into the outline, and no neck is as long as it
///   is deep), corner_below_bur, leeway_below_voxel, point_off_floor, target_scores_less (an attempt that meets the target
///   loses points), bands_without_edge (whatever is measured earns full points), weight_vanishes (a criterion
///   brings no point that shows), language_missing, nothing_can_be_cut,
///   protected_twice (protected_removed counts it twice; detail: the tissue, or "region"), wall_of_other_side (a mesial or
///   distal wall of the target stands on the other side of the tooth), sides_unknown (the target names them on a file
///   without a number or mesial axis), tooth_turned (by its landmarks: measures by side are not measurable), tooth_tilted
///   (by its long axis); with a specimen: tissue_unused.
std::vector<Finding> validate(const Scenario& scenario, const SpecimenFacts* specimen = nullptr);

/// Read, then validate(scenario), then what the schema minds besides, errors first. A text that does not read yields its
/// reasons and stops there.
std::vector<Finding> validate_text(std::string_view text, const SpecimenFacts* specimen = nullptr);

bool has_error(const std::vector<Finding>& findings) noexcept;

}  // namespace cusp::scenarios
