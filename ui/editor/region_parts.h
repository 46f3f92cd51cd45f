/// Leaves and nodes of a target by their place in the tree, and the edits of a tree. Pure functions.
#pragma once

#include <optional>
#include <vector>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Indices into `parts`, from the root on; empty: the root.
using PartPath = std::vector<std::size_t>;

/// A shape between from_mm and to_mm.
constexpr bool has_ends(RegionKind kind) noexcept { return kind == RegionKind::cylinder || kind == RegionKind::cone || kind == RegionKind::capsule; }
/// nullptr if the tree has no such part.
const Region* part_at(const Region& root, const PartPath& path);
Region* part_at(Region& root, const PartPath& path);
/// All parts, each before its own parts.
std::vector<PartPath> parts_of(const Region& root);
/// The first outline of the tree, else the root.
PartPath first_outline(const Region& root);
/// The longest beginning of `path` that the tree has.
PartPath clamped(const Region& root, PartPath path);

/// A shape to begin with: 2 mm wide about `middle_mm`.
Region new_part(RegionKind kind, Vec3 middle_mm);
/// The tree with `added` beside the part at `path`, in the nearest node that joins; without one a union is made of both. `path`
/// becomes that of the new part.
Region with_part(const Region& root, PartPath& path, const Region& added);
/// The tree without a part; a node that keeps one part gives way to it. nullopt for the root. `path` becomes that of the parent.
std::optional<Region> without_part(const Region& root, PartPath& path);

}  // namespace cusp::ui
