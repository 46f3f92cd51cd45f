/// A bur led into a face of a small block of tissue: the device point is held ahead of it so that the wear coefficient
/// stays the same, and how fast it goes is read off the surface that is left.
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
  std::string name;      // "round 1.0", with the diameter that a person knows it by
  Bur bur;
  Feed feed = Feed::tip_first;
  double flank_mm = 0.0;  // of a straight fissure: the head's length; 0: a ball
};
/// Of a neck that is to stay out of the way.
inline constexpr double kThinNeckMm = 0.02;
/// A ball of this diameter, led tip first.
Cutter round_cutter(double diameter_mm);

/// A straight fissure with a head of kFissureMm, led tip first or sideways.
inline constexpr double kFissureMm = 1.2;
Cutter fissure_cutter(double diameter_mm, Feed feed);

/// F_full of the bench's scenes, N: 0.25 mm of spring at the stiffness of every tissue there, 1 N/mm.
inline constexpr double kFullForceN = 0.25;
inline constexpr double kStrokeMm = 0.5;
/// Of the stroke, before the clock starts.
inline constexpr double kRunIn = 0.05;

/// What one run is of.
struct DrillRun {
  Method method = Method::surface;
  Cutter cutter;
  double voxel_mm = 0.1;
  double tick_ms = 1.0;
  Vec3 direction{0.0, 0.0, -1.0};  // unit
  double alpha = 1.0;
  std::function<Tissue(Vec3)> tissue = [](Vec3) { return Tissue::dentine; };  // the face passes through the origin
  std::array<double, kTissueCodes> speed_mm_s{};
  double target_mm_s = 1.0;  // what the speed should be: how long the run is
  double stroke_mm = kStrokeMm;
};

/// What it came to; kAbsent where there is nothing to read.
struct DrillSpeed {
  double by_volume_mm_s;   // of what is gone (cut_volume), as the depth of a bur that takes so much
  double by_deepest_mm_s;  // of the deepest place of the surface, on the bur's own line
  double volume_error_percent;  // of the volume lost in the whole stroke against the exact swept bur's, at the depth reached
  double target_mm_s;      // the run's, or what a hand's push came to
  std::int64_t ticks;
};

/// The block that a run is drilled in: half a ball of tissue with its flat face across `direction`, through the origin.
std::shared_ptr<Scene> drill_scene(const DrillRun& run);
/// What the bur takes from behind the face when it has gone `depth_mm` into it; closed form. Pre: sideways, at most its
/// radius deep.
double closed_form_mm3(const Cutter& cutter, double depth_mm);

/// Full speed of a ball on that way, by what of each tissue its front has before it between the run-in and the end: the
/// harmonic mean over the voxels that it meets, for a specimen knows its tissues by the voxel.
double front_of_voxels_mm_s(const DrillRun& run);

DrillSpeed drill(const DrillRun& run);

}  // namespace cusp::bench
