#include "tests/fuzz/readers.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "engine/volume/specimen.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/import/binvox.h"
#include "scenarios/import/metaimage.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/nrrd_image.h"
#include "scenarios/shapes/target.h"
#include "tests/modules.h"

namespace cusp::fuzz {
namespace {

// A fuzzer that is let read hundreds of megabytes finds nothing but that.
constexpr VolumeLimits kSmall{.max_edge_voxels = 256, .max_voxels = std::size_t{1} << 18};

void must(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

void check(const Image& image) {
  const ImageLayout& l = image.layout;
  const auto voxels = static_cast<std::size_t>(l.size.x) * static_cast<std::size_t>(l.size.y) * static_cast<std::size_t>(l.size.z);
  must(image.value.size() == voxels && voxels <= kSmall.max_voxels, "as many values as voxels");
  for (int i = 0; i < 3; ++i) must(std::isfinite(l.origin_mm[i]) && l.spacing_mm[i] > 0.0, "a place and a spacing");
  for (const float v : image.value) must(std::isfinite(v), "finite values");
}

/// Dentine about a pulp, and a lesion beside it.
std::shared_ptr<const Specimen> small_tooth() {
  constexpr double kVoxelMm = 0.25;
  VoxelVolume dense(Grid{IVec3(24), kVoxelMm, Vec3(-11.5 * kVoxelMm)});
  for (int i = 0; i < 24 * 24 * 24; ++i) {
    const IVec3 v(i % 24, i / 24 % 24, i / 576);
    const Vec3 p = dense.grid.centre_mm(v);
    const double out = glm::length(p);
    const auto at = dense.grid.index(v);
    dense.s[at] = solid_from_distance((out - 1.8) / kVoxelMm);
    if (dense.s[at] == 0) continue;
    dense.tissue[at] = out < 0.6 ? Tissue::pulp : p.x > 0.9 ? Tissue::carious_dentine : Tissue::dentine;
  }
  return Specimen::build(dense, Reading::banded);
}

std::istringstream stream_of(std::span<const std::uint8_t> bytes) {
  return std::istringstream(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace

void nrrd_specimen(std::span<const std::uint8_t> bytes) {
  auto in = stream_of(bytes);
  const auto volume = read_nrrd(in, bytes.size(), "v.nrrd", kSmall);
  if (!volume) return;
  must(volume->s.size() == volume->grid.voxels() && volume->tissue.size() == volume->s.size(), "as many voxels as the grid");
  for (std::size_t i = 0; i < volume->s.size(); ++i)
    must(is_tissue_code(index_of(volume->tissue[i])) && (volume->s[i] == 0 || volume->tissue[i] != Tissue::empty), "tissue where it is solid");
}

void nrrd_image(std::span<const std::uint8_t> bytes) {
  auto in = stream_of(bytes);
  if (const auto image = read_nrrd_image(in, bytes.size(), "v.nrrd", kSmall)) check(*image);
}

void metaimage(std::span<const std::uint8_t> bytes) {
  auto in = stream_of(bytes);
  // The files beside it hold the same bytes again: short ones, long ones and packed ones.
  const SideFiles beside = [&](const std::string& name) {
    must(!name.empty() && name.find_first_of("/\\") == name.npos && name != "..", "plain names only");
    SideFile side;
    if (name.ends_with('!')) return side;
    side.in = std::make_unique<std::istringstream>(stream_of(bytes));
    side.bytes = bytes.size();
    return side;
  };
  if (const auto image = read_metaimage(in, bytes.size(), "v.mhd", beside, kSmall)) check(*image);
}

void binvox(std::span<const std::uint8_t> bytes) {
  auto in = stream_of(bytes);
  const auto volume = read_binvox(in, bytes.size(), "v.binvox", kSmall);
  if (!volume) return;
  const auto image = image_of(*volume, "v.binvox", kSmall);
  if (image) check(*image);
}

void scenario(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::vector<Finding> findings = validate_text(text);
  const auto read = read_scenario(text);
  must(read.has_value() || has_error(findings), "what does not read is found wrong");
  if (!read) return;
  const auto again = read_scenario(write_scenario(*read));
  must(again.has_value() && content_hash(*again) == content_hash(*read), "it reads back as it is written");
  if (has_error(findings)) return;
  // Leaves of voxels are those of a small tooth, whatever the file's own is.
  static const std::shared_ptr<const Specimen> tooth = small_tooth();
  const TargetShape shape(read->target, tooth);
  double last = 0;
  for (int i = 0; i < 8; ++i) {
    const double d = shape.distance_mm(Vec3(0.37 * i, -0.21 * i, 1.0 - 0.5 * i));
    must(std::isfinite(d), "a finite distance");
    must(i == 0 || shape.empty() || std::fabs(d - last) <= 0.6575, "that changes by no more than its place");  // 0.6575 mm a step
    last = d;
  }
}

}  // namespace cusp::fuzz
