/// By how much a limit was passed and what would keep it: the first line of an ImportFailure's detail, as text between the
/// import's process and its parent.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/vec.h"
#include "scenarios/import/limits.h"

namespace cusp::scenarios {

enum class LimitKind : std::uint8_t {
  voxels,       // of the specimen that was asked for
  edge,         // voxels of it along one axis
  file_voxels,  // the file's own, before anything is chosen of it
  file_edge,    // the file's own along one axis
  file_bytes,
  file_count,   // files of one series
  memory,       // bytes of the import's process
  processor,    // seconds
  wall,         // seconds by the clock
};
inline constexpr std::array<std::string_view, 9> kLimitKeys = {
    "voxels", "edge", "file_voxels", "file_edge", "file_bytes", "file_count", "memory", "processor", "wall"};

struct LimitFigures {
  LimitKind kind = LimitKind::voxels;
  double asked = 0.0;    // 0: not known, as of a process that was ended
  double allowed = 0.0;
  double fits_mm = 0.0;  // a voxel edge that would keep it; 0: none would
  friend bool operator==(const LimitFigures&, const LimitFigures&) = default;
};

std::string text_of(const LimitFigures& figures);
/// Of the first line; nullopt when it holds none.
std::optional<LimitFigures> limit_figures(std::string_view detail);

/// Bytes of a dense voxel: a tissue and a solid fraction.
inline constexpr double kBytesPerVoxel = 3.0;

/// Which limit a specimen of this size passes; nullopt: none. `extent_mm` is what its voxels of `voxel_mm` cover without
/// the padding: it computes the voxel that would fit.
std::optional<LimitFigures> passed_limit(Vec3 voxels, Vec3 extent_mm, double voxel_mm, const VolumeLimits& limits);
/// The same for a file's own voxels, as text; empty: it passes none.
std::string passed_file_limit(Vec3 voxels, const VolumeLimits& limits);

}  // namespace cusp::scenarios
