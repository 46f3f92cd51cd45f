#include "scenarios/metrics/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/format/keys.h"
#include "scenarios/metrics/region_classifier.h"
#include "scenarios/teeth/landmarks.h"

namespace cusp::scenarios {

namespace {

/// Adds up what lies in the target.
class TargetSum final : public RegionClassifier {
 public:
  using RegionClassifier::RegionClassifier;
  double mm3 = 0;
  void face(const std::array<Vec3, 3>&, double, Tissue) override {}

 private:
  void solid(Place place, double volume, Tissue) override {
    if (place == Place::target) mm3 += volume;
  }
};

constexpr std::size_t kLeafVoxels = 16;  // a search looks at each voxel of the leaves that it enters

double box_gap_squared(Vec3 p, Vec3 low, Vec3 high) noexcept {
  const Vec3 off = glm::max(glm::max(low - p, p - high), Vec3(0.0));
  return glm::dot(off, off);
}

}  // namespace

PulpIndex::PulpIndex(const Specimen& specimen) : grid_(specimen.grid()) {
  std::vector<Node> leaves;
  const IVec3 bricks = specimen.brick_count();
  const auto is_pulp = [&](IVec3 v) {
    return specimen.tissue(v) == Tissue::pulp &&
           (specimen.reading() == Reading::filled ? specimen.s(v) > 0 : specimen.s(v) >= kHalf);
  };
  const auto outermost = [&](IVec3 v) {
    for (int axis = 0; axis < 3; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        if (!is_pulp(next)) return true;
      }
    return false;
  };
  int leaf_of = -1;  // brick of the last leaf
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (specimen.uniform(b) && specimen.tissue_in(b, 0) != Tissue::pulp) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      if (!is_pulp(v) || !outermost(v)) continue;
      const Vec3 low = grid_.centre_mm(v) - 0.5 * grid_.voxel_mm, high = grid_.centre_mm(v) + 0.5 * grid_.voxel_mm;
      if (leaves.empty() || leaf_of != b || leaves.back().last - leaves.back().first == kLeafVoxels)
        leaves.push_back({low, high, voxels_.size(), voxels_.size()});
      leaf_of = b;
      Node& leaf = leaves.back();
      leaf.low = glm::min(leaf.low, low);
      leaf.high = glm::max(leaf.high, high);
      voxels_.push_back(v);
      leaf.last = voxels_.size();
    }
  }
  if (!leaves.empty()) root_ = grow(leaves);
}

std::int32_t PulpIndex::grow(std::span<Node> leaves) {
  Node node = leaves.front();
  if (leaves.size() > 1) {
    for (const Node& leaf : leaves) {
      node.low = glm::min(node.low, leaf.low);
      node.high = glm::max(node.high, leaf.high);
    }
    const Vec3 size = node.high - node.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const std::size_t half = leaves.size() / 2;
    std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(),
                     [axis](const Node& a, const Node& b) { return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis]; });
    node.first = node.last = 0;
    node.left = grow(leaves.first(half));
    node.right = grow(leaves.subspan(half));
  }
  nodes_.push_back(node);
  return static_cast<std::int32_t>(nodes_.size()) - 1;
}

double PulpIndex::distance_mm(Vec3 p, double at_most_mm) const noexcept {
  if (root_ < 0) return at_most_mm;
  double best = at_most_mm * at_most_mm;
  struct Waiting {
    std::int32_t node;
    double gap;
  };
  std::array<Waiting, 64> stack;  // a balanced tree of 2^32 leaves is not deeper than 32
  std::size_t waiting = 0;
  const auto gap_of = [&](std::int32_t node) {
    const Node& n = nodes_[static_cast<std::size_t>(node)];
    return box_gap_squared(p, n.low, n.high);
  };
  stack[waiting++] = {root_, gap_of(root_)};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.gap >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.left < 0) {
      for (std::size_t i = node.first; i < node.last; ++i) {
        const Vec3 centre = grid_.centre_mm(voxels_[i]);
        best = std::min(best, box_gap_squared(p, centre - 0.5 * grid_.voxel_mm, centre + 0.5 * grid_.voxel_mm));
      }
      continue;
    }
    // The nearer half is looked into first.
    Waiting a{node.left, gap_of(node.left)}, b{node.right, gap_of(node.right)};
    if (a.gap < b.gap) std::swap(a, b);
    if (a.gap < best) stack[waiting++] = a;
    if (b.gap < best) stack[waiting++] = b;
  }
  return std::sqrt(best);
}

Reference::Reference(const Scenario& scenario, std::shared_ptr<const Specimen> specimen)
    : specimen_(std::move(specimen)), shape_(scenario.target), leeway_(scenario.leeway), pulp_(*specimen_),
      heat_(has_phenomenon(scenario.phenomena, "heat")),
      mesial_x_(scenario.specimen.generator == "tooth" ? scenarios::mesial_x(scenario.specimen.fdi) : 0) {
  for (const ScenarioTissue& t : scenario.tissues) tissues_.push_back(t.tissue);
  for (const Protected& one : scenario.protected_parts)
    protected_parts_.push_back({one.tissue.value_or(Tissue::empty), one.region ? std::make_shared<const TargetShape>(*one.region) : nullptr,
                                one.severity, one.depth_mm});
  const Grid& grid = specimen_->grid();
  const IVec3 bricks = specimen_->brick_count();
  const double reach = grid.voxel_mm;  // cells and voxels stand up to one voxel out of their brick
  TargetSum sum(shape_, leeway_);
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (specimen_->uniform(b)) {
      present_[index_of(specimen_->tissue_in(b, 0))] = true;
    } else {
      for (int o = 0; o < kBrickVoxels; ++o)
        if (specimen_->s_in(b, o) >= kHalf) present_[index_of(specimen_->tissue_in(b, o))] = true;
    }
    const Vec3 low = grid.centre_mm(specimen_->brick_at(b) * kBrickEdge) - reach;
    const Vec3 high = low + kBrickEdge * grid.voxel_mm + 2.0 * reach;
    if (shape_.empty() || high.z < shape_.floor_mm() || high.x < shape_.low().x || high.y < shape_.low().y ||
        low.x > shape_.high().x || low.y > shape_.high().y)
      continue;
    emit_specimen(*specimen_, b, sum);
  }
  present_[index_of(Tissue::empty)] = false;
  target_mm3_ = sum.mm3;
}

double Reference::surface_sigma_mm() const noexcept {
  return (specimen_->reading() == Reading::filled ? kFilledSigmaVoxels : kBandedSigmaVoxels) * specimen_->grid().voxel_mm;
}
double Reference::point_sigma_mm() const noexcept {
  return (specimen_->reading() == Reading::filled ? kFilledSigmaVoxels : kBandedPointVoxels) * specimen_->grid().voxel_mm;
}

}  // namespace cusp::scenarios
