#include "engine/contact/cut_memory.h"

#include <algorithm>
#include <cmath>

namespace cusp {

namespace {
IVec3 cell_of(Vec3 p, double edge) noexcept {
  return {static_cast<int>(std::floor(p.x / edge)), static_cast<int>(std::floor(p.y / edge)),
          static_cast<int>(std::floor(p.z / edge))};
}
Vec3 nearest_on(const CutMemory::Segment& s, Vec3 y) noexcept {
  const Vec3 along = s.b - s.a;
  const double square = glm::dot(along, along);
  double t = square > 1e-18 ? glm::dot(y - s.a, along) / square : 0.0;
  t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
  return s.a + along * t;
}
}  // namespace

CutMemory::CutMemory() : segments_(kSegments), blocks_(kSegments / kBlock), nodes_(kNodes), heads_(kBuckets, -1) {}

std::size_t CutMemory::bucket(IVec3 c) noexcept {
  const auto h = static_cast<std::uint32_t>(c.x) * 73856093u ^ static_cast<std::uint32_t>(c.y) * 19349663u ^
                 static_cast<std::uint32_t>(c.z) * 83492791u;
  return (h ^ h >> 15) & (kBuckets - 1);
}

void CutMemory::link(std::int32_t index) noexcept {
  const Segment& s = segments_[static_cast<std::size_t>(index)];
  const IVec3 low = cell_of(glm::min(s.a, s.b) - kReachMm, kCellMm);
  const IVec3 high = cell_of(glm::max(s.a, s.b) + kReachMm, kCellMm);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const std::size_t b = bucket({x, y, z});
        if (nodes_used_ == kNodes) return;
        // A growing segment is linked again at each step: once a bucket is enough.
        if (heads_[b] >= 0 && nodes_[static_cast<std::size_t>(heads_[b])].segment == index) continue;
        nodes_[nodes_used_] = {index, heads_[b]};
        heads_[b] = static_cast<std::int32_t>(nodes_used_++);
      }
}

void CutMemory::rebuild() noexcept {
  std::fill(heads_.begin(), heads_.end(), -1);
  std::fill(blocks_.begin(), blocks_.end(), Block{});
  nodes_used_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    link(static_cast<std::int32_t>(i));
    enclose(i);
  }
}

void CutMemory::enclose(std::size_t i) noexcept {
  const Segment& s = segments_[i];
  Block& block = blocks_[i / kBlock];
  if (s.by.head != Sweeper::kBall) return;
  block.low = glm::min(block.low, glm::min(s.a, s.b) - s.by.radius_mm);
  block.high = glm::max(block.high, glm::max(s.a, s.b) + s.by.radius_mm);
}

int CutMemory::reaching(Vec3 low, Vec3 high, double reach_mm, std::span<Segment> out) const noexcept {
  const auto apart = [&](Vec3 a, Vec3 b) {
    for (int i = 0; i < 3; ++i)
      if (a[i] > high[i] + reach_mm || b[i] < low[i] - reach_mm) return true;
    return false;
  };
  const Vec3 middle = 0.5 * (low + high);
  const Vec3 half = 0.5 * (high - low);
  const double around = std::sqrt(glm::dot(half, half)) + reach_mm;
  std::size_t found = 0, last = 0;
  for (std::size_t block = 0; block * kBlock < count_; ++block) {
    if (apart(blocks_[block].low, blocks_[block].high)) continue;
    const std::size_t end = std::min(count_, (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) {
      const Segment& s = segments_[i];
      if (s.by.head != Sweeper::kBall) continue;
      if (apart(glm::min(s.a, s.b) - s.by.radius_mm, glm::max(s.a, s.b) + s.by.radius_mm)) continue;
      const Vec3 off = nearest_on(s, middle) - middle;
      const double far = s.by.radius_mm + around;
      if (glm::dot(off, off) > far * far) continue;
      if (found > 0 && i == last + 1) {
        Segment& before = out[found - 1];
        const Segment joined{before.a, s.b, s.by};
        const Vec3 gap = s.a - before.b, bent = nearest_on(joined, s.a) - s.a;
        if (before.by == s.by && glm::dot(gap, gap) < 1e-18 && glm::dot(bent, bent) < kStraightMm * kStraightMm) {
          before.b = s.b;
          last = i;
          continue;
        }
      }
      if (found == out.size()) return -1;
      out[found++] = s;
      last = i;
    }
  }
  return static_cast<int>(found);
}

bool CutMemory::add(Vec3 from, Vec3 to, const Sweeper& by) noexcept {
  if (count_ == kSegments || nodes_used_ > kNodes - kMostCells) {
    const std::size_t keep = count_ / 2;
    std::copy(segments_.begin() + static_cast<std::ptrdiff_t>(count_ - keep),
              segments_.begin() + static_cast<std::ptrdiff_t>(count_), segments_.begin());
    count_ = keep;
    rebuild();
  }
  if (open_ && count_ > 0) {
    Segment& last = segments_[count_ - 1];
    const Vec3 gap = from - last.b;
    if (last.by == by && glm::dot(gap, gap) < kStraightMm * kStraightMm) {
      const Segment longer{last.a, to, by};
      const Vec3 along = to - last.a;
      const Vec3 off = nearest_on(longer, last.b) - last.b;
      if (glm::dot(along, along) <= kLongestMm * kLongestMm && glm::dot(off, off) < kStraightMm * kStraightMm) {
        last.b = to;
        enclose(count_ - 1);
        link(static_cast<std::int32_t>(count_ - 1));
        return true;
      }
    }
  }
  segments_[count_] = {from, to, by};
  link(static_cast<std::int32_t>(count_));
  if (count_ % kBlock == 0) blocks_[count_ / kBlock] = Block{};
  enclose(count_);
  ++count_;
  open_ = true;
  return false;
}

bool CutMemory::straight_from(Vec3 p) const noexcept {
  if (count_ == 0) return false;
  const Vec3 off = nearest_on(segments_[count_ - 1], p) - p;
  return glm::dot(off, off) < kStraightMm * kStraightMm;
}

int CutMemory::near(Vec3 y, const Sweeper& tool, std::array<Vec3, kMost>& out) const noexcept {
  int found = 0;
  std::int32_t last = -1;
  int visited = 0;
  for (std::int32_t n = heads_[bucket(cell_of(y, kCellMm))]; n >= 0 && found + 1 < kMost && visited < 256; ++visited) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    n = node.next;
    if (node.segment == last) continue;
    last = node.segment;
    const Segment& s = segments_[static_cast<std::size_t>(node.segment)];
    if (!s.by.holds(tool)) continue;
    // The part of the segment inside the ball of reach about y.
    const Vec3 along = s.b - s.a;
    const Vec3 from = s.a - y;
    const double square = glm::dot(along, along);
    const double outside = glm::dot(from, from) - kReachMm * kReachMm;
    if (square < 1e-18) {
      if (outside <= 0.0) out[static_cast<std::size_t>(found++)] = s.a;
      continue;
    }
    const double half = glm::dot(along, from) / square;
    const double root2 = half * half - outside / square;
    if (root2 < 0.0) continue;
    const double root = std::sqrt(root2);
    double t0 = -half - root, t1 = -half + root;
    if (t0 > 1.0 || t1 < 0.0) continue;
    t0 = t0 < 0.0 ? 0.0 : t0;
    t1 = t1 > 1.0 ? 1.0 : t1;
    out[static_cast<std::size_t>(found++)] = s.a + along * t0;
    if (t1 > t0) out[static_cast<std::size_t>(found++)] = s.a + along * t1;
  }
  return found;
}

void CutMemory::load(const std::vector<Segment>& segments, bool open) noexcept {
  count_ = std::min(segments.size(), kSegments);
  std::copy_n(segments.begin(), count_, segments_.begin());
  open_ = open;
  rebuild();
}

}  // namespace cusp
