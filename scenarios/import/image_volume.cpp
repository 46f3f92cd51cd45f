#include "scenarios/import/image_volume.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>

#include "scenarios/import/grey_surface.h"
#include "scenarios/import/label_map.h"
#include "scenarios/import/pieces.h"

namespace cusp {
namespace {

constexpr double kCubic = 1e-3;  // share by which spacings may differ and still be one: printed digits

Result<void, ImportFailure> check(const ImageTissues& what, const std::string& name) {
  if (!(what.unit_mm > 0.0) || !std::isfinite(what.unit_mm)) return fail(ImportError::bad_option, "unit-mm");
  if (what.labels.empty() && what.thresholds.empty()) return fail(ImportError::nothing_solid, name);
  if (!what.labels.empty() && !what.thresholds.empty()) return fail(ImportError::bad_option, "threshold");
  for (std::size_t i = 0; i < what.thresholds.size(); ++i) {
    const auto& [from, tissue] = what.thresholds[i];
    if (!std::isfinite(from) || (i > 0 && !(from > what.thresholds[i - 1].first))) return fail(ImportError::bad_option, "threshold");
    if (index_of(tissue) >= kTissueCodes) return fail(ImportError::bad_tissue, "threshold");
  }
  for (const auto& [value, tissue] : what.labels) {
    if (index_of(tissue) >= kTissueCodes) return fail(ImportError::bad_tissue, std::to_string(value));
  }
  if (what.hollows && (*what.hollows == Tissue::empty || index_of(*what.hollows) >= kTissueCodes))
    return fail(ImportError::bad_tissue, "hollows");
  return {};
}

/// The same voxels with another axis up.
Image with_up(const Image& image, UpAxis up, const VolumeLimits& limits) {
  const ImageLayout& l = image.layout;
  const std::array<Vec3, 3> step = {turned_up(Vec3(l.spacing_mm.x, 0, 0), up), turned_up(Vec3(0, l.spacing_mm.y, 0), up),
                                    turned_up(Vec3(0, 0, l.spacing_mm.z), up)};
  const auto layout = lay_out(l.size, step, turned_up(l.origin_mm, up), limits);
  if (!layout) return image;  // never: it is a right-angled turn of what was laid out before
  Image out = image;
  out.layout = *layout;
  std::size_t i = 0;
  for (int z = 0; z < l.size.z; ++z)
    for (int y = 0; y < l.size.y; ++y)
      for (int x = 0; x < l.size.x; ++x, ++i) out.value[layout->place(x, y, z)] = image.value[i];
  return out;
}

/// Cubes over the same box, and about its middle.
Result<Grid, ImportFailure> cubes_over(const ImageLayout& l, Vec3 spacing_mm, Vec3 origin_mm, double voxel_mm,
                                       const std::string& name, const VolumeLimits& limits) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  double voxels = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double n = std::max(1.0, std::round(l.size[i] * spacing_mm[i] / voxel_mm));
    voxels *= n + 2 * kPadVoxels;
    if (!(n + 2 * kPadVoxels <= limits.max_edge_voxels) || !(voxels <= static_cast<double>(limits.max_voxels)))
      return fail(ImportError::too_large, name, std::to_string(voxel_mm) + " mm");
    grid.size[i] = static_cast<int>(n);
    grid.origin_mm[i] = origin_mm[i] + 0.5 * (l.size[i] - 1) * spacing_mm[i] - 0.5 * (n - 1) * voxel_mm;
  }
  return grid;
}

/// Tissue codes on the cubes, of the nearest voxel of the file.
std::vector<Tissue> nearest_tissues(const Image& image, const GreyField& field, const ImageTissues& what, const Grid& grid) {
  std::map<std::uint32_t, Tissue> of(what.labels.begin(), what.labels.end());
  std::vector<Tissue> out(grid.voxels(), Tissue::empty);
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) {
        const IVec3 from = field.nearest(grid.centre_mm(v));
        const float value = image.value[static_cast<std::size_t>(from.x) +
                                        static_cast<std::size_t>(image.layout.size.x) *
                                            (static_cast<std::size_t>(from.y) + static_cast<std::size_t>(image.layout.size.y) *
                                                                                    static_cast<std::size_t>(from.z))];
        if (value <= 0.0f || value >= 4294967296.0f) continue;
        const auto it = of.find(static_cast<std::uint32_t>(value));
        if (it != of.end()) out[i] = it->second;
      }
  return out;
}

std::vector<Tissue> grey_tissues(const GreyField& field, const ImageTissues& what, const Grid& grid, const ImportProgress& progress) {
  std::vector<Tissue> out(grid.voxels(), Tissue::empty);
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < grid.size.z; ++v.z) {
    if (progress) progress(0.4 * v.z / grid.size.z);
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) out[i] = tissue_at(field.at(grid.centre_mm(v)), what.thresholds);
  }
  return out;
}

Result<VoxelVolume, ImportFailure> make(const Image& image, const ImageTissues& what, const std::string& name,
                                        const VolumeLimits& limits, std::vector<ImportRemark>& remarks,
                                        const ImportProgress& progress) {
  const ImageLayout& l = image.layout;
  const Vec3 spacing = l.spacing_mm * what.unit_mm, origin = l.origin_mm * what.unit_mm;
  const double least = std::min({spacing.x, spacing.y, spacing.z}), most = std::max({spacing.x, spacing.y, spacing.z});
  const double voxel = what.voxel_mm.value_or(least);
  if (!(voxel >= limits.min_voxel_mm && voxel <= limits.max_voxel_mm))
    return what.voxel_mm ? fail(ImportError::bad_option, "voxel-mm") : fail(ImportError::bad_spacing, name);
  const bool same = most <= voxel * (1.0 + kCubic) && least >= voxel * (1.0 - kCubic);
  if (!same) remarks.push_back({RemarkCode::resampled, {}, {spacing.x, spacing.y, spacing.z, voxel}});
  if (l.turned_degrees > 0.0) remarks.push_back({RemarkCode::straightened, {}, {l.turned_degrees}});
  if (!image.spacing_known) remarks.push_back({RemarkCode::spacing_assumed});
  const auto grid = cubes_over(l, spacing, origin, voxel, name, limits);
  if (!grid) return std::unexpected(grid.error());

  const GreyField field{image.value, l.size, spacing, origin};
  const bool grey = !what.thresholds.empty();
  std::vector<Tissue> labels = grey ? grey_tissues(field, what, *grid, progress) : nearest_tissues(image, field, what, *grid);
  if (what.largest_piece) {
    if (const std::size_t gone = keep_largest_piece(*grid, labels)) remarks.push_back({RemarkCode::pieces_removed, {}, {static_cast<double>(gone)}});
  }
  if (what.hollows) {
    if (const std::size_t filled = fill_hollows(*grid, labels, *what.hollows)) remarks.push_back({RemarkCode::hollows_filled, {}, {static_cast<double>(filled)}});
  }
  const LabelBox box = box_of_labels(*grid, labels);
  if (box.empty()) return fail(ImportError::nothing_solid, name);
  if (padded_grid(*grid, box).voxels() > limits.max_voxels) return fail(ImportError::too_large, name);
  if (progress) progress(0.5);
  VoxelVolume out = grey ? volume_of_grey(field, what.thresholds, *grid, labels, box, progress) : volume_of_labels(*grid, labels);
  if (progress) progress(1.0);
  return out;
}

}  // namespace

Tissue tissue_at(double value, const std::vector<std::pair<double, Tissue>>& thresholds) noexcept {
  Tissue out = Tissue::empty;
  for (const auto& [from, tissue] : thresholds) {
    if (value < from) break;
    out = tissue;
  }
  return out;
}

Result<VoxelVolume, ImportFailure> volume_of_image(const Image& image, const ImageTissues& what, const std::string& name,
                                                   const VolumeLimits& limits, std::vector<ImportRemark>& remarks,
                                                   const ImportProgress& progress) {
  if (auto r = check(what, name); !r) return std::unexpected(r.error());
  try {
    if (what.up == UpAxis::z) return make(image, what, name, limits, remarks, progress);
    return make(with_up(image, what.up, limits), what, name, limits, remarks, progress);
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, name);
  }
}

}  // namespace cusp
