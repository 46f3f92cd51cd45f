/// The verb `scale`: cost of a tick and memory of a scene in solid blocks of 128^3 to 1024^3 voxels of 10/128 mm. A bur of
/// 0.5 mm slides at 50 mm/s, kDepthMm below the offset surface of the top.
#pragma once

#include <memory>
#include <vector>

#include "engine/step/step.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/modules.h"

namespace cusp::bench {

/// A solid cube of dentine in a box of edge_voxels^3 about the origin. Its faces lie 6.75 voxels inside the box: four
/// empty voxels and the band.
std::shared_ptr<const Specimen> solid_block(int edge_voxels, double voxel_mm, Reading reading);
/// Half of its edge.
double solid_block_half_mm(int edge_voxels, double voxel_mm);

/// Device points over the top of a block: straight lines to random places within half_way_mm of its middle.
struct BlockSlide {
  double top_mm = 0.0;
  double bur_radius_mm = 0.5;
  double half_way_mm = 1.0;
  double speed_mm_s = 50.0;
};
std::vector<StepInput> block_inputs(const BlockSlide& slide, std::uint64_t seed, std::size_t ticks);

/// Variant "same-way" covers the same 8 mm of every block, "whole-top" the whole top. The sizes alternate in run_lanes;
/// cost_to_smallest is ratio_of to the smallest. memory_mb: growth of resident memory by specimen and state.
std::vector<Row> scale_rows(const Options& options);
int run_scale(const Options& options);

}  // namespace cusp::bench
