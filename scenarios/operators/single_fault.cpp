#include "scenarios/operators/single_fault.h"

namespace cusp::scenarios {

namespace {

/// Small is the least that an examiner sees, medium is a mark off, large fails. Sources: facts/dental.md 2.2, or [M].
constexpr std::array<SingleFaultRow, 15> kRows = {{
    {SingleFault::too_deep, "too_deep", "mm", {0.25, 0.5, 0.9}, "bands of depth end at 0.15, 0.3 and 0.8 beside the target"},
    {SingleFault::too_shallow, "too_shallow", "mm", {0.25, 0.45, 0.8}, "bands of depth end at 0.15, 0.3 and 0.6 above the target"},
    {SingleFault::too_wide, "too_wide", "mm", {0.15, 0.35, 0.6}, "half the tolerance zone, just past it, twice it"},
    {SingleFault::tilted_wall, "tilted_wall", "deg", {6.0, 10.0, 16.0}, "row set A: 3 degrees of divergence excellent, 8 fails"},
    {SingleFault::undermined, "undermined", "mm", {0.1, 0.2, 0.3}, "a round bur on a thin neck reaches beneath the edge by less than its radius [M]"},
    {SingleFault::rough_floor, "rough_floor", "mm", {0.2, 0.4, 0.6}, "row set A: flat to 0.12 mm excellent, to 0.25 acceptable"},
    {SingleFault::thin_ridge, "thin_ridge", "mm", {0.3, 0.6, 1.0}, "ridges of 2.0, 1.6 and 1.2 mm on a molar [M]"},
    {SingleFault::exposed_pulp, "exposed_pulp", "mm", {0.1, 0.3, 0.6}, "a pinpoint, a bur's tip, half a bur [M]"},
    {SingleFault::nicked_neighbour, "nicked_neighbour", "mm", {0.15, 0.3, 0.6}, "polished away, to be restored, into dentine [M]"},
    {SingleFault::contact_closed, "contact_closed", "mm", {0.1, 0.25, 0.5}, "a shell that breaks away, one that stands, no clearance [M]"},
    {SingleFault::caries_left, "caries_left", "mm", {0.3, 0.6, 1.0}, "the periphery is the millimetre along the junction"},
    {SingleFault::over_excavated, "over_excavated", "mm", {0.4, 0.7, 1.0}, "the tolerance zone of 0.3 forgives the first of it [M]"},
    {SingleFault::wrong_bur, "wrong_bur", "mm", {0.1, 0.2, 0.4}, "radii of the next sizes of round burs"},
    {SingleFault::tremor, "tremor", "mm", {0.1, 0.2, 0.4}, "a braced, an unbraced and an unsteady hand [M]"},
    {SingleFault::dry_cutting, "dry_cutting", "s", {3.0, 6.0, 12.0}, "full points end at 2 s, all points at 10 s [M]"},
}};

}  // namespace

std::span<const SingleFaultRow> single_faults() noexcept { return kRows; }

double SizedFault::amount() const noexcept {
  return kRows[static_cast<std::size_t>(fault)].sizes[static_cast<std::size_t>(size)];
}

std::optional<SizedFault> sized_fault_by_name(std::string_view name) noexcept {
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return std::nullopt;
  for (const SingleFaultRow& row : kRows)
    for (std::size_t size = 0; size < kFaultSizeKeys.size(); ++size)
      if (row.key == name.substr(0, colon) && kFaultSizeKeys[size] == name.substr(colon + 1))
        return SizedFault{row.fault, static_cast<FaultSize>(size)};
  return std::nullopt;
}

std::string key_of(SizedFault fault) {
  return std::string(kRows[static_cast<std::size_t>(fault.fault)].key) + ":" +
         std::string(kFaultSizeKeys[static_cast<std::size_t>(fault.size)]);
}

}  // namespace cusp::scenarios
