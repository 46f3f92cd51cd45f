/// The shape of a Region: its tree evaluated to a signed distance and the nearest named face.
/// Frame: specimen. Millimetres. Immutable; any thread; no memory per query.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "scenarios/shapes/facing.h"
#include "scenarios/shapes/outline.h"
#include "scenarios/shapes/tissue_shape.h"

namespace cusp::scenarios {

/// Box about a shape; ends beyond kEndlessMm are open.
struct RegionBounds {
  Vec3 low{0.0}, high{0.0};
};
inline constexpr double kEndlessMm = 1e4;

class RegionShape {
 public:
  /// `specimen`: uncut; a leaf of its voxels is nowhere without it. Pre: validate() finds no error in the region.
  explicit RegionShape(const Region& region, std::shared_ptr<const Specimen> specimen = nullptr);

  /// The sign is exact; the distance is exact or a lower bound, and changes by no more than its place. A cone, an
  /// ellipsoid, a leaning outline and any node are bounds. On the edge between parts of a node the face is that of the part
  /// that decides there; of equals the first.
  Near near(Vec3 p) const noexcept { return at(0, p); }
  /// The face that a piece of cut surface belongs to, from its place and its normal into the void (of length 1). nullopt where
  /// no face of the region leans like it.
  std::optional<Facing> facing(Vec3 p, Vec3 into_void) const noexcept;
  const RegionBounds& bounds() const noexcept { return bounds_; }

 private:
  struct Node {
    RegionKind kind = RegionKind::outline;
    std::size_t outline = 0;             // index into outlines_
    Vec3 from{0.0}, half{0.0};
    std::array<Vec3, 3> axes{};          // of length 1; [2] along a cylinder, cone or capsule, or out of a half-space
    double length = 0, radius = 0, end_radius = 0, slant = 1;  // slant: of a cone, its length by its side's
    double rounding = 0, by = 0;
    std::array<FaceName, 6> faces{};
    std::shared_ptr<const TissueShape> voxels;  // of a leaf of voxels, with a specimen
    std::vector<std::size_t> parts;             // indices into nodes_
  };
  std::size_t add(const Region& region, const std::shared_ptr<const Specimen>& specimen);
  Near at(std::size_t node, Vec3 p) const noexcept;
  Near leaf(const Node& node, Vec3 p) const noexcept;
  RegionBounds bounds_of(std::size_t node) const noexcept;
  struct Sought {
    Vec3 p, into_void;
  };
  struct Found {
    double off;  // mm2
    Facing facing;
  };
  /// Fills one entry for each face of a leaf; returns how many.
  std::size_t faces_of(const Node& node, Vec3 p, std::array<LeafFace, 6>& out) const noexcept;
  /// `grown`: mm by which the offsets above move the node's own faces outwards. `sense`: whether it is taken off.
  enum class Sense : std::uint8_t { added, taken };  // a part that its node adds, or takes away
  static constexpr Sense opposite(Sense sense) noexcept { return sense == Sense::added ? Sense::taken : Sense::added; }
  void offer_faces(const Sought& sought, std::size_t node, double grown, Sense sense, Found& best) const noexcept;

  std::vector<Node> nodes_;
  std::vector<OutlineShape> outlines_;
  RegionBounds bounds_;
};

}  // namespace cusp::scenarios
