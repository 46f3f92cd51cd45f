/// A scenario: the authored exercise, as values. Read from and written to scenario.json (scenario.schema.json is
/// its JSON Schema); units are in the names. The interface calls it "exercise".
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/vec.h"
#include "engine/scene/scene.h"
#include "scenarios/format/landmark.h"
#include "scenarios/format/region.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Text by language code ("en", "de", "pt_BR"); "en" is always there.
using LocalText = std::map<std::string, std::string>;

/// A carious lesion on a grown tooth; fields as in scenarios/teeth/caries.h.
struct LesionSource {
  std::string kind = "fissure";  // key of kLesionKeys
  std::string site = "central";  // pit, fissure or side
  double radius_mm = 0.8, depth_mm = 1.0, softness = 0.7;
  friend bool operator==(const LesionSource&, const LesionSource&) = default;
};

/// Where the voxels come from: a generator, or a volume file beside scenario.json.
struct SpecimenSource {
  std::string generator;   // "paper-block", "block", "tooth"; empty = from file
  int fdi = 0;             // tooth: FDI number, 11..48
  std::uint64_t seed = 0;  // tooth: natural variation, below 2^53; 0 = the average
  double voxel_mm = 0.1;
  std::string volume;  // file name beside scenario.json (NRRD), when generator is empty
  bool typodont = false;            // tooth: of plastic, as in a training model
  std::vector<std::string> around;  // tooth: what stands about it, keys of kAroundKeys
  std::vector<LesionSource> lesions;
  SpecimenLandmarks landmarks;      // of a tooth from a file
  /// FDI number of a tooth of Cusp's own; 0 of any other specimen.
  int grown_fdi() const noexcept { return generator == "tooth" ? fdi : 0; }
  /// FDI number of any tooth: of one from a file as its author stated it. 0 of a block, and where nobody stated one.
  int tooth_number() const noexcept { return generator.empty() ? landmarks.fdi : grown_fdi(); }
  /// Whether the tooth and its neighbours are of one plastic: nobody knows where it ends between them.
  bool is_one_with_neighbours() const noexcept {
    for (const std::string& key : around)
      if (key == "neighbours" || key == "jaw") return typodont;
    return false;
  }
  friend bool operator==(const SpecimenSource&, const SpecimenSource&) = default;
};

/// One tissue of the exercise: stiffness and drilling speed. Its look and sound: scenarios/tissues.
struct ScenarioTissue {
  Tissue tissue = Tissue::enamel;
  double stiffness_n_per_mm = 1.0;
  double speed_mm_s = 1.0;
  friend bool operator==(const ScenarioTissue&, const ScenarioTissue&) = default;
};

/// The template that fitted the target to its tooth, and the values that its author set (scenarios/templates).
struct TemplateUse {
  std::string key;                       // "class-2-adhesive"
  std::map<std::string, double> values;  // by parameter; one that is left out has the template's default for the tooth
  friend bool operator==(const TemplateUse&, const TemplateUse&) = default;
};

/// Width of the tolerance zone about the target, by face.
struct Leeway {
  double floor_mm = 0.3;              // of floors that `faces` does not name
  double side_mm = 0.3;               // of walls that it does not name
  std::map<FaceName, double> faces{};  // mm
  double of(FaceName face) const noexcept {
    if (faces.empty()) return is_floor(face) ? floor_mm : side_mm;
    const auto own = faces.find(face);
    return own != faces.end() ? own->second : is_floor(face) ? floor_mm : side_mm;
  }
  double most() const noexcept {
    double out = floor_mm > side_mm ? floor_mm : side_mm;
    for (const auto& [face, mm] : faces) out = mm > out ? mm : out;
    return out;
  }
  friend bool operator==(const Leeway&, const Leeway&) = default;
};

/// Full points in [ideal_lo, ideal_hi], sinking in a straight line to half at acc_*, to none at fail_* (dental.md 2.4).
struct Bands {
  double fail_lo = 0, acc_lo = 0, ideal_lo = 0, ideal_hi = 0, acc_hi = 0, fail_hi = 0;
  friend bool operator==(const Bands&, const Bands&) = default;
};

struct Criterion {
  std::string metric;  // key of scenarios/format/keys.h ("target_removed", "depth_mean", "removed_enamel", ...)
  double weight = 10;  // share of the score, > 0; weights need not sum to 100
  Bands bands;
  int needs_dof = 3;  // axes that a device must sense to express it; by fewer it is measured and brings no points
  friend bool operator==(const Criterion&, const Criterion&) = default;
};

struct Rubric {
  double pass = 70;  // of 100
  std::vector<Criterion> criteria;
  std::vector<std::string> critical;  // "pulp_exposure", ...: fails the attempt, the score stays
  friend bool operator==(const Rubric&, const Rubric&) = default;
};

/// What counts as damage of a protected tissue or region.
enum class Damage : std::uint8_t {
  removal,  // some of it is gone
  touch,    // it lies bare: what covered it is gone
  depth     // a region was cut deeper than depth_mm
};
inline constexpr std::array<std::string_view, 3> kDamageKeys = {"removal", "touch", "depth"};

/// A tissue, or a region, that an attempt is to spare. Damage is the critical event "protected_damage" where the rubric
/// lists it.
struct Protected {
  Protected(Tissue of, Damage least = Damage::removal) : tissue(of), severity(least) {}
  explicit Protected(Region of, Damage least = Damage::removal) : region(std::move(of)), severity(least) {}
  std::optional<Tissue> tissue;  // else the region
  std::optional<Region> region;
  Damage severity;
  double depth_mm = 0;  // severity depth
  friend bool operator==(const Protected&, const Protected&) = default;
};

/// What an exercise asks of a student; its author's judgement.
enum class Level : std::uint8_t { beginner, intermediate, advanced };
inline constexpr std::array<std::string_view, 3> kLevelKeys = {"beginner", "intermediate", "advanced"};

struct DeviceNeeds {
  int needs_dof = 3;
  std::vector<std::string> admitted;  // device classes; empty = all
  double full_force_n = 1.5;
  friend bool operator==(const DeviceNeeds&, const DeviceNeeds&) = default;
};

struct Scenario {
  int format = 2;  // kScenarioFormat; what is read of format 1 is brought to it
  ScenarioId id;
  int version = 1;
  std::string key;  // built-in id ("paper-block"), else empty
  LocalText title, briefing;
  std::optional<Level> level;             // nullopt: not stated
  double expected_time_s = 0;             // that a student needs; 0: not stated; no criterion
  bool self_assessment = false;           // the student rates each criterion before the result is shown
  std::optional<TemplateUse> made_with;   // nullopt: drawn by hand; what was edited since may differ from it
  SpecimenSource specimen;
  std::vector<ScenarioTissue> tissues;
  std::vector<Bur> instruments;
  DeviceNeeds device;
  Method method = Method::surface;
  std::vector<std::string> phenomena;  // kPhenomenonKeys of scenarios/format/keys.h
  Region target;
  Leeway leeway;
  std::vector<Protected> protected_parts;
  double time_limit_s = 0;                // 0 = none
  double tool_tilt_deg = 0;               // of the tool axis at rest, from vertical towards buccal
  double tool_turn_deg = 0;               // how far the student may turn it from there; 0: not at all
  Rubric rubric;
  double tolerance_points = 2;  // largest change of the grade that an audit accepts
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// The tissue that a part protects, by itself or as a region of it; nullopt of any other region.
inline std::optional<Tissue> whole_tissue(const Protected& part) noexcept {
  return part.region && part.region->kind == RegionKind::tissue ? std::optional(part.region->tissue) : part.tissue;
}

inline bool is_protected(const Scenario& scenario, Tissue tissue) noexcept {
  for (const Protected& one : scenario.protected_parts)
    if (whole_tissue(one) == tissue) return true;
  return false;
}

}  // namespace cusp::scenarios
