/// The tables of teeth.json as values; its own "schema" line explains each. Parsed once, from text that the
/// build embeds. Frame and units as there: mm, x mesial, y buccal, z occlusal.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "scenarios/teeth/curve.h"
#include "scenarios/teeth/tooth.h"

namespace cusp::scenarios {

using Vec2 = glm::dvec2;

struct LoftTable {
  std::string name;
  std::vector<Vec3> path;        // centre line, in order of falling z
  std::vector<double> rx, ry;    // semi-axes at the points of path
  double exponent = 2.0;
  double cap_mm = 0.0;           // rounding at the lowest end
  double top_cap_mm = 0.0;       // rounding at the highest end
  double rotation_deg = 0.0;     // of the cross-section, about z
};

struct WallTable {
  std::vector<Knot> m, d, b, l;  // signed position of each side over z
  std::vector<Knot> cy;          // y of the middle, as a share of the way from L to B
  std::array<std::vector<Knot>, 4> exponent;  // MB, DB, ML, DL
  std::vector<Knot> taper, shear;
  double cap_mm = 0.0;           // apex of a single-rooted tooth
};

struct CuspTable {
  std::string name;
  Vec3 tip{0.0};
  double enamel_mm = 0.0;
};

struct RidgeTable {
  std::string name;
  std::vector<Vec3> path;
  double inner_slope = 0.0, outer_slope = 0.0;
  double rounding_mm = 0.0;
};

struct GrooveTable {
  std::string name;
  std::vector<Vec2> path;
  double depth_mm = 0.0, half_width_mm = 0.0;
};

struct PitTable {
  std::string name;
  Vec2 at{0.0};
  double depth_mm = 0.0, width_mm = 0.0;
};

/// A ridge or hollow on a side wall; path in (x, z) on B and L, in (y, z) on M and D.
struct FaceTable {
  enum class Side : std::uint8_t { mesial, distal, buccal, lingual };
  std::string name;
  Side side = Side::buccal;
  std::vector<Vec2> path;
  double outward_mm = 0.0, width_mm = 0.0, power = 2.0;
};

struct EnamelTable {
  double b = 0, l = 0, m = 0, d = 0;  // thickness at mid height of each side
  double basin = 0, fissure_min = 0, tau = 0;
};

struct HornTable {
  Vec3 a{0.0}, b{0.0};
  double ra = 0.0, rb = 0.0;
};

struct ToothTable {
  std::string id;
  int fdi = 0;
  ToothDims dims;
  double cej_m = 0, cej_d = 0, cej_b = 0, cej_l = 0;
  Vec2 contact_m{0.0}, contact_d{0.0};  // (y, z): where the contacts are to lie
  WallTable wall;
  double edge_mm = 0.0;
  double ridge_blend_mm = 0.0;
  double floor_z = 0.0;  // far below the roots when the table gives none
  std::vector<CuspTable> cusps;
  std::vector<RidgeTable> ridges;
  std::vector<GrooveTable> grooves;
  std::vector<PitTable> pits;
  std::vector<FaceTable> faces;
  std::vector<LoftTable> roots;
  EnamelTable enamel;
  std::vector<LoftTable> chambers;
  std::vector<LoftTable> canals;
  std::vector<HornTable> horns;
  double x_crown = 1, x_neck = 1, y_crown = 1, y_neck = 1, z_crown = 1, z_root = 1;  // calibration to start from
};

/// Reads the text of a teeth.json. Fails with bad_tables naming the tooth and key that does not fit.
Result<std::vector<ToothTable>, ToothFailure> read_tooth_tables(std::string_view json_text);

/// The table of that FDI number, and whether it is to be mirrored in x (quadrants 2 and 4).
struct TableChoice {
  const ToothTable* table = nullptr;
  bool mirrored = false;
};
Result<TableChoice, ToothFailure> table_for(int fdi);

}  // namespace cusp::scenarios
