#include "ui/render/patch_feed.h"

#include <algorithm>
#include <set>
#include <utility>

#include "scenarios/teeth/two_threads.h"

namespace cusp::ui {
namespace {

/// Voxels about a patch that its points read: a cell's point looks a few voxels beyond the cell.
constexpr int kReadMargin = 5;
/// From the region of interest; a rough place further away stays coarse, smoothed by vertex_look.
constexpr double kRoughMm = 2.5;

/// True where a coarse patch would lose what is to be seen: its normals spread as on a fissure or an edge.
bool rough(const Patch& patch) {
  constexpr float kSmooth = 0.82f;  // cosine of 35 degrees; a crown of 5 mm radius turns by 9 within a brick
  // The vertices of the patch's own triangles come first.
  std::size_t own = 0;
  for (std::size_t i = 0; i < patch.own; ++i) own = std::max<std::size_t>(own, patch.indices[i] + 1u);
  Vec3f sum(0.0f);
  for (std::size_t i = 0; i < own; ++i) sum += patch.vertices[i].normal;
  const float length = glm::length(sum);
  for (std::size_t i = 0; i < own; ++i) {
    if (glm::dot(sum, patch.vertices[i].normal) < kSmooth * length) return true;
  }
  return false;
}

struct Extent {
  IVec3 low{kBrickEdge}, high{-1};
  bool empty() const { return high.x < 0; }
  void add(int offset) {
    const IVec3 v(offset & 7, offset >> 3 & 7, offset >> 6);
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
};

bool near_region(const Box& region, const Volume& volume, int brick, double margin_mm) {
  if (region.low == region.high) return true;
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  const Vec3 low = grid.centre_mm(corner), high = grid.centre_mm(corner + kBrickEdge);
  for (int i = 0; i < 3; ++i) {
    if (high[i] < region.low[i] - margin_mm || low[i] > region.high[i] + margin_mm) return false;
  }
  return true;
}

/// The patch of a brick, whose level it chooses; without triangles where the brick shows nothing.
Patch first_patch(const Volume& volume, const Box& region, int brick, std::uint8_t& level) {
  const bool fine = volume.has_cut(brick) || near_region(region, volume, brick, 0.0);
  level = fine ? kFinePatch : kCoarsePatch;
  if (!may_have_surface(volume, brick)) return {};
  Patch patch = build_patch(volume, brick, level);
  if (!patch.indices.empty() && !fine && near_region(region, volume, brick, kRoughMm) && rough(patch)) {
    level = kFinePatch;
    patch = build_patch(volume, brick, level);
  }
  return patch;
}

BakedPatch bake_at(const Volume& volume, const PatchSurroundings& around, const Patch& patch, const std::vector<std::uint8_t>& level,
                   const DeviationAt& deviation) {
  std::function<bool(int)> is_fine;
  if (patch.level == kCoarsePatch) is_fine = [&level](int b) { return level[static_cast<std::size_t>(b)] == kFinePatch; };
  return bake_patch(volume, around, patch, is_fine, deviation);
}

}  // namespace

BakedPatch PatchFeed::bake(const Volume& volume, int brick, const Patch& patch) const {
  BakedPatch out = bake_at(volume, around_, patch, level_, settings_.deviation);
  out.brick = brick;
  return out;
}

void PatchFeed::put(BakedPatch patch, Origin origin) {
  const std::lock_guard lock(mutex_);
  Waiting& place = waiting_[patch.brick];
  if (origin == Origin::update) place.origin = origin;
  place.patch = std::move(patch);
}

void PatchFeed::build_all(const Volume& volume, std::uint64_t tick) { begin(volume, build_mesh(volume, settings_), tick); }

WholeMesh PatchFeed::build_mesh(const Volume& volume, const FeedSettings& settings) {
  const IVec3 n = volume.specimen().brick_count();
  const int bricks = n.x * n.y * n.z;
  const auto count = static_cast<std::size_t>(bricks);
  WholeMesh out{std::vector<std::uint8_t>(count, kCoarsePatch), {}};
  std::vector<Patch> patches(count);
  in_two_threads(bricks, [&](int b) {
    const auto at = static_cast<std::size_t>(b);
    patches[at] = first_patch(volume, settings.region, b, out.level[at]);
  });
  const PatchSurroundings around{SolidShares(volume), JunctionDepth(volume.specimen())};
  std::vector<BakedPatch> baked(count);
  in_two_threads(bricks, [&](int b) {
    const auto at = static_cast<std::size_t>(b);
    if (patches[at].indices.empty()) return;
    baked[at] = bake_at(volume, around, patches[at], out.level, settings.deviation);
    baked[at].brick = b;
  });
  for (BakedPatch& patch : baked)
    if (!patch.indices.empty()) out.patches.push_back(std::move(patch));
  return out;
}

void PatchFeed::begin(const Volume& volume, WholeMesh mesh, std::uint64_t tick) {
  level_ = std::move(mesh.level);
  seen_.assign(level_.size(), {});
  for (std::size_t b = 0; b < seen_.size(); ++b)
    if (const std::uint16_t* cut = volume.cut_of(static_cast<int>(b))) seen_[b].assign(cut, cut + kBrickVoxels);
  around_ = {SolidShares(volume), JunctionDepth(volume.specimen())};
  for (BakedPatch& patch : mesh.patches) {
    patch.tick = tick;
    put(std::move(patch), Origin::build_all);
  }
}

void PatchFeed::update(const Volume& volume, std::span<const std::int32_t> changed_bricks, std::uint64_t tick,
                       const TickTimes& changes) {
  const Specimen& specimen = volume.specimen();
  std::set<int> anew;
  for (const std::int32_t brick : changed_bricks) {
    around_.shares.update(volume, brick);
    const std::uint16_t* cut = volume.cut_of(brick);
    std::vector<std::uint16_t>& seen = seen_[static_cast<std::size_t>(brick)];
    if (cut == nullptr || seen.empty()) {
      // First cut here (or taken back): the level may change too, and with it the neighbours' seams.
      if (cut != nullptr) seen.assign(cut, cut + kBrickVoxels);
      else seen.clear();
      level_[static_cast<std::size_t>(brick)] = kFinePatch;
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
      // A patch reads its brick and about it one voxel (coarse, with its seam: four) and the points' margin.
      const IVec3 offset = (specimen.brick_at(b) - at) * kBrickEdge;
      const int about = (level_[static_cast<std::size_t>(b)] == kCoarsePatch ? 4 : 1) + kReadMargin;
      const IVec3 low = offset - about, high = offset + (kBrickEdge - 1 + about);
      bool reads = true;
      for (int i = 0; i < 3; ++i) reads = reads && extent.high[i] >= low[i] && extent.low[i] <= high[i];
      if (reads) anew.insert(b);
    }
  }
  for (const int b : anew) {
    BakedPatch patch = bake(volume, b, build_patch(volume, b, level_[static_cast<std::size_t>(b)]));
    patch.tick = tick;
    put(std::move(patch), Origin::update);
  }
  const std::lock_guard lock(mutex_);
  changes_.insert(changes_.end(), changes.begin(), changes.end());
}

FedPatches PatchFeed::take(std::size_t max_bytes) {
  FedPatches out;
  std::size_t bytes = 0;
  const std::lock_guard lock(mutex_);
  for (const Origin origin : {Origin::update, Origin::build_all}) {
    for (auto it = waiting_.begin(); it != waiting_.end();) {
      if (it->second.origin != origin) {
        ++it;
        continue;
      }
      if (!out.patches.empty() && bytes + it->second.patch.bytes() > max_bytes) {
        out.more = true;
        return out;
      }
      bytes += it->second.patch.bytes();
      out.tick = std::max(out.tick, it->second.patch.tick);
      out.patches.push_back(std::move(it->second.patch));
      it = waiting_.erase(it);
    }
    if (origin == Origin::update) out.changes = std::exchange(changes_, {});
  }
  return out;
}

bool PatchFeed::empty() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty();
}

}  // namespace cusp::ui
