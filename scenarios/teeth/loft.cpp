#include "scenarios/teeth/loft.h"

#include <algorithm>

#include "scenarios/teeth/power.h"

namespace cusp::scenarios {
namespace {

constexpr double kSlopeStepMm = 0.02;  // forward difference along z

std::vector<Knot> knots_of(const LoftTable& t, double (*pick)(const LoftTable&, std::size_t)) {
  std::vector<Knot> out;
  for (std::size_t i = 0; i < t.path.size(); ++i) out.push_back({t.path[i].z, pick(t, i)});
  return out;
}
double raised(std::vector<Knot>& knots, double least) {
  for (Knot& k : knots) k.value = std::max(k.value, least);
  return least;
}
/// Weight of one side's features: nothing at the middle of the tooth, all from half way out.
double side_weight(double w) noexcept { return w <= 0.05 ? 0.0 : w >= 0.5 ? 1.0 : smoothstep(0.05, 0.5, w); }

/// (|u|^n + |v|^n)^(1/n) at two places, and its slopes by |u| and |v| at the first.
struct Ellipses {
  Ellipses(Pair u, Pair v, Pair n) noexcept {
    const Pair au{off_axis(u[0]), off_axis(u[1])}, av{off_axis(v[0]), off_axis(v[1])};
    const Pair un = power(au, n), vn = power(av, n), sum = un + vn;
    g = power(sum, 1.0 / n);
    gu = un[0] / au[0] * g[0] / sum[0];
    gv = vn[0] / av[0] * g[0] / sum[0];
  }
  Pair g;
  double gu, gv;

 private:
  static double off_axis(double x) noexcept { return std::max(std::fabs(x), 1e-9); }
};

/// A round end: `cap` grows from 0 where it begins to 1 at the end.
double capped(double g, double cap) noexcept { return cap > 0.0 ? std::sqrt(g * g + cap * cap) : g; }

}  // namespace

Loft::Loft(const LoftTable& t, double min_radius_mm)
    : cx_(knots_of(t, [](const LoftTable& l, std::size_t i) { return l.path[i].x; }), Beyond::linear),
      cy_(knots_of(t, [](const LoftTable& l, std::size_t i) { return l.path[i].y; }), Beyond::linear),
      exponent_(t.exponent),
      low_z_(t.path.back().z),
      high_z_(t.path.front().z),
      low_cap_(t.cap_mm),
      high_cap_(t.top_cap_mm),
      cos_(std::cos(glm::radians(t.rotation_deg))),
      sin_(std::sin(glm::radians(t.rotation_deg))) {
  std::vector<Knot> rx = knots_of(t, [](const LoftTable& l, std::size_t i) { return l.rx[i]; });
  std::vector<Knot> ry = knots_of(t, [](const LoftTable& l, std::size_t i) { return l.ry[i]; });
  raised(rx, min_radius_mm);
  raised(ry, min_radius_mm);
  rx_ = Curve(std::move(rx));
  ry_ = Curve(std::move(ry));
}

Loft::Loft(const LoftTable& t, double top_z, double top_cap_mm) : Loft(t, 0.0) {
  high_z_ = top_z;
  high_cap_ = top_cap_mm;
}

Loft::InPlane Loft::in_plane(Vec3 p) const noexcept {
  const double x = p.x - cx_.at(p.z), y = p.y - cy_.at(p.z);
  InPlane out{0, 0, 1.0 / rx_.at(p.z), 1.0 / ry_.at(p.z), 0};
  out.u = (cos_ * x + sin_ * y) * out.per_rx;
  out.v = (cos_ * y - sin_ * x) * out.per_ry;
  if (low_cap_ > 0.0 && p.z < low_z_ + low_cap_) out.cap = (low_z_ + low_cap_ - p.z) / low_cap_;
  if (high_cap_ > 0.0 && p.z > high_z_ - high_cap_) out.cap = (p.z - high_z_ + high_cap_) / high_cap_;
  return out;
}

Sided Loft::sided(Vec3 p) const noexcept {
  const InPlane here = in_plane(p), up = in_plane(p + Vec3(0.0, 0.0, kSlopeStepMm));
  const Ellipses e(Pair{here.u, up.u}, Pair{here.v, up.v}, Pair{exponent_, exponent_});
  const double gu = std::copysign(e.gu, here.u) * here.per_rx, gv = std::copysign(e.gv, here.v) * here.per_ry;
  const double g = capped(e.g[0], here.cap), shrink = e.g[0] / g;
  const double dx = (cos_ * gu - sin_ * gv) * shrink, dy = (sin_ * gu + cos_ * gv) * shrink;
  const double dz = (capped(e.g[1], up.cap) - g) / kSlopeStepMm;
  const double slope = std::sqrt(dx * dx + dy * dy + dz * dz + 1e-12);
  return {(g - 1.0) / slope, Vec3(dx, dy, dz) / slope};
}

Wall::Wall(const ToothTable& table, double min_half_width_mm) {
  const WallTable& w = table.wall;
  const Curve m(w.m, Beyond::linear), d(w.d, Beyond::linear), b(w.b, Beyond::linear), l(w.l, Beyond::linear);
  const Curve cy(w.cy), taper(w.taper), shear = w.shear.empty() ? Curve() : Curve(w.shear);
  std::array<Curve, 4> n;
  for (std::size_t q = 0; q < 4; ++q) n[q] = Curve(w.exponent[q]);
  bottom_z_ = w.m.front().z;
  cap_ = w.cap_mm;
  const bool has_roots = !table.roots.empty();
  first_z_ = bottom_z_ - 1.5;
  const double last_z = w.m.back().z + 1.5;
  for (double z = first_z_; z < last_z; z += kSectionStepMm) {
    const double zm = m.at(z), zd = d.at(z), zb = b.at(z), zl = l.at(z);
    Section s;
    s.x0 = 0.5 * (zm + zd);
    s.y0 = zl + cy.at(z) * (zb - zl);
    // The trunk draws in over its last 2.4 mm, so that roots take over without a ledge.
    const double narrow = has_roots ? 1.0 - 0.36 * smoothstep(bottom_z_ + 2.4, bottom_z_, z) : 1.0;
    constexpr double kLeastMm = 0.05;
    s.a = std::max(kLeastMm, 0.5 * (zm - zd) * narrow);
    s.buccal = std::max(kLeastMm, (zb - s.y0) * narrow);
    s.lingual = std::max(kLeastMm, (s.y0 - zl) * narrow);
    s.half = std::max(kLeastMm, 0.5 * (zb - zl));
    s.taper = taper.at(z);
    s.shear = shear.at(z);
    for (std::size_t q = 0; q < 4; ++q) s.n[q] = n[q].at(z);
    sections_.push_back(s);
  }
  build_faces(table, min_half_width_mm);
}

Wall::Section Wall::section(double z) const noexcept {
  if (cap_ > 0.0) z = std::max(z, bottom_z_);  // below the apex the profiles cross
  const double t = std::clamp((z - first_z_) / kSectionStepMm, 0.0, static_cast<double>(sections_.size()) - 1.001);
  const auto i = static_cast<std::size_t>(t);
  const double f = t - static_cast<double>(i), e = 1.0 - f;
  const Section &p = sections_[i], &q = sections_[i + 1];
  Section s;
  s.x0 = e * p.x0 + f * q.x0;
  s.y0 = e * p.y0 + f * q.y0;
  s.a = e * p.a + f * q.a;
  s.buccal = e * p.buccal + f * q.buccal;
  s.lingual = e * p.lingual + f * q.lingual;
  s.half = e * p.half + f * q.half;
  s.taper = e * p.taper + f * q.taper;
  s.shear = e * p.shear + f * q.shear;
  for (std::size_t k = 0; k < 4; ++k) s.n[k] = e * p.n[k] + f * q.n[k];
  return s;
}

Wall::InPlane Wall::in_plane(Vec3 p, const Section& s) const noexcept {
  InPlane r;
  r.y = p.y - s.y0;
  r.widen = std::max(0.3, 1.0 + s.taper * r.y / s.half);
  r.x = (p.x - s.x0 - s.shear * r.y) / r.widen;
  r.b = r.y > 0.0 ? s.buccal : s.lingual;
  r.side = {r.x / s.a, r.y / r.b};
  return r;
}

Wall::Slopes Wall::slopes(Vec3 p, const InPlane& at, const Section& s) const noexcept {
  const Vec3 above = p + Vec3(0.0, 0.0, kSlopeStepMm);
  const Section s_up = section(above.z);
  const InPlane up = in_plane(above, s_up);
  const Ellipses e(Pair{at.side.u, up.side.u}, Pair{at.side.v, up.side.v}, Pair{exponent(at, s), exponent(up, s_up)});
  const double gu = std::copysign(e.gu, at.side.u) / s.a, gv = std::copysign(e.gv, at.side.v) / at.b;
  Slopes r;
  r.g = capped(e.g[0], cap_at(p.z));
  const double shrink = e.g[0] / r.g;
  r.dx = gu / at.widen * shrink;
  r.dy = (gv - gu * (s.shear + at.x * s.taper / s.half) / at.widen) * shrink;
  r.dz = (capped(e.g[1], cap_at(above.z)) - r.g) / kSlopeStepMm;
  return r;
}

template <bool kSoft>
WallPlace Wall::place(Vec3 p) const noexcept {
  const Section s = section(p.z);
  const InPlane at = in_plane(p, s);
  const WallSide here = at.side;
  const Slopes to = slopes(p, at, s);
  WallPlace out;
  out.u = here.u;
  out.v = here.v;
  const double slope = std::sqrt(to.dx * to.dx + to.dy * to.dy + to.dz * to.dz + 1e-12);
  out.plain = (to.g - 1.0) / slope;
  out.normal = Vec3(to.dx, to.dy, to.dz) / slope;
  out.featured = out.soft = out.plain;
  const double side[4] = {here.u, -here.u, here.v, -here.v};
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side_weight(side[k]);
    if (weight == 0.0 || faces_[k].all.empty()) continue;
    const double along = k < 2 ? p.y : p.x;
    out.featured -= weight * faces_[k].all.at(along, p.z);
    if (kSoft && !faces_[k].soft.empty()) out.soft -= weight * faces_[k].soft.at(along, p.z);
  }
  return out;
}
template WallPlace Wall::place<true>(Vec3) const noexcept;
template WallPlace Wall::place<false>(Vec3) const noexcept;

void Wall::build_faces(const ToothTable& table, double min_half_width_mm) {
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<const FaceTable*> mine;
    Vec2 low{1e9}, high{-1e9};
    for (const FaceTable& f : table.faces) {
      if (static_cast<std::size_t>(f.side) != k) continue;
      mine.push_back(&f);
      const double reach = 2.8 * f.width_mm;
      for (const Vec2 q : f.path) {
        low = glm::min(low, q - reach);
        high = glm::max(high, q + reach);
      }
    }
    if (mine.empty()) continue;
    Face& face = faces_[k];
    face.all = face.soft = HeightField(low, high);
    for (const FaceTable* f : mine) {
      const Line2 line(smooth_line<Vec2>(f->path, 8));
      const double width = std::max(f->width_mm, min_half_width_mm), reach = 2.8 * width;
      const bool fades = line.length() > 2.2 * width;
      // Broad ones rise slowly, or their ends show as dimples; a fissure's continuation must still be deep at the rim.
      const double fade = f->width_mm < 0.5 ? std::min(0.3 * line.length(), 1.6 * width)
                                            : std::min(0.45 * line.length(), 3.5 * width);
      // A narrow groove is in the enamel only; ridges and broad hollows are in the dentine too.
      const bool soft = f->outward_mm > 0.0 || width > 0.7;
      for (int j = 0; j < face.all.height(); ++j) {
        for (int i = 0; i < face.all.width(); ++i) {
          const Vec2 at = face.all.place(i, j);
          if (at.x < line.low().x - reach || at.x > line.high().x + reach || at.y < line.low().y - reach ||
              at.y > line.high().y + reach)
            continue;
          const Line2::Nearest near = line.nearest(at);
          if (near.distance > reach) continue;
          double a = f->outward_mm * std::exp(-std::pow(near.distance / width, f->power));
          if (fades) a *= smoothstep(0.0, fade, near.along) * smoothstep(0.0, fade, line.length() - near.along);
          face.all.cell(i, j) += static_cast<float>(a);
          if (soft) face.soft.cell(i, j) += static_cast<float>(a);
        }
      }
    }
  }
}

double round_cone(Vec3 p, const HornTable& horn) noexcept {
  const Vec3 ba = horn.b - horn.a, pa = p - horn.a;
  const double l2 = glm::dot(ba, ba), rr = horn.ra - horn.rb, a2 = l2 - rr * rr, il2 = 1.0 / l2;
  const double y = glm::dot(pa, ba), z = y - l2;
  const Vec3 side = pa * l2 - ba * y;
  const double x2 = glm::dot(side, side), y2 = y * y * l2, z2 = z * z * l2;
  const double k = std::copysign(rr * rr * x2, rr);
  if (std::copysign(a2 * z2, z) > k) return std::sqrt(x2 + z2) * il2 - horn.rb;
  if (std::copysign(a2 * y2, y) < k) return std::sqrt(x2 + y2) * il2 - horn.ra;
  return (std::sqrt(x2 * a2 * il2) + y * rr) * il2 - horn.ra;
}

}  // namespace cusp::scenarios
