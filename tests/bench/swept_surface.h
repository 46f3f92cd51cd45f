/// SweptSurface: the surface that a SweptPath has left in solid tissue. Surfels lie on it 10 um apart, and its edges, where
/// two sweeps meet, are traced to points 5 um apart; a parabola through three of them errs by 2 nm. All edges are convex,
/// because each sweep bounds a convex void. Frame: specimen. Unit: mm. Thread: any but the haptic one.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "tests/bench/swept_path.h"

namespace cusp::bench {

/// Indices of points by place.
class PointGrid {
 public:
  void add(Vec3 p, int index) { cells_[key(cell_of(p))].push_back(index); }
  /// Calls visit(index) for every point of the cells that a ball of reach_mm about the centre meets; some lie further off.
  template <class Visit>
  void about(Vec3 centre, double reach_mm, Visit&& visit) const {
    const IVec3 low = cell_of(centre - reach_mm), high = cell_of(centre + reach_mm);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
          if (const auto found = cells_.find(key({x, y, z})); found != cells_.end())
            for (const int index : found->second) visit(index);
  }

 private:
  static constexpr double kCellMm = 0.05;
  static IVec3 cell_of(Vec3 p);
  static std::uint64_t key(IVec3 cell);
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

class SweptSurface {
 public:
  static constexpr double kSurfelMm = 0.01;
  static constexpr double kEdgeStepMm = 0.005;

  /// Depth of a place in the region whose surface is built, mm; it changes by at most the way between two places.
  using Region = std::function<double(Vec3)>;
  SweptSurface(SweptPath path, const Region& region);

  struct Surfel {
    Vec3 at{0.0};
    int sweep = -1;
  };
  struct EdgePoint {
    Vec3 at{0.0};
    int before = -1, after = -1;  // along the edge; -1 at its end
  };
  const SweptPath& path() const { return path_; }
  const std::vector<Surfel>& surfels() const { return surfels_; }
  const std::vector<EdgePoint>& edge_points() const { return edges_; }
  const PointGrid& surfel_grid() const { return surfel_grid_; }
  const PointGrid& edge_grid() const { return edge_grid_; }

  /// No other sweep has removed this place of two sweeps' surfaces.
  bool remains(Vec3 p, int a, int b) const { return !path_.taken(p, a, b, kTouch); }
  /// The edge's place nearest to `centre` between a point's neighbours, by a parabola; an end takes the parabola of the
  /// point beside it. Two points are a line.
  struct Foot {
    Vec3 at{0.0};
    Vec3 tangent{0.0};    // not unit
    Vec3 curvature{0.0};  // towards its centre, 1/mm
    bool inside = false;  // between the neighbours, so that the foot moves with `centre`
  };
  Foot foot(int edge_point, Vec3 centre) const;

 private:
  static constexpr double kTouch = 1e-9;  // mm: a point this close to a face lies on it
  struct Seed {
    int a = -1, b = -1;
    Vec3 at{0.0};
    int tries = 0;  // places between, which a third sweep had taken
  };
  void add_surfels(Vec3 middle, double half, int guess);
  void seed_edges();
  void trace_all();
  void try_seed(const Seed& seed);
  bool project_onto(int a, int b, Vec3& p) const;
  bool known(int a, int b, Vec3 p) const;
  void trace(int a, int b, Vec3 from);
  std::vector<Vec3> walk(int a, int b, Vec3 from, double way, bool& closed);
  void store(int a, int b, const std::vector<Vec3>& points, bool closed);

  SweptPath path_;
  Region region_;  // while it is built
  Vec3 low_{0.0};  // of the surfels' cells
  std::vector<Surfel> surfels_;
  std::vector<EdgePoint> edges_;
  PointGrid surfel_grid_, edge_grid_;
  std::unordered_map<std::uint64_t, std::vector<int>> surfels_of_cell_;
  std::unordered_map<std::uint64_t, std::vector<int>> points_of_pair_;
  std::vector<Seed> seeds_;
};

}  // namespace cusp::bench
