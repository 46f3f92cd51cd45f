#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/volume/specimen.h"
#include "scenarios/import/binvox.h"
#include "scenarios/import/foreign_images.h"
#include "scenarios/import/header_text.h"
#include "scenarios/import/import.h"
#include "scenarios/import/metaimage.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/nrrd_image.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {
namespace {

constexpr std::size_t kMaxColours = 4096;

enum class Format : std::uint8_t { mesh, nrrd, metaimage, binvox, nifti, dicom, unknown };

Format format_of(const std::filesystem::path& path) {
  std::error_code ec;
  if (std::filesystem::is_directory(path, ec)) return Format::dicom;
  const std::string name = lower(path.filename().string());
  constexpr std::array<std::pair<std::string_view, Format>, 14> endings = {{{".stl", Format::mesh},
                                                                            {".obj", Format::mesh},
                                                                            {".ply", Format::mesh},
                                                                            {".3ds", Format::mesh},
                                                                            {".off", Format::mesh},
                                                                            {".nrrd", Format::nrrd},
                                                                            {".mha", Format::metaimage},
                                                                            {".mhd", Format::metaimage},
                                                                            {".binvox", Format::binvox},
                                                                            {".nii", Format::nifti},
                                                                            {".nii.gz", Format::nifti},
                                                                            {".hdr", Format::nifti},
                                                                            {".dcm", Format::dicom},
                                                                            {".ima", Format::dicom}}};
  for (const auto& [ending, format] : endings) {
    if (name.ends_with(ending)) return format;
  }
  return looks_like_dicom(path) ? Format::dicom : Format::unknown;
}

struct Opened {
  Image image;
  std::size_t series = 0, slices = 0;
};

Result<Opened, ImportFailure> open_image(const std::filesystem::path& path, const VolumeLimits& limits, const ImportProgress& progress) {
  const std::string name = path.filename().string();
  const auto plain = [](Result<Image, ImportFailure> image) -> Result<Opened, ImportFailure> {
    if (!image) return std::unexpected(image.error());
    return Opened{std::move(*image), 0, 0};
  };
  switch (format_of(path)) {
    case Format::nrrd: return plain(read_nrrd_image(path, limits, progress));
    case Format::metaimage: return plain(read_metaimage(path, limits, progress));
    case Format::nifti: return plain(read_nifti(path, limits, progress));
    case Format::binvox: {
      const auto read = read_binvox(path, limits);
      if (!read) return std::unexpected(read.error());
      return plain(image_of(*read, name, limits));
    }
    case Format::dicom: {
      auto series = read_dicom(path, limits, progress);
      if (!series) return std::unexpected(series.error());
      return Opened{std::move(series->image), series->series, series->slices};
    }
    case Format::mesh:
    case Format::unknown: break;
  }
  return fail(ImportError::unknown_format, name);
}

ImageInfo info_of(const Opened& opened) {
  const Image& image = opened.image;
  ImageInfo out;
  out.kind = image.kind;
  out.size = image.layout.size;
  out.spacing_mm = image.layout.spacing_mm;
  out.spacing_known = image.spacing_known;
  out.turned_degrees = image.layout.turned_degrees;
  out.series = opened.series;
  out.slices = opened.slices;
  out.low = out.high = static_cast<double>(std::ranges::max(image.value));
  for (const float v : image.value)
    if (static_cast<double>(v) >= image.measured_from) out.low = std::min(out.low, static_cast<double>(v));
  if (image.kind == ImageKind::grey) return out;
  std::map<std::uint32_t, std::size_t> count;
  for (const float v : image.value) {
    if (v > 0.0f) ++count[static_cast<std::uint32_t>(v)];
    if (count.size() > kMaxColours) break;  // a painting, not a map of tissues
  }
  out.values.assign(count.begin(), count.end());
  std::ranges::stable_sort(out.values, std::ranges::greater{}, [](const auto& v) { return v.second; });
  if (out.values.size() > kMaxLabels) out.values.resize(kMaxLabels);
  return out;
}

ImagePreview preview_of(const Image& image) {
  ImagePreview out;
  IVec3 by(1);
  for (int i = 0; i < 3; ++i) {
    by[i] = (image.layout.size[i] + kPreviewEdge - 1) / kPreviewEdge;
    out.size[i] = (image.layout.size[i] + by[i] - 1) / by[i];
    out.spacing_mm[i] = image.layout.spacing_mm[i] * by[i];
  }
  const auto nx = static_cast<std::size_t>(image.layout.size.x), ny = static_cast<std::size_t>(image.layout.size.y);
  IVec3 v;
  for (v.z = 0; v.z < out.size.z; ++v.z)
    for (v.y = 0; v.y < out.size.y; ++v.y)
      for (v.x = 0; v.x < out.size.x; ++v.x) {
        const IVec3 from = v * by;
        out.value.push_back(image.value[static_cast<std::size_t>(from.x) +
                                        nx * (static_cast<std::size_t>(from.y) + ny * static_cast<std::size_t>(from.z))]);
      }
  return out;
}

}  // namespace

FileKind file_kind(const std::filesystem::path& path) {
  switch (format_of(path)) {
    case Format::mesh: return FileKind::mesh;
    case Format::unknown: return FileKind::unknown;
    default: return FileKind::image;
  }
}

bool are_slices_of_a_folder(const std::vector<std::filesystem::path>& files) {
  return std::ranges::all_of(files, [&](const std::filesystem::path& file) {
    return format_of(file) == Format::dicom && file.parent_path() == files.front().parent_path();
  });
}

Result<FileLook, ImportFailure> look_at_files(const std::vector<std::filesystem::path>& files, const VolumeLimits& limits,
                                              const ImportProgress& progress) {
  FileLook out;
  if (files.empty()) return fail(ImportError::missing_file, {});
  const std::filesystem::path& path = files.front();
  std::error_code ec;
  if (!std::filesystem::exists(path, ec)) return fail(ImportError::missing_file, path.filename().string());
  const Format format = format_of(path);
  for (const std::filesystem::path& other : files) {
    if (format_of(other) != format || (files.size() > 1 && format != Format::mesh && format != Format::dicom))
      return fail(ImportError::unknown_format, other.filename().string());
  }
  if (format == Format::mesh) {
    auto meshes = list_meshes(path, {files.begin() + 1, files.end()});
    if (!meshes) return std::unexpected(meshes.error());
    out.meshes = std::move(*meshes);
    return out;
  }
  if (format == Format::nrrd && nrrd_is_specimen(path)) {
    const auto volume = read_nrrd(path, limits);
    if (!volume) return std::unexpected(volume.error());
    ImageInfo info;
    info.specimen = true;
    info.kind = ImageKind::labels;
    info.size = volume->grid.size;
    info.spacing_mm = Vec3(volume->grid.voxel_mm);
    std::map<std::uint32_t, std::size_t> count;
    for (std::size_t i = 0; i < volume->s.size(); ++i)
      if (volume->s[i] >= kHalf) ++count[static_cast<std::uint32_t>(index_of(volume->tissue[i]))];
    info.values.assign(count.begin(), count.end());
    out.image = info;
    return out;
  }
  const auto opened = open_image(path, limits, progress);
  if (!opened) return std::unexpected(opened.error());
  out.image = info_of(*opened);
  out.preview = preview_of(opened->image);
  return out;
}

Result<VoxelVolume, ImportFailure> import_image(const ImageImport& what, const ImportProgress& progress, std::vector<ImportRemark>* remarks) {
  const std::string name = what.path.filename().string();
  std::error_code ec;
  if (!std::filesystem::exists(what.path, ec)) return fail(ImportError::missing_file, name);
  if (format_of(what.path) == Format::nrrd && nrrd_is_specimen(what.path)) return read_nrrd(what.path, what.limits);
  const auto part = [&](double from, double to) {
    return [&progress, from, to](double share) {
      if (progress) progress(from + (to - from) * share);
    };
  };
  const auto opened = open_image(what.path, what.limits, part(0.0, 0.4));
  if (!opened) return std::unexpected(opened.error());
  std::vector<ImportRemark> remarks_made;
  if (opened->slices > 0) remarks_made.push_back({RemarkCode::identity_left_out});
  if (opened->series > 1)
    remarks_made.push_back({RemarkCode::one_of_series, {}, {static_cast<double>(opened->series), static_cast<double>(opened->slices)}});
  auto volume = volume_of_image(opened->image, what.tissues, name, what.limits, remarks_made, part(0.4, 1.0));
  if (volume && remarks) *remarks = std::move(remarks_made);
  return volume;
}

}  // namespace cusp::scenarios
