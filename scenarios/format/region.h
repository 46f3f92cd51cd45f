/// A region of the specimen: a tree whose leaves are plain shapes with named faces. Values only; scenarios/shapes makes
/// signed distances of them. Frame: specimen, right-handed, z up (occlusal). Millimetres and degrees.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Names of a preparation's faces. A wall belongs to the side of the tooth that it stands on; side_wall: of no named side.
enum class FaceName : std::uint8_t {
  pulpal_floor,
  mesial_wall,
  distal_wall,
  buccal_wall,
  lingual_wall,
  gingival_floor,
  axial_wall,
  side_wall
};
inline constexpr std::array<std::string_view, 8> kFaceKeys = {"pulpal_floor", "mesial_wall",    "distal_wall", "buccal_wall",
                                                              "lingual_wall", "gingival_floor", "axial_wall",  "side_wall"};
inline constexpr std::size_t kFaceNames = kFaceKeys.size();
constexpr bool is_floor(FaceName face) noexcept {
  return face == FaceName::pulpal_floor || face == FaceName::gingival_floor;
}
/// Keys of Outline::taper_deg.
inline constexpr std::array<const char*, 4> kTaperKeys = {"x_low", "x_high", "y_low", "y_high"};
constexpr std::string_view key_of(FaceName face) noexcept { return kFaceKeys[static_cast<std::size_t>(face)]; }

/// A cavity as an instructor draws it: an outline on the occlusal plane, swept up without end from its floor.
struct Outline {
  /// "channel": a straight slot between two points; "outline": the union of slots along `path` polylines
  /// (a class I follows the fissures); "box": an axis-aligned rectangle.
  std::string shape = "channel";
  std::vector<std::vector<Vec3>>
      paths;                      // mm; each polyline runs along the middle of the floor (channel: 1 of 2 points)
  double width_mm = 1.2;          // of the slot, wall to wall, where it is narrowest
  double depth_mm = 2.0;          // from `top_mm` down to the floor
  double top_mm = 0.0;            // height of the reference plane (block: its face; tooth: the central pit)
  double corner_radius_mm = 0.5;  // rounding between wall and floor (the bur's radius)
  Vec3 box_size_mm{0.0};          // shape "box": x, y extents about paths[0][0]; z ignored
  /// Lean of the walls on the sides -x, +x, -y, +y. Above 0: the wall opens upwards from the floor to top_mm; below 0:
  /// downwards from top_mm to the floor. Beyond these heights it is upright.
  std::array<double, 4> taper_deg{};
  friend bool operator==(const Outline&, const Outline&) = default;
};

enum class RegionKind : std::uint8_t {
  outline,
  box,
  cylinder,
  cone,
  sphere,
  capsule,
  ellipsoid,
  half_space,
  tissue,      // voxels of one tissue of the uncut specimen
  lesion,      // its carious voxels, down to a hardness
  joined,      // "union"
  common,      // "intersection"
  difference,  // the first part less the others
  offset       // its one part, grown outwards by by_mm
};
inline constexpr std::array<std::string_view, 14> kRegionKeys = {"outline",   "box",        "cylinder", "cone",   "sphere", "capsule",      "ellipsoid",
                                                                 "half-space", "tissue", "lesion",   "union", "intersection", "difference", "offset"};
constexpr std::string_view key_of(RegionKind kind) noexcept { return kRegionKeys[static_cast<std::size_t>(kind)]; }
/// Of the uncut specimen's voxels: nobody knows its place without them.
constexpr bool is_of_voxels(RegionKind kind) noexcept { return kind == RegionKind::tissue || kind == RegionKind::lesion; }
constexpr bool is_node(RegionKind kind) noexcept { return kind >= RegionKind::joined; }

/// How far a lesion goes: its soft tissue (carious enamel and soft carious dentine), or firm carious dentine too.
enum class Hardness : std::uint8_t { soft, firm };
inline constexpr std::array<std::string_view, 2> kHardnessKeys = {"soft", "firm"};

/// One leaf or node. Fields that its kind does not name stand at their defaults.
struct Region {
  RegionKind kind = RegionKind::outline;
  Outline outline;
  Vec3 from_mm{0.0};                   // centre of box, sphere, ellipsoid; first end of cylinder, cone, capsule; a point of the
                                       // half-space's plane
  Vec3 to_mm{0.0};                     // last end of cylinder, cone, capsule
  Vec3 size_mm{0.0};                   // extents of box and ellipsoid
  double radius_mm = 0;                // of cylinder, sphere, capsule; of the cone at its first end
  double end_radius_mm = 0;            // of the cone at its last end
  Vec3 x_axis{1.0, 0.0, 0.0};          // box: direction of size_mm.x; need not be of length 1
  Vec3 z_axis{0.0, 0.0, 1.0};          // box: direction of size_mm.z; half-space: out of it
  Tissue tissue = Tissue::empty;       // of the leaf tissue
  Hardness down_to = Hardness::firm;   // of the leaf lesion
  std::map<std::string, FaceName> faces;  // by face_slots(kind); those left out: default_face()
  double rounding_mm = 0;              // union, intersection, difference: radius at the edges between the parts
  double by_mm = 0;                    // offset
  std::string name;                        // of one of several targets, a direct part of the target's union; else empty
  std::map<std::string, std::string> title;  // its name for people, by language code
  std::vector<Region> parts;
  friend bool operator==(const Region&, const Region&) = default;
};

/// A region that is this outline alone.
inline Region region_of(Outline outline) {
  Region out;
  out.outline = std::move(outline);
  return out;
}
/// Faces of a leaf, by slot: "floor", "x_low", ... of an outline; none of a node.
std::span<const std::string_view> face_slots(RegionKind kind) noexcept;
/// Whether a leaf of the tree is of the specimen's voxels.
bool needs_voxels(const Region& region) noexcept;
/// Slot 0 of outline, box, cylinder and cone is the pulpal floor (it faces the deep end); any other a side_wall.
FaceName default_face(RegionKind kind, std::size_t slot) noexcept;
/// Several targets: the named parts of a union, first to last. Of any other region none.
std::vector<const Region*> named_targets(const Region& target);
/// The region's outlines, first to last; a lone outline is its own.
std::vector<const Outline*> outlines_of(const Region& region);

/// A tree has at most so many leaves and nodes: each query walks them all.
inline constexpr int kMostRegionParts = 64;

}  // namespace cusp::scenarios
