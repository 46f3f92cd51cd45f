#include "ui/render/patch_feed.h"

#include <algorithm>
#include <set>

namespace cusp {
namespace {

/// Voxels about a patch that its points read: a cell's point looks a few voxels beyond the cell.
constexpr int kReadMargin = 5;

struct Extent {
  IVec3 low{kBrickEdge}, high{-1};
  bool empty() const { return high.x < 0; }
  void add(int offset) {
    const IVec3 v(offset & 7, offset >> 3 & 7, offset >> 6);
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
};

}  // namespace

int PatchFeed::level_of(const Volume& volume, int brick) const {
  if (settings_.region.low == settings_.region.high || volume.has_cut(brick)) return kFinePatch;
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  const Vec3 low = grid.centre_mm(corner), high = grid.centre_mm(corner + kBrickEdge);
  for (int i = 0; i < 3; ++i) {
    if (high[i] < settings_.region.low[i] || low[i] > settings_.region.high[i]) return kCoarsePatch;
  }
  return kFinePatch;
}

BakedPatch PatchFeed::bake(const Volume& volume, int brick) const {
  const int level = level_of(volume, brick);
  bool seam = false;
  if (level == kCoarsePatch) {
    const IVec3 at = volume.specimen().brick_at(brick);
    for (int i = 1; i < 8 && !seam; ++i) {
      const int upper = volume.specimen().brick_index(at + IVec3(i & 1, i >> 1 & 1, i >> 2));
      seam = upper >= 0 && level_of(volume, upper) == kFinePatch;
    }
  }
  BakedPatch out = bake_patch(volume, build_patch(volume, brick, level), seam, settings_.deviation);
  out.brick = brick;
  return out;
}

void PatchFeed::put(BakedPatch patch, std::optional<std::chrono::steady_clock::time_point> changed_at) {
  const std::lock_guard lock(mutex_);
  Waiting& place = waiting_[patch.brick];
  // What waits already has waited longer: the oldest moment is the one that counts.
  if (!place.changed_at || (changed_at && *changed_at < *place.changed_at)) place.changed_at = changed_at;
  place.patch = std::move(patch);
}

void PatchFeed::build_all(const Volume& volume, std::uint64_t tick) {
  const IVec3 n = volume.specimen().brick_count();
  const int bricks = n.x * n.y * n.z;
  seen_.assign(static_cast<std::size_t>(bricks), {});
  for (int b = 0; b < bricks; ++b) {
    if (const std::uint16_t* cut = volume.cut_of(b)) seen_[static_cast<std::size_t>(b)].assign(cut, cut + kBrickVoxels);
    if (!may_have_surface(volume, b)) continue;
    BakedPatch patch = bake(volume, b);
    if (patch.indices.empty()) continue;
    patch.tick = tick;
    put(std::move(patch), std::nullopt);
  }
}

void PatchFeed::update(const Volume& volume, std::span<const std::int32_t> changed_bricks, std::uint64_t tick,
                       std::chrono::steady_clock::time_point changed_at) {
  const Specimen& specimen = volume.specimen();
  const IVec3 n = specimen.brick_count();
  seen_.resize(static_cast<std::size_t>(n.x * n.y * n.z));
  std::set<int> anew;
  for (const std::int32_t brick : changed_bricks) {
    const std::uint16_t* cut = volume.cut_of(brick);
    std::vector<std::uint16_t>& seen = seen_[static_cast<std::size_t>(brick)];
    if (cut == nullptr || seen.empty()) {
      // First cut here (or taken back): the level may change too, and with it the neighbours' seams.
      if (cut != nullptr) seen.assign(cut, cut + kBrickVoxels);
      else seen.clear();
      for (const int b : patches_touched_by(specimen, brick)) anew.insert(b);
      continue;
    }
    Extent extent;
    for (int o = 0; o < kBrickVoxels; ++o) {
      if (seen[static_cast<std::size_t>(o)] != cut[o]) extent.add(o);
    }
    if (extent.empty()) continue;
    seen.assign(cut, cut + kBrickVoxels);
    const IVec3 at = specimen.brick_at(brick);
    for (const int b : patches_touched_by(specimen, brick)) {
      // A patch reads its brick, one voxel below, and one (coarse: six) above, and the points' margin about that.
      const IVec3 offset = (specimen.brick_at(b) - at) * kBrickEdge;
      const int above = level_of(volume, b) == kCoarsePatch ? 6 : 1;
      const IVec3 low = offset - 2 - kReadMargin, high = offset + (kBrickEdge - 1 + above + kReadMargin);
      bool reads = true;
      for (int i = 0; i < 3; ++i) reads = reads && extent.high[i] >= low[i] && extent.low[i] <= high[i];
      if (reads) anew.insert(b);
    }
  }
  for (const int b : anew) {
    BakedPatch patch = bake(volume, b);
    patch.tick = tick;
    put(std::move(patch), changed_at);
  }
}

FedPatches PatchFeed::take(std::size_t max_bytes) {
  FedPatches out;
  std::size_t bytes = 0;
  const std::lock_guard lock(mutex_);
  // Live changes before the first picture's patches.
  for (const bool live : {true, false}) {
    for (auto it = waiting_.begin(); it != waiting_.end();) {
      if (it->second.changed_at.has_value() != live) {
        ++it;
        continue;
      }
      if (!out.patches.empty() && bytes + it->second.patch.bytes() > max_bytes) {
        out.more = true;
        return out;
      }
      bytes += it->second.patch.bytes();
      if (it->second.changed_at && (!out.changed_at || *it->second.changed_at < *out.changed_at))
        out.changed_at = it->second.changed_at;
      out.tick = std::max(out.tick, it->second.patch.tick);
      out.patches.push_back(std::move(it->second.patch));
      it = waiting_.erase(it);
    }
  }
  return out;
}

bool PatchFeed::empty() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty();
}

}  // namespace cusp
