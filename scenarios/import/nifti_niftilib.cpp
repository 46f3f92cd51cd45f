// The one file that knows niftilib.
#include <nifti/nifti1_io.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

#include "scenarios/import/foreign_images.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/packed_data.h"
#include "scenarios/import/samples.h"

namespace cusp::scenarios {
namespace {

struct Free {
  void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using NiftiImage = std::unique_ptr<nifti_image, Free>;

/// How a number is stored; channels above 1 for colours.
struct Stored {
  SampleFormat format;
  int channels = 1;
};
std::optional<Stored> stored_as(int datatype) {
  switch (datatype) {
    case DT_UINT8: return Stored{{1, false, false, false}, 1};
    case DT_INT8: return Stored{{1, true, false, false}, 1};
    case DT_INT16: return Stored{{2, true, false, false}, 1};
    case DT_UINT16: return Stored{{2, false, false, false}, 1};
    case DT_INT32: return Stored{{4, true, false, false}, 1};
    case DT_UINT32: return Stored{{4, false, false, false}, 1};
    case DT_INT64: return Stored{{8, true, false, false}, 1};
    case DT_UINT64: return Stored{{8, false, false, false}, 1};
    case DT_FLOAT32: return Stored{{4, true, true, false}, 1};
    case DT_FLOAT64: return Stored{{8, true, true, false}, 1};
    case DT_RGB24: return Stored{{1, false, false, false}, 3};
    case DT_RGBA32: return Stored{{1, false, false, false}, 4};
    default: return std::nullopt;
  }
}

/// Where the voxels of a single file begin at the earliest: after the header and the four bytes that follow it. The library reads from
/// the header's end where the file names an earlier place, or none: two voxels of 16 bits too soon.
constexpr int kLeastOffset = 352;

struct FreeHeader {
  void operator()(nifti_1_header* header) const { std::free(header); }
};

/// Whether every axis of the volume has a length in the header. The library replaces those that are none by 1, and under a
/// quaternion those below 0 too.
bool has_lengths(const std::filesystem::path& file, const nifti_image& n) {
  if (n.sform_code > 0) return true;  // its lengths are the affine's
  int swapped = 0;
  const std::unique_ptr<nifti_1_header, FreeHeader> header(nifti_read_header(file.c_str(), &swapped, 0));
  if (!header) return false;
  const int sizes[3] = {n.nx, n.ny, n.nz};
  for (int i = 0; i < 3; ++i) {
    const float length = header->pixdim[i + 1];
    const bool none = !std::isfinite(length) || length == 0.0f || (n.qform_code > 0 && length < 0.0f);
    if (sizes[i] > 1 && none) return false;
  }
  return true;
}

/// From one voxel to the next along each axis, and the first voxel's centre, in millimetres where the unit is known.
struct Pose {
  std::array<Vec3, 3> step_mm{};
  Vec3 first_mm{0.0};
  bool known = true;
  bool sides_known = true;
};
Pose pose_of(const std::filesystem::path& file, const nifti_image& n) {
  Pose out;
  double unit = 1.0;
  if (n.xyz_units == NIFTI_UNITS_METER) unit = 1000.0;
  else if (n.xyz_units == NIFTI_UNITS_MICRON) unit = 1e-3;
  else out.known = n.xyz_units == NIFTI_UNITS_MM;
  const mat44* affine = n.sform_code > 0 ? &n.sto_xyz : n.qform_code > 0 ? &n.qto_xyz : nullptr;
  out.sides_known = affine != nullptr;
  const double plain[3] = {n.dx, n.dy, n.dz};
  for (int i = 0; i < 3; ++i) {
    Vec3& step = out.step_mm[static_cast<std::size_t>(i)];
    for (int row = 0; row < 3; ++row) step[row] = affine ? double{affine->m[row][i]} * unit : row == i ? plain[i] * unit : 0.0;
    const double length = std::sqrt(glm::dot(step, step));
    if (std::isfinite(length) && length > 0.0) continue;
    out.known = false;
  }
  if (affine) out.first_mm = unit * Vec3(affine->m[0][3], affine->m[1][3], affine->m[2][3]);
  const auto bad = [](Vec3 s) { return !std::isfinite(s.x + s.y + s.z) || s == Vec3(0.0); };
  if (std::ranges::any_of(out.step_mm, bad) || !has_lengths(file, n)) {
    out.known = out.sides_known = false;
    for (int i = 0; i < 3; ++i) {
      out.step_mm[static_cast<std::size_t>(i)] = Vec3(0.0);
      out.step_mm[static_cast<std::size_t>(i)][i] = 1.0;
    }
  }
  return out;
}

/// Whether voxels follow that are one number each, and how each is stored.
Result<Stored, ImportFailure> stored_in(const nifti_image& n, const std::string& name) {
  if (n.ndim < 2 || n.ndim > 7 || n.nx < 1 || n.ny < 1 || n.nz < 1) return fail(ImportError::bad_sizes, name + " dim");
  for (const int more : {n.nt, n.nu, n.nv, n.nw}) {
    if (more > 1) return fail(ImportError::unsupported, name + " dim");
  }
  const int least_offset = n.nifti_type == NIFTI_FTYPE_NIFTI1_1 ? kLeastOffset : 0;
  if (n.iname_offset < least_offset) return fail(ImportError::bad_header, name + " vox_offset");
  auto stored = stored_as(n.datatype);
  if (!stored) return fail(ImportError::unsupported, name + " datatype");
  if (n.nbyper != stored->format.bytes * stored->channels) return fail(ImportError::bad_header, name + " bitpix");
  const bool turned = n.byteorder != nifti_short_order();  // from this machine's order
  stored->format.big_endian = turned != (std::endian::native == std::endian::big);
  return *stored;
}

/// Packed if its name and its first bytes are those of gzip: the library reads a plain file of that name as it is.
Packing packing_of(std::istream& in, const std::filesystem::path& data) {
  constexpr int first_of_gzip = 0x1f;
  return nifti_is_gzfile(data.c_str()) && in.peek() == first_of_gzip ? Packing::deflate : Packing::raw;
}

Result<void, ImportError> skip(PackedSource& source, std::size_t bytes) {
  std::vector<std::byte> block(65536);
  for (std::size_t left = bytes; left > 0;) {
    const std::size_t next = std::min(left, block.size());
    if (auto r = source.read({block.data(), next}); !r) return r;
    left -= next;
  }
  return {};
}

/// Fills image.value, whose layout is set. The library does not read the voxels: of files of one stem it takes v.nii in place of
/// v.nii.gz, it waits for a pipe's other end, and it makes 0 of what is no number.
Result<void, ImportFailure> read_voxels(const std::filesystem::path& data, const nifti_image& n, const Stored& stored, Image& image,
                                        const ImportProgress& progress) {
  const std::string name = data.filename().string();
  std::ifstream in;
  const auto bytes = open_volume_file(data, in);
  if (!bytes) return std::unexpected(bytes.error());
  const IVec3 size = image.layout.file_size;
  const std::size_t voxels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
  const auto voxel_bytes = static_cast<std::size_t>(stored.format.bytes * stored.channels);
  const auto offset = static_cast<std::size_t>(n.iname_offset);
  const Packing packing = packing_of(in, data);
  if (!data_can_be_there(in, {*bytes, offset + voxels * voxel_bytes}, packing)) return fail(ImportError::truncated, name);
  PackedSource source(in, packing);
  if (const auto r = skip(source, offset); !r) return fail(r.error(), name);
  image.value.resize(voxels);
  const bool scaled = std::isfinite(n.scl_slope) && n.scl_slope != 0.0f && std::isfinite(n.scl_inter);
  const double slope = scaled ? double{n.scl_slope} : 1.0, intercept = scaled ? double{n.scl_inter} : 0.0;
  std::vector<std::byte> row(static_cast<std::size_t>(size.x) * voxel_bytes);
  for (int k = 0; k < size.z; ++k) {
    if (progress) progress(static_cast<double>(k) / size.z);
    for (int j = 0; j < size.y; ++j) {
      if (const auto r = source.read(row); !r) return fail(r.error(), name);
      const std::byte* p = row.data();
      for (int i = 0; i < size.x; ++i, p += voxel_bytes)
        image.value[image.layout.place(i, j, k)] =
            stored.channels > 1 ? colour_value(p, stored.channels)
                                : static_cast<float>(sample_value(p, stored.format) * slope + intercept);
    }
  }
  return {};
}

}  // namespace

Result<Image, ImportFailure> read_nifti(const std::filesystem::path& file, const VolumeLimits& limits,
                                        const ImportProgress& progress) {
  const std::string name = file.filename().string();
  std::error_code ec;
  const auto status = std::filesystem::status(file, ec);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return fail(ImportError::io, name);
  nifti_set_debug_level(0);
  const NiftiImage nifti(nifti_image_read(file.c_str(), 0));
  if (!nifti) return fail(ImportError::bad_header, name);
  const nifti_image& n = *nifti;
  const auto stored = stored_in(n, name);
  if (!stored) return std::unexpected(stored.error());
  const Pose pose = pose_of(file, n);
  const IVec3 size(n.nx, n.ny, n.nz);
  const auto layout = lay_out(size, pose.step_mm, pose.first_mm, limits);
  if (!layout) return fail(layout.error(), name, passed_file_limit(size, limits));
  const std::size_t voxels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
  if (static_cast<std::size_t>(n.nvox) != voxels) return fail(ImportError::bad_sizes, name + " dim");

  Image out;
  out.layout = *layout;
  out.spacing_known = pose.known;
  out.sides_known = pose.sides_known;
  // Of a pair it is another file than the header's.
  const std::filesystem::path data = n.iname ? std::filesystem::path(n.iname) : file;
  if (auto r = read_voxels(data, n, *stored, out, progress); !r) return std::unexpected(r.error());
  if (const auto r = tidy_values(out); !r) return fail(r.error(), name);
  out.kind = stored->channels > 1 ? ImageKind::colours : kind_of_values(out.value);
  return out;
}

}  // namespace cusp::scenarios
