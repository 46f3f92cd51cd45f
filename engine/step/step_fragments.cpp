#include "engine/step/step_fragments.h"

#include "engine/volume/fragments.h"

namespace cusp::engine {

namespace {

/// for_boxes(mark) marks what has changed within low..high.
template <class ForBoxes>
bool drop_crumbs_in(StepState::Inner& state, IVec3 low, IVec3 high, ForBoxes&& for_boxes) noexcept {
  bool room = true;
  for_crumbs(state.volume, low, high, for_boxes,
             [&](const Crumb& crumb) { room = state.method->remove_voxels(state, crumb.voxels()) && room; });
  return room;
}

}  // namespace

bool drop_crumbs(StepState::Inner& state, const Carved& carved) noexcept {
  return !carved.any || drop_crumbs_in(state, carved.low, carved.high, [&](auto&& mark) {
    for_changed(carved, [&](const ChangedVoxels& changed) { mark(changed.low, changed.high); });
  });
}

bool drop_crumbs(StepState::Inner& state, IVec3 low, IVec3 high) noexcept {
  return drop_crumbs_in(state, low, high, [&](auto&& mark) { mark(low, high); });
}

bool remove_fragments(StepState::Inner& state, std::uint16_t named) noexcept {
  bool room = true;
  state.fragment_removal.receive(state.volume, named);
  state.fragment_removal.advance(
      state.volume, [&](std::span<const IVec3> voxels) { room = state.method->remove_voxels(state, voxels) && room; });
  return room;
}

}  // namespace cusp::engine
