#include "engine/contact/cavity/cut_memory.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/cell_field.h"

namespace cusp::engine {

namespace {
constexpr std::size_t kMostBack = 64;  // segments of a way that is followed back: 0.04 mm at 0.6 um a tick
Vec3 nearest_on(const CutMemory::Segment& s, Vec3 y) noexcept {
  const Vec3 along = s.b - s.a;
  const double square = glm::dot(along, along);
  double t = square > 1e-18 ? glm::dot(y - s.a, along) / square : 0.0;
  t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
  return s.a + along * t;
}
}  // namespace

CutMemory::CutMemory()
    : segments_(kSegments), nodes_of_(kSegments), nodes_(kNodes), heads_(kBuckets, -1) {}

std::size_t CutMemory::bucket(IVec3 c) noexcept {
  const auto h = static_cast<std::uint32_t>(c.x) * 73856093u ^ static_cast<std::uint32_t>(c.y) * 19349663u ^
                 static_cast<std::uint32_t>(c.z) * 83492791u;
  return (h ^ h >> 15) & (kBuckets - 1);
}

void CutMemory::link(std::size_t place) noexcept {
  const Segment& s = segments_[place];
  const IVec3 low = cell_of_voxels((glm::min(s.a, s.b) - kReachMm) / kCellMm);
  const IVec3 high = cell_of_voxels((glm::max(s.a, s.b) + kReachMm) / kCellMm);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        if (nodes_of_[place] == kMostCells) return;
        const std::size_t b = bucket({x, y, z});
        // A growing segment is linked again at each step: once a bucket is enough.
        const std::int32_t head = heads_[b];
        const bool known = head >= 0 && age(head) <= node_count_ && nodes_[static_cast<std::size_t>(head)].bucket == b;
        if (known && nodes_[static_cast<std::size_t>(head)].segment == place) continue;
        while (node_count_ == kNodes) forget_oldest();
        nodes_[next_node_] = {known ? head : -1, static_cast<std::uint16_t>(place), static_cast<std::uint16_t>(b)};
        heads_[b] = static_cast<std::int32_t>(next_node_);
        next_node_ = next_node_ + 1 == kNodes ? 0 : next_node_ + 1;
        ++node_count_;
        ++nodes_of_[place];
      }
}

/// Its nodes are the oldest as well.
void CutMemory::forget_oldest() noexcept {
  node_count_ -= nodes_of_[first_];
  nodes_of_[first_] = 0;
  first_ = (first_ + 1) % kSegments;
  --count_;
}

void CutMemory::append(const Segment& segment) noexcept {
  if (count_ == kSegments) forget_oldest();
  ++count_;
  const std::size_t place = newest();
  segments_[place] = segment;
  link(place);
}

void CutMemory::add(Vec3 from, Vec3 to, const Sweeper& by) noexcept {
  if (open_ && count_ > 0) {
    Segment& last = segments_[newest()];
    const Vec3 gap = from - last.b;
    if (last.by == by && glm::dot(gap, gap) < kStraightMm * kStraightMm) {
      const Segment longer{last.a, to, by};
      const Vec3 along = to - last.a;
      const Vec3 off = nearest_on(longer, last.b) - last.b;
      if (glm::dot(along, along) <= kLongestMm * kLongestMm && glm::dot(off, off) < kStraightMm * kStraightMm) {
        last.b = to;
        link(newest());
        return;
      }
    }
  }
  append({from, to, by});
  open_ = true;
}

bool CutMemory::nearly_straight_from(Vec3 p, double off_mm) const noexcept {
  if (count_ == 0) return false;
  const auto off2 = [](const Segment& from, Vec3 q) {
    const Vec3 off = nearest_on(from, q) - q;
    return glm::dot(off, off);
  };
  const Segment line{p, segments_[newest()].b, {}};
  Vec3 after = line.b;  // where the segment before has to end
  for (std::size_t back = 0; back < std::min(count_, kMostBack); ++back) {
    const Segment& s = segment(count_ - 1 - back);
    const Vec3 gap = s.b - after;
    if (glm::dot(gap, gap) > kStraightMm * kStraightMm) return false;
    if (off2(s, p) < kStraightMm * kStraightMm) return true;
    if (off2(line, s.a) > off_mm * off_mm) return false;
    after = s.a;
  }
  return false;
}

int CutMemory::near(Vec3 y, const Sweeper& tool, std::array<Vec3, kMost>& out) const noexcept {
  int found = 0;
  std::int32_t last = -1;
  int visited = 0;
  const std::size_t b = bucket(cell_of_voxels(y / kCellMm));
  std::int32_t n = heads_[b];
  if (n >= 0 && nodes_[static_cast<std::size_t>(n)].bucket != b) n = -1;
  for (std::size_t before = 0; n >= 0 && found + 1 < kMost && visited < 256; ++visited) {
    const std::size_t now = age(n);
    if (now <= before || now > node_count_) break;
    before = now;
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    n = node.next;
    if (node.segment == last) continue;
    last = node.segment;
    const Segment& s = segments_[node.segment];
    if (!(s.by == tool)) continue;
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

void CutMemory::load(const std::vector<Segment>& segments, Newest newest) noexcept {
  first_ = count_ = next_node_ = node_count_ = 0;
  std::fill(heads_.begin(), heads_.end(), -1);
  std::fill(nodes_of_.begin(), nodes_of_.end(), std::uint16_t{0});
  const std::size_t skip = segments.size() > kSegments ? segments.size() - kSegments : 0;
  for (std::size_t i = skip; i < segments.size(); ++i) append(segments[i]);
  open_ = newest == Newest::open;
}

}  // namespace cusp::engine
