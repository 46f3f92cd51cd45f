#include "scenarios/teeth/caries.h"

#include <algorithm>
#include <cmath>

#include "scenarios/teeth/landmarks.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/shape.h"
#include "scenarios/teeth/tables.h"

namespace cusp::scenarios {
namespace {

constexpr double kBelowContactMm = 1.0;   // proximal caries begins 0.5 to 1 mm below the contact [M]
constexpr double kTowardsPulp = 0.35;     // and follows the tubules cervically [M]
constexpr double kBelowCejMm = 1.2;       // root caries sits just below the gingival margin [M]
constexpr double kSpread = 1.25;          // a lesion is that much wider in dentine than where it enters it (teeth.md)

/// The tooth's outermost place at that height, seen along `way` from its axis.
std::optional<Vec3> on_side(const ToothShape& shape, Vec3 way, Vec3 through) {
  const auto gone = shape.march(through + 9.0 * way, -way, 12.0);
  if (!gone) return std::nullopt;
  return through + (9.0 - *gone) * way;
}

Vec3 outward(const ToothShape& shape, Vec3 p) {
  constexpr double h = 0.05;
  const auto f = [&](double x, double y, double z) { return shape.outside(p + h * Vec3(x, y, z)); };
  return glm::normalize(Vec3(f(1, 0, 0) - f(-1, 0, 0), f(0, 1, 0) - f(0, -1, 0), f(0, 0, 1) - f(0, 0, -1)));
}

std::optional<Vec3> fissure_site(const std::string& name, const ToothLandmarks& marks) {
  for (const SurfacePlace& pit : marks.pits) {
    if (pit.name == name) return pit.at_mm;
  }
  if (name == "central" && !marks.fissures.empty()) return marks.central;
  const SurfaceLine* line = marks.fissure(name);
  if (line == nullptr || line->points_mm.empty()) return std::nullopt;
  return line->points_mm[line->points_mm.size() / 2];
}

std::optional<Vec3> side_way(const std::string& name) {
  if (name == "mesial") return Vec3(1, 0, 0);
  if (name == "distal") return Vec3(-1, 0, 0);
  if (name == "buccal") return Vec3(0, 1, 0);
  if (name == "lingual") return Vec3(0, -1, 0);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> lesion_sites(int fdi, Lesion::Kind kind) {
  const auto choice = table_for(fdi);
  if (!choice) return {};
  if (kind == Lesion::Kind::proximal) return {"mesial", "distal"};
  if (kind == Lesion::Kind::root) return {"mesial", "distal", "buccal", "lingual"};
  std::vector<std::string> out;
  if (!choice->table->grooves.empty()) out.push_back("central");
  for (const PitTable& pit : choice->table->pits) {
    if (pit.name != "central") out.push_back(pit.name);
  }
  return out;
}

std::optional<PlacedLesion> PlacedLesion::place(const Lesion& lesion, const ToothShape& shape, const ToothLandmarks& marks) {
  PlacedLesion out(lesion, shape);
  std::optional<Vec3> site;
  if (lesion.kind == Lesion::Kind::fissure) {
    site = fissure_site(lesion.site, marks);
    out.in_ = {0, 0, -1};
  } else {
    const auto way = side_way(lesion.site);
    if (!way) return std::nullopt;
    if (lesion.kind == Lesion::Kind::proximal) {
      if (way->x == 0.0) return std::nullopt;
      Vec3 through = way->x > 0.0 ? marks.mesial_contact : marks.distal_contact;
      through.x = 0.0;
      through.z -= kBelowContactMm;
      site = on_side(shape, *way, through);
    } else {
      const Vec3 neck = *std::max_element(marks.cej.begin(), marks.cej.end(), [&](Vec3 a, Vec3 b) { return glm::dot(a, *way) < glm::dot(b, *way); });
      Vec3 through = neck - glm::dot(neck, *way) * *way;
      through.z = neck.z - kBelowCejMm;
      site = on_side(shape, *way, through);
    }
    if (site) {
      // Of a wall's tilt only half: it would lead a deep lesion up or down past the dentine that lies behind it.
      Vec3 n = outward(shape, *site);
      n.z = lesion.kind == Lesion::Kind::proximal ? kTowardsPulp : 0.5 * n.z;
      out.in_ = -glm::normalize(n);
    }
  }
  if (!site) return std::nullopt;
  out.at_ = *site;
  constexpr double kStep = 0.02, kMost = 4.0;
  while (out.to_junction_ < kMost) {
    const Vec3 p = out.at_ + out.to_junction_ * out.in_;
    if (shape.dentine(p, shape.outside(p)) < 0.0) break;
    out.to_junction_ += kStep;
  }
  out.junction_ = out.at_ + out.to_junction_ * out.in_;
  out.reach_ = out.to_junction_ + 0.35 + lesion.depth_mm + 2.1 * lesion.radius_mm;
  return out;
}

Tissue PlacedLesion::carious(Tissue sound, Vec3 p, double outside_mm, double dentine_mm) const noexcept {
  if (sound != Tissue::enamel && sound != Tissue::dentine && sound != Tissue::cementum) return sound;
  const Vec3 off = p - at_;
  if (glm::dot(off, off) > reach_ * reach_) return sound;
  const double r = lesion_.radius_mm, deep = lesion_.depth_mm;
  const double along = glm::dot(off, in_), rho = glm::length(off - along * in_);
  double share = 2.0;  // 0 in its middle, 1 at its rim
  if (lesion_.kind == Lesion::Kind::root) {
    const double d = std::max(-outside_mm, 0.0) / std::max(deep, 0.05);
    share = along > -r ? std::sqrt(rho * rho / (r * r) + d * d) : 2.0;
  } else if (sound == Tissue::enamel) {
    const double e = std::max(-outside_mm, 0.0), d = std::max(dentine_mm, 0.0), t = e / (e + d + 1e-9);
    const bool fissure = lesion_.kind == Lesion::Kind::fissure;
    const double wide = fissure ? r * (0.3 + 0.7 * t) : r * (1.0 - 0.75 * t);
    // Not past the junction: behind it the enamel of another wall may come near the axis again.
    if (along > to_junction_ + 0.3 || along < (fissure ? -0.5 : -0.3)) return sound;
    if (!fissure && along > e + 0.5) return sound;  // the enamel of the fossa above it
    share = rho / wide;
    return share < 1.0 ? Tissue::carious_enamel : sound;
  } else if (deep > 0.0 && sound == Tissue::dentine) {
    const double wide = (lesion_.kind == Lesion::Kind::fissure ? kSpread : 0.95) * r, below = std::max(-dentine_mm, 0.0);
    const double from = along - to_junction_, across = rho / wide;
    if (across >= 1.0 || below >= deep || glm::length(p - junction_) > 2.1 * r + deep) return sound;
    if (from > 0.35 + deep * (1.0 - across * across)) return sound;
    share = std::sqrt(across * across + below / deep);
  }
  if (share >= 1.0 || shape_->pulp(p) < kLesionFromPulpMm) return sound;
  return share < lesion_.softness ? Tissue::carious_dentine : kFirmCariousDentine;
}

}  // namespace cusp::scenarios
