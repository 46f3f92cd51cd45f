/// Segments of past cut poses. A pose that has cut stays admissible, for the bur fitted there. Segments are merged while
/// straight and found by place. Fixed memory, as rings: a full memory forgets its oldest segment for each new one. A bur may
/// then jam again in an old hole; a force is never wrong. Frame: specimen, mm. Thread: haptic. Wait-free.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/tool/bur.h"

namespace cusp::engine {

class CutMemory {
 public:
  static constexpr double kReachMm = 0.03;      // poses within this of the proxy relax its constraints
  static constexpr double kStraightMm = 1e-4;   // merged while straight to 0.1 um
  static constexpr double kLongestMm = 0.1;

  CutMemory();

  /// What swept a segment: a ball at any axis, or another head at one axis.
  struct Sweeper {
    static constexpr std::int32_t kBall = -1;
    double radius_mm = 0.0;       // of the ball
    std::int32_t head = kBall;    // else the scene's number of the bur
    Vec3 axis{0.0};               // zero for a ball
    bool operator==(const Sweeper&) const = default;
    /// `other` fits wherever this has been.
    bool covers(const Sweeper& other) const noexcept {
      return head == kBall ? other.head == kBall && radius_mm >= other.radius_mm : head == other.head && axis == other.axis;
    }
  };

  /// The pivot of `by` cut from `from` to `to`. True if this only lengthened the last segment.
  bool add(Vec3 from, Vec3 to, const Sweeper& by) noexcept;
  /// True if the last segment passes through p within kStraightMm.
  bool straight_from(Vec3 p) const noexcept;
  /// The next add() starts a new segment (button up, bur changed).
  void break_path() noexcept { open_ = false; }

  /// Returns how many poses it wrote to `out`: the newest segments that cover `tool`, clipped to kReachMm about y, by their ends.
  static constexpr int kMost = 24;
  int near(Vec3 y, const Sweeper& tool, std::array<Vec3, kMost>& out) const noexcept;

  struct Segment {
    Vec3 a{0.0}, b{0.0};
    Sweeper by;
  };
  /// Writes the balls' segments whose swept surface comes within reach_mm of a box, oldest first, straight ones joined.
  /// Returns their number, -1 if `out` has no room for them.
  int reaching(Vec3 low, Vec3 high, double reach_mm, std::span<Segment> out) const noexcept;

  static constexpr std::size_t kSegments = 32768;
  /// For saving and hashing: oldest first. load() replaces all, with the newest of what there is room for.
  std::size_t size() const noexcept { return count_; }
  const Segment& segment(std::size_t i) const noexcept { return segments_[(first_ + i) % kSegments]; }
  bool open() const noexcept { return open_; }
  void load(const std::vector<Segment>& segments, bool open) noexcept;

 private:
  /// Segments near a cell, newest first. The ring reuses its places in turn: `next` is valid while it is older than this node
  /// and not yet forgotten; a bucket's head must also be of that bucket.
  struct Node {
    std::int32_t next = -1;
    std::uint16_t segment = 0, bucket = 0;
  };
  static constexpr std::size_t kNodes = kSegments * 12;  // 0.1 mm and reach touch some 8 cells
  static constexpr std::size_t kMostCells = 4096;        // of one segment: 7 mm across the grain of the cells
  static constexpr std::size_t kBuckets = 16384;
  static_assert(kSegments <= 65536 && kBuckets <= 65536, "their numbers are kept in 16 bits");
  static constexpr double kCellMm = 0.15;

  /// Box about the swept balls of kBlock places in a row, of which some may hold no segment any more.
  static constexpr std::size_t kBlock = 64;
  struct Block {
    Vec3 low{1e300}, high{-1e300};
  };
  std::size_t newest() const noexcept { return (first_ + count_ - 1) % kSegments; }
  void append(const Segment& segment) noexcept;
  void forget_oldest() noexcept;
  void enclose(std::size_t place) noexcept;
  void link(std::size_t place) noexcept;
  /// Ticks of the ring since a node was written, from 1 on.
  std::size_t age(std::int32_t node) const noexcept {
    const auto n = static_cast<std::size_t>(node);
    return next_node_ > n ? next_node_ - n : next_node_ + kNodes - n;
  }
  static std::size_t bucket(IVec3 cell) noexcept;

  std::vector<Segment> segments_;            // a ring
  std::vector<std::uint16_t> nodes_of_;      // [place]: how many
  std::vector<Block> blocks_;
  std::vector<Node> nodes_;                  // a ring
  std::vector<std::int32_t> heads_;
  std::size_t first_ = 0, count_ = 0;        // of segments_
  std::size_t next_node_ = 0, node_count_ = 0;
  bool open_ = false;  // the last segment may grow
};

/// What a bur sweeps, for the memory. index: of the scene's burs.
inline CutMemory::Sweeper sweeper_of(const Bur& bur, std::uint16_t index, Vec3 axis) noexcept {
  if (bur.head.ball()) return {bur.radius_mm, CutMemory::Sweeper::kBall, Vec3(0.0)};
  return {bur.radius_mm, index, axis};
}

}  // namespace cusp::engine
