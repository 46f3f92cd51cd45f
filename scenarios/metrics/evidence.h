/// Which of many places shows a measure best: the pin on the tooth stands there. A place counts more the more of this
/// holds: its face is of the kind that the measure names (floor or wall), it lies a voxel inside the original surface, and
/// no tissue stands between it and whoever looks down the axis. Not for the haptic thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Lean of a face from level, above which it is a wall (dental.md 2.2): cosine of 45 degrees.
inline constexpr double kFloorCosine = 0.70710678;

enum class FaceKind : std::uint8_t { floor, wall, any };

/// A place on the cut surface.
struct Evidence {
  int rank = -1;  // -1: none; bits: 4 of the kind, 2 inside the original surface, 1 open from above
  double mm = 0;  // how far off
  Vec3 at_mm{0.0};
  bool found() const noexcept { return rank >= 0; }
  bool better_than(const Evidence& other) const noexcept { return rank != other.rank ? rank > other.rank : mm > other.mm; }
};
inline constexpr int kBestRank = 7;

/// Looks at faces of one volume's cut.
class FaceJudge {
 public:
  explicit FaceJudge(const Volume& volume) : volume_(volume) {}
  /// Takes the middle of a face for `best` if it shows the measure better. Cheap where it cannot.
  void offer(const std::array<Vec3, 3>& corners, FaceKind kind, double mm, Evidence& best) const noexcept;

 private:
  bool solid_at(Vec3 p) const noexcept;
  bool inside_original(Vec3 p) const noexcept;
  bool open_above(Vec3 p) const noexcept;

  const Volume& volume_;
};

/// The free surface above the tissue that stands deepest inside the target; nullopt where nothing stands in it.
[[nodiscard]] std::optional<Vec3> standing_place(const Reference& reference, const Volume& volume);

/// Where the pulp lies open: the face between a pulp voxel and a removed one, nearest to the middle of all such faces.
[[nodiscard]] std::optional<Vec3> exposed_pulp(const Reference& reference, const Volume& volume);

}  // namespace cusp::scenarios
