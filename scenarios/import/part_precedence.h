/// Which of several meshes wins where they overlap, and what they become together.
#pragma once

#include <vector>

#include "scenarios/import/mesh_parts.h"

namespace cusp::scenarios {

/// Indices of parts, the one that wins over all others first.
using PartOrder = std::vector<std::size_t>;

/// Innermost first: of two parts the one more of whose own surface lies a voxel deep or deeper within the other. Caps are
/// no surface of their own, so a shell that was closed yields to the body inside it. Parts that lie alike stand
/// by their volumes, the smaller first, then by their names. The same whatever the order of `parts`.
PartOrder innermost_first(const std::vector<MeshPart>& parts, const std::vector<PartField>& fields, const Grid& grid);

struct PartOverlap {
  std::size_t winner = 0, loser = 0;
  double mm3 = 0.0;      // of the voxels that both fill, whatever others win there
  bool within = false;   // the winner lies in the loser whole
};
/// Of 0.01 mm³ at the least: walls that two parts share come to less. In the order of their winners.
std::vector<PartOverlap> overlaps_of(const PartOrder& order, const std::vector<PartField>& fields, const Grid& grid);

/// All parts as one specimen: each where it is, the winner where several are, and outside the nearest. Where walls of two
/// parts meet inside, nothing is left between them.
VoxelVolume put_together(const PartOrder& order, const std::vector<MeshPart>& parts, const std::vector<PartField>& fields,
                         const Grid& grid);

}  // namespace cusp::scenarios
