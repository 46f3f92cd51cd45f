/// Carries the picture's mesh from the thread that owns the volume (the mirror's) to the one that draws. A newer patch
/// of the same brick replaces one that still waits, so that a slow drawer sees the newest state and nothing piles up.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "ui/render/baked_patch.h"

namespace cusp::ui {

/// Box in the specimen frame, mm.
struct Box {
  Vec3 low{0.0}, high{0.0};
  friend bool operator==(const Box&, const Box&) = default;
};

struct FeedSettings {
  /// Inside it patches are fine; outside coarse where the surface is smooth or far, until a bur comes. An empty box
  /// (low == high): all fine.
  Box region;
  DeviationAt deviation;
};

using TickTimes = std::vector<std::chrono::steady_clock::time_point>;

/// What the drawer got, with the moments of the ticks whose changes it shows first (as passed to update()).
struct FedPatches {
  std::vector<BakedPatch> patches;
  TickTimes changes;
  std::uint64_t tick = 0;   // newest state shown
  bool more = false;        // the limit was reached; further patches wait
};

/// The mesh of a volume as a whole.
struct WholeMesh {
  std::vector<std::uint8_t> level;  // [brick] kFinePatch or kCoarsePatch
  std::vector<BakedPatch> patches;  // by rising brick; none of them is empty
};

class PatchFeed {
 public:
  explicit PatchFeed(FeedSettings settings) : settings_(std::move(settings)) {}

  /// Owner of the volume: every patch anew. Before update().
  void build_all(const Volume& volume, std::uint64_t tick = 0);
  /// The same in two steps: another thread may build the mesh. build_mesh() uses two threads.
  static WholeMesh build_mesh(const Volume& volume, const FeedSettings& settings);
  /// Pre: build_mesh()'s, of this volume and these settings.
  void begin(const Volume& volume, WholeMesh mesh, std::uint64_t tick = 0);
  /// Owner of the volume: what depends on these bricks. `changes`: when they were made, for measuring; any of them.
  void update(const Volume& volume, std::span<const std::int32_t> changed_bricks, std::uint64_t tick,
              const TickTimes& changes = {});

  /// The drawing thread: what waits, at most about `max_bytes` of it (one patch at least).
  FedPatches take(std::size_t max_bytes);
  bool empty() const;

 private:
  enum class Origin : std::uint8_t { build_all, update };
  struct Waiting {
    BakedPatch patch;
    Origin origin = Origin::build_all;  // changes go out before the first picture's patches
  };
  BakedPatch bake(const Volume& volume, int brick, const Patch& patch) const;
  void put(BakedPatch patch, Origin origin);

  FeedSettings settings_;
  PatchSurroundings around_;
  std::vector<std::uint8_t> level_;               // [brick] fine in the region, where a bur was, and where it is rough
  std::vector<std::vector<std::uint16_t>> seen_;  // [brick] cut values at the last build, for the extent of a change
  mutable std::mutex mutex_;                      // guards waiting_; held for a move of a patch, never by the loop
  std::map<int, Waiting> waiting_;                // [brick]
  TickTimes changes_;                             // not yet shown; handed on with the last patch of update()
};

}  // namespace cusp::ui
