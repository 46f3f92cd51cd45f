/// What an import did to a file that its owner should know. Codes and numbers; ui makes sentences of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::scenarios {

enum class RemarkCode : std::uint8_t {
  resampled,         // numbers: the file's spacing along x, y, z and the voxels' edge, mm
  straightened,      // oblique axes; numbers: degrees
  spacing_assumed,   // the file has no length
  identity_left_out, // of a CT: only what the picture needs was read
  one_of_series,     // numbers: series in the folder, slices read
  points_joined,     // subject: mesh; numbers: how many
  triangles_dropped, // subject: mesh; numbers: how many
  triangles_turned,  // subject: mesh; numbers: how many
  holes_closed,      // subject: mesh; numbers: how many, the widest in mm
  components_removed,  // numbers: voxels
  hollows_filled,    // numbers: voxels
  shell_capped,      // an open shell was closed; subject: mesh; numbers: mm² of caps, share of the mesh's own area, tissue
  precedence,        // subject: mesh; numbers: its place (1 wins over all others), its tissue, 1 when the user gave the order
  parts_overlap,     // subject: mesh that got it, other: mesh that did not; numbers: mm³, their tissues
  part_within,       // the same, where the subject lies in the other whole
  size_odd,          // no length of a tooth; numbers: mm, then the factors that would make it one
  sides_assumed,     // the file does not state which way its axes run: the specimen may be mirrored
  inside_out,        // all of a mesh was wound inwards, as a mirrored one is; subject: mesh
};
inline constexpr std::array<std::string_view, 18> kRemarkKeys = {
    "resampled",         "straightened",     "spacing_assumed", "identity_left_out", "one_of_series", "points_joined",
    "triangles_dropped", "triangles_turned", "holes_closed",    "pieces_removed",    "hollows_filled",
    "shell_capped",      "precedence",       "parts_overlap",   "part_within",       "size_odd",
    "sides_assumed",     "inside_out"};

struct ImportRemark {
  RemarkCode code;
  std::string subject{};
  std::vector<double> numbers{};
  std::string other{};
  friend bool operator==(const ImportRemark&, const ImportRemark&) = default;
};

constexpr std::string_view key_of(RemarkCode code) noexcept { return kRemarkKeys[static_cast<std::size_t>(code)]; }
constexpr std::optional<RemarkCode> remark_from_key(std::string_view key) noexcept {
  for (std::size_t i = 0; i < kRemarkKeys.size(); ++i) {
    if (kRemarkKeys[i] == key) return static_cast<RemarkCode>(i);
  }
  return std::nullopt;
}

}  // namespace cusp::scenarios
