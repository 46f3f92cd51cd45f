/// Files of other programs' kinds, made byte by byte: volumes and meshes for tests, fuzzing and mutation. None is shipped.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {

/// Values of a volume, x fastest.
std::vector<std::int16_t> values_of(IVec3 size, const std::function<int(IVec3)>& value);
/// Least significant byte first.
std::string bytes_of(const std::vector<std::int16_t>& values);

struct NiftiWish {
  IVec3 size{1};
  Vec3 spacing_mm{1.0};
  std::array<float, 12> affine{};  // three rows of four; all zero: no sform
  float slope = 0.0f, intercept = 0.0f;
  int units = 2;                   // NIFTI_UNITS_MM
  std::vector<std::int16_t> values;
};
std::string nifti_file(const NiftiWish& wish);

struct DicomWish {
  int columns = 1, rows = 1;
  Vec3 position{0.0};                       // left-posterior-superior
  std::array<double, 6> orientation{1, 0, 0, 0, 1, 0};
  double across_mm = 1.0, down_mm = 1.0, thickness_mm = 1.0;
  double slope = 1.0, intercept = 0.0;
  int number = 1;
  std::string series = "1.2.3", patient = "Doe^Jane", transfer = "1.2.840.10008.1.2.1";
  bool placed = true;
  std::optional<double> location_mm;  // SliceLocation
  std::optional<double> between_mm;   // SpacingBetweenSlices
  std::optional<int> padding, padding_limit;  // PixelPaddingValue, PixelPaddingRangeLimit
  std::vector<std::int16_t> values;
  std::string frame;  // packed (packed_dicom.h), instead of the values; `transfer` names the packing
};
/// Explicit VR, little endian, with preamble and meta header.
std::string dicom_file(const DicomWish& wish);

std::string binary_stl(const Mesh& mesh);
enum class PlyData : std::uint8_t { text, binary };
std::string ply_file(const Mesh& mesh, PlyData data);
struct ThreeDsWish {
  bool tree = true;               // key frames, where the library finds the objects' names
  Vec3 origin{0.0};               // of the objects' own axes, in which 3DS programs show them; points stay where they are
  bool quarter_about_z = false;   // the objects' own axes are turned
};
/// Several objects; names of at most ten letters. Points are the meshes' own, as the format has them.
std::string three_ds_file(const std::vector<Mesh>& meshes, const ThreeDsWish& wish = {});

/// Bytes in a container of blocks that are not packed.
std::string gzip_stored(const std::string& bytes);
std::string zlib_stored(const std::string& bytes);

}  // namespace cusp::test
