/// The keys of a scenario: metrics, critical events, generators, shapes, phenomena. Files and databases store them:
/// never rename one, only add. ui/text has a text for each.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/volume/tissue.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// A quantity that a rubric may ask for. Besides these, "removed_<tissue>" (mm3) for every tissue key but "empty".
struct MetricKey {
  std::string_view key;
  std::string_view unit;  // "%", "mm3", "mm", "deg", "s", "N", "K", "" for a yes (1) or no (0)
  double least = 0;       // values below or above cannot be measured; used to see whether points can be reached
  double most = 1e9;
};

inline constexpr std::array kMetricKeys = {
    MetricKey{"target_removed", "%", 0, 100},      // of the target's tissue that was there
    MetricKey{"overcut_leeway_floor", "mm3"},      // outside the target, inside the leeway, below its floor
    MetricKey{"overcut_leeway_side", "mm3"},
    MetricKey{"overcut_beyond_floor", "mm3"},      // over-cut outside the leeway
    MetricKey{"overcut_beyond_side", "mm3"},
    MetricKey{"uncut_remainder", "mm3"},           // of the target; "undercut" in format 1
    MetricKey{"depth_least", "mm"},                // of the floor, from the target's top_mm
    MetricKey{"depth_mean", "mm"},
    MetricKey{"depth_most", "mm"},
    MetricKey{"wall_angle_mesial", "deg", -45, 45},  // to the axis; positive: diverges occlusally
    MetricKey{"wall_angle_distal", "deg", -45, 45},
    MetricKey{"wall_angle_buccal", "deg", -45, 45},
    MetricKey{"wall_angle_lingual", "deg", -45, 45},
    MetricKey{"convergence_mesiodistal", "deg", -90, 90},  // of opposite walls, occlusally
    MetricKey{"convergence_buccolingual", "deg", -90, 90},
    MetricKey{"floor_flatness", "mm"},             // RMS about the floor's best plane
    MetricKey{"floor_tilt", "deg", 0, 45},         // of that plane
    MetricKey{"isthmus_width", "mm"},              // least buccolingual width at the occlusal cavosurface
    MetricKey{"ridge_mesial", "mm"},               // marginal ridge: wall to greatest proximal contour
    MetricKey{"ridge_distal", "mm"},
    MetricKey{"remaining_over_pulp", "mm"},        // least wall between the cavity and the pulp
    MetricKey{"protected_removed", "mm3"},         // of what the scenario protects
    MetricKey{"time", "s"},
    MetricKey{"force_peak", "N"},
    MetricKey{"force_mean", "N"},
    MetricKey{"dry_cutting_time", "s"},            // the bur worked without coolant; needs the phenomenon "heat"
    MetricKey{"temperature_rise_peak", "K"},       // likewise
    // Groups of dentistry.md; definitions in scenarios/metrics: volume.h, surface.h, box.h, margin.h,
    // unsupported.h, proximal.h, caries.h.
    MetricKey{"overcut_leeway_pulpal_floor", "mm3"},
    MetricKey{"overcut_leeway_mesial_wall", "mm3"},
    MetricKey{"overcut_leeway_distal_wall", "mm3"},
    MetricKey{"overcut_leeway_buccal_wall", "mm3"},
    MetricKey{"overcut_leeway_lingual_wall", "mm3"},
    MetricKey{"overcut_leeway_gingival_floor", "mm3"},
    MetricKey{"overcut_leeway_axial_wall", "mm3"},
    MetricKey{"overcut_leeway_side_wall", "mm3"},
    MetricKey{"overcut_beyond_pulpal_floor", "mm3"},
    MetricKey{"overcut_beyond_mesial_wall", "mm3"},
    MetricKey{"overcut_beyond_distal_wall", "mm3"},
    MetricKey{"overcut_beyond_buccal_wall", "mm3"},
    MetricKey{"overcut_beyond_lingual_wall", "mm3"},
    MetricKey{"overcut_beyond_gingival_floor", "mm3"},
    MetricKey{"overcut_beyond_axial_wall", "mm3"},
    MetricKey{"overcut_beyond_side_wall", "mm3"},
    MetricKey{"surface_within_100", "%", 0, 100},
    MetricKey{"surface_within_200", "%", 0, 100},
    MetricKey{"surface_within_300", "%", 0, 100},
    MetricKey{"surface_within_400", "%", 0, 100},
    MetricKey{"surface_within_500", "%", 0, 100},
    MetricKey{"surface_rms", "mm"},
    MetricKey{"surface_p95", "mm"},
    MetricKey{"surface_greatest", "mm"},
    MetricKey{"gingival_above_cej", "mm", -20, 20},
    MetricKey{"box_height", "mm", -20, 20},
    MetricKey{"axial_past_junction_least", "mm", -20, 20},  // below 0: still in enamel
    MetricKey{"axial_past_junction_mean", "mm", -20, 20},
    MetricKey{"axial_past_junction_most", "mm", -20, 20},
    MetricKey{"cavosurface_angle", "deg", 0, 180},
    MetricKey{"cavosurface_off", "%", 0, 100},
    MetricKey{"unsupported_enamel", "mm3"},
    MetricKey{"contact_broken", "", 0, 1},
    MetricKey{"clearance_buccal_gingival", "mm"},
    MetricKey{"clearance_buccal_middle", "mm"},
    MetricKey{"clearance_buccal_occlusal", "mm"},
    MetricKey{"clearance_lingual_gingival", "mm"},
    MetricKey{"clearance_lingual_middle", "mm"},
    MetricKey{"clearance_lingual_occlusal", "mm"},
    MetricKey{"clearance_gingival", "mm"},
    MetricKey{"gingival_floor_mesiodistal", "mm"},
    MetricKey{"caries_left_periphery", "mm3"},
    MetricKey{"caries_left_pulp", "mm3"},
    MetricKey{"caries_left_pulp_firm", "mm3"},
    MetricKey{"caries_left_enamel", "mm3"},
    MetricKey{"sound_lost", "mm3"},
};

/// Events that may fail an attempt whatever its score.
/// dry_cutting: the tooth came to the pulp's criterion (engine/removal/heat.h); needs the phenomenon "heat".
/// protected_damage: something protected was damaged at its severity (scenarios/metrics/protected_parts.h).
inline constexpr std::array<std::string_view, 3> kCriticalKeys = {"pulp_exposure", "dry_cutting", "protected_damage"};

/// "paper-block": three materials, 10 mm cube, 128^3 voxels; "block": plastic 20x20x10 mm; "layered-block": the same
/// with a hard layer above; "tooth": by FDI number.
inline constexpr std::array<std::string_view, 4> kGeneratorKeys = {"paper-block", "block", "layered-block", "tooth"};
/// What a tooth may have about it: the teeth that touch it; the soft tissue and the bone that they stand in; the rest of
/// its jaw, as scenery.
inline constexpr std::array<std::string_view, 4> kAroundKeys = {"neighbours", "gingiva", "bone", "jaw"};
inline constexpr std::array<std::string_view, 3> kLesionKeys = {"fissure", "proximal", "root"};
/// How an outline is drawn (region.h).
inline constexpr std::array<std::string_view, 3> kShapeKeys = {"channel", "outline", "box"};
/// At most one spindle; vibration and sound need one. "sound" is of no account to the step.
inline constexpr std::array<std::string_view, 7> kPhenomenonKeys = {
    "friction", "spindle-turbine", "spindle-electric", "spindle-slow", "vibration", "sound", "heat"};
inline constexpr std::array kMethods = {Method::occupancy, Method::occupancy_pivot, Method::ray,
                                        Method::penalty,   Method::gradient,        Method::surface};

/// "depth_mean@mesial_pit": a metric of one of several targets (named_targets of region.h). Of the whole target the name is empty.
struct MetricOfTarget {
  std::string_view metric, target;
};
constexpr MetricOfTarget split_metric(std::string_view key) noexcept {
  const std::size_t at = key.find('@');
  return at == std::string_view::npos ? MetricOfTarget{key, {}} : MetricOfTarget{key.substr(0, at), key.substr(at + 1)};
}
/// The key of `metric` of the target `target`; of the whole target `metric` itself.
inline std::string metric_key(std::string_view metric, std::string_view target) {
  return target.empty() ? std::string(metric) : std::string(metric).append("@").append(target);
}
/// A name of a target: a small letter, then small letters, digits and '_', 32 at most.
bool is_target_name(std::string_view name) noexcept;
/// Whether a metric can be of one of several targets: what is measured on its own cavity. Not time, force and heat, which are of the
/// attempt; not caries, contact and neighbours, which are of the tooth.
bool is_of_cavity(std::string_view metric) noexcept;

/// The metric of a key, with "removed_<tissue>" and those of one of several targets among them; nullopt when there is none.
std::optional<MetricKey> metric_from_key(std::string_view key) noexcept;

/// What the engine makes of a scenario's phenomena. Of several spindles the first counts.
Phenomena phenomena_from_keys(const std::vector<std::string>& keys) noexcept;
inline bool has_phenomenon(const std::vector<std::string>& keys, std::string_view key) noexcept {
  for (const std::string& one : keys)
    if (one == key) return true;
  return false;
}
/// The present key of a metric that a record or a file of format 1 names; any other key as it is.
inline std::string_view present_metric(std::string_view stored) noexcept {
  return stored == "undercut" ? std::string_view("uncut_remainder") : stored;
}
/// True for metrics and critical events that are only measured where the phenomenon "heat" is on.
bool needs_heat(std::string_view key) noexcept;

/// FDI numbers of permanent teeth: 11..18, 21..28, 31..38, 41..48.
constexpr bool is_fdi(int fdi) noexcept {
  return fdi / 10 >= 1 && fdi / 10 <= 4 && fdi % 10 >= 1 && fdi % 10 <= 8;
}

/// Key of a tissue in a scenario: the built-in keys, and "16" to "31" for a volume's own tissues.
std::optional<Tissue> scenario_tissue_from_key(std::string_view key) noexcept;
/// Pre: the code is below kTissueCodes and is not 13 to 15.
std::string_view key_of_scenario_tissue(Tissue tissue) noexcept;

}  // namespace cusp::scenarios
