#include "scenarios/format/region.h"

namespace cusp::scenarios {
namespace {

constexpr std::string_view kOutlineSlots[] = {"floor", "x_low", "x_high", "y_low", "y_high"};
constexpr std::string_view kBoxSlots[] = {"z_low", "z_high", "x_low", "x_high", "y_low", "y_high"};
constexpr std::string_view kEndSlots[] = {"from", "to", "side"};
constexpr std::string_view kOneSlot[] = {"surface"};

void collect(const Region& region, std::vector<const Outline*>& out) {
  if (region.kind == RegionKind::outline) out.push_back(&region.outline);
  for (const Region& part : region.parts) collect(part, out);
}

}  // namespace

std::span<const std::string_view> face_slots(RegionKind kind) noexcept {
  switch (kind) {
    case RegionKind::outline: return kOutlineSlots;
    case RegionKind::box: return kBoxSlots;
    case RegionKind::cylinder:
    case RegionKind::cone: return kEndSlots;
    case RegionKind::sphere:
    case RegionKind::capsule:
    case RegionKind::ellipsoid:
    case RegionKind::half_space:
    case RegionKind::tissue:
    case RegionKind::lesion: return kOneSlot;
    default: return {};
  }
}

bool needs_voxels(const Region& region) noexcept {
  if (is_of_voxels(region.kind)) return true;
  for (const Region& part : region.parts)
    if (needs_voxels(part)) return true;
  return false;
}

FaceName default_face(RegionKind kind, std::size_t slot) noexcept {
  return slot == 0 && face_slots(kind).size() > 1 ? FaceName::pulpal_floor : FaceName::side_wall;
}

std::vector<const Region*> named_targets(const Region& target) {
  std::vector<const Region*> out;
  if (target.kind != RegionKind::joined) return out;
  for (const Region& part : target.parts)
    if (!part.name.empty()) out.push_back(&part);
  return out;
}

std::vector<const Outline*> outlines_of(const Region& region) {
  std::vector<const Outline*> out;
  collect(region, out);
  return out;
}

}  // namespace cusp::scenarios
