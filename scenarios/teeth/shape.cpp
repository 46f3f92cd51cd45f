#include "scenarios/teeth/shape.h"

#include <algorithm>

#include "scenarios/teeth/variety.h"

namespace cusp::scenarios {
namespace {

constexpr double kGrooveVoxels = 1.8, kCanalVoxels = 0.8, kCoatVoxels = 1.2;
constexpr double kRootTopMm = 1.2;       // roots end in a round top inside the crown
constexpr double kTrunkCutMm = 1.2;      // rounding of the trunk's lower end
constexpr double kWarpMm = 0.18, kWarpLengthMm = 3.6;  // a seed's sideways variation
constexpr double kPastMm = 1e-6;  // a search for the outermost place passes the best one by this, for rounding
const Vec3 kToothMm{9.0, 9.0, 24.0};  // no tooth, nor the space about it that is asked for, is longer
constexpr double kMdBlSpread = 0.05, kCrownSpread = 0.06, kRootSpread = 0.09;  // one sigma, as shares (teeth.md)

ToothDims varied(ToothDims d, std::uint64_t seed) {
  if (seed == 0) return d;
  const double md = 1.0 + kMdBlSpread * normal_draw(seed, 0), bl = 1.0 + kMdBlSpread * normal_draw(seed, 1);
  d.mesiodistal *= md;
  d.mesiodistal_neck *= md;
  d.buccolingual *= bl;
  d.buccolingual_neck *= bl;
  d.crown_length *= 1.0 + kCrownSpread * normal_draw(seed, 2);
  d.root_length *= 1.0 + kRootSpread * normal_draw(seed, 3);
  return d;
}

/// Union of two bodies, rounded where they meet at an angle. Where they run side by side a rounded union would bulge by
/// k/4 and leave a ring where one of them ends, so there it is nearly a plain one.
Sided joined(const Sided& a, const Sided& b, double k) {
  k *= std::clamp(1.3 * (1.0 - glm::dot(a.n, b.n)), 0.15, 1.0);
  const double share = std::clamp(0.5 + (b.d - a.d) / (2.0 * k), 0.0, 1.0);
  const Vec3 n = glm::mix(b.n, a.n, share);
  return {smin(a.d, b.d, k), n / (glm::length(n) + 1e-9)};
}

}  // namespace

ToothShape::ToothShape(const ToothTable& table, std::uint64_t seed, double voxel_mm)
    : table_(varied_table(table, seed)),
      seed_(seed),
      voxel_mm_(voxel_mm),
      wall_(table_, kGrooveVoxels * voxel_mm),
      occlusal_(table_, seed, kGrooveVoxels * voxel_mm),
      warp_x_(seed * 3, kWarpLengthMm, kToothMm),
      warp_y_(seed * 3 + 1, kWarpLengthMm, kToothMm) {
  for (const LoftTable& root : table.roots) roots_.emplace_back(root, kRootTopMm, kRootTopMm);
  for (const LoftTable& loft : table.chambers) pulp_.emplace_back(loft, kCanalVoxels * voxel_mm);
  for (const LoftTable& loft : table.canals) pulp_.emplace_back(loft, kCanalVoxels * voxel_mm);
  scale_ = {table.x_crown, table.x_neck, table.y_crown, table.y_neck, table.z_crown, table.z_root};
  double widest_m = -1e9, widest_d = 1e9, widest_b = -1e9, widest_l = 1e9;
  double z_md = 0.0, z_bl = 0.0;
  for (const Knot& k : table.wall.m) {
    if (k.value > widest_m) widest_m = k.value, z_md = k.z;
  }
  for (const Knot& k : table.wall.d) {
    if (k.value < widest_d) widest_d = k.value, z_md = std::min(z_md, k.z);
  }
  for (const Knot& k : table.wall.b) {
    if (k.value > widest_b) widest_b = k.value, z_bl = k.z;
  }
  for (const Knot& k : table.wall.l) {
    if (k.value < widest_l) widest_l = k.value, z_bl = std::min(z_bl, k.z);
  }
  x_blend_low_ = std::max(table.cej_m, table.cej_d);
  x_blend_high_ = std::max(z_md, x_blend_low_ + 1.5);
  y_blend_low_ = 0.0;
  y_blend_high_ = std::max(z_bl, 1.2);
  fit();
}

Vec3 ToothShape::to_table(Vec3 p) const noexcept {
  const double z = p.z > 0.0 ? p.z / scale_.z_crown : p.z / scale_.z_root;
  const double tx = smoothstep(x_blend_low_, x_blend_high_, z), ty = smoothstep(y_blend_low_, y_blend_high_, z);
  Vec3 q{p.x / (scale_.x_neck + tx * (scale_.x_crown - scale_.x_neck)),
         p.y / (scale_.y_neck + ty * (scale_.y_crown - scale_.y_neck)), z};
  if (seed_ != 0) {
    const double x = warp_x_.at(q), y = warp_y_.at(q);
    q.x += kWarpMm * x;
    q.y += kWarpMm * y;
  }
  return q;
}

Vec3 ToothShape::from_table(Vec3 place) const noexcept {
  Vec3 p = place;
  p.z = place.z * (place.z > 0.0 ? scale_.z_crown : scale_.z_root);
  for (int round = 0; round < 8; ++round) {  // the warp is gentle: each round gains a digit
    const Vec3 off = place - to_table(p);
    p.x += off.x;
    p.y += off.y;
  }
  return p;
}

double ToothShape::crown(Vec3 t, const WallPlace& wall) const noexcept {
  if (t.z < occlusal_.lowest() - 4.0) return wall.featured;
  return smax(wall.featured, occlusal_.distance(t), table_.edge_mm);
}

double ToothShape::outside(Vec3 p) const noexcept {
  const Vec3 t = to_table(p);
  if (roots_.empty() || t.z > 0.0) return crown(t, wall_.outside_at(t));
  // Trunk: the wall, cut off below.
  Sided trunk{wall_.bottom_z() - t.z, {0, 0, -1}};
  double neck = trunk.d;
  if (trunk.d < 2.5) {
    const WallPlace wall = wall_.outside_at(t);
    neck = wall.featured;
    const double share = std::clamp(0.5 + (wall.featured - trunk.d) / (2.0 * kTrunkCutMm), 0.0, 1.0);
    trunk = {smax(wall.featured, trunk.d, kTrunkCutMm), glm::normalize(glm::mix(trunk.n, wall.normal, share))};
  }
  Sided roots = roots_.front().sided(t);
  for (std::size_t i = 1; i < roots_.size(); ++i) roots = joined(roots, roots_[i].sided(t), 0.8);
  // Rounder below: this makes the arch of the furcation.
  const double root = joined(trunk, roots, 0.6 + 0.6 * smoothstep(-2.4, -3.8, t.z)).d;
  // The roots never bulge the neck.
  const double f = smoothstep(-1.5, 0.0, t.z);
  return root + f * (neck - root);
}

double ToothShape::cej_height(const WallSide& w) const noexcept {
  const double u2 = w.u * w.u, q = u2 / (u2 + w.v * w.v + 1e-12);
  const double proximal = w.u > 0.0 ? table_.cej_m : table_.cej_d;
  const double facial = w.v > 0.0 ? table_.cej_b : table_.cej_l;
  const double q15 = q * std::sqrt(q);
  return facial + q15 * (proximal - facial);
}

double ToothShape::above_cej(Vec3 p) const noexcept {
  const Vec3 t = to_table(p);
  return t.z - cej_height(wall_.side_at(t));
}

double ToothShape::dentine(Vec3 p, double outside_mm) const noexcept {
  const Vec3 t = to_table(p);
  const double coat = kCoatVoxels * voxel_mm_;
  if (t.z < -0.5) {
    const double apex_share = std::clamp(t.z / -table_.dims.root_length, 0.0, 1.0);
    return outside_mm + std::max(coat, 0.04 + 0.16 * apex_share);
  }
  const double h = t.z - cej_height(wall_.side_at(t));
  if (h <= 0.0) return outside_mm + std::max(coat, 0.04 * std::min(1.0, -h / 0.3));
  const WallPlace w = wall_.at(t);
  const EnamelTable& e = table_.enamel;
  const double rise = 1.0 - std::exp(-h / e.tau);
  const double u2 = w.u * w.u, q = u2 / (u2 + w.v * w.v + 1e-12);
  const double sides = (q * (w.u > 0.0 ? e.m : e.d) + (1.0 - q) * (w.v > 0.0 ? e.b : e.l)) * rise;
  double top = e.basin;
  for (const CuspTable& c : table_.cusps) {
    const double dx = t.x - c.tip.x, dy = t.y - c.tip.y;
    top += (c.enamel_mm - 0.25 - e.basin) * std::exp(-(dx * dx + dy * dy) / (1.5 * 1.5));
  }
  const double junction = smax(w.soft + sides, occlusal_.soft_distance(t) + top, 0.3);
  const double least = std::max(w.featured, t.z - occlusal_.height(t.x, t.y)) + e.fissure_min * rise;
  return std::max({junction, least, outside_mm + coat});
}

double ToothShape::pulp(Vec3 p) const noexcept {
  const Vec3 t = to_table(p);
  double d = 1e9;
  for (const Loft& loft : pulp_) d = smin(d, loft.distance(t), 0.3);
  for (const HornTable& horn : table_.horns) d = smin(d, round_cone(t, horn), 0.4);
  return d;
}

std::optional<double> ToothShape::march(Vec3 from, Vec3 way, double most_mm) const noexcept {
  double gone = 0.0;
  for (int i = 0; i < 200 && gone < most_mm; ++i) {
    const double d = outside(from + gone * way);
    if (d < 1e-4) return gone;
    gone += 0.7 * std::min(d, 2.0);  // the slope of the field stays below 1.3
  }
  return std::nullopt;
}

std::optional<Vec3> ToothShape::top_at(double x, double y) const noexcept {
  const Vec3 from{x, y, high_.z + 0.3};
  const auto d = march(from, {0, 0, -1}, 8.0);
  if (!d) return std::nullopt;
  return from + *d * Vec3(0, 0, -1);
}

/// The surface point that lies furthest along `way` (x or y, either sign) between two heights.
Vec3 ToothShape::furthest(Vec3 way, double z_from, double z_to) const {
  const Vec3 across = way.x != 0.0 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  Vec3 best{0.0};
  double best_reach = -1e9;
  const auto look = [&](double s, double z) {
    if (z < z_from - 1e-9 || z > z_to + 1e-9) return;
    const Vec3 from = across * s + Vec3(0, 0, z) + way * 9.0;
    const auto d = march(from, -way, std::min(9.0, 9.0 - best_reach + kPastMm));
    if (d && 9.0 - *d > best_reach) {
      best_reach = 9.0 - *d;
      best = from - way * *d;
    }
  };
  const double dz = z_to > z_from ? std::max(0.35, (z_to - z_from) / 24.0) : 1.0;
  for (double z = z_from; z <= z_to; z += dz) {
    for (double s = -4.8; s <= 4.8; s += 0.6) look(s, z);
  }
  for (double step = 0.3; step > 0.02; step *= 0.6) {
    const Vec3 at = best;
    const double s = glm::dot(at, across);
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) look(s + i * step, at.z + j * step);
    }
  }
  return best;
}

void ToothShape::measure() {
  const ToothTable& t = table_;
  high_.z = t.dims.crown_length * scale_.z_crown * 1.25 + 1.0;
  const double top = t.dims.crown_length * scale_.z_crown;
  mesial_ = furthest({1, 0, 0}, t.cej_m, top);
  distal_ = furthest({-1, 0, 0}, t.cej_d, top);
  const Vec3 buccal = furthest({0, 1, 0}, t.cej_b, top), lingual = furthest({0, -1, 0}, t.cej_l, top);
  dims_.mesiodistal = mesial_.x - distal_.x;
  dims_.buccolingual = buccal.y - lingual.y;
  const double cm = t.cej_m * scale_.z_crown, cd = t.cej_d * scale_.z_crown;
  dims_.mesiodistal_neck = furthest({1, 0, 0}, cm, cm).x - furthest({-1, 0, 0}, cd, cd).x;
  dims_.buccolingual_neck = furthest({0, 1, 0}, t.cej_b, t.cej_b).y - furthest({0, -1, 0}, t.cej_l, t.cej_l).y;

  measure_crown_and_root();
  const double crown = dims_.crown_length, apex = -dims_.root_length;

  high_ = {mesial_.x, buccal.y, crown};
  low_ = {distal_.x, lingual.y, apex};
  // Spread roots may reach beyond the crown.
  if (!roots_.empty()) {
    const double bottom = apex + 0.2, neck = -0.5;
    high_.x = std::max(high_.x, furthest({1, 0, 0}, bottom, neck).x);
    low_.x = std::min(low_.x, furthest({-1, 0, 0}, bottom, neck).x);
    high_.y = std::max(high_.y, furthest({0, 1, 0}, bottom, neck).y);
    low_.y = std::min(low_.y, furthest({0, -1, 0}, bottom, neck).y);
  } else {
    low_.x = std::min(low_.x, furthest({-1, 0, 0}, apex + 0.2, 0.0).x);  // a bent apex
    high_.x = std::max(high_.x, furthest({1, 0, 0}, apex + 0.2, 0.0).x);
  }
}

void ToothShape::measure_crown_and_root() {
  const ToothTable& t = table_;
  double crown = 0.0;
  for (const CuspTable& cusp : t.cusps) {
    Vec3 tip = from_table(cusp.tip);
    double z = -1e9;
    for (double step = 0.4; step > 0.02; step *= 0.5) {
      const Vec3 at = tip;
      for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
          const Vec3 from{at.x + i * step, at.y + j * step, high_.z + 0.3};
          const auto d = march(from, {0, 0, -1}, std::min(8.0, from.z - z + kPastMm));
          if (d && from.z - *d > z) z = from.z - *d, tip = {from.x, from.y, z};
        }
      }
    }
    crown = std::max(crown, z);
  }
  dims_.crown_length = crown;

  double apex = 0.0;
  std::vector<Vec3> starts;
  for (const Loft& root : roots_) starts.push_back(root.apex());
  if (starts.empty()) starts.push_back({t.canals.front().path.back().x, t.canals.front().path.back().y, wall_.bottom_z()});
  for (const Vec3& start : starts) {
    Vec3 tip = from_table(start);
    double z = 1e9;
    for (double step = 0.4; step > 0.02; step *= 0.5) {
      const Vec3 at = tip;
      for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
          const Vec3 from{at.x + i * step, at.y + j * step, -t.dims.root_length * 1.3 - 1.0};
          const auto d = march(from, {0, 0, 1}, std::min(12.0, z - from.z + kPastMm));
          if (d && from.z + *d < z) z = from.z + *d, tip = {from.x, from.y, z};
        }
      }
    }
    apex = std::min(apex, z);
  }
  dims_.root_length = -apex;
}

void ToothShape::fit() {
  const ToothDims want = varied(table_.dims, seed_);
  const double md = want.mesiodistal / table_.dims.mesiodistal, bl = want.buccolingual / table_.dims.buccolingual;
  scale_.x_crown *= md;
  scale_.x_neck *= md;
  scale_.y_crown *= bl;
  scale_.y_neck *= bl;
  scale_.z_crown *= want.crown_length / table_.dims.crown_length;
  scale_.z_root *= want.root_length / table_.dims.root_length;
  constexpr int kRounds = 4;  // residual after the last: below 0.3 % (tests/scenarios/teeth)
  for (int round = 0; round < kRounds; ++round) {
    measure();
    scale_.x_crown *= want.mesiodistal / dims_.mesiodistal;
    scale_.x_neck *= want.mesiodistal_neck / dims_.mesiodistal_neck;
    scale_.y_crown *= want.buccolingual / dims_.buccolingual;
    scale_.y_neck *= want.buccolingual_neck / dims_.buccolingual_neck;
    scale_.z_crown *= want.crown_length / dims_.crown_length;
    scale_.z_root *= want.root_length / dims_.root_length;
  }
  measure();
}

}  // namespace cusp::scenarios
