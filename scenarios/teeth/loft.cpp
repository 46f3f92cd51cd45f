#include "scenarios/teeth/loft.h"

#include <algorithm>

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

Loft::Value Loft::value(Vec3 p) const noexcept {
  const double px = p.x - cx_.at(p.z), py = p.y - cy_.at(p.z);
  const double irx = 1.0 / rx_.at(p.z), iry = 1.0 / ry_.at(p.z);
  const double u = (cos_ * px + sin_ * py) * irx, v = (cos_ * py - sin_ * px) * iry;
  const double au = std::max(std::fabs(u), 1e-9), av = std::max(std::fabs(v), 1e-9);
  double g, gu, gv;
  if (exponent_ == 2.0) {
    g = std::sqrt(au * au + av * av);
    gu = au / g;
    gv = av / g;
  } else {
    const double un = std::pow(au, exponent_), vn = std::pow(av, exponent_), sum = un + vn;
    g = std::pow(sum, 1.0 / exponent_);
    gu = un / au * g / sum;
    gv = vn / av * g / sum;
  }
  gu = std::copysign(gu, u) * irx;
  gv = std::copysign(gv, v) * iry;
  Value out{g, cos_ * gu - sin_ * gv, sin_ * gu + cos_ * gv};
  double t = 0.0;
  if (low_cap_ > 0.0 && p.z < low_z_ + low_cap_) t = (low_z_ + low_cap_ - p.z) / low_cap_;
  if (high_cap_ > 0.0 && p.z > high_z_ - high_cap_) t = (p.z - high_z_ + high_cap_) / high_cap_;
  if (t > 0.0) {
    out.g = std::sqrt(g * g + t * t);
    out.dx *= g / out.g;
    out.dy *= g / out.g;
  }
  return out;
}

Sided Loft::sided(Vec3 p) const noexcept {
  const Value here = value(p);
  const double dz = (value(p + Vec3(0.0, 0.0, kSlopeStepMm)).g - here.g) / kSlopeStepMm;
  const double slope = std::sqrt(here.dx * here.dx + here.dy * here.dy + dz * dz + 1e-12);
  return {(here.g - 1.0) / slope, Vec3(here.dx, here.dy, dz) / slope};
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

Wall::Value Wall::value(Vec3 p, const Section& s) const noexcept {
  const auto [x, y, b, widen, side] = in_plane(p, s);
  Value r;
  r.u = side.u;
  r.v = side.v;
  const double n = s.n[static_cast<std::size_t>((x > 0.0 ? 0 : 1) + (y > 0.0 ? 0 : 2))];
  const double au = std::max(std::fabs(r.u), 1e-9), av = std::max(std::fabs(r.v), 1e-9);
  const double un = std::pow(au, n), vn = std::pow(av, n), sum = un + vn;
  r.g = std::pow(sum, 1.0 / n);
  const double gu = std::copysign(un / au * r.g / sum, r.u) / s.a;
  const double gv = std::copysign(vn / av * r.g / sum, r.v) / b;
  r.dx = gu / widen;
  r.dy = gv - gu * (s.shear + x * s.taper / s.half) / widen;
  if (cap_ > 0.0 && p.z < bottom_z_ + cap_) {
    const double t = (bottom_z_ + cap_ - p.z) / cap_, g = std::sqrt(r.g * r.g + t * t);
    r.dx *= r.g / g;
    r.dy *= r.g / g;
    r.g = g;
  }
  return r;
}

template <bool kSoft>
WallPlace Wall::place(Vec3 p) const noexcept {
  const Value here = value(p, section(p.z));
  const Vec3 up = p + Vec3(0.0, 0.0, kSlopeStepMm);
  const double dz = (value(up, section(up.z)).g - here.g) / kSlopeStepMm;
  WallPlace out;
  out.u = here.u;
  out.v = here.v;
  const double slope = std::sqrt(here.dx * here.dx + here.dy * here.dy + dz * dz + 1e-12);
  out.plain = (here.g - 1.0) / slope;
  out.normal = Vec3(here.dx, here.dy, dz) / slope;
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
