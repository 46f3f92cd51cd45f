/// The nearest of many things that lie in boxes. Millimetres. Immutable; any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

class BoxTree {
 public:
  /// A box round the things first to last - 1.
  struct Leaf {
    Vec3 low, high;
    std::size_t first = 0, last = 0;
  };

  BoxTree() = default;
  explicit BoxTree(std::vector<Leaf> leaves) {
    if (!leaves.empty()) root_ = grow(leaves);
  }

  /// Squared distance from p to the box.
  static double gap_squared(Vec3 p, Vec3 low, Vec3 high) noexcept {
    const Vec3 off = glm::max(glm::max(low - p, p - high), Vec3(0.0));
    return glm::dot(off, off);
  }

  /// The least squared distance from p to a thing, at most `most_squared`. squared_to(i, best): the squared distance to thing
  /// i, no less than that to its leaf's box; of a thing that is no nearer than best, any value from best on.
  template <class SquaredTo>
  double nearest_squared(Vec3 p, double most_squared, SquaredTo&& squared_to) const noexcept {
    double best = most_squared;
    struct Waiting {
      std::int32_t node;
      double gap;
    };
    std::array<Waiting, 64> stack;  // a balanced tree of 2^32 leaves is not deeper than 32
    std::size_t waiting = 0;
    const auto at = [&](std::int32_t node) {
      const Leaf& box = nodes_[static_cast<std::size_t>(node)].box;
      return Waiting{node, gap_squared(p, box.low, box.high)};
    };
    if (root_ >= 0) stack[waiting++] = at(root_);
    while (waiting > 0) {
      const Waiting next = stack[--waiting];
      if (next.gap >= best) continue;
      const Node& node = nodes_[static_cast<std::size_t>(next.node)];
      if (node.left < 0) {
        for (std::size_t i = node.box.first; i < node.box.last; ++i) best = std::min(best, squared_to(i, best));
        continue;
      }
      // The nearer half is looked into first.
      Waiting a = at(node.left), b = at(node.right);
      if (a.gap < b.gap) std::swap(a, b);
      if (a.gap < best) stack[waiting++] = a;
      if (b.gap < best) stack[waiting++] = b;
    }
    return best;
  }

 private:
  struct Node {
    Leaf box;
    std::int32_t left = -1, right = -1;  // of a branch: in nodes_
  };
  std::int32_t grow(std::span<Leaf> leaves);

  std::vector<Node> nodes_;
  std::int32_t root_ = -1;
};

}  // namespace cusp::scenarios
