/// Segments of past cut poses of heads that are no balls. A pose that has cut stays admissible, for the bur fitted there. Segments are merged while
/// straight and found by place. Fixed memory, as rings: a full memory forgets its oldest segment for each new one. A bur may
/// then jam again in an old hole; a force is never wrong. Frame: specimen, mm. Thread: haptic. Wait-free.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::engine {

class CutMemory {
 public:
  static constexpr double kReachMm = 0.03;      // poses within this of the proxy relax its constraints
  static constexpr double kStraightMm = 1e-4;   // merged while straight to 0.1 um
  static constexpr double kLongestMm = 0.1;

  CutMemory();

  /// What swept a segment: a head that is no ball, at one axis.
  struct Sweeper {
    std::int32_t head = 0;  // the scene's number of the bur
    Vec3 axis{0.0};
    bool operator==(const Sweeper&) const = default;
  };

  /// The pivot of `by` cut from `from` to `to`.
  void add(Vec3 from, Vec3 to, const Sweeper& by) noexcept;
  /// True if the way from p to the newest pose has no gap and stays within off_mm of the line between them.
  bool nearly_straight_from(Vec3 p, double off_mm) const noexcept;
  /// The next add() starts a new segment (button up, bur changed).
  void break_path() noexcept { open_ = false; }

  /// Returns how many poses it wrote to `out`: the newest segments that `tool` has cut, clipped to kReachMm about y, by their ends.
  static constexpr int kMost = 24;
  int near(Vec3 y, const Sweeper& tool, std::array<Vec3, kMost>& out) const noexcept;

  struct Segment {
    Vec3 a{0.0}, b{0.0};
    Sweeper by;
  };
  static constexpr std::size_t kSegments = 32768;
  /// For saving and hashing: oldest first. load() replaces all, with the newest of what there is room for.
  std::size_t size() const noexcept { return count_; }
  const Segment& segment(std::size_t i) const noexcept { return segments_[(first_ + i) % kSegments]; }
  bool open() const noexcept { return open_; }
  enum class Newest : std::uint8_t { closed, open };
  void load(const std::vector<Segment>& segments, Newest newest) noexcept;

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

  std::size_t newest() const noexcept { return (first_ + count_ - 1) % kSegments; }
  void append(const Segment& segment) noexcept;
  void forget_oldest() noexcept;
  void link(std::size_t place) noexcept;
  /// Ticks of the ring since a node was written, from 1 on.
  std::size_t age(std::int32_t node) const noexcept {
    const auto n = static_cast<std::size_t>(node);
    return next_node_ > n ? next_node_ - n : next_node_ + kNodes - n;
  }
  static std::size_t bucket(IVec3 cell) noexcept;

  std::vector<Segment> segments_;            // a ring
  std::vector<std::uint16_t> nodes_of_;      // [place]: how many
  std::vector<Node> nodes_;                  // a ring
  std::vector<std::int32_t> heads_;
  std::size_t first_ = 0, count_ = 0;        // of segments_
  std::size_t next_node_ = 0, node_count_ = 0;
  bool open_ = false;  // the last segment may grow
};

}  // namespace cusp::engine
