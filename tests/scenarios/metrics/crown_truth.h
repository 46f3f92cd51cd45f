/// What the measurements of a known preparation in a known crown have to come to, by dense sampling of both.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/scenarios/metrics/turned_crown.h"

namespace cusp::test {

/// A target of upright walls: half its sides and its depth below the preparation's plane.
struct UprightBox {
  double half_x = 1.0, half_y = 0.7, depth = 1.8, corner = 0.3;

  /// Height of its floor at a place off its middle; above 100 mm beside it.
  double floor_at(double x, double y) const;
};

/// Heights over a part of the plane, linear between places `step_mm` apart.
class Heights {
 public:
  template <class At>
  Heights(Vec2 low, Vec2 high, double step_mm, At&& at) : low_(low), step_(step_mm) {
    nx_ = static_cast<int>(std::ceil((high.x - low.x) / step_mm)) + 1;
    const int ny = static_cast<int>(std::ceil((high.y - low.y) / step_mm)) + 1;
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx_; ++i) z_.push_back(at(low.x + step_mm * i, low.y + step_mm * j));
  }
  double at(double x, double y) const;

 private:
  Vec2 low_;
  double step_;
  int nx_ = 0;
  std::vector<double> z_;
};

/// A place where the wall meets the tooth's surface.
struct MarginPlace {
  Vec3 at{0.0}, out{0.0}, into_void{0.0};  // normals of the tooth and of the wall
  double deg = 0;                          // direction from the preparation's axis
};

class CrownTruth {
 public:
  CrownTruth(const TurnedCrown& crown, const Preparation& preparation, const UprightBox& target);

  /// Values by key. `voxel_mm`: half a voxel above the rounded line angle the walls begin.
  std::map<std::string, double> values(double voxel_mm) const;

 private:
  void add_floor(std::map<std::string, double>& out) const;
  void add_walls_and_ridges(double low, std::map<std::string, double>& out) const;
  void add_volumes(std::map<std::string, double>& out) const;
  void add_target(double low, std::map<std::string, double>& out) const;
  void add_margin(std::map<std::string, double>& out) const;
  void add_pulp(std::map<std::string, double>& out) const;
  std::vector<MarginPlace> margin() const;
  double isthmus() const;
  double ridge(double low, double direction) const;
  double contour(double y, double low, double direction) const;
  double pulp_distance(Vec3 p, Vec3 at) const;
  double floor_z(double x, double y) const;

  const TurnedCrown& crown_;
  const Preparation& p_;
  const UprightBox& target_;
  Heights top_;
  std::vector<MarginPlace> margin_;
};

}  // namespace cusp::test
