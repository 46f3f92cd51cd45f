/// Cross-sections carried along a centre line: roots, pulp chambers and canals (Loft), and the crown's side walls with
/// the trunk or single root below them (Wall). Signed distances are first order: exact on the surface, negative inside.
#pragma once

#include <array>

#include "scenarios/teeth/height_field.h"
#include "scenarios/teeth/tables.h"

namespace cusp::scenarios {

/// A signed distance and the unit direction in which it grows.
struct Sided {
  double d = 0.0;
  Vec3 n{0.0, 0.0, 1.0};
};

class Loft {
 public:
  /// The loft ends at `top_z` with a cap of `top_cap_mm`, or where its table ends. No radius falls below min_radius_mm.
  Loft(const LoftTable& table, double min_radius_mm);
  Loft(const LoftTable& table, double top_z, double top_cap_mm);
  Sided sided(Vec3 p) const noexcept;
  double distance(Vec3 p) const noexcept { return sided(p).d; }
  Vec3 apex() const noexcept { return {cx_.at(low_z_), cy_.at(low_z_), low_z_}; }

 private:
  struct InPlane {
    double u = 0, v = 0;  // ±1 on the axes of the section
    double per_rx = 1, per_ry = 1, cap = 0;
  };
  InPlane in_plane(Vec3 p) const noexcept;
  Curve cx_, cy_, rx_, ry_;
  double exponent_ = 2.0, low_z_ = 0.0, high_z_ = 0.0, low_cap_ = 0.0, high_cap_ = 0.0;
  double cos_ = 1.0, sin_ = 0.0;
};

/// Where a point lies within the wall's cross-section: ±1 at the mesial/distal (u) and buccal/lingual (v) side.
struct WallSide {
  double u = 0.0, v = 0.0;
};

struct WallPlace : WallSide {
  double plain = 0.0;     // distance to the wall without its features
  Vec3 normal{0.0};       // in which that distance grows
  double featured = 0.0;  // distance with all features
  double soft = 0.0;      // distance without narrow grooves: what the dentine below follows
};

class Wall {
 public:
  explicit Wall(const ToothTable& table, double min_half_width_mm);
  WallPlace at(Vec3 p) const noexcept { return place<true>(p); }
  /// The same less `soft`, and quicker.
  WallPlace outside_at(Vec3 p) const noexcept { return place<false>(p); }
  /// A fraction of the work.
  WallSide side_at(Vec3 p) const noexcept { return in_plane(p, section(p.z)).side; }
  /// Lowest z of the table: apex of a single-rooted tooth, else the bottom of the trunk.
  double bottom_z() const noexcept { return bottom_z_; }

 private:
  struct Section {
    double x0 = 0, y0 = 0, a = 1, buccal = 1, lingual = 1, half = 1, taper = 0, shear = 0;
    std::array<double, 4> n{2, 2, 2, 2};  // MB, DB, ML, DL
  };
  struct Slopes {
    double g = 0, dx = 0, dy = 0, dz = 0;  // g is 1 on the surface
  };
  struct InPlane {
    double x = 0, y = 0, b = 1, widen = 1;
    WallSide side;
  };
  template <bool kSoft>
  WallPlace place(Vec3 p) const noexcept;
  InPlane in_plane(Vec3 p, const Section& s) const noexcept;
  Section section(double z) const noexcept;
  Slopes slopes(Vec3 p, const InPlane& at, const Section& s) const noexcept;
  static double exponent(const InPlane& at, const Section& s) noexcept {
    return s.n[static_cast<std::size_t>((at.x > 0.0 ? 0 : 1) + (at.y > 0.0 ? 0 : 2))];
  }
  double cap_at(double z) const noexcept { return cap_ > 0.0 && z < bottom_z_ + cap_ ? (bottom_z_ + cap_ - z) / cap_ : 0.0; }
  void build_faces(const ToothTable& table, double min_half_width_mm);

  static constexpr double kSectionStepMm = 0.02;
  double first_z_ = 0.0, bottom_z_ = 0.0, cap_ = 0.0;
  std::vector<Section> sections_;
  struct Face {
    HeightField all, soft;  // outward shift in mm
  };
  std::array<Face, 4> faces_;  // mesial, distal, buccal, lingual
};

/// Distance to a capsule of two radii.
double round_cone(Vec3 p, const HornTable& horn) noexcept;

}  // namespace cusp::scenarios
