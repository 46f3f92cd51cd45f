// One body without any symmetry through every mesh format and every volume format: the same volume in the same place, with
// any axis up. The files are written here; the table of what came in is printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "engine/volume/cut_volume.h"
#include "engine/volume/specimen.h"
#include "scenarios/import/binvox.h"
#include "scenarios/import/import.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/quarter_turn.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {


constexpr double kVolumeShare = 0.005;  // of the body's volume
constexpr double kPlaceVoxels = 0.1;

/// Centre of the body's mass: of its box and its two bumps, by their volumes.
const Vec3 kMiddle = (72.0 * Vec3(4.0, 4.0, 0.5) + 1.5 * Vec3(2.25, 3.0, 2.5) + 0.75 * Vec3(7.25, 5.0, 0.25)) / kLopsidedMm3;
const Vec3 kLow(1.0, 2.0, -1.0), kHigh(7.5, 6.0, 3.0);

/// Share of a voxel that is inside, of a face across it.
double coverage(std::uint16_t s) { return std::clamp(0.5 - distance_from_solid(s), 0.0, 1.0); }

struct Measured {
  double mm3 = 0.0;
  Vec3 middle{0.0};
};
Measured measure(const VoxelVolume& volume) {
  Measured out;
  double all = 0.0;
  IVec3 v;
  for (v.z = 0; v.z < volume.grid.size.z; ++v.z)
    for (v.y = 0; v.y < volume.grid.size.y; ++v.y)
      for (v.x = 0; v.x < volume.grid.size.x; ++v.x) {
        const double share = coverage(volume.s[volume.grid.index(v)]);
        out.middle += share * volume.grid.centre_mm(v);
        all += share;
      }
  out.middle /= all;
  out.mm3 = specimen_solid(*Specimen::build(volume, Reading::banded)).total_mm3();
  return out;
}

enum class Side : std::uint8_t { lower, upper };

/// Where the surface crosses a ray along an axis from outside, by the two voxels about it.
double face(const VoxelVolume& volume, Vec3 through, int axis, Side side) {
  const bool upper = side == Side::upper;
  const Grid& g = volume.grid;
  IVec3 v(glm::round((through - g.origin_mm) / g.voxel_mm));
  const int step = upper ? -1 : 1;
  v[axis] = upper ? g.size[axis] - 1 : 0;
  while (g.contains(v) && volume.s[g.index(v)] < kHalf) v[axis] += step;
  if (!g.contains(v)) return std::nan("");
  IVec3 before = v;
  before[axis] -= step;
  const double inside = distance_from_solid(volume.s[g.index(v)]), outside = distance_from_solid(volume.s[g.index(before)]);
  return g.centre_mm(before)[axis] + step * g.voxel_mm * outside / (outside - inside);
}

class Formats : public ::testing::Test {
 protected:
  /// One row: how far the volume, the middle and the six outermost faces are off, and whether that is little enough.
  /// `moved`: where the file has the body, when not where it was made.
  void row(const std::string& name, const Result<VoxelVolume, ImportFailure>& volume, UpAxis up = UpAxis::z, Vec3 moved = Vec3(0.0)) {
    ASSERT_TRUE(volume) << name << ": " << key_of(volume.error().code) << " " << volume.error().where << " " << volume.error().detail;
    const Measured got = measure(*volume);
    const double off_mm3 = got.mm3 / kLopsidedMm3 - 1.0, voxel = volume->grid.voxel_mm;
    const double off_middle = glm::length(got.middle - turned_up(kMiddle + moved, up)) / voxel;
    const Vec3 a = turned_up(kLow + moved, up), b = turned_up(kHigh + moved, up);
    // Through the middle of the upper bump, of the right one, and of the box.
    const Vec3 through_z = turned_up(Vec3(2.25, 3.0, 0.6) + moved, up), through_x = turned_up(Vec3(4.1, 5.0, 0.3) + moved, up),
               through_y = turned_up(Vec3(4.1, 4.1, 0.6) + moved, up);
    double off_face = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      for (const Side side : {Side::lower, Side::upper}) {
        const double wanted = side == Side::upper ? std::max(a[axis], b[axis]) : std::min(a[axis], b[axis]);
        const std::array<Vec3, 3> along = {turned_up(Vec3(1, 0, 0), up), turned_up(Vec3(0, 1, 0), up), turned_up(Vec3(0, 0, 1), up)};
        const Vec3 through = std::abs(along[0][axis]) > 0.5 ? through_x : std::abs(along[1][axis]) > 0.5 ? through_y : through_z;
        off_face = std::max(off_face, std::abs(face(*volume, through, axis, side) - wanted) / voxel);
      }
    std::printf("| %-28s | %2s | %5.3f | %8.4f | %+7.3f %% | %6.3f | %6.3f |\n", name.c_str(),
                std::string(kUpAxisKeys[static_cast<std::size_t>(up)]).c_str(), voxel, got.mm3, 100.0 * off_mm3, off_middle, off_face);
    EXPECT_LE(std::abs(off_mm3), kVolumeShare) << name;
    EXPECT_LE(off_middle, kPlaceVoxels) << name;
    EXPECT_LE(off_face, kPlaceVoxels) << name;
  }
  static void head() {
    std::printf("| %-28s | up | voxel | mm³      | volume    | middle | faces  | of %.3f mm³; places in voxels\n", "file", kLopsidedMm3);
  }
  TempFolder folder;
};

TEST_F(Formats, EveryMeshFormatHoldsTheSameBodyInTheSamePlaceWithAnyAxisUp) {
  const Mesh body = lopsided("body");
  write_obj(folder / "a.obj", {body});
  write_stl(folder / "text.stl", body);
  write_text(folder / "binary.stl", binary_stl(body));
  write_text(folder / "text.ply", ply_file(body, PlyData::text));
  write_text(folder / "binary.ply", ply_file(body, PlyData::binary));
  write_off(folder / "a.off", body);
  ThreeDsWish plain, tree, placed, turned;
  plain.tree = false;
  placed.origin = turned.origin = Vec3(3.0, -2.0, 1.0);
  turned.quarter_about_z = true;
  write_text(folder / "plain.3ds", three_ds_file({body}, plain));
  write_text(folder / "tree.3ds", three_ds_file({body}, tree));
  write_text(folder / "placed.3ds", three_ds_file({body}, placed));
  write_text(folder / "turned.3ds", three_ds_file({body}, turned));
  head();
  for (const char* name : {"a.obj", "text.stl", "binary.stl", "text.ply", "binary.ply", "a.off", "plain.3ds", "tree.3ds", "placed.3ds", "turned.3ds"}) {
    const auto list = list_meshes(folder / name);
    ASSERT_TRUE(list) << name << " " << list.error().detail;
    ASSERT_EQ(list->size(), 1u) << name;
    // Every axis where the library knows of axes, one turn elsewhere.
    const bool every = std::string(name) == "a.obj" || std::string(name) == "tree.3ds";
    for (std::size_t up = 0; up < (every ? kUpAxisKeys.size() : 2); ++up) {
      MeshImport what;
      what.path = folder / name;
      what.tissues = {{list->front().name, Tissue::dentine}};
      what.up = static_cast<UpAxis>(up);
      row(name, import_mesh(what), what.up);
    }
  }
}

/// The body in a file's voxels: of an axis-aligned box that holds it, x fastest.
struct Sampled {
  IVec3 size{0};
  Vec3 spacing_mm{0.0}, first_mm{0.0};  // centre of voxel (0,0,0)
  std::vector<std::int16_t> values;
};
/// file_axis[i]: the world axis that the file's axis i runs along; negative[i]: against it.
Sampled sampled(Vec3 spacing_of_world, std::array<int, 3> file_axis, std::array<bool, 3> negative, int inside, int outside) {
  const Vec3 low(0.0, 1.0, -2.0), high(8.5, 7.0, 4.0);
  Sampled out;
  std::array<Vec3, 3> step{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = file_axis[i];
    const double mm = spacing_of_world[axis];
    out.size[static_cast<int>(i)] = static_cast<int>(std::lround((high[axis] - low[axis]) / mm));
    out.spacing_mm[static_cast<int>(i)] = mm;
    step[i][axis] = negative[i] ? -mm : mm;
    out.first_mm[axis] = negative[i] ? high[axis] - 0.5 * mm : low[axis] + 0.5 * mm;
  }
  out.values = values_of(out.size, [&](IVec3 v) {
    return in_lopsided(out.first_mm + double(v.x) * step[0] + double(v.y) * step[1] + double(v.z) * step[2]) ? inside : outside;
  });
  return out;
}

std::string text_of(Vec3 v, const char* separator) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "%.9g%s%.9g%s%.9g", v.x, separator, v.y, separator, v.z);
  return buffer;
}
std::string text_of(IVec3 v) { return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z); }

constexpr Vec3 kUneven(0.125, 0.25, 0.5), kFine(0.125);
constexpr std::array kStraight = {0, 1, 2}, kSwapped = {2, 0, 1};
constexpr std::array kForward = {false, false, false}, kBackward = {true, false, true};

class VolumeFormats : public Formats {
 protected:
  enum class Axes : std::uint8_t { as_read, every };
  void labels(const std::string& name, const std::string& bytes, Axes axes = Axes::as_read) {
    write_text(folder / name, bytes);
    for (std::size_t up = 0; up < (axes == Axes::every ? kUpAxisKeys.size() : 1); ++up) {
      ImageImport what;
      what.path = folder / name;
      what.tissues.labels = {{7, Tissue::dentine}};
      what.tissues.up = static_cast<UpAxis>(up);
      row(name, import_image(what), what.tissues.up);
    }
  }
  /// With directions of the file's axes in the specimen's frame.
  static std::string nrrd(const Sampled& b, const std::array<Vec3, 3>& unit, const std::string& encoding, const std::string& data) {
    std::string directions;
    for (std::size_t i = 0; i < 3; ++i) directions += " (" + text_of(unit[i] * b.spacing_mm[static_cast<int>(i)], ",") + ")";
    return "NRRD0004\ntype: int16\ndimension: 3\nspace: right-anterior-superior\nsizes: " + text_of(b.size) +
           "\nspace directions:" + directions + "\nspace origin: (" + text_of(b.first_mm, ",") + ")\nendian: little\nencoding: " + encoding +
           "\n\n" + data;
  }
  /// MetaImage and its readers: x to the left and y to the back.
  static std::string metaimage(const Sampled& b, const std::string& matrix, const std::string& more) {
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix = " + matrix +
           "\nOffset = " + text_of(b.first_mm * Vec3(-1, -1, 1), " ") + "\nElementSpacing = " + text_of(b.spacing_mm, " ") +
           "\nDimSize = " + text_of(b.size) + "\nElementType = MET_SHORT\n" + more;
  }
};

TEST_F(VolumeFormats, EveryVolumeFormatHoldsTheSameBodyInTheSamePlace) {
  head();
  const Sampled straight = sampled(kUneven, kStraight, kForward, 7, 0), turned = sampled(kUneven, kSwapped, kBackward, 7, 0);
  const std::array<Vec3, 3> axes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  const std::array<Vec3, 3> turned_axes = {Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, -1, 0)};
  const std::string data = bytes_of(straight.values), turned_data = bytes_of(turned.values);
  labels("raw.nrrd", nrrd(straight, axes, "raw", data), Axes::every);
  labels("gzip.nrrd", nrrd(straight, axes, "gzip", gzip_stored(data)));
  labels("turned.nrrd", nrrd(turned, turned_axes, "raw", turned_data), Axes::every);
  // Right-anterior-superior axes are minus x and minus y of a MetaImage.
  labels("local.mha", metaimage(straight, "-1 0 0 0 -1 0 0 0 1", "ElementDataFile = LOCAL\n" + data), Axes::every);
  labels("turned.mha", metaimage(turned, "0 0 -1 -1 0 0 0 1 0", "ElementDataFile = LOCAL\n" + turned_data));
  labels("packed.mha", metaimage(straight, "-1 0 0 0 -1 0 0 0 1",
                                 "CompressedData = True\nElementDataFile = LOCAL\n" + zlib_stored(data)));
  write_text(folder / "beside.raw", data);
  labels("beside.mhd", metaimage(straight, "-1 0 0 0 -1 0 0 0 1", "ElementDataFile = beside.raw\n"));
  const auto nifti = [](const Sampled& b, const std::array<Vec3, 3>& unit) {
    NiftiWish w;
    w.size = b.size;
    w.spacing_mm = b.spacing_mm;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c)
        w.affine[4 * r + c] = static_cast<float>(unit[c][static_cast<int>(r)] * b.spacing_mm[static_cast<int>(c)]);
      w.affine[4 * r + 3] = static_cast<float>(b.first_mm[static_cast<int>(r)]);
    }
    w.values = b.values;
    return nifti_file(w);
  };
  labels("straight.nii", nifti(straight, axes), Axes::every);
  labels("turned.nii", nifti(turned, turned_axes));
  labels("packed.nii.gz", gzip_stored(nifti(turned, turned_axes)));
  std::string header = nifti(turned, turned_axes).substr(0, 352);
  header.replace(108, 4, std::string(4, '\0'));  // the data begin their own file
  header.replace(344, 4, std::string("ni1\0", 4));
  write_text(folder / "pair.img", turned_data);
  labels("pair.hdr", header);
}

TEST_F(VolumeFormats, ABinvoxAndASpecimenOfOurOwnHoldItToo) {
  head();
  const Sampled fine = sampled(kFine, kStraight, kForward, 1, 0);
  Binvox own;
  own.size = fine.size;
  own.scale = 0.125 * std::max({fine.size.x, fine.size.y, fine.size.z});
  own.translate = fine.first_mm - 0.5 * 0.125;
  own.value.assign(fine.values.begin(), fine.values.end());
  ASSERT_TRUE(write_binvox(own, folder / "a.binvox"));
  ImageImport what;
  what.path = folder / "a.binvox";
  what.tissues.labels = {{1, Tissue::dentine}};
  const auto volume = import_image(what);
  row("a.binvox", volume);
  ASSERT_TRUE(volume);
  ASSERT_TRUE(write_nrrd(*volume, folder / "specimen.nrrd"));
  what.path = folder / "specimen.nrrd";
  what.tissues = {};
  row("specimen.nrrd", import_image(what));
}

TEST_F(VolumeFormats, ACtSeriesHoldsItInGreyValuesWhateverItsFilesAreCalled) {
  head();
  // Patient's left and back: x and y are mirrored on the way, and the slices go downwards.
  const Sampled b = sampled(Vec3(0.125, 0.125, 0.25), kStraight, kForward, 1500, -1000);
  const auto across = static_cast<std::size_t>(b.size.x), down = static_cast<std::size_t>(b.size.y);
  std::filesystem::create_directory(folder / "ct");
  for (int n = 0; n < b.size.z; ++n) {
    DicomWish w;
    w.columns = b.size.x;
    w.rows = b.size.y;
    w.across_mm = w.down_mm = 0.125;
    w.thickness_mm = 0.25;
    w.number = b.size.z - n;
    w.orientation = {-1, 0, 0, 0, -1, 0};
    w.position = Vec3(-b.first_mm.x, -b.first_mm.y, b.first_mm.z + 0.25 * n);
    const auto first = b.values.begin() + static_cast<std::ptrdiff_t>(across * down * static_cast<std::size_t>(n));
    w.values.assign(first, first + static_cast<std::ptrdiff_t>(across * down));
    write_text(folder / ("ct/" + std::to_string((n * 7) % b.size.z)), dicom_file(w));
  }
  ImageImport what;
  what.path = folder / "ct";
  what.tissues.thresholds = {{250.0, Tissue::dentine}};
  for (const UpAxis up : {UpAxis::z, UpAxis::minus_x}) {
    what.tissues.up = up;
    row("CT series (DICOM)", import_image(what), up);
  }
}

TEST_F(VolumeFormats, ObliqueAxesKeepTheVolumeAndItsPlaceAboutTheMiddleOfTheFile) {
  head();
  const Sampled b = sampled(kUneven, kStraight, kForward, 7, 0);
  const Quat turn = glm::angleAxis(0.3, glm::normalize(Vec3(1.0, 2.0, 3.0)));
  const Vec3 middle = b.first_mm + 0.5 * Vec3(b.size - 1) * b.spacing_mm;
  Sampled oblique = b;
  oblique.first_mm = turn * b.first_mm;
  write_text(folder / "oblique.nrrd", nrrd(oblique, {turn * Vec3(1, 0, 0), turn * Vec3(0, 1, 0), turn * Vec3(0, 0, 1)}, "raw", bytes_of(b.values)));
  ImageImport what;
  what.path = folder / "oblique.nrrd";
  what.tissues.labels = {{7, Tissue::dentine}};
  std::vector<ImportRemark> remarks;
  row("oblique.nrrd", import_image(what, {}, &remarks), UpAxis::z, turn * middle - middle);
  EXPECT_TRUE(std::ranges::any_of(remarks, [](const ImportRemark& r) { return r.code == RemarkCode::straightened; }));
}

TEST_F(Formats, AQuarterTurnOfTheSpecimenIsAQuarterTurnOfTheFile) {
  write_obj(folder / "a.obj", {lopsided("body")});
  MeshImport what;
  what.path = folder / "a.obj";
  what.tissues = {{"body", Tissue::dentine}};
  const auto upright = import_mesh(what);
  ASSERT_TRUE(upright);
  struct Turn {
    int axis, quarters;
    UpAxis up;
  };
  for (const Turn& t : {Turn{0, 1, UpAxis::y}, Turn{0, -1, UpAxis::minus_y}, Turn{0, 2, UpAxis::minus_z}, Turn{1, -1, UpAxis::x}, Turn{1, 1, UpAxis::minus_x}}) {
    what.up = t.up;
    const auto from_file = import_mesh(what);
    ASSERT_TRUE(from_file);
    const VoxelVolume turned = quarter_turned(*upright, t.axis, t.quarters);
    ASSERT_EQ(turned.grid.size, from_file->grid.size) << t.axis << " " << t.quarters;
    EXPECT_LT(glm::length(turned.grid.origin_mm - from_file->grid.origin_mm), 1e-9) << t.axis << " " << t.quarters;
    int worst = 0;
    for (std::size_t i = 0; i < turned.s.size(); ++i) worst = std::max(worst, std::abs(turned.s[i] - from_file->s[i]));
    EXPECT_LE(worst, 2) << t.axis << " " << t.quarters;  // of 65535: the rounding of distances
  }
  const VoxelVolume round = quarter_turned(quarter_turned(*upright, 2, 3), 2, 1);
  EXPECT_TRUE(round.s == upright->s && round.tissue == upright->tissue);
}

}  // namespace
}  // namespace cusp::test
