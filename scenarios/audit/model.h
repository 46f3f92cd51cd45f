/// What an audit changes of an exercise: one modelling choice at a time, halved or left out. Pure values; any thread.
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
  tilt,       // how far the hand may turn the handpiece, degrees
};
std::string_view key_of(Aspect aspect) noexcept;

/// One choice and what stands instead of it. Of voxel, band and tilt the figures say what; of all others 1 is "there" and
/// 0 "left out".
struct Choice {
  Aspect aspect = Aspect::voxel;
  std::string subject;
  double as_set = 1;
  double instead = 0;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// An exercise and what of its model no scenario.json can say.
struct Model {
  Scenario scenario;
  double band_voxels = kBandVoxels;
  bool near_target_only = false;
  std::vector<Tissue> left_out = {};  // become the tissue that they touch most
  friend bool operator==(const Model&, const Model&) = default;
};

/// The model with the choice made.
[[nodiscard]] Model with(Model model, const Choice& choice);

/// A generated volume as the model wants it: tissues merged, distances clamped to the narrower band, cropped to the region.
/// One to three passes over the voxels.
[[nodiscard]] VoxelVolume prepared(VoxelVolume volume, const Model& model);

/// Beyond target and leeway, and beyond the largest bur's radius, this much is kept of a specimen that is cropped: as far
/// as a hand that goes wrong may reach [M].
inline constexpr double kReachMm = 1.5;

}  // namespace cusp::scenarios
