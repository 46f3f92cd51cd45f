#include "tests/bench/swept_path.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {

constexpr std::int32_t kLeaf = 6;    // sweeps
constexpr std::size_t kStack = 128;  // nodes that wait: the tree is balanced, so twice its depth suffices

inline double box_distance2(Vec3 low, Vec3 high, Vec3 p) {
  const Vec3 off = glm::max(glm::max(low - p, p - high), Vec3(0.0));
  return glm::dot(off, off);
}

}  // namespace

Vec3 nearest_on(const Sweep& sweep, Vec3 p) {
  const Vec3 along = sweep.b - sweep.a;
  const double square = glm::dot(along, along);
  return square > 0.0 ? sweep.a + along * std::clamp(glm::dot(p - sweep.a, along) / square, 0.0, 1.0) : sweep.a;
}

SweptPath::SweptPath(std::vector<Sweep> sweeps, double radius_mm)
    : sweeps_(std::move(sweeps)), radius_(radius_mm), order_(sweeps_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(sweeps_.size());
  build(0, static_cast<std::int32_t>(order_.size()));
  legs_.reserve(order_.size());
  for (const std::int32_t i : order_) {
    const Vec3 along = sweep(i).b - sweep(i).a;
    const double square = glm::dot(along, along);
    legs_.push_back({sweep(i).a, along, square > 0.0 ? 1.0 / square : 0.0});
  }
}

std::int32_t SweptPath::build(std::int32_t first, std::int32_t count) {
  const auto at = static_cast<std::int32_t>(nodes_.size());
  Node node;
  node.first = first;
  node.count = count;
  const auto middle_of = [this](std::int32_t i) { return 0.5 * (sweep(i).a + sweep(i).b); };
  for (std::int32_t k = first; k < first + count; ++k) {
    const Sweep& s = sweep(order_[static_cast<std::size_t>(k)]);
    node.low = glm::min(node.low, glm::min(s.a, s.b));
    node.high = glm::max(node.high, glm::max(s.a, s.b));
  }
  nodes_.push_back(node);
  if (count <= kLeaf) return at;
  const Vec3 size = node.high - node.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](std::int32_t i, std::int32_t j) { return middle_of(i)[axis] < middle_of(j)[axis]; });
  const std::int32_t left = build(first, count / 2);
  const std::int32_t right = build(first + count / 2, count - count / 2);
  nodes_[static_cast<std::size_t>(at)].left = left;
  nodes_[static_cast<std::size_t>(at)].right = right;
  return at;
}

double SweptPath::depth(int i, Vec3 p, Vec3* gradient) const {
  const Vec3 off = p - nearest_on(sweep(i), p);
  const double far = length(off);
  if (gradient) *gradient = far > 1e-12 ? -off / far : Vec3(0.0);
  return radius_ - far;
}

SweptPath::Deepest SweptPath::deepest(Vec3 p, int guess) const {
  double least = 1e300;
  std::int32_t which = guess;
  if (guess >= 0) {
    const Vec3 off = p - nearest_on(sweep(guess), p);
    least = glm::dot(off, off);
  }
  struct Waiting {
    std::int32_t node;
    double distance2;
  };
  Waiting stack[kStack];
  std::size_t top = 0;
  stack[top++] = {0, box_distance2(nodes_[0].low, nodes_[0].high, p)};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (next.distance2 >= least) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.left < 0) {
      for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
        const double d2 = legs_[static_cast<std::size_t>(k)].distance2(p);
        if (d2 < least) {
          least = d2;
          which = order_[static_cast<std::size_t>(k)];
        }
      }
      continue;
    }
    const Node& left = nodes_[static_cast<std::size_t>(node.left)];
    const Node& right = nodes_[static_cast<std::size_t>(node.right)];
    Waiting a{node.left, box_distance2(left.low, left.high, p)}, b{node.right, box_distance2(right.low, right.high, p)};
    if (a.distance2 < b.distance2) std::swap(a, b);
    stack[top++] = a;
    stack[top++] = b;
  }
  return {radius_ - std::sqrt(least), which};
}

bool SweptPath::taken(Vec3 p, int but, int but_other, double more_mm) const {
  const double within = radius_ - more_mm, within2 = within * within;
  std::int32_t stack[kStack];
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    if (box_distance2(node.low, node.high, p) >= within2) continue;
    if (node.left >= 0) {
      stack[top++] = node.left;
      stack[top++] = node.right;
      continue;
    }
    for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
      const std::int32_t i = order_[static_cast<std::size_t>(k)];
      if (i != but && i != but_other && legs_[static_cast<std::size_t>(k)].distance2(p) < within2) return true;
    }
  }
  return false;
}

}  // namespace cusp::bench
