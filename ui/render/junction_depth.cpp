#include "ui/render/junction_depth.h"

#include <algorithm>
#include <cmath>

#include "scenarios/teeth/own_tissues.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kMostFineBricks = 1'000'000;
constexpr float kFar = 1e3f;

bool is_under_enamel(Tissue t) noexcept {
  return t != Tissue::empty && !is_enamel(t) && t != Tissue::gingiva && t != Tissue::bone && t != Tissue::ligament;
}

}  // namespace

bool is_enamel(Tissue tissue) noexcept { return tissue == Tissue::enamel || tissue == kNeighbourEnamel; }

JunctionDepth::JunctionDepth(const Specimen& specimen) {
  const IVec3 bricks = specimen.brick_count();
  const auto count = static_cast<std::size_t>(bricks.x) * static_cast<std::size_t>(bricks.y) * static_cast<std::size_t>(bricks.z);
  edge_ = count > kMostFineBricks ? kBrickEdge : kBrickEdge / 2;
  size_ = bricks * (kBrickEdge / edge_);
  cell_mm_ = static_cast<float>(edge_ * specimen.grid().voxel_mm);
  seed(specimen);
  fixed_.resize(distance_.size());
  if (distance_.empty()) return;
  sweep();
  fixed_ = {};
  blur();
}

/// Cells that hold both sides know the junction from their shares; wholly other ones lie half a cell behind it.
void JunctionDepth::seed(const Specimen& specimen) {
  const auto cells = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(size_.z);
  distance_.assign(cells, kFar);
  fixed_.assign(cells, 0);
  const IVec3 bricks = specimen.brick_count();
  const int per_brick = kBrickEdge / edge_, shift = edge_ == kBrickEdge ? 3 : 2;
  bool any_enamel = false, any_other = false;
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    const Tissue only = specimen.only_tissue(b);
    if (only == Tissue::empty && specimen.uniform(b)) continue;
    const IVec3 low = specimen.brick_at(b) * per_brick;
    int enamel[8] = {}, other[8] = {};
    for (int o = 0; o < kBrickVoxels; o += only == Tissue::empty ? 1 : kBrickVoxels) {
      const Tissue t = specimen.tissue_in(b, o);
      const int cell = ((o & 7) >> shift) | ((o >> 3 & 7) >> shift) << 1 | (o >> 6 >> shift) << 2;
      (is_enamel(t) ? enamel : other)[cell] += is_enamel(t) || is_under_enamel(t) ? 1 : 0;
    }
    for (int i = 0; i < 8; ++i) {
      const IVec3 d(i & 1, i >> 1 & 1, i >> 2);
      if (d.x >= per_brick || d.y >= per_brick || d.z >= per_brick) continue;
      const int e = only == Tissue::empty ? enamel[i] : is_enamel(only), u = only == Tissue::empty ? other[i] : is_under_enamel(only);
      any_enamel = any_enamel || e > 0;
      any_other = any_other || u > 0;
      if (u == 0) continue;
      distance_[index(low + d)] = 0.5f - static_cast<float>(u) / static_cast<float>(e + u);
      fixed_[index(low + d)] = 1;
    }
  }
  if (!any_enamel || !any_other) distance_.clear();
}

/// The distance that a cell's neighbours give it: |grad d| = 1 by upwind differences.
/// Source: Zhao, A fast sweeping method for eikonal equations, 2005.
void JunctionDepth::relax(IVec3 c) {
  const std::size_t at = index(c);
  if (fixed_[at] != 0) return;
  float least[3];
  const int step[3] = {1, size_.x, size_.x * size_.y};
  for (int axis = 0; axis < 3; ++axis) {
    least[axis] = kFar;
    if (c[axis] > 0) least[axis] = distance_[at - static_cast<std::size_t>(step[axis])];
    if (c[axis] + 1 < size_[axis]) least[axis] = std::min(least[axis], distance_[at + static_cast<std::size_t>(step[axis])]);
  }
  std::sort(least, least + 3);
  if (least[0] + 1.0f >= distance_[at]) return;
  float d = least[0] + 1.0f;
  if (d > least[1]) {
    const float apart = least[0] - least[1];
    d = 0.5f * (least[0] + least[1] + std::sqrt(std::max(2.0f - apart * apart, 0.0f)));
    if (d > least[2]) {
      const float sum = least[0] + least[1] + least[2];
      const float squares = least[0] * least[0] + least[1] * least[1] + least[2] * least[2];
      d = (sum + std::sqrt(std::max(sum * sum - 3.0f * (squares - 1.0f), 0.0f))) / 3.0f;
    }
  }
  distance_[at] = std::min(distance_[at], d);
}

void JunctionDepth::sweep() {
  for (int way = 0; way < 8; ++way) {
    const auto place = [&](int axis, int i) { return way >> axis & 1 ? size_[axis] - 1 - i : i; };
    for (int z = 0; z < size_.z; ++z)
      for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) relax({place(0, x), place(1, y), place(2, z)});
  }
}

/// Weights 1, 2, 1 along each axis: a cell knows its junction to a voxel only.
void JunctionDepth::blur() {
  const float most = kMostMm / cell_mm_;
  for (float& d : distance_) d = std::min(d, most);
  const int step[3] = {1, size_.x, size_.x * size_.y};
  std::vector<float> line;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = size_[axis], across = (axis + 1) % 3, along = (axis + 2) % 3;
    line.resize(static_cast<std::size_t>(n));
    for (int j = 0; j < size_[along]; ++j)
      for (int i = 0; i < size_[across]; ++i) {
        float* first = &distance_[static_cast<std::size_t>(i * step[across] + j * step[along])];
        for (int k = 0; k < n; ++k) line[static_cast<std::size_t>(k)] = first[k * step[axis]];
        for (int k = 1; k + 1 < n; ++k) {
          const float* at = &line[static_cast<std::size_t>(k)];
          first[k * step[axis]] = 0.25f * (at[-1] + at[1]) + 0.5f * at[0];
        }
      }
  }
}

float JunctionDepth::mm_at(Vec3f voxel) const noexcept {
  if (distance_.empty()) return kMostMm;
  const Vec3f p = glm::clamp((voxel + 0.5f) / static_cast<float>(edge_), Vec3f(0.0f), Vec3f(size_) - 1e-3f);
  const IVec3 middle(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  float weight[3][3];  // a quadratic spline's
  for (int axis = 0; axis < 3; ++axis) {
    const float t = p[axis] - static_cast<float>(middle[axis]);
    weight[axis][0] = 0.5f * (1.0f - t) * (1.0f - t);
    weight[axis][1] = 0.5f + t * (1.0f - t);
    weight[axis][2] = 0.5f * t * t;
  }
  const IVec3 from = glm::clamp(middle - 1, IVec3(0), glm::max(size_ - 3, IVec3(0)));
  const IVec3 last = glm::min(from + 2, size_ - 1) - from;
  float sum = 0.0f;
  for (int z = 0; z <= last.z; ++z)
    for (int y = 0; y <= last.y; ++y) {
      const float* row = &distance_[index(from + IVec3(0, y, z))];
      float along = 0.0f;
      for (int x = 0; x <= last.x; ++x) along += weight[0][x] * row[x];
      sum += along * weight[1][y] * weight[2][z];
    }
  return std::clamp(sum * cell_mm_, 0.0f, kMostMm);
}

}  // namespace cusp::ui
