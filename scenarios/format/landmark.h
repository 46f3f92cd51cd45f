/// Landmarks of an imported tooth, as an exercise keeps them. A grown tooth has its own (scenarios/teeth/landmarks.h).
/// Frame: specimen. Millimetres.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

enum class MarkKind : std::uint8_t {
  long_axis,       // two points, the second occlusal of the first
  mesial_axis,     // two points, the second mesial of the first
  cusp_tip,        // a place
  pit,             // a place
  fissure,         // a line along its bottom, pit first
  marginal_ridge,  // a line along its crest
  contact,         // the most mesial or distal place of the crown
  contour,         // its most buccal or lingual place
  cej              // a closed line: the last point is the first
};
inline constexpr std::array<std::string_view, 9> kMarkKeys = {"long_axis",      "mesial_axis", "cusp_tip", "pit", "fissure",
                                                              "marginal_ridge", "contact",     "contour",  "cej"};
constexpr std::string_view key_of(MarkKind kind) noexcept { return kMarkKeys[static_cast<std::size_t>(kind)]; }

/// Who says so: the program, or the author.
enum class MarkState : std::uint8_t { proposed, set };
inline constexpr std::array<std::string_view, 2> kMarkStateKeys = {"proposed", "set"};
constexpr std::string_view key_of(MarkState state) noexcept { return kMarkStateKeys[static_cast<std::size_t>(state)]; }

struct Landmark {
  MarkKind kind = MarkKind::cusp_tip;
  std::string name;  // as a grown tooth names it: "MB", "central mesial"; of a contact or contour its side; of others empty
  std::vector<Vec3> points_mm;
  MarkState state = MarkState::proposed;
  friend bool operator==(const Landmark&, const Landmark&) = default;
};

struct SpecimenLandmarks {
  int fdi = 0;  // 0: of no known tooth
  std::vector<Landmark> marks;
  bool empty() const noexcept { return fdi == 0 && marks.empty(); }
  /// nullptr where there is none.
  const Landmark* find(MarkKind kind, std::string_view name = {}) const noexcept;
  friend bool operator==(const SpecimenLandmarks&, const SpecimenLandmarks&) = default;
};

/// How many points a landmark has.
struct PointCount {
  std::size_t least = 1, most = 1;
};
PointCount point_count(MarkKind kind) noexcept;
inline constexpr std::size_t kMostMarks = 64, kMostMarkPoints = 128;

/// Angle about z, right-handed, from where mesial lies in the frame of that tooth (x in quadrants 1 and 3, -x in 2 and 4) to
/// where it lies; -180 to 180. nullopt without a number or a mesial axis.
[[nodiscard]] std::optional<double> turn_deg(const SpecimenLandmarks& landmarks) noexcept;
/// Angle between the long axis and z, 0 to 180. nullopt without the axis.
[[nodiscard]] std::optional<double> tilt_deg(const SpecimenLandmarks& landmarks) noexcept;

/// Turned or tilted further, a tooth's sides and depths are not those of its frame, deg [M]: a wall's name changes at 45, and the axis
/// of inertia leans by up to 9 in an upright tooth (scenarios/landmarks).
inline constexpr double kMostTurnedDeg = 9.0, kMostTiltedDeg = 15.0;

}  // namespace cusp::scenarios
