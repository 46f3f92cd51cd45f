/// The handles of a node of the target: one moves its leaves, one rounds the edges between its parts, one grows an offset.
/// part_handles.h has the node after one of them was moved. Frame: specimen, z up. Millimetres. Pure functions. Thread: any.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/format/scenario.h"
#include "ui/editor/target_handles.h"
#include "ui/modules.h"

namespace cusp::ui {

/// The mean place of the leaves below a part, on a handle's step. A half-space counts if no other leaf has a place. nullopt: every
/// leaf is of the specimen's voxels.
std::optional<Vec3> middle_of_leaves(const Region& part);
/// The part with each leaf moved; those of voxels stay. Rounds to 0.1 µm.
Region shifted(const Region& part, Vec3 by_mm);

/// A place on the surface of a node's parts, and the way of its handle.
struct NodeAnchor {
  Vec3 at_mm{0.0};
  Vec3 along{0.0};  // unit: of an offset out of its part, else away from both faces of an edge, into the rounding
  friend bool operator==(const NodeAnchor&, const NodeAnchor&) = default;
};
/// Of an offset a place on its part, of any other node one on an edge between two parts: the highest within the tooth, else the highest
/// beside it; a face beside a corner comes last. Neither rounding_mm nor by_mm changes it. nullopt: no two parts meet there, or the part has no surface there. Takes
/// milliseconds; leaves of voxels take tens of milliseconds each.
std::optional<NodeAnchor> node_anchor(const Region& node, const std::shared_ptr<const Specimen>& specimen);

/// Place of the leaves, and the handle of rounding_mm or by_mm at that distance from the anchor. None of a leaf.
std::vector<TargetHandle> handles_of_node(const Region& node, const std::optional<NodeAnchor>& anchor);

}  // namespace cusp::ui
