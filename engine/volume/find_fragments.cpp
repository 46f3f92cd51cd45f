// Finds severed fragments: components grow from the changed bricks, the smallest first, until only one of each original
// component still grows. Cost: the changed bricks, and the smaller side of a severing cut.
#include <algorithm>
#include <deque>
#include <map>

#include "engine/volume/fragments.h"

namespace cusp::engine {

namespace {

/// A component's part in one brick.
struct Part {
  int brick = 0;
  BrickVoxelSet voxels;
  int group = 0;
};

/// Union-find over groups of parts.
class Groups {
 public:
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int of(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      int& up = parent_[static_cast<std::size_t>(i)];
      up = parent_[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  }
  /// Returns the lower of the two.
  int join(int a, int b) {
    a = of(a), b = of(b);
    if (a > b) std::swap(a, b);
    parent_[static_cast<std::size_t>(b)] = a;
    return a;
  }

 private:
  std::vector<int> parent_;
};

std::vector<BrickVoxelSet> split(BrickVoxelSet left) {
  std::vector<BrickVoxelSet> out;
  while (!left.empty()) {
    BrickVoxelSet seed;
    seed.add(left.first());
    out.push_back(reached(left, seed));
    for (std::size_t z = 0; z < 8; ++z) left.slice[z] &= ~out.back().slice[z];
  }
  return out;
}

bool meet(const BrickVoxelSet& a, const BrickVoxelSet& b) {
  for (std::size_t z = 0; z < 8; ++z)
    if (a.slice[z] & b.slice[z]) return true;
  return false;
}

class Search {
 public:
  explicit Search(const Volume& volume)
      : volume_(volume), specimen_(volume.specimen()), voxel_mm3_(volume.grid().voxel_mm * volume.grid().voxel_mm * volume.grid().voxel_mm) {}

  std::vector<std::uint32_t> run(std::span<const std::int32_t> changed) {
    std::vector<std::int32_t> bricks = around(changed);
    for (const std::int32_t brick : bricks)
      for (const int part : open(brick)) begin(part);
    // One step of each: parts of one component join at once.
    const auto first = static_cast<int>(parts_.size());
    for (int part = 0; part < first; ++part)
      if (frontier_.contains(groups_.of(parts_[static_cast<std::size_t>(part)].group))) grow(part);
    if (size_.size() < 2) return {};
    find_origins(bricks, first);
    for (;;) {
      std::map<int, std::vector<int>> by_origin;
      for (const auto& [group, size] : size_) by_origin[origin_[group]].push_back(group);
      const int best = smallest_growing(by_origin);
      if (best < 0) return names(by_origin);
      const int part = frontier_[best].front();
      frontier_[best].pop_front();
      grow(part);
    }
  }

 private:
  /// The smallest group that grows among origins with two or more growing groups; -1: none.
  int smallest_growing(const std::map<int, std::vector<int>>& by_origin) {
    int best = -1;
    for (const auto& [origin, groups] : by_origin) {
      int growing = 0;
      for (const int g : groups) growing += frontier_[g].empty() ? 0 : 1;
      if (growing < 2) continue;
      for (const int g : groups)
        if (!frontier_[g].empty() && (best < 0 || size_[g] < size_[best])) best = g;
    }
    return best;
  }
  /// The changed bricks and their neighbours, sorted: a voxel removed at a brick's edge can sever tissue of the next
  /// brick.
  std::vector<std::int32_t> around(std::span<const std::int32_t> changed) const {
    std::vector<std::int32_t> out;
    for (const std::int32_t brick : changed) {
      const IVec3 at = specimen_.brick_at(brick);
      for (int i = 0; i < 27; ++i) {
        const int b = specimen_.brick_index(at + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        if (b >= 0) out.push_back(b);
      }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  const std::vector<int>& open(int brick) {
    const auto [at, fresh] = opened_.try_emplace(brick);
    if (fresh)
      for (const BrickVoxelSet& voxels : split(occupied_in(volume_, brick))) {
        at->second.push_back(static_cast<int>(parts_.size()));
        parts_.push_back({brick, voxels, -1});
      }
    return at->second;
  }
  void begin(int part) {
    Part& p = parts_[static_cast<std::size_t>(part)];
    p.group = groups_.add();
    size_[p.group] = p.voxels.count();
    frontier_[p.group] = {part};
  }

  /// Adds the parts that touch this one to its group.
  void grow(int part) {
    const int brick = parts_[static_cast<std::size_t>(part)].brick;
    const BrickVoxelSet voxels = parts_[static_cast<std::size_t>(part)].voxels;
    const IVec3 at = specimen_.brick_at(brick);
    int group = groups_.of(parts_[static_cast<std::size_t>(part)].group);
    std::erase(frontier_[group], part);
    for (int i = 0; i < 27; ++i) {
      const IVec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const int beside = specimen_.brick_index(at + step);
      if (i == 13 || beside < 0) continue;
      const BrickVoxelSet there = touching(voxels, step);
      if (there.empty()) continue;
      for (const int other : open(beside)) {
        Part& o = parts_[static_cast<std::size_t>(other)];
        if (!meet(o.voxels, there)) continue;
        if (o.group < 0) {
          o.group = group;
          size_[group] += o.voxels.count();
          frontier_[group].push_back(other);
          continue;
        }
        const int theirs = groups_.of(o.group);
        if (theirs == group) continue;
        const int kept = groups_.join(group, theirs), joined = kept == group ? theirs : group;
        size_[kept] += size_[joined];
        frontier_[kept].insert(frontier_[kept].end(), frontier_[joined].begin(), frontier_[joined].end());
        size_.erase(joined);
        frontier_.erase(joined);
        group = kept;
      }
    }
  }

  /// Assigns each group its origin: the specimen's component, within `bricks`, that it was cut from. Tissue that was
  /// connected before the last cut is connected within `bricks`.
  void find_origins(const std::vector<std::int32_t>& bricks, int parts) {
    Groups solids;
    std::map<int, std::vector<std::pair<BrickVoxelSet, int>>> of;  // [brick]
    for (const std::int32_t brick : bricks)
      for (const BrickVoxelSet& voxels : split(occupied_in(specimen_, brick))) of[brick].emplace_back(voxels, solids.add());
    for (const auto& [brick, parts_of_brick] : of) {
      const IVec3 at = specimen_.brick_at(brick);
      for (int i = 14; i < 27; ++i) {
        const IVec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const auto beside = of.find(specimen_.brick_index(at + step));
        if (beside == of.end()) continue;
        for (const auto& [voxels, solid] : parts_of_brick) {
          const BrickVoxelSet there = touching(voxels, step);
          for (const auto& [others, their_solid] : beside->second)
            if (meet(others, there)) solids.join(solid, their_solid);
        }
      }
    }
    for (int part = parts - 1; part >= 0; --part) {
      const Part& p = parts_[static_cast<std::size_t>(part)];
      if (p.group < 0) continue;
      for (const auto& [voxels, solid] : of[p.brick])
        if (meet(voxels, p.voxels)) origin_[groups_.of(p.group)] = solids.of(solid);
    }
  }

  std::vector<std::uint32_t> names(const std::map<int, std::vector<int>>& by_origin) {
    std::vector<int> severed;
    for (const auto& [of, groups] : by_origin) {
      // The largest stays: the group that still grows, or else the first with the highest count.
      int stays = groups.front();
      for (const int g : groups) {
        const auto rank = [this](int x) { return std::pair(!frontier_[x].empty(), size_[x]); };
        if (rank(g) > rank(stays)) stays = g;
      }
      for (const int g : groups)
        if (g != stays && size_[g] * voxel_mm3_ <= kMostFragmentMm3) severed.push_back(g);
    }
    std::map<int, std::uint32_t> name;  // [group]
    for (const Part& part : parts_) {
      if (part.group < 0 || part.brick >= kMostNamedBricks) continue;
      const int group = groups_.of(part.group);
      if (std::find(severed.begin(), severed.end(), group) == severed.end()) continue;
      BrickVoxelSet left = part.voxels;
      // The lower half of a name must not be 0.
      if ((voxel_name(part.brick, left.first()) & 0x7fffu) == 0) left.slice[0] &= ~std::uint64_t{1};
      if (left.empty()) continue;
      const std::uint32_t own = voxel_name(part.brick, left.first());
      const auto [at, fresh] = name.try_emplace(group, own);
      at->second = std::min(at->second, own);
    }
    std::vector<std::uint32_t> out;
    for (const auto& [group, own] : name) out.push_back(own);
    std::sort(out.begin(), out.end());
    return out;
  }

  const Volume& volume_;
  const Specimen& specimen_;
  double voxel_mm3_;
  std::map<int, std::vector<int>> opened_;     // [brick]: its parts
  std::vector<Part> parts_;
  Groups groups_;
  std::map<int, int> size_;                    // [group]: voxels found so far
  std::map<int, int> origin_;                  // [group]
  std::map<int, std::deque<int>> frontier_;    // [group]: parts whose neighbours have not been visited
};

}  // namespace

std::vector<std::uint32_t> find_severed_fragments(const Volume& volume, std::span<const std::int32_t> changed_bricks) {
  if (changed_bricks.empty()) return {};
  return Search(volume).run(changed_bricks);
}

}  // namespace cusp::engine
