#include "scenarios/shapes/box_tree.h"

namespace cusp::scenarios {

std::int32_t BoxTree::grow(std::span<Leaf> leaves) {
  Node node{leaves.front()};
  if (leaves.size() > 1) {
    for (const Leaf& leaf : leaves) {
      node.box.low = glm::min(node.box.low, leaf.low);
      node.box.high = glm::max(node.box.high, leaf.high);
    }
    const Vec3 size = node.box.high - node.box.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const std::size_t half = leaves.size() / 2;
    std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(),
                     [axis](const Leaf& a, const Leaf& b) { return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis]; });
    node.left = grow(leaves.first(half));
    node.right = grow(leaves.subspan(half));
  }
  nodes_.push_back(node);
  return static_cast<std::int32_t>(nodes_.size()) - 1;
}

}  // namespace cusp::scenarios
