#include "scenarios/teeth/shared_shape.h"

#include <list>
#include <map>
#include <mutex>
#include <tuple>

namespace cusp::scenarios {

std::shared_ptr<const ToothShape> shared_shape(const ToothTable& table, std::uint64_t seed, double voxel_mm) {
  struct Slot {
    std::once_flag fitted;
    std::optional<ToothShape> shape;
  };
  using Key = std::tuple<const ToothTable*, std::uint64_t, double>;
  static std::mutex mutex;
  static std::map<Key, std::weak_ptr<Slot>> slots;
  static std::list<std::shared_ptr<Slot>> recent;  // the last asked for first
  std::shared_ptr<Slot> slot;
  {
    const std::lock_guard lock(mutex);
    std::erase_if(slots, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<Slot>& kept = slots[{&table, seed, voxel_mm}];
    slot = kept.lock();
    if (!slot) kept = slot = std::make_shared<Slot>();
    recent.remove(slot);
    recent.push_front(slot);
    if (recent.size() > kKeptShapes) recent.pop_back();
  }
  std::call_once(slot->fitted, [&] { slot->shape.emplace(table, seed, voxel_mm); });
  return {slot, &*slot->shape};
}

}  // namespace cusp::scenarios
