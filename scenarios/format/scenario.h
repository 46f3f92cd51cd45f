/// A scenario: the authored exercise, as values. Read from and written to scenario.json (scenario.schema.json is
/// its JSON Schema); units are in the names. The interface calls it "exercise".
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/vec.h"
#include "engine/scene/scene.h"
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
  friend bool operator==(const SpecimenSource&, const SpecimenSource&) = default;
};

/// One tissue of the exercise: stiffness and drilling speed. Its look and sound: scenarios/tissues.
struct ScenarioTissue {
  Tissue tissue = Tissue::enamel;
  double stiffness_n_per_mm = 1.0;
  double speed_mm_s = 1.0;
  friend bool operator==(const ScenarioTissue&, const ScenarioTissue&) = default;
};

/// A cavity as an instructor draws it: an outline on the occlusal plane, swept down to a floor.
struct Target {
  /// "channel": a straight slot between two points; "outline": the union of slots along `path` polylines
  /// (a class I follows the fissures); "box": an axis-aligned box.
  std::string shape = "channel";
  std::vector<std::vector<Vec3>>
      paths;                      // mm; each polyline runs along the middle of the floor (channel: 1 of 2 points)
  double width_mm = 1.2;          // of the slot, wall to wall
  double depth_mm = 2.0;          // from `top_mm` down to the floor
  double top_mm = 0.0;            // height of the reference plane (block: its face; tooth: the central pit)
  double corner_radius_mm = 0.5;  // rounding between wall and floor (the bur's radius)
  Vec3 box_size_mm{0.0};          // shape "box": x, y extents about paths[0][0]; z ignored
  friend bool operator==(const Target&, const Target&) = default;
};

struct Leeway {
  double floor_mm = 0.3;
  double side_mm = 0.3;
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
  friend bool operator==(const Criterion&, const Criterion&) = default;
};

struct Rubric {
  double pass = 70;  // of 100
  std::vector<Criterion> criteria;
  std::vector<std::string> critical;  // "pulp_exposure", ...: fails the attempt, the score stays
  friend bool operator==(const Rubric&, const Rubric&) = default;
};

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
  SpecimenSource specimen;
  std::vector<ScenarioTissue> tissues;
  std::vector<Bur> instruments;
  DeviceNeeds device;
  Method method = Method::surface;
  std::vector<std::string> phenomena;  // kPhenomenonKeys of scenarios/format/keys.h
  Target target;
  Leeway leeway;
  std::vector<Tissue> protected_tissues;  // touching one is recorded, removing it is critical if the rubric lists it
  double time_limit_s = 0;                // 0 = none
  double tool_tilt_deg = 0;               // of the tool axis at rest, from vertical towards buccal
  double tool_turn_deg = 0;               // how far the student may turn it from there; 0: not at all
  Rubric rubric;
  double tolerance_points = 2;  // largest change of the grade that an audit accepts
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

}  // namespace cusp::scenarios
