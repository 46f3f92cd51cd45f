#include "scenarios/operators/fast_cut.h"

#include <algorithm>
#include <cmath>

#include "engine/removal/carve.h"
#include "engine/tool/voxel_tool.h"
#include "engine/volume/fragments.h"
#include "scenarios/operators/faults.h"

namespace cusp::scenarios {

namespace {

bool cut_banded(const Plan& plan, const Bur& bur, Volume& volume) {
  Vec3 at = plan.start_mm;
  for (const Stroke& stroke : plan.strokes) {
    if (stroke.cut && carve_sweep(volume, at, stroke.to_mm, bur, plan.axis).overflow) return false;
    at = stroke.to_mm;
  }
  return true;
}

/// Every voxel of the bur, half a voxel after half a voxel.
bool cut_filled(const Plan& plan, const Bur& bur, Volume& volume) {
  const Grid& grid = volume.grid();
  const VoxelTool tool = voxelise(bur, plan.axis, grid.voxel_mm);
  const auto cut_at = [&](Vec3 pivot) {
    const IVec3 centre(glm::floor((pivot - grid.origin_mm) / grid.voxel_mm + 0.5));
    for (const IVec3 offset : tool.cutting) {
      const IVec3 v = centre + offset;
      if (volume.s(v) == 0) continue;
      const int brick = volume.specimen().brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
      std::uint16_t* values = volume.cut_for_writing(brick);
      if (values == nullptr) return false;
      values[brick_offset(v.x & 7, v.y & 7, v.z & 7)] = 0;
      volume.touched(brick);
    }
    return true;
  };
  Vec3 at = plan.start_mm;
  for (const Stroke& stroke : plan.strokes) {
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * glm::length(stroke.to_mm - at) / grid.voxel_mm)));
    for (int i = 0; stroke.cut && i <= steps; ++i)
      if (!cut_at(at + (static_cast<double>(i) / steps) * (stroke.to_mm - at))) return false;
    at = stroke.to_mm;
  }
  return true;
}

bool drop_severed(Volume& volume) {
  bool room = true;
  const IVec3 last = volume.grid().size - 1;
  for_crumbs(volume, IVec3(0), last, [&](auto&& mark) {
    for (const std::int32_t brick : volume.cut_bricks()) {
      const IVec3 low = volume.specimen().brick_at(brick) * kBrickEdge;
      mark(low, glm::min(low + kBrickEdge - 1, last));
    }
  }, [&](const Crumb& crumb) { room = room && !remove_voxels(volume, crumb.voxels()).overflow; });
  FragmentRemoval removal;
  const std::vector<std::int32_t> changed(volume.cut_bricks().begin(), volume.cut_bricks().end());
  for (const std::uint32_t name : find_severed_fragments(volume, changed)) {
    removal.receive(volume, static_cast<std::uint16_t>(name >> 15 | 0x8000u));
    removal.receive(volume, static_cast<std::uint16_t>(name & 0x7fffu));
    while (room && removal.active())
      removal.advance(volume, [&](std::span<const IVec3> voxels) { room = room && !remove_voxels(volume, voxels).overflow; });
  }
  return room;
}

}  // namespace

bool cut_along(const Plan& plan, const Scenario& scenario, Volume& volume) { return cut_along(plan, scenario.instruments[plan.bur], volume); }

bool cut_along(const Plan& plan, const Bur& bur, Volume& volume) {
  if (volume.specimen().reading() == Reading::filled) return cut_filled(plan, bur, volume);
  return cut_banded(plan, bur, volume) && drop_severed(volume);
}

std::optional<Plan> plan_by_name(std::string_view name, const Scenario& scenario, const Specimen& specimen, PlanCancel cancel) {
  if (name == "reference") return plan_target(scenario, specimen, {}, cancel);
  const auto fault = fault_by_name(name);
  if (!fault || *fault == OperatorFault::shaky || *fault == OperatorFault::dry) return std::nullopt;
  return plan_target(scenario, specimen, errors_of(*fault, scenario, specimen), cancel);
}

}  // namespace cusp::scenarios
