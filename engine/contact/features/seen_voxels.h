/// The voxels that a pass has seen. Fixed room: where it ends, each voxel is new. Wait-free. Thread: of the caller.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::engine {

class SeenVoxels {
 public:
  SeenVoxels() : slots_(kRoom) {}

  /// Begins a pass.
  void clear() noexcept {
    ++pass_;
    count_ = 0;
  }
  /// True if the pass has not seen it. Pre: coordinates of 0 to 2^16 - 1.
  bool add(IVec3 voxel) noexcept {
    const auto part = [](int of, int shift) { return static_cast<std::uint64_t>(of) << shift; };
    const std::uint64_t key = part(voxel.x, 0) | part(voxel.y, 16) | part(voxel.z, 32);
    for (std::size_t i = key * kGolden >> (64 - kBits);; i = (i + 1) % kRoom) {
      Slot& slot = slots_[i];
      if (slot.pass == pass_ && slot.key != key) continue;
      if (slot.pass == pass_) return false;
      if (count_ == kRoom / 2) return true;
      ++count_;
      slot = {key, pass_};
      return true;
    }
  }

 private:
  static constexpr int kBits = 12;
  static constexpr std::size_t kRoom = std::size_t{1} << kBits;  // half of it is used; about a head some 100 are at hand
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio: spreads neighbours (Knuth)
  struct Slot {
    std::uint64_t key = 0, pass = 0;
  };
  std::vector<Slot> slots_;
  std::uint64_t pass_ = 0;
  std::size_t count_ = 0;
};

}  // namespace cusp::engine
