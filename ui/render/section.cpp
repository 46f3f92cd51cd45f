#include "ui/render/section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/tool/swept.h"
#include "ui/modules.h"
#include "ui/render/scenery_section.h"
#include "ui/render/tissue_plane.h"

namespace cusp::ui {
namespace {

std::uint32_t packed(Colour c) {
  const auto byte = [](float v) { return static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f)); };
  return byte(c.r) | byte(c.g) << 8 | byte(c.b) << 16 | byte(c.a) << 24;
}

Colour over(Colour under, Colour top, float alpha) {
  alpha *= top.a;
  const float a = alpha + under.a * (1 - alpha);
  if (a <= 0) return {0, 0, 0, 0};
  const auto mix = [&](float u, float t) { return (t * alpha + u * under.a * (1 - alpha)) / a; };
  return {mix(under.r, top.r), mix(under.g, top.g), mix(under.b, top.b), a};
}

/// Solid fraction between the voxels' centres, 0 to 1; for a filled volume the share of occupied corners. `volume`: it, or
/// its specimen, uncut.
template <class Field>
double solid_at(const Field& volume, Reading reading, Vec3 p) {
  const IVec3 cell(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)),
                   static_cast<int>(std::floor(p.z)));
  const Vec3 f = p - Vec3(cell);
  const bool filled = reading == Reading::filled;
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    const IVec3 corner(i & 1, i >> 1 & 1, i >> 2);
    const double w = (corner.x ? f.x : 1 - f.x) * (corner.y ? f.y : 1 - f.y) * (corner.z ? f.z : 1 - f.z);
    const IVec3 v = cell + corner;
    sum += w * (filled ? (volume.s(v) > 0 ? 1.0 : 0.0) : volume.s(v) / 65535.0);
  }
  return sum;
}

float line(double distance_px, double half_width_px) {
  return static_cast<float>(std::clamp(half_width_px + 0.5 - std::abs(distance_px), 0.0, 1.0));
}

constexpr double kLeastSlope = 0.2;  // [M]

/// How fast a distance rises in the plane, a pixel a pixel: a wall that lies nearly in the plane would draw a wide line. Not below
/// kLeastSlope, where noise would tear the line.
double slope_in_plane(double rise_right, double rise_up) { return std::clamp(std::hypot(rise_right, rise_up), kLeastSlope, 1.0); }

/// A field of the plane, asked at every fourth pixel and interpolated: a distance changes slowly.
class PlaneField {
 public:
  PlaneField(int width, int height, const auto& at_px, const std::function<double(Vec3)>& field) {
    if (!field) return;
    columns_ = width / kStep + 2;
    const int rows = height / kStep + 2;
    values_.reserve(static_cast<std::size_t>(columns_ * rows));
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns_; ++x) values_.push_back(static_cast<float>(field(at_px(x * kStep, y * kStep))));
  }
  bool empty() const { return values_.empty(); }
  float at(int x, int y) const {
    const int cx = x / kStep, cy = y / kStep;
    const float fx = static_cast<float>(x % kStep) / kStep, fy = static_cast<float>(y % kStep) / kStep;
    const auto v = [&](int i, int j) { return values_[static_cast<std::size_t>((cy + j) * columns_ + cx + i)]; };
    return (v(0, 0) * (1 - fx) + v(1, 0) * fx) * (1 - fy) + (v(0, 1) * (1 - fx) + v(1, 1) * fx) * fy;
  }
  /// How much of a line along the field's border covers a pixel, 0 to 1.
  float line_at(int x, int y, double px_per_mm, double half_width_px) const {
    const double d_px = at(x, y) * px_per_mm;
    if (line(d_px, half_width_px) <= 0) return 0;
    const auto rise = [&](int i, int j) { return (at(x + i, y + j) - at(x, y)) * px_per_mm; };
    return line(d_px / slope_in_plane(rise(1, 0), rise(0, 1)), half_width_px);
  }

 private:
  static constexpr int kStep = 4;
  int columns_ = 0;
  std::vector<float> values_;
};

/// How far a place lies within the bur, mm; above 0 outside.
double bur_distance(const Bur& bur, Vec3 from_pivot, Vec3 axis) {
  const double along = glm::dot(from_pivot, axis);
  const double across = glm::length(from_pivot - along * axis);
  double d = head_distance(bur, axis, from_pivot);
  const auto rod = [&](double low, double high, double radius) {
    return std::max({across - radius, low - along, along - high});
  };
  d = std::min(d, rod(0, bur.neck_length_mm, bur.neck_radius_mm));
  return std::min(d, rod(bur.neck_length_mm, bur.neck_length_mm + bur.shank_length_mm, bur.shank_radius_mm));
}

}  // namespace

namespace {

constexpr Colour kGhostLight = kDifference[2];
constexpr double kGhostHalfPx = 0.9;  // of the line's width
constexpr double kGhostRimPx = 1.5;  // where its wall meets the specimen's own surface no line is drawn

Reading reading_of(const Specimen& specimen) { return specimen.reading(); }
Reading reading_of(const Volume& volume) { return volume.specimen().reading(); }

/// Distance to the surface in pixels, below 0 in tissue. `v`: the voxel at `p`, which is in voxels; where it is whole or empty and
/// the field a distance, nothing is interpolated.
template <class Field>
double surface_px(const Field& field, IVec3 v, Vec3 p, double voxel_px) {
  const bool filled = reading_of(field) == Reading::filled;
  double s = field.s(v) / 65535.0;
  if ((s > 0.0 && s < 1.0) || filled) s = solid_at(field, reading_of(field), p);
  return (0.5 - s) * 2 * (filled ? 1.0 : kBandVoxels) * voxel_px;
}

/// A wall of the ghost over `c`, in dashes of two colours: it shows on tissue and on either theme.
Colour over_ghost(Colour c, const Volume& ghost, const SectionPlane& plane, IVec3 v, Vec3 p, double voxel_px, int dash) {
  const double d = surface_px(ghost, v, p, voxel_px);
  if (line(d, kGhostHalfPx) <= 0 || surface_px(ghost.specimen(), v, p, voxel_px) > -kGhostRimPx) return c;
  const auto rise = [&](Vec3 way) { return surface_px(ghost, v, p + way / voxel_px, voxel_px) - d; };
  return over(c, dash % 8 < 4 ? kTargetCasing : kGhostLight, line(d / slope_in_plane(rise(plane.right), rise(plane.up)), kGhostHalfPx));
}

/// The bur's metal and outline over `c`.
Colour over_bur(Colour c, const SectionSettings& settings, Vec3 at_mm) {
  const double b_px = bur_distance(*settings.bur, at_mm - settings.pivot_mm, settings.axis) / settings.mm_per_px;
  if (b_px >= 1.0) return c;
  c = over(c, settings.metal, static_cast<float>(std::clamp(0.5 - b_px, 0.0, 1.0)));
  return over(c, settings.edge, line(b_px, 0.5));
}

}  // namespace

SectionImage draw_section(const Volume& volume, const SectionSettings& settings) {
  SectionImage out;
  out.width = std::max(settings.width, 1);
  out.height = std::max(settings.height, 1);
  out.mm_per_px = settings.mm_per_px;
  out.plane = settings.plane;
  out.rgba.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));

  const Grid& grid = volume.grid();
  const std::array<Colour, kTissueCodes> colours = tissue_colours();
  const auto at_px = [&](int x, int y) {
    return settings.plane.centre_mm + (x - (out.width - 1) / 2.0) * settings.mm_per_px * settings.plane.right -
           (y - (out.height - 1) / 2.0) * settings.mm_per_px * settings.plane.up;
  };
  const PlaneField target(out.width, out.height, at_px, settings.target);
  const PlaneField leeway(out.width, out.height, at_px, settings.leeway);
  const TissuePlane tissues(volume.specimen(), settings);
  std::vector<SceneryPixel> scenery;
  if (settings.scenery) scenery = scenery_in_section(*settings.scenery, settings);
  const double px_per_mm = 1.0 / settings.mm_per_px;
  const double voxel_px = grid.voxel_mm * px_per_mm;

  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const Vec3 at = at_px(x, y);
      const Vec3 p = (at - grid.origin_mm) / grid.voxel_mm;
      const IVec3 v(static_cast<int>(std::floor(p.x + 0.5)), static_cast<int>(std::floor(p.y + 0.5)),
                    static_cast<int>(std::floor(p.z + 0.5)));
      const double d_px = surface_px(volume, v, p, voxel_px);
      Colour c{0, 0, 0, 0};
      // Where the specimen has or had tissue its voxels know better; round it the scenery continues.
      if (!scenery.empty() && volume.specimen().s(v) < kHalf) {
        const SceneryPixel& beside = scenery[static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x)];
        if (beside.tissue != Tissue::empty) c = colours[index_of(beside.tissue) % kTissueCodes];
        c = over(c, settings.edge, 0.85f * beside.edge);
      }
      if (d_px < 1.0) {
        c = over(c, tissues.at(x, y, colours), static_cast<float>(std::clamp(0.5 - d_px, 0.0, 1.0)));
        c = over(c, settings.edge, 0.85f * line(d_px, 0.6));
      } else if (!target.empty() && target.at(x, y) < 0 && volume.specimen().s(v) > 0) {
        // What was taken away as it should be, to where the specimen's surface was.
        const double was_px = -surface_px(volume.specimen(), v, p, voxel_px);
        c = over(c, kTargetLine, 0.10f * static_cast<float>(std::clamp(was_px + 0.5, 0.0, 1.0)));
      }
      if (settings.bur) c = over_bur(c, settings, at);
      if (volume.specimen().s(v) > 0) {  // the target goes up without end; its lines end just above the specimen
        if (!leeway.empty() && (x + y) % 9 < 6) c = over(c, kLeewayLine, leeway.line_at(x, y, px_per_mm, 0.6));
        if (!target.empty()) c = over(c, kTargetLine, target.line_at(x, y, px_per_mm, 0.9));
        if (settings.ghost) c = over_ghost(c, *settings.ghost, settings.plane, v, p, voxel_px, 2 * x + 3 * y);
      }
      out.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x)] =
          packed(c);
    }
  return out;
}

}  // namespace cusp::ui
