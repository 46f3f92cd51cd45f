/// The modelling choices of an exercise, each halved or left out alone. Pure values; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// What can be chosen of a model.
enum class Aspect : std::uint8_t {
  voxel,      // edge of a voxel, mm
  band,       // half width of the distance band about the surface, voxels
  region,     // all of the specimen, or only what lies near the target
  around,     // what stands about a tooth; subject: key of kAroundKeys
  tissue,     // subject: its key; left out it becomes the tissue that it touches most
  friction,
  spindle,    // subject: its key among the phenomena; without it no vibration and no sound
  vibration,
  heat,
  tilt,       // how far the student may turn the handpiece, degrees
};
std::string_view key_of(Aspect aspect) noexcept;

/// One choice and its replacement. Voxel, band and tilt hold values; of all others 1 is present and 0 left out.
struct Choice {
  Aspect aspect = Aspect::voxel;
  std::string subject;
  double as_set = 1;
  double instead = 0;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// An exercise and the parts of its model that scenario.json has no key for.
struct Model {
  Scenario scenario;
  double band_voxels = kBandVoxels;
  bool near_target_only = false;
  std::vector<Tissue> left_out = {};  // become the tissue that they touch most
  friend bool operator==(const Model&, const Model&) = default;
};

/// The model with the choice made.
[[nodiscard]] Model with(Model model, const Choice& choice);

/// A generated volume changed as the model asks: tissues merged, distances clamped to the narrower band, cropped to the region.
/// One to three passes over the voxels.
[[nodiscard]] VoxelVolume prepared(VoxelVolume volume, const Model& model);

/// A cropped specimen keeps this much beyond target, tolerance zone and the largest bur's radius, mm: the reach of a
/// mistake [M].
inline constexpr double kReachMm = 1.5;

}  // namespace cusp::scenarios
