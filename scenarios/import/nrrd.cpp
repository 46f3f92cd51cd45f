#include "scenarios/import/nrrd.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "scenarios/import/label_map.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/nrrd_header.h"
#include "scenarios/import/packed_data.h"
#include "scenarios/import/whole_file.h"

namespace cusp::scenarios {
namespace {

std::string text_of(IVec3 v) {
  return "(" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + ")";
}

struct SampleType {
  int bytes = 0;
  bool is_signed = false, big_endian = false;
};

/// Sample at p. A negative one becomes huge, and so larger than any code.
std::uint64_t sample(const std::byte* p, const SampleType& type) noexcept {
  const auto [bytes, is_signed, big] = type;
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i)
    value |= static_cast<std::uint64_t>(p[big ? bytes - 1 - i : i]) << (8 * i);
  if (is_signed && bytes < 8 && (value >> (8 * bytes - 1)) != 0) value |= ~std::uint64_t{0} << (8 * bytes);
  return value;
}

/// Calls put(index in the specimen's grid, its voxel, bytes of the samples) for each voxel in the file's order.
template <class Put>
Result<void, ImportFailure> for_each_voxel(PackedSource& source, const NrrdHeader& h, int samples,
                                           const std::string& name, Put put) {
  const auto bytes = static_cast<std::size_t>(samples * h.sample_bytes);
  std::vector<std::byte> row(static_cast<std::size_t>(h.file_size.x) * bytes);
  IVec3 f;
  for (f.z = 0; f.z < h.file_size.z; ++f.z)
    for (f.y = 0; f.y < h.file_size.y; ++f.y) {
      if (const auto r = source.read(row); !r) return fail(r.error(), name);
      for (f.x = 0; f.x < h.file_size.x; ++f.x) {
        IVec3 v;
        for (int i = 0; i < 3; ++i)
          v[h.axis[static_cast<std::size_t>(i)]] =
              h.reversed[static_cast<std::size_t>(i)] ? h.file_size[i] - 1 - f[i] : f[i];
        if (!put(h.grid.index(v), &row[static_cast<std::size_t>(f.x) * bytes]))
          return fail(ImportError::bad_tissue, name + " " + text_of(v));
      }
    }
  if (const auto r = source.expect_end(); !r) return fail(r.error(), name);
  return {};
}

Result<VoxelVolume, ImportFailure> read_labels(PackedSource& source, const NrrdHeader& h, const std::string& name,
                                               const VolumeLimits& limits) {
  std::vector<Tissue> labels(h.grid.voxels(), Tissue::empty);
  const auto r = for_each_voxel(source, h, 1, name, [&](std::size_t i, const std::byte* p) {
    const std::uint64_t code = sample(p, {h.sample_bytes, h.sample_signed, h.big_endian});
    if (!is_tissue_code(code)) return false;
    labels[i] = static_cast<Tissue>(code);
    return true;
  });
  if (!r) return std::unexpected(r.error());
  const LabelBox box = box_of_labels(h.grid, labels);
  if (box.empty()) return fail(ImportError::nothing_solid, name);
  // The padding may lift a volume that just fits over the limit.
  if (auto passed = passed_file_limit(padded_grid(h.grid, box).size, limits); !passed.empty())
    return fail(ImportError::too_large, name, std::move(passed));
  VoxelVolume out = volume_of_labels(h.grid, labels);
  out.names = h.names;
  return out;
}

Result<VoxelVolume, ImportFailure> read_tissue_and_s(PackedSource& source, const NrrdHeader& h, const std::string& name) {
  VoxelVolume out(h.grid);
  out.names = h.names;
  bool solid = false;
  const auto r = for_each_voxel(source, h, 2, name, [&](std::size_t i, const std::byte* p) {
    const std::uint64_t code = sample(p, {2, false, h.big_endian});
    const auto s = static_cast<std::uint16_t>(sample(p + 2, {2, false, h.big_endian}));
    if (!is_tissue_code(code) || (code == 0 && s > 0)) return false;
    out.tissue[i] = static_cast<Tissue>(code);
    out.s[i] = s;
    solid |= s >= kHalf;
    return true;
  });
  if (!r) return std::unexpected(r.error());
  if (!solid) return fail(ImportError::nothing_solid, name);
  return out;
}

/// bad_tissue with its place for what a reader would refuse.
Result<void, ImportFailure> check_writable(const VoxelVolume& volume, const std::string& name) {
  const Grid& g = volume.grid;
  if (g.size.x < 1 || g.size.y < 1 || g.size.z < 1 || volume.s.size() != g.voxels() ||
      volume.tissue.size() != g.voxels())
    return fail(ImportError::bad_sizes, name);
  for (const auto& [code, tissue] : volume.names) {
    if (code < 16 || code >= kTissueCodes) return fail(ImportError::bad_tissue, name + " tissue " + std::to_string(code));
    for (const char c : tissue) {
      if (static_cast<unsigned char>(c) < 0x20)
        return fail(ImportError::bad_tissue, name + " tissue " + std::to_string(code));
    }
  }
  bool solid = false;
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < g.size.z; ++v.z)
    for (v.y = 0; v.y < g.size.y; ++v.y)
      for (v.x = 0; v.x < g.size.x; ++v.x, ++i) {
        const std::size_t code = index_of(volume.tissue[i]);
        if (!is_tissue_code(code) || (code == 0 && volume.s[i] > 0))
          return fail(ImportError::bad_tissue, name + " " + text_of(v));
        solid |= volume.s[i] >= kHalf;
      }
  if (!solid) return fail(ImportError::nothing_solid, name);
  return {};
}

}  // namespace

Result<VoxelVolume, ImportFailure> read_nrrd(const std::filesystem::path& file, const VolumeLimits& limits) {
  const std::string name = file.filename().string();
  std::ifstream in;
  const auto bytes = open_volume_file(file, in);
  if (!bytes) return std::unexpected(bytes.error());
  return read_nrrd(in, *bytes, name, limits);
}

Result<VoxelVolume, ImportFailure> read_nrrd(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                             const VolumeLimits& limits) {
  const auto text = read_nrrd_text(in, name);
  if (!text) return std::unexpected(text.error());
  const auto header = parse_nrrd_header(*text, name, limits);
  if (!header) return std::unexpected(header.error());
  const std::uintmax_t samples = header->content == NrrdHeader::Content::labels ? 1 : 2;
  const std::uintmax_t needed = header->grid.voxels() * samples * static_cast<std::uintmax_t>(header->sample_bytes);
  const Packing packing = header->gzip ? Packing::deflate : Packing::raw;
  if (!data_can_be_there(in, {bytes, needed}, packing)) return fail(ImportError::truncated, name);
  PackedSource source(in, packing);
  if (header->content == NrrdHeader::Content::labels) return read_labels(source, *header, name, limits);
  return read_tissue_and_s(source, *header, name);
}

std::map<std::uint8_t, std::string> nrrd_names(const std::filesystem::path& file) {
  std::ifstream in;
  if (!open_volume_file(file, in)) return {};
  const std::string name = file.filename().string();
  const auto text = read_nrrd_text(in, name);
  if (!text) return {};
  auto header = parse_nrrd_header(*text, name, {});
  return header ? std::move(header->names) : std::map<std::uint8_t, std::string>{};
}

Result<void, ImportFailure> write_nrrd(const VoxelVolume& volume, const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (auto r = check_writable(volume, name); !r) return r;
  WholeFile whole(file);
  const auto give_up = [&name](const std::error_code& why) { return fail(ImportError::io, name, why.message()); };
  if (auto begun = whole.write(nrrd_header_of(volume)); !begun) return give_up(begun.error());
  PackedSink sink(whole.stream());
  std::vector<std::byte> row(static_cast<std::size_t>(volume.grid.size.x) * 4);
  for (std::size_t i = 0; i < volume.s.size(); i += static_cast<std::size_t>(volume.grid.size.x)) {
    for (std::size_t x = 0; x < row.size() / 4; ++x) {
      row[4 * x] = static_cast<std::byte>(volume.tissue[i + x]);
      row[4 * x + 1] = std::byte{0};
      row[4 * x + 2] = static_cast<std::byte>(volume.s[i + x] & 0xff);
      row[4 * x + 3] = static_cast<std::byte>(volume.s[i + x] >> 8);
    }
    sink.write(row);
  }
  sink.finish();
  if (auto done = whole.finish(); !done) return give_up(done.error());
  return {};
}

}  // namespace cusp::scenarios
