#include "scenarios/import/nrrd_image.h"

#include <fstream>

#include "scenarios/import/limit_figures.h"
#include "scenarios/import/nrrd_header.h"
#include "scenarios/import/packed_data.h"
#include "scenarios/import/samples.h"

namespace cusp::scenarios {
Result<Image, ImportFailure> read_nrrd_image(std::istream& in, std::uintmax_t bytes, const std::string& name,
                                             const VolumeLimits& limits, const ImportProgress& progress) {
  const auto text = read_nrrd_text(in, name);
  if (!text) return std::unexpected(text.error());
  const auto header = parse_nrrd_header(*text, name, limits, NrrdUse::image);
  if (!header) return std::unexpected(header.error());
  const NrrdHeader& h = *header;
  if (h.content == NrrdHeader::Content::tissue_and_s) {
    // With named tissues it is a specimen whose header is wrong, else two channels of another program's.
    const auto specimen = parse_nrrd_header(*text, name, limits);
    if (!specimen && text->find("\ntissue ") != std::string::npos) return std::unexpected(specimen.error());
    return fail(ImportError::unsupported, name + " sizes");
  }
  const auto layout = lay_out(h.file_size, h.step_mm, h.first_mm, limits);
  if (!layout) return fail(layout.error(), name, passed_file_limit(h.file_size, limits));

  Image out;
  out.layout = *layout;
  out.spacing_known = h.spacing_known;
  out.sides_known = h.sides_known;
  const std::size_t voxels = static_cast<std::size_t>(h.file_size.x) * static_cast<std::size_t>(h.file_size.y) *
                             static_cast<std::size_t>(h.file_size.z);
  const auto voxel_bytes = static_cast<std::size_t>(h.samples * h.sample_bytes);
  const Packing packing = h.gzip ? Packing::deflate : Packing::raw;
  if (!data_can_be_there(in, {bytes, voxels * voxel_bytes}, packing)) return fail(ImportError::truncated, name);
  out.value.resize(voxels);
  PackedSource source(in, packing);
  const SampleFormat format{h.sample_bytes, h.sample_signed, h.sample_float, h.big_endian};
  const bool colours = h.content == NrrdHeader::Content::colours;
  std::vector<std::byte> row(static_cast<std::size_t>(h.file_size.x) * voxel_bytes);
  for (int k = 0; k < h.file_size.z; ++k) {
    if (progress) progress(static_cast<double>(k) / h.file_size.z);
    for (int j = 0; j < h.file_size.y; ++j) {
      if (const auto r = source.read(row); !r) return fail(r.error(), name);
      for (int i = 0; i < h.file_size.x; ++i) {
        const std::byte* p = &row[static_cast<std::size_t>(i) * voxel_bytes];
        out.value[layout->place(i, j, k)] = colours ? colour_value(p, h.samples) : static_cast<float>(sample_value(p, format));
      }
    }
  }
  if (const auto r = source.expect_end(); !r) return fail(r.error(), name);
  if (const auto r = tidy_values(out); !r) return fail(r.error(), name);
  out.kind = colours ? ImageKind::colours : kind_of_values(out.value);
  return out;
}

Result<Image, ImportFailure> read_nrrd_image(const std::filesystem::path& file, const VolumeLimits& limits,
                                             const ImportProgress& progress) {
  std::ifstream in;
  const auto bytes = open_volume_file(file, in);
  if (!bytes) return std::unexpected(bytes.error());
  return read_nrrd_image(in, *bytes, file.filename().string(), limits, progress);
}

bool nrrd_is_specimen(const std::filesystem::path& file) {
  std::ifstream in;
  if (!open_volume_file(file, in)) return false;
  const auto text = read_nrrd_text(in, {});
  if (!text) return false;
  const auto header = parse_nrrd_header(*text, {}, {});
  return header && header->content == NrrdHeader::Content::tissue_and_s;
}

}  // namespace cusp::scenarios
