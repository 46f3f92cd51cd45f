#include "scenarios/teeth/occlusal.h"

#include <algorithm>

#include "scenarios/teeth/noise.h"

namespace cusp::scenarios {
namespace {

constexpr double kHalfExtentMm = 7.2;  // beyond the widest crown (BL 11 mm) and a seed's spread
const Vec3 kMapMm{kHalfExtentMm + 0.1, kHalfExtentMm + 0.1, 0.1};
constexpr double kFanBlurMm = 0.11;    // nearest-point fans leave ribs without it (teeth.md)
constexpr double kDentineBlurMm = 0.42;
constexpr double kWanderMm = 0.07, kWanderLengthMm = 0.8;  // below a fissure's half width: by eye
constexpr double kBumpMm = 0.09, kBumpLengthMm = 2.2;  // a seed's variation of the height

/// A crest line and the slopes to both sides of it.
struct Roof {
  Line2 line;
  std::vector<double> z;  // at the line's points
  const RidgeTable* table;
  double highest;  // of z
};

/// No less than roof_height there.
double roof_at_most(const Roof& roof, Vec2 p) {
  const RidgeTable& t = *roof.table;
  const Vec2 off = glm::max(glm::max(roof.line.low() - p, p - roof.line.high()), Vec2(0.0));
  const double slope = std::max(0.0, std::min(t.inner_slope, t.outer_slope)), r = t.rounding_mm;
  constexpr double kRoundingMm = 1e-9;
  return roof.highest - slope * (std::sqrt(glm::dot(off, off) + r * r) - r) + kRoundingMm;
}

double roof_height(const Roof& roof, Vec2 p, Vec2 centre) {
  const Line2::Nearest near = roof.line.nearest(p);
  const std::size_t i = near.segment, j = std::min(i + 1, roof.z.size() - 1);
  const double crest = roof.z[i] + near.share * (roof.z[j] - roof.z[i]);
  const RidgeTable& t = *roof.table;
  double k = t.inner_slope;
  if (t.outer_slope != t.inner_slope) {
    const Vec2 outward = near.point - centre, offset = p - near.point;
    const double side = glm::dot(outward, offset) / ((glm::length(outward) + 1e-9) * (near.distance + 0.15));
    k += (t.outer_slope - t.inner_slope) * smoothstep(-0.35, 0.35, side);
  }
  const double d = near.distance, r = t.rounding_mm;
  return crest - k * (std::sqrt(d * d + r * r) - r);
}

HeightField steepness_of(const HeightField& height) {
  HeightField out = height;
  for (int j = 0; j < height.height(); ++j) {
    for (int i = 0; i < height.width(); ++i) {
      const double dx = double(height.clamped(i + 1, j) - height.clamped(i - 1, j)) / (2.0 * HeightField::kStepMm);
      const double dy = double(height.clamped(i, j + 1) - height.clamped(i, j - 1)) / (2.0 * HeightField::kStepMm);
      out.cell(i, j) = static_cast<float>(1.0 / std::sqrt(1.0 + dx * dx + dy * dy));
    }
  }
  return out;
}

/// Depth of all fissures and pits at a place. Where they meet, the deeper one counts, with a soft join.
class Fissures {
 public:
  /// A bottom sharper than half a voxel would ring in the cubic reading of the samples, two voxels to either side.
  Fissures(const ToothTable& table, std::uint64_t seed, double min_half_width_mm)
      : bottom_(0.3 * min_half_width_mm),
        wander_x_(seed * 5 + 11, kWanderLengthMm, kMapMm),
        wander_y_(seed * 5 + 12, kWanderLengthMm, kMapMm),
        uneven_(seed * 5 + 13, 2.0 * kWanderLengthMm, kMapMm) {
    for (const GrooveTable& g : table.grooves) {
      lines_.push_back({Line2(smooth_line<Vec2>(g.path, 8)), g.depth_mm, std::max(g.half_width_mm, min_half_width_mm)});
    }
    for (const PitTable& p : table.pits) pits_.push_back({p.at, p.depth_mm, std::max(p.width_mm, min_half_width_mm)});
  }
  double depth(Vec2 p) const {
    // Fissures wander and are not evenly deep; all by the same field, so that those which meet still meet.
    const Vec3 at{p.x, p.y, 0.0};
    const double deeper = 1.0 + 0.15 * uneven_.at(at);
    p += kWanderMm * Vec2(wander_x_.at(at), wander_y_.at(at));
    double sum4 = 0.0;
    for (const Groove& g : lines_) {
      const double reach = 7.0 * g.width;
      if (p.x < g.line.low().x - reach || p.x > g.line.high().x + reach || p.y < g.line.low().y - reach ||
          p.y > g.line.high().y + reach)
        continue;
      const Line2::Nearest near = g.line.nearest(p);
      const double d = near.distance, w = g.width;
      const double fade = 1.0 - 0.55 * smoothstep(0.3, 1.0, near.along / g.line.length());
      const double depth = g.depth * fade * std::exp(-(d / w) * d / (d + bottom_));
      sum4 += depth * depth * depth * depth;
    }
    double depth = deeper * std::sqrt(std::sqrt(sum4));
    for (const Pit& pit : pits_) {
      const double r2 = glm::dot(p - pit.at, p - pit.at) / (pit.width * pit.width);
      if (r2 < 12.0) depth += pit.depth * std::exp(-r2);
    }
    return depth;
  }

 private:
  struct Groove {
    Line2 line;
    double depth, width;
  };
  struct Pit {
    Vec2 at;
    double depth, width;
  };
  std::vector<Groove> lines_;
  std::vector<Pit> pits_;
  double bottom_;  // rounding of the V
  ValueNoise wander_x_, wander_y_, uneven_;
};

}  // namespace

Occlusal::Occlusal(const ToothTable& table, std::uint64_t seed, double min_half_width_mm) {
  std::vector<Roof> roofs;
  Vec2 low{1e9}, high{-1e9};
  for (const RidgeTable& r : table.ridges) {
    std::vector<Vec2> flat;
    std::vector<double> z;
    for (const Vec3& p : smooth_line<Vec3>(r.path, 8)) {
      flat.emplace_back(p.x, p.y);
      z.push_back(p.z);
      low = glm::min(low, flat.back());
      high = glm::max(high, flat.back());
    }
    const double highest = *std::max_element(z.begin(), z.end());
    roofs.push_back({Line2(std::move(flat)), std::move(z), &r, highest});
  }
  const Vec2 centre = 0.5 * (low + high);
  HeightField bare(Vec2(-kHalfExtentMm), Vec2(kHalfExtentMm));
  const ValueNoise bump(seed * 3 + 2, kBumpLengthMm, kMapMm);
  for (int j = 0; j < bare.height(); ++j) {
    for (int i = 0; i < bare.width(); ++i) {
      const Vec2 p = bare.place(i, j);
      double h = table.floor_z;
      for (const Roof& roof : roofs) {
        if (roof_at_most(roof, p) <= h - table.ridge_blend_mm) continue;  // then it adds nothing, to the bit
        h = smax(h, roof_height(roof, p, centre), table.ridge_blend_mm);
      }
      if (seed != 0) h += kBumpMm * bump.at({p.x, p.y, 0.0});
      bare.cell(i, j) = static_cast<float>(h);
    }
  }
  height_ = bare.blurred(kFanBlurMm);
  soft_ = bare.blurred(kDentineBlurMm);
  const Fissures fissures(table, seed, min_half_width_mm);
  for (int j = 0; j < height_.height(); ++j) {
    for (int i = 0; i < height_.width(); ++i) height_.cell(i, j) -= static_cast<float>(fissures.depth(height_.place(i, j)));
  }
  steepness_ = steepness_of(height_);
  soft_steepness_ = steepness_of(soft_);
  lowest_ = height_.lowest();
}

}  // namespace cusp::scenarios
