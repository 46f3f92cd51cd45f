#include "engine/step/step_fragments.h"

#include "engine/volume/fragments.h"

namespace cusp::engine {

bool drop_crumbs(StepState::Inner& state, const Carved& carved) noexcept {
  if (!carved.any) return true;
  bool room = true;
  for_crumbs(
      state.volume, carved.low, carved.high, [&](auto&& mark) { for_changed(carved, mark); },
      [&](const Crumb& crumb) { room = state.method->remove_voxels(state, crumb.voxels()) && room; });
  return room;
}

bool drop_crumbs(StepState::Inner& state, IVec3 low, IVec3 high) noexcept {
  bool room = true;
  for_crumbs(
      state.volume, low, high, [&](auto&& mark) { mark(low, high); },
      [&](const Crumb& crumb) { room = state.method->remove_voxels(state, crumb.voxels()) && room; });
  return room;
}

bool remove_fragments(StepState::Inner& state, std::uint16_t named) noexcept {
  bool room = true;
  state.fragment_removal.receive(state.volume, named);
  state.fragment_removal.advance(
      state.volume, [&](std::span<const IVec3> voxels) { room = state.method->remove_voxels(state, voxels) && room; });
  return room;
}

}  // namespace cusp::engine
