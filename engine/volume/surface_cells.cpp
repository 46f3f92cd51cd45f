#include "engine/volume/surface_cells.h"

#include "engine/volume/cell_field.h"

namespace cusp::engine {

namespace {

/// Tissue of the most solid corner; ties go to the lowest.
Tissue corner_tissue(const Volume& volume, IVec3 cell) noexcept {
  int best = -1;
  Tissue tissue = Tissue::empty;
  for (int i = 0; i < 8; ++i) {
    const IVec3 v = cell + IVec3(i & 1, i >> 1 & 1, i >> 2);
    const int s = volume.s(v);
    if (s > best && volume.tissue(v) != Tissue::empty) {
      best = s;
      tissue = volume.tissue(v);
    }
  }
  return tissue;
}

/// True if the corners' occupancies differ.
bool crosses(const Volume& volume, IVec3 cell) noexcept {
  const bool first = volume.occupied(cell);
  for (int i = 1; i < 8; ++i)
    if (volume.occupied(cell + IVec3(i & 1, i >> 1 & 1, i >> 2)) != first) return true;
  return false;
}

/// True if a corner that the specimen occupied is empty.
bool has_cut_corner(const Volume& volume, IVec3 cell) noexcept {
  const Specimen& specimen = volume.specimen();
  const std::uint16_t least = specimen.reading() == Reading::filled ? std::uint16_t{1} : kHalf;
  for (int i = 0; i < 8; ++i) {
    const IVec3 v = cell + IVec3(i & 1, i >> 1 & 1, i >> 2);
    if (!volume.occupied(v) && specimen.s(v) >= least) return true;
  }
  return false;
}

/// Mean of the edge crossings, for filled volumes and for cells that no polynomial describes.
bool mean_crossing(const Volume& volume, IVec3 cell, SurfacePoint& out) noexcept {
  const bool filled = volume.specimen().reading() == Reading::filled;
  double d[8];
  for (int i = 0; i < 8; ++i) {
    const IVec3 v = cell + IVec3(i & 1, i >> 1 & 1, i >> 2);
    const std::uint16_t s = volume.s(v);
    d[i] = filled ? (s > 0 ? -0.5 : 0.5) : 0.5 - static_cast<double>(s) / 65535.0;
  }
  Vec3 sum(0.0);
  int count = 0;
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const int j = i | 1 << axis;
      if (j == i || (d[i] > 0.0) == (d[j] > 0.0)) continue;
      Vec3 at(i & 1, i >> 1 & 1, i >> 2);
      at[axis] += d[i] / (d[i] - d[j]);
      sum += at;
      ++count;
    }
  if (count == 0) return false;
  Vec3 n(0.0);
  // The normal is of a wider neighbourhood than the cell: a staircase of voxels then shades as a slope.
  for (int z = -1; z <= 2; ++z)
    for (int y = -1; y <= 2; ++y)
      for (int x = -1; x <= 2; ++x)
        if (volume.occupied(cell + IVec3(x, y, z))) n -= Vec3(x, y, z) - 0.5;
  const double length = length_of(n);
  out.normal = length > 1e-9 ? n / length : Vec3(0.0, 0.0, 1.0);
  const Grid& grid = volume.grid();
  out.point_mm = grid.centre_mm(cell) + grid.voxel_mm * (sum / static_cast<double>(count));
  return true;
}

/// The place of the cell where base and cut are both zero, by Newton's shortest steps. False if there is none.
bool meeting_place(const CellField& base, const CellField& cut, Vec3& f) noexcept {
  f = Vec3(0.5);
  Vec3 gb(0.0), gc(0.0);
  for (int pass = 0; pass < 5; ++pass) {
    const double db = base.eval(f, gb);
    const double dc = cut.eval(f, gc);
    const double bb = glm::dot(gb, gb), cc = glm::dot(gc, gc), bc = glm::dot(gb, gc);
    const double det = bb * cc - bc * bc;
    if (!(det > 1e-3)) return false;
    f -= gb * ((db * cc - dc * bc) / det) + gc * ((dc * bb - db * bc) / det);
    for (int a = 0; a < 3; ++a)
      if (!(f[a] > -0.3 && f[a] < 1.3)) return false;
  }
  return true;
}

}  // namespace

bool surface_point(const Volume& volume, IVec3 cell, SurfacePoint& out) noexcept {
  if (!crosses(volume, cell)) return false;
  out.tissue = corner_tissue(volume, cell);
  out.cut = has_cut_corner(volume, cell);
  if (volume.specimen().reading() == Reading::filled) return mean_crossing(volume, cell, out);

  const Grid& grid = volume.grid();
  const Vec3 corner = grid.centre_mm(cell);
  CellField base;
  base.load(volume, Field::base, cell);
  CellField cut;
  cut.load(volume, Field::cut, cell);
  Vec3 f(0.5), fb(0.5), nb(0.0), fc(0.5), nc(0.0), g(0.0);
  const bool has_base = base.crossed() && cell_point(base, fb, nb);
  const bool has_cut = cut.crossed() && cell_point(cut, fc, nc);
  if (has_base && has_cut && meeting_place(base, cut, f)) {
    const Vec3 n = nb + nc;
    const double length = length_of(n);
    out.point_mm = corner + grid.voxel_mm * f;
    out.normal = length > 1e-3 ? n / length : nb;
    return true;
  }
  // The surface that lies in the other's solid.
  if (has_cut && (!has_base || base.eval(fc, g) <= 0.0)) {
    out.point_mm = corner + grid.voxel_mm * fc;
    out.normal = nc;
    return true;
  }
  if (has_base && (!has_cut || cut.eval(fb, g) <= 0.0)) {
    out.point_mm = corner + grid.voxel_mm * fb;
    out.normal = nb;
    return true;
  }
  return mean_crossing(volume, cell, out);
}

double base_distance_mm(const Specimen& specimen, Vec3 at_mm, Vec3* normal) noexcept {
  const Grid& grid = specimen.grid();
  const Vec3 x = (at_mm - grid.origin_mm) / grid.voxel_mm;
  const IVec3 cell = cell_of_voxels(x);
  CellField f;
  f.load(specimen, cell);
  Vec3 g;
  const double d = f.eval(x - Vec3(cell), g);
  const double length = length_of(g);
  if (normal) *normal = length > 1e-9 ? g / length : Vec3(0.0, 0.0, 1.0);
  return length > 0.25 ? d * grid.voxel_mm / length : d * grid.voxel_mm;
}

}  // namespace cusp::engine
