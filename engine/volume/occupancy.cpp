#include "engine/volume/occupancy.h"

namespace cusp {

Occupancy::Occupancy(const Volume& volume) : size_(volume.grid().size), bricks_(volume.specimen().brick_count()) {
  const std::size_t words = static_cast<std::size_t>(bricks_.x) * static_cast<std::size_t>(bricks_.y) *
                            static_cast<std::size_t>(bricks_.z) * 8;
  occupied_.assign(words, 0);
  boundary_.assign(words, 0);
  IVec3 v;
  for (v.z = 0; v.z < size_.z; ++v.z)
    for (v.y = 0; v.y < size_.y; ++v.y)
      for (v.x = 0; v.x < size_.x; ++v.x)
        if (volume.occupied(v)) occupied_[word(v)] |= mask(v);
  for (v.z = 0; v.z < size_.z; ++v.z)
    for (v.y = 0; v.y < size_.y; ++v.y)
      for (v.x = 0; v.x < size_.x; ++v.x) {
        if (!bit(occupied_, v)) continue;
        bool open = false;
        for (int i = 0; i < 27 && !open; ++i)
          open = !occupied(v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        if (open) boundary_[word(v)] |= mask(v);
      }
}

void Occupancy::vanish(IVec3 v) noexcept {
  if (!occupied(v)) return;
  occupied_[word(v)] &= ~mask(v);
  boundary_[word(v)] &= ~mask(v);
  for (int i = 0; i < 27; ++i) {
    const IVec3 n = v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (occupied(n)) boundary_[word(n)] |= mask(n);
  }
}

}  // namespace cusp
