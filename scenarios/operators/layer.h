/// The poses of one height, on a grid: which are allowed, the rows and the edge of their area, and ways within it.
/// Frame: specimen. Millimetres. Any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "scenarios/modules.h"
#include "scenarios/operators/poses.h"

namespace cusp::scenarios {

/// Nodes over the target's plan, row by row along x.
struct PlanGrid {
  Vec2 low{0.0};
  double step_mm = 0.1;
  int nx = 0, ny = 0;
  std::size_t size() const noexcept { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  std::size_t index(int i, int j) const noexcept {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  int column(std::size_t node) const noexcept { return static_cast<int>(node % static_cast<std::size_t>(nx)); }
  int row(std::size_t node) const noexcept { return static_cast<int>(node / static_cast<std::size_t>(nx)); }
  Vec2 at(std::size_t node) const noexcept { return low + step_mm * Vec2(column(node), row(node)); }
  /// visit(node) of the two to four nodes beside one.
  template <class Visit>
  void each_beside(std::size_t node, Visit&& visit) const {
    const int i = column(node), j = row(node);
    if (i > 0) visit(node - 1);
    if (i + 1 < nx) visit(node + 1);
    if (j > 0) visit(index(i, j - 1));
    if (j + 1 < ny) visit(index(i, j + 1));
  }
};

/// A line of poses; `node` is an allowed node beside its first one.
struct PoseLine {
  std::vector<Vec2> points;
  std::size_t first_node = 0, last_node = 0;
};

class Layer {
 public:
  /// `open`: nodes that the bur reaches straight from above; those that it cannot pass at this height are struck out.
  /// `worth`: nodes with tissue of the target below the bur there; the others are crossed, never worked.
  Layer(const Poses& poses, const PlanGrid& grid, double z_mm, std::vector<char>& open, std::vector<char> worth);

  double z_mm() const noexcept { return z_; }
  bool allowed(std::size_t node) const noexcept { return out_[node] <= 0.0f; }
  /// No node is worth work.
  bool idle() const noexcept;
  /// Allowed stretches of every `every`th row, their ends at the edge; and of the first and last row that has any.
  std::vector<PoseLine> rows(int every) const;
  /// The edge of the allowed area, in lines that close or end where no work is.
  std::vector<PoseLine> edges() const;
  /// Connected area of each allowed node, from 1; 0: not allowed.
  std::vector<int> areas() const;
  /// Bends of a way through allowed nodes, `to` last; empty if there is none.
  std::vector<std::size_t> way(std::size_t from, std::size_t to) const;

 private:
  double out_at(Vec2 p) const noexcept { return poses_->out_mm({p.x, p.y, z_}); }
  Vec2 edge_point(Vec2 inside, Vec2 outside) const noexcept;
  bool straight(std::size_t a, std::size_t b) const noexcept;
  void add_runs(int j, std::vector<PoseLine>& out) const;
  void sharpen(PoseLine& line) const;

  const Poses* poses_;
  PlanGrid grid_;
  double z_;
  std::vector<float> out_;
  std::vector<char> worth_;
};

}  // namespace cusp::scenarios
