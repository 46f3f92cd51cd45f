#include "scenarios/import/image_volume.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <set>

#include "scenarios/import/grey_surface.h"
#include "scenarios/import/label_map.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/components.h"
#include "scenarios/import/size_question.h"

namespace cusp::scenarios {
namespace {

constexpr double kCubic = 1e-3;  // share by which spacings may differ and still be one: printed digits

Result<void, ImportFailure> check(const ImageTissues& what, const std::string& name) {
  if (!(what.unit_mm > 0.0) || !std::isfinite(what.unit_mm)) return fail(ImportError::bad_option, "unit-mm");
  if (what.labels.empty() && what.thresholds.empty()) return fail(ImportError::nothing_solid, name);
  if (!what.labels.empty() && !what.thresholds.empty()) return fail(ImportError::bad_option, "threshold");
  for (std::size_t i = 0; i < what.thresholds.size(); ++i) {
    const auto& [from, tissue] = what.thresholds[i];
    if (!std::isfinite(from) || (i > 0 && !(from > what.thresholds[i - 1].first))) return fail(ImportError::bad_option, "threshold");
    if (!is_tissue_code(index_of(tissue))) return fail(ImportError::bad_tissue, "threshold");
  }
  std::set<std::uint32_t> named;
  for (const auto& [value, tissue] : what.labels) {
    if (!named.insert(value).second) return fail(ImportError::bad_option, "tissue " + std::to_string(value));
    if (!is_tissue_code(index_of(tissue))) return fail(ImportError::bad_tissue, std::to_string(value));
  }
  if (what.hollows && (*what.hollows == Tissue::empty || !is_tissue_code(index_of(*what.hollows))))
    return fail(ImportError::bad_tissue, "hollows");
  return {};
}

/// A label or colour that was chosen and that no voxel has. 0 is none: it stands for nothing.
std::optional<std::uint32_t> absent_label(const Image& image, const ImageTissues& what) {
  std::set<std::uint32_t> absent;
  for (const auto& [value, tissue] : what.labels) absent.insert(value);
  float last = 0.0f;
  for (const float v : image.value) {
    if (absent.empty()) break;
    if (v == last) continue;
    last = v;
    if (v > 0.0f && v < 4294967296.0f) absent.erase(static_cast<std::uint32_t>(v));
  }
  return absent.empty() ? std::nullopt : std::optional(*absent.begin());
}

/// No measured value lies between the new first threshold and a lower one that it replaces.
std::vector<std::pair<double, Tissue>> above_unmeasured(std::vector<std::pair<double, Tissue>> thresholds, double measured_from) {
  while (thresholds.size() > 1 && thresholds[1].first <= measured_from) thresholds.erase(thresholds.begin());
  if (!thresholds.empty()) thresholds.front().first = std::max(thresholds.front().first, measured_from);
  return thresholds;
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
  out.layout.turned_degrees = l.turned_degrees;  // of the file's axes; right angles add nothing to it
  std::size_t i = 0;
  for (int z = 0; z < l.size.z; ++z)
    for (int y = 0; y < l.size.y; ++y)
      for (int x = 0; x < l.size.x; ++x, ++i) out.value[layout->place(x, y, z)] = image.value[i];
  return out;
}

/// Whether a value is one of what was chosen, or could lie beside such a value: of grey values all from the first tissue on,
/// for what is left out above it passes through the tissues on its way to nothing.
class Chosen {
 public:
  explicit Chosen(const ImageTissues& what) {
    for (const auto& [value, tissue] : what.labels)
      if (tissue != Tissue::empty) labels_.insert(value);
    for (const auto& [from, tissue] : what.thresholds)
      if (tissue != Tissue::empty) least_ = std::min(least_, from);
    grey_ = !what.thresholds.empty();
  }
  bool operator()(float value) const {
    if (grey_) return static_cast<double>(value) >= least_;
    return value > 0.0f && value < 4294967296.0f && labels_.contains(static_cast<std::uint32_t>(value));
  }

 private:
  std::set<std::uint32_t> labels_;
  double least_ = 1e300;
  bool grey_ = false;
};

/// The file's own voxels as a grid, for counting only: their edge and place do not matter.
Grid own_voxels(const ImageLayout& l) {
  Grid out;
  out.size = l.size;
  return out;
}

enum class Extent : std::uint8_t { all, largest_component };

/// Box of the file's chosen voxels, or of their largest connected component.
LabelBox box_of_chosen(const Image& image, const ImageTissues& what, Extent extent) {
  const Chosen chosen(what);
  const Grid own = own_voxels(image.layout);
  if (extent == Extent::all) {
    return box_where(own, [&](std::size_t i) { return chosen(image.value[i]); });
  }
  std::vector<Tissue> marks(image.value.size(), Tissue::empty);
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (chosen(image.value[i])) marks[i] = Tissue::plastic;
  keep_largest_component(own, marks);
  return box_of_labels(own, marks);
}

/// Cubes over the whole file and about its middle, of which `grid` is the part that holds a box of the file's voxels.
struct Cubes {
  Vec3 size{0.0};       // of the part, in cubes; whole numbers
  Vec3 extent_mm{0.0};  // of the box
  Grid grid;            // size is set once it is known to fit
};
Cubes cubes_about(const LabelBox& box, const ImageLayout& l, Vec3 spacing_mm, Vec3 origin_mm, double voxel_mm) {
  constexpr double kBeside = 1.0;  // a surface between grey values lies up to a voxel beyond the last that is in it
  Cubes out;
  out.grid.voxel_mm = voxel_mm;
  for (int i = 0; i < 3; ++i) {
    const double n = std::max(1.0, std::round(l.size[i] * spacing_mm[i] / voxel_mm));
    const double whole_first = origin_mm[i] + 0.5 * (l.size[i] - 1) * spacing_mm[i] - 0.5 * (n - 1) * voxel_mm;
    const double low = origin_mm[i] + (box.first[i] - kBeside) * spacing_mm[i], high = origin_mm[i] + (box.last[i] + kBeside) * spacing_mm[i];
    const double first = std::clamp(std::floor((low - whole_first) / voxel_mm), 0.0, n - 1);
    const double last = std::clamp(std::ceil((high - whole_first) / voxel_mm), first, n - 1);
    out.size[i] = last - first + 1;
    out.extent_mm[i] = high - low;
    out.grid.origin_mm[i] = whole_first + first * voxel_mm;
  }
  return out;
}

/// Cubes about what was chosen, held against the limits.
Result<Grid, ImportFailure> cubes_over(const Image& image, const ImageTissues& what, Vec3 spacing_mm, Vec3 origin_mm,
                                       double voxel_mm, const std::string& name, const VolumeLimits& limits) {
  std::optional<LimitFigures> passed;
  for (const Extent extent : {Extent::all, Extent::largest_component}) {
    if (extent == Extent::largest_component && !what.largest_component) break;
    const LabelBox box = box_of_chosen(image, what, extent);
    if (box.empty()) return fail(ImportError::nothing_solid, name);
    Cubes cubes = cubes_about(box, image.layout, spacing_mm, origin_mm, voxel_mm);
    passed = passed_limit(cubes.size + 2.0 * kPadVoxels, cubes.extent_mm, voxel_mm, limits);
    if (passed) continue;
    cubes.grid.size = IVec3(cubes.size);
    return cubes.grid;
  }
  return fail(ImportError::too_large, name, text_of(*passed));
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
  if (!image.sides_known) remarks.push_back({RemarkCode::sides_assumed});
  const auto grid = cubes_over(image, what, spacing, origin, voxel, name, limits);
  if (!grid) return std::unexpected(grid.error());

  const GreyField field{image.value, l.size, spacing, origin};
  const bool grey = !what.thresholds.empty();
  std::vector<Tissue> labels = grey ? grey_tissues(field, what, *grid, progress) : nearest_tissues(image, field, what, *grid);
  if (what.largest_component) {
    if (const std::size_t removed = keep_largest_component(*grid, labels)) {
      remarks.push_back({RemarkCode::components_removed, {}, {static_cast<double>(removed)}});
    }
  }
  if (what.hollows) {
    if (const std::size_t filled = fill_hollows(*grid, labels, *what.hollows)) remarks.push_back({RemarkCode::hollows_filled, {}, {static_cast<double>(filled)}});
  }
  const LabelBox box = box_of_labels(*grid, labels);
  if (box.empty()) return fail(ImportError::nothing_solid, name);
  if (auto remark = odd_size(Vec3(box.last - box.first + 1) * grid->voxel_mm)) remarks.push_back(std::move(*remark));
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
  if (const auto absent = absent_label(image, what)) return fail(ImportError::mesh_not_found, std::to_string(*absent));
  try {
    ImageTissues used = what;
    used.thresholds = above_unmeasured(std::move(used.thresholds), image.measured_from);
    if (what.up == UpAxis::z) return make(image, used, name, limits, remarks, progress);
    return make(with_up(image, what.up, limits), used, name, limits, remarks, progress);
  } catch (const std::bad_alloc&) {
    return fail(ImportError::out_of_memory, name);
  }
}

}  // namespace cusp::scenarios
