/// drill() feeds a bur into the face of a small block of tissue. The device point stays ahead of the bur by a constant
/// spring length, which keeps the wear coefficient constant. The remaining surface gives the speed.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "engine/step/step.h"
#include "tests/modules.h"

namespace cusp::bench {

enum class Feed : std::uint8_t { tip_first, sideways };

/// A bur and the direction of its feed: along its axis or across it.
struct Cutter {
  std::string name;      // "round 1.0": shape and diameter in mm
  Bur bur;
  Feed feed = Feed::tip_first;
  double flank_mm = 0.0;  // head length of a straight fissure, mm; 0: a ball
};
/// mm; radius of a neck that touches nothing.
inline constexpr double kThinNeckMm = 0.02;
/// A ball of this diameter, tip first.
Cutter round_cutter(double diameter_mm);

/// A straight fissure with a head of kFissureMm.
inline constexpr double kFissureMm = 1.2;
Cutter fissure_cutter(double diameter_mm, Feed feed);

/// F_full of the bench's scenes, N: 0.25 mm of spring at 1 N/mm.
inline constexpr double kFullForceN = 0.25;
inline constexpr double kStrokeMm = 0.5;
/// Share of the stroke before the measured part.
inline constexpr double kRunIn = 0.05;

/// Settings of one drilling run.
struct DrillRun {
  Method method = Method::surface;
  Cutter cutter;
  double voxel_mm = 0.1;
  double tick_ms = 1.0;
  Vec3 direction{0.0, 0.0, -1.0};  // unit
  double alpha = 1.0;
  std::function<Tissue(Vec3)> tissue = [](Vec3) { return Tissue::dentine; };  // the face passes through the origin
  std::array<double, kTissueCodes> speed_mm_s{};
  double target_mm_s = 1.0;  // expected speed; sets the number of ticks
  double stroke_mm = kStrokeMm;
};

/// Result of a run; kAbsent if a reading is impossible.
struct DrillSpeed {
  double by_volume_mm_s;   // from removed volume, as the depth at which the exact bur removes as much
  double by_deepest_mm_s;  // from the deepest point of the surface on the bur's line
  double volume_error_percent;  // of the whole stroke against the exact swept bur at that depth
  double target_mm_s;      
  std::int64_t ticks;
};

/// The block that a run is drilled in: half a ball of tissue with its flat face across `direction`, through the origin.
std::shared_ptr<Scene> drill_scene(const DrillRun& run);
/// Volume behind the face that the bur removes at depth_mm; closed form. Pre: sideways at most its radius deep.
double closed_form_mm3(const Cutter& cutter, double depth_mm);

/// Expected full speed of a ball: the harmonic mean over the voxels ahead of its front between run-in and end. A
/// specimen knows its tissues by the voxel.
double front_of_voxels_mm_s(const DrillRun& run);

DrillSpeed drill(const DrillRun& run);

}  // namespace cusp::bench
