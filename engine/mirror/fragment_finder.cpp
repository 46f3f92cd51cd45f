#include "engine/mirror/fragment_finder.h"

#include <algorithm>

#include "engine/volume/fragments.h"

namespace cusp::engine {

void FragmentFinder::on_state(const StepState& state, const StateNews& news) {
  changed_.insert(changed_.end(), news.changed_bricks.begin(), news.changed_bricks.end());
  if (news.last || changed_.empty() || state.last().elapsed_us < next_us_) return;
  next_us_ = state.last().elapsed_us + kEveryUs;
  name(state.volume());
}

void FragmentFinder::search(const StepState& state) {
  const Volume& volume = state.volume();
  if (seen_revision_.empty()) {
    const IVec3 n = volume.specimen().brick_count();
    seen_revision_.assign(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), 0);
  }
  for (const std::int32_t brick : volume.cut_bricks()) {
    std::uint32_t& seen = seen_revision_[static_cast<std::size_t>(brick)];
    if (volume.revision(brick) != seen) changed_.push_back(brick);
    seen = volume.revision(brick);
  }
  if (!changed_.empty()) name(volume);
}

void FragmentFinder::name(const Volume& volume) {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  // A full ring drops the rest: the next search looks in the same bricks.
  bool all = true;
  for (const std::uint32_t fragment : find_severed_fragments(volume, changed_)) all = hand_over_.fragments.push(fragment) && all;
  if (all) changed_.clear();
}

}  // namespace cusp::engine
