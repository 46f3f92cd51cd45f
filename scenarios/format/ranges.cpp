#include "scenarios/format/ranges.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "scenarios/format/json_text.h"
#include "scenarios/format/migrate.h"

namespace cusp::scenarios {
namespace {

constexpr std::string_view kPlace = "a metre: no specimen is larger, and 0.1 µm steps of it fit 32 bits";
constexpr std::string_view kHead = "a head lies within its bur's figures";
constexpr std::string_view kBand = "any figure that a measure can have, and an open end";
constexpr std::string_view kThin = "a needle's tip is 0.1 mm wide; the widest wheel 10 mm [M]";
constexpr std::string_view kFloorReach = "a shell thicker than half a crown tolerates everything";

constexpr std::string_view kTaper = "walls of a preparation lean by less than 15 degrees; twice that";
constexpr std::string_view kShapeSize = "two voxels of the finest grid to the largest imported specimen's";

constexpr auto kRanges = std::to_array<NumberRange>({
    {"/format", "", kScenarioFormat, kScenarioFormat, false, "older ones are migrated before"},
    {"/version", "", 1, 1e9, false, "counts from 1; fits 32 bits"},
    {"/expected_time_s", "s", 10, 86400, true, "0: not stated; in less nobody reaches the tooth; a day"},
    {"/template/values/*/value", "", -1000, 1000, false, "of any unit; the template has a range for each"},
    {"/specimen/fdi", "", 11, 48, false, "FDI numbers of permanent teeth"},
    {"/specimen/seed", "", 0, 9007199254740991.0, false, "2^53 - 1: every JSON reader keeps it"},
    {"/specimen/voxel_mm", "mm", 0.04, 1, false, "the finest grid of a molar that fits memory; coarser no bur is resolved"},
    {"/specimen/landmarks/fdi", "", 11, 48, false, "FDI numbers of permanent teeth"},
    {"/specimen/landmarks/marks/*/points_mm/*/*", "mm", -1000, 1000, false, kPlace},
    {"/specimen/lesions/*/radius_mm", "mm", 0.2, 4, false, "two voxels to half a crown (scenarios/teeth/caries.h)"},
    {"/specimen/lesions/*/depth_mm", "mm", 0, 5, false, "from enamel alone to the pulp (scenarios/teeth/caries.h)"},
    {"/specimen/lesions/*/softness", "", 0, 1, false, "a share"},
    {"/tissues/*/stiffness_n_per_mm", "N/mm", 0.05, 20, false,
     "softer than a sixth of gums is not felt over a device's friction; no device renders more than 20"},
    {"/tissues/*/speed_mm_s", "mm/s", 0.01, 100, true,
     "0: cannot be cut; slower takes minutes for a tenth of a millimetre; faster is a voxel a tick"},
    {"/instruments/*/radius_mm", "mm", 0.05, 5, false, kThin},
    {"/instruments/*/neck_radius_mm", "mm", 0.05, 5, false, kThin},
    {"/instruments/*/neck_length_mm", "mm", 0, 50, false, "a surgical bur is 50 mm long [M]"},
    {"/instruments/*/shank_radius_mm", "mm", 0.05, 5, false, kThin},
    {"/instruments/*/shank_length_mm", "mm", 0, 100, false, "a surgical handpiece's shank [M]"},
    {"/instruments/*/head/*/*", "mm", -50, 50, false, kHead},
    {"/device/needs_dof", "", 3, 6, false, "axes of a body in space; three place the tip"},
    {"/device/full_force_n", "N", 0.1, 20, false,
     "below the friction of a device every touch is a full push; no desktop device gives more than 20 N"},
    {"/device/tool_tilt_deg", "deg", -80, 80, false, "short of lying: the neck would be the first to touch"},
    {"/device/tool_turn_deg", "deg", 0, 60, false, "what a wrist turns a handpiece [M]"},
    {"/target/paths/*/*/*", "mm", -1000, 1000, false, kPlace},
    {"/target/width_mm", "mm", 0.1, 100, false, "the thinnest bur's width to the largest imported specimen's"},
    {"/target/depth_mm", "mm", 0.1, 100, false, "two voxels of the finest grid to the largest imported specimen's"},
    {"/target/top_mm", "mm", -1000, 1000, false, kPlace},
    {"/target/corner_radius_mm", "mm", 0, 5, false, "a flat end leaves none; the widest bur's radius"},
    {"/target/box_size_mm/*", "mm", 0, 1000, false, kPlace},
    {"/target/taper_deg/x_low", "deg", -30, 30, false, kTaper},
    {"/target/taper_deg/x_high", "deg", -30, 30, false, kTaper},
    {"/target/taper_deg/y_low", "deg", -30, 30, false, kTaper},
    {"/target/taper_deg/y_high", "deg", -30, 30, false, kTaper},
    {"/target/from_mm/*", "mm", -1000, 1000, false, kPlace},
    {"/target/to_mm/*", "mm", -1000, 1000, false, kPlace},
    {"/target/size_mm/*", "mm", 0.1, 100, false, kShapeSize},
    {"/target/radius_mm", "mm", 0, 100, false, kShapeSize},
    {"/target/end_radius_mm", "mm", 0, 100, false, kShapeSize},
    {"/target/x_axis/*", "", -1000, 1000, false, "a direction; its length is of no account"},
    {"/target/z_axis/*", "", -1000, 1000, false, "a direction; its length is of no account"},
    {"/target/rounding_mm", "mm", 0, 5, false, "the widest bur's radius"},
    {"/target/by_mm", "mm", -5, 5, false, "half a crown"},
    {"/leeway/faces/pulpal_floor", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/mesial_wall", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/distal_wall", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/buccal_wall", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/lingual_wall", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/gingival_floor", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/axial_wall", "mm", 0, 5, false, kFloorReach},
    {"/leeway/faces/side_wall", "mm", 0, 5, false, kFloorReach},
    {"/protected/*/depth_mm", "mm", 0, 10, false, "a crown's height"},
    {"/leeway/floor_mm", "mm", 0, 5, false, kFloorReach},
    {"/leeway/side_mm", "mm", 0, 5, false, kFloorReach},
    {"/limits/time_s", "s", 10, 86400, true, "0: none; in less nobody reaches the tooth; a day"},
    {"/rubric/pass", "", 1, 100, false, "of 100; at 0 whoever opens the exercise passes it"},
    {"/rubric/criteria/*/weight", "", 0.1, 1000, false, "what earns nothing is no criterion; four figures suffice for a share"},
    {"/rubric/criteria/*/needs_dof", "", 3, 6, false, "axes of a body in space; three place the tip"},
    {"/rubric/criteria/*/bands/fail_lo", "", -1e6, 1e6, false, kBand},
    {"/rubric/criteria/*/bands/acc_lo", "", -1e6, 1e6, false, kBand},
    {"/rubric/criteria/*/bands/ideal_lo", "", -1e6, 1e6, false, kBand},
    {"/rubric/criteria/*/bands/ideal_hi", "", -1e6, 1e6, false, kBand},
    {"/rubric/criteria/*/bands/acc_hi", "", -1e6, 1e6, false, kBand},
    {"/rubric/criteria/*/bands/fail_hi", "", -1e6, 1e6, false, kBand},
    {"/tolerance/points", "", 0, 20, false, "of 100; more than a fifth would call any model the same"},
});

/// The next step of a pointer, without its '/'; `rest` is what follows.
std::string_view next_step(std::string_view& rest) noexcept {
  rest.remove_prefix(1);
  const std::string_view step = rest.substr(0, rest.find('/'));
  rest.remove_prefix(step.size());
  return step;
}

bool is_index(std::string_view step) noexcept {
  return !step.empty() && std::ranges::all_of(step, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_at(std::string_view path, std::string_view pointer) noexcept {
  while (path.starts_with('/') && pointer.starts_with('/')) {
    const std::string_view wanted = next_step(path), step = next_step(pointer);
    if (wanted == "*" ? !is_index(step) : wanted != step) return false;
  }
  return path.empty() && pointer.empty();
}

}  // namespace

std::string NumberRange::text() const {
  std::string out = or_zero ? "0 or [" : "[";
  json_text::append_number(out, least);
  out += ", ";
  json_text::append_number(out, most);
  return out + "]";
}

std::span<const NumberRange> number_ranges() noexcept { return kRanges; }

const NumberRange* range_of(std::string_view pointer) noexcept {
  // A part of a region holds what a target does, at any depth of its tree.
  std::string_view rest = pointer;
  constexpr std::string_view kProtected = "/protected/", kRegion = "/region", kTarget = "/target", kParts = "/parts/";
  if (rest.starts_with(kProtected) && rest.find(kRegion) != std::string_view::npos) rest.remove_prefix(rest.find(kRegion) + kRegion.size());
  else if (rest.starts_with(kTarget)) rest.remove_prefix(kTarget.size());
  else rest = {};
  if (!rest.empty()) {
    while (rest.starts_with(kParts)) {
      rest.remove_prefix(kParts.size());
      while (!rest.empty() && rest.front() != '/') rest.remove_prefix(1);
    }
    const auto own = std::ranges::find_if(kRanges, [&](const NumberRange& r) {
      return r.path.starts_with(kTarget) && is_at(r.path.substr(kTarget.size()), rest);
    });
    if (own != kRanges.end()) return &*own;
  }
  const auto it = std::ranges::find_if(kRanges, [&](const NumberRange& r) { return is_at(r.path, pointer); });
  return it == kRanges.end() ? nullptr : &*it;
}

}  // namespace cusp::scenarios
