// NRRD and MetaImage as images: axes, spacings, colours and kinds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include "scenarios/import/image_volume.h"
#include "scenarios/import/metaimage.h"
#include "scenarios/import/nrrd_image.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"

namespace cusp::test {
namespace {

float at(const Image& image, int x, int y, int z) {
  const IVec3 n = image.layout.size;
  return image.value[static_cast<std::size_t>(x + n.x * (y + n.y * z))];
}

Result<Image, ImportFailure> nrrd(const std::string& bytes, const VolumeLimits& limits = {}) {
  std::istringstream in(bytes);
  return read_nrrd_image(in, bytes.size(), "v.nrrd", limits);
}
Result<Image, ImportFailure> mha(const std::string& bytes, const SideFiles& beside = [](const std::string&) { return SideFile{}; }) {
  std::istringstream in(bytes);
  return read_metaimage(in, bytes.size(), "v.mha", beside);
}

std::string ramp() { return bytes_of(values_of({2, 3, 4}, [](IVec3 v) { return v.x + 10 * v.y + 100 * v.z; })); }

TEST(Layout, AxesInAnyOrderAndDirectionFindTheirPlace) {
  // File axis 0 runs along -z, 1 along x, 2 along -y.
  const auto l = lay_out({2, 3, 4}, {Vec3(0, 0, -0.5), Vec3(0.1, 0, 0), Vec3(0, -0.2, 0)}, Vec3(1, 2, 3), {});
  ASSERT_TRUE(l);
  EXPECT_EQ(l->size, IVec3(3, 4, 2));
  EXPECT_LT(glm::length(l->spacing_mm - Vec3(0.1, 0.2, 0.5)), 1e-12);
  EXPECT_LT(glm::length(l->origin_mm - Vec3(1.0, 2.0 - 0.6, 3.0 - 0.5)), 1e-12);
  EXPECT_EQ(l->turned_degrees, 0.0);
  // The file's first voxel lies at x 0, y last, z last.
  EXPECT_EQ(l->place(0, 0, 0), static_cast<std::size_t>(0 + 3 * (3 + 4 * 1)));
  EXPECT_EQ(l->place(1, 2, 3), static_cast<std::size_t>(2 + 3 * (0 + 4 * 0)));
}

TEST(Layout, ObliqueAxesAreStraightenedByTheirAngleAndNeverMirrored) {
  const double a = 0.3;
  const Vec3 x(std::cos(a), std::sin(a), 0), y(-std::sin(a), std::cos(a), 0), z(0, 0, 1);
  const auto l = lay_out({5, 6, 7}, {x, y, z}, Vec3(0.0), {});
  ASSERT_TRUE(l);
  EXPECT_NEAR(l->turned_degrees, 0.3 * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_EQ(l->step[0], 1);
  const auto mirrored = lay_out({5, 6, 7}, {x, y, -z}, Vec3(0.0), {});
  ASSERT_TRUE(mirrored);
  EXPECT_LT(mirrored->step[2], 0);
  EXPECT_NEAR(mirrored->turned_degrees, l->turned_degrees, 1e-9);
}

TEST(Layout, ShearedFlatAndEndlessAxesAreRefused) {
  EXPECT_EQ(lay_out({5, 5, 5}, {Vec3(1, 0, 0), Vec3(0.1, 1, 0), Vec3(0, 0, 1)}, {}, {}).error(), ImportError::bad_orientation);
  EXPECT_EQ(lay_out({5, 5, 5}, {Vec3(1, 0, 0), Vec3(0.0), Vec3(0, 0, 1)}, {}, {}).error(), ImportError::bad_spacing);
  EXPECT_EQ(lay_out({5, 5, 5}, {Vec3(NAN, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {}, {}).error(), ImportError::bad_spacing);
  EXPECT_EQ(lay_out({2000, 2000, 2000}, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {}, {}).error(), ImportError::too_large);
}

TEST(NrrdImage, SpacingsThatAreNoNumberAreAskedForAndTheColourAxisIsNoSpace) {
  // As the builder of coloured voxels writes it: four bytes a voxel, black or transparent is nothing.
  std::string data;
  for (int i = 0; i < 8; ++i) data += i == 3 ? std::string("\xff\x80\x01\xff") : i == 5 ? std::string("\x10\x20\x30\0", 4) : std::string(4, '\0');
  const std::string head = "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 4 2 2 2\nencoding: raw\n";
  const auto known = nrrd(head + "spacings: nan 0.5 0.5 0.5\nkinds: RGBA-color domain domain domain\n\n" + data);
  ASSERT_TRUE(known) << key_of(known.error().code) << known.error().where;
  EXPECT_EQ(known->kind, ImageKind::colours);
  EXPECT_TRUE(known->spacing_known);
  EXPECT_EQ(known->value[3], static_cast<float>(0xff8001));
  EXPECT_EQ(known->value[5], 0.0f);
  const auto unknown = nrrd(head + "spacings: nan nan nan nan\n\n" + data);
  ASSERT_TRUE(unknown);
  EXPECT_FALSE(unknown->spacing_known);
  EXPECT_EQ(unknown->layout.spacing_mm, Vec3(1.0));
}

TEST(NrrdImage, SpacingsAreInTheUnitsOfTheirAxes) {
  const auto with = [](const std::string& units) {
    return nrrd("NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 2 2\nencoding: raw\nspacings: nan 50 50 50\n" + units + "\n" + std::string(24, '\1'));
  };
  const auto um = with("units: \"\" \"um\" \"um\" \"um\"\n");
  ASSERT_TRUE(um) << um.error().where;
  EXPECT_TRUE(um->spacing_known);
  EXPECT_LT(glm::length(um->layout.spacing_mm - Vec3(0.05)), 1e-12);
  EXPECT_EQ(with("")->layout.spacing_mm, Vec3(50.0));
  EXPECT_FALSE(with("units: \"\" \"ell\" \"ell\" \"ell\"\n")->spacing_known);
  for (const char* mixed : {"\"um\" \"mm\" \"mm\"", "\"mm\" \"mm\" \"um\"", "\"um\" \"ell\" \"um\""}) {
    const auto image = with("units: \"\" " + std::string(mixed) + "\n");
    ASSERT_TRUE(image) << mixed;
    EXPECT_FALSE(image->spacing_known) << mixed;
    EXPECT_EQ(image->layout.spacing_mm, Vec3(50.0)) << mixed << ": as the file has them";
  }
}

TEST(NrrdImage, WithoutASpaceItsSidesAreNotKnown) {
  const auto with = [](const std::string& space) {
    return nrrd("NRRD0004\ntype: uchar\ndimension: 3\n" + space + "sizes: 2 2 2\nencoding: raw\nspacings: 0.5 0.5 0.5\n\n" + std::string(8, '\1'));
  };
  EXPECT_FALSE(with("")->sides_known);
  EXPECT_FALSE(with("space dimension: 3\n")->sides_known);
  for (const char* space : {"left-posterior-superior", "RAS", "3D-right-handed"}) {
    const auto image = with("space: " + std::string(space) + "\n");
    ASSERT_TRUE(image) << space;
    EXPECT_TRUE(image->sides_known) << space;
  }
}

TEST(NrrdImage, SpacingsOfNoLengthAreRefused) {
  const std::string data(8, '\1');
  for (const char* spacings : {"0 0.5 0.5", "0.5 -0.5 0.5", "nan 0.5 0"}) {
    const auto image = nrrd("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspacings: " + std::string(spacings) + "\n\n" + data);
    ASSERT_FALSE(image) << spacings;
    EXPECT_EQ(image.error().code, ImportError::bad_header) << spacings;
    EXPECT_NE(image.error().where.find("spacings"), std::string::npos) << image.error().where;
  }
}

TEST(NrrdImage, OfAFileThatWasPackedInPartsAllPartsAreRead) {
  const std::string head = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: gzip\nspacings: 0.5 0.5 0.5\n\n";
  const std::string parts = gzip_stored("\1\2\3") + gzip_stored("") + gzip_stored("\4\5\6\7\10");
  const auto image = nrrd(head + parts);
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(at(*image, 0, 0, 0), 1.0f);
  EXPECT_EQ(at(*image, 1, 1, 1), 8.0f);
  EXPECT_TRUE(nrrd(head + parts + "notes")) << "no part of the packed data";
  const auto longer = nrrd(head + parts + gzip_stored("\11"));
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().code, ImportError::corrupt);
}

TEST(NrrdImage, GreyFloatsAnisotropicAndLpsAreRead) {
  std::string data;
  for (int i = 0; i < 8; ++i) {
    const float v = i == 6 ? NAN : static_cast<float>(i) + 0.5f;
    data.append(reinterpret_cast<const char*>(&v), 4);
  }
  const auto image = nrrd("NRRD0005\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
                          "space directions: (0.2,0,0) (0,0.2,0) (0,0,1.5)\nendian: little\nencoding: raw\nspace origin: (1,2,3)\n\n" + data);
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(image->kind, ImageKind::grey);
  EXPECT_EQ(image->layout.spacing_mm, Vec3(0.2, 0.2, 1.5));
  EXPECT_LT(glm::length(image->layout.origin_mm - Vec3(-1.2, -2.2, 3.0)), 1e-12);
  EXPECT_EQ(at(*image, 1, 1, 0), 0.5f);  // the file's first voxel lies to the right and in front
  EXPECT_LT(at(*image, 1, 0, 1), 0.5f) << "no number: below the least there is";
}

/// A cube of 5 voxels a side, of which the inner 27 have a number.
std::string masked(const std::function<float(IVec3)>& inner) {
  std::string data;
  IVec3 v;
  for (v.z = 0; v.z < 5; ++v.z)
    for (v.y = 0; v.y < 5; ++v.y)
      for (v.x = 0; v.x < 5; ++v.x) {
        const bool within = glm::all(glm::greaterThan(v, IVec3(0))) && glm::all(glm::lessThan(v, IVec3(4)));
        const float value = within ? inner(v) : v.x % 2 == 0 ? NAN : -INFINITY;
        data.append(reinterpret_cast<const char*>(&value), 4);
      }
  return "NRRD0005\ntype: float\ndimension: 3\nsizes: 5 5 5\nspacings: 0.5 0.5 0.5\nendian: little\nencoding: raw\n\n" + data;
}

TEST(NrrdImage, NoThresholdMakesTissueOfVoxelsWithoutANumber) {
  const auto image = nrrd(masked([](IVec3 v) { return 1000.5f + static_cast<float>(v.x); }));
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(image->kind, ImageKind::grey);
  using Thresholds = std::vector<std::pair<double, Tissue>>;
  for (const Thresholds& thresholds : {Thresholds{{900.0, Tissue::dentine}}, Thresholds{{-1e6, Tissue::dentine}},
                                       Thresholds{{-1e6, Tissue::empty}, {-9e5, Tissue::dentine}}}) {
    ImageTissues what;
    what.thresholds = thresholds;
    std::vector<ImportRemark> remarks;
    const auto volume = volume_of_image(*image, what, "v.nrrd", {}, remarks);
    ASSERT_TRUE(volume) << key_of(volume.error().code);
    EXPECT_EQ(std::ranges::count_if(volume->s, [](std::uint16_t s) { return s >= kHalf; }), 27) << thresholds.front().first;
  }
}

TEST(NrrdImage, LabelsWithoutANumberAreNothingAndAFileWithoutAnyNumberIsRefused) {
  const auto labels = nrrd(masked([](IVec3 v) { return static_cast<float>(v.x); }));
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->kind, ImageKind::labels);
  EXPECT_EQ(at(*labels, 0, 0, 0), 0.0f);
  EXPECT_EQ(at(*labels, 1, 1, 1), 1.0f);
  const auto none = nrrd(masked([](IVec3) { return NAN; }));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ImportError::nothing_solid);
  EXPECT_EQ(none.error().where, "v.nrrd");
}

const std::string kMha = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
                         "Offset = 1 2 3\nElementSpacing = 0.1 0.2 0.4\nDimSize = 2 3 4\nElementType = MET_SHORT\n";

TEST(MetaImage, LocalDataAreReadInLeftPosteriorSuperior) {
  const auto image = mha(kMha + "ElementDataFile = LOCAL\n" + ramp());
  ASSERT_TRUE(image) << key_of(image.error().code) << image.error().where;
  EXPECT_EQ(image->layout.size, IVec3(2, 3, 4));
  EXPECT_EQ(image->layout.spacing_mm, Vec3(0.1, 0.2, 0.4));
  EXPECT_LT(glm::length(image->layout.origin_mm - Vec3(-1.1, -2.4, 3.0)), 1e-12);
  EXPECT_EQ(at(*image, 1, 2, 0), 0.0f);
  EXPECT_EQ(at(*image, 0, 2, 0), 1.0f);
  EXPECT_EQ(at(*image, 1, 1, 3), 310.0f);
}

TEST(MetaImage, WithoutADirectionOfItsAxesItsSidesAreNotKnown) {
  const auto with = [](const std::string& line) { return mha(kMha + line + "ElementDataFile = LOCAL\n" + ramp()); };
  const auto plain = with("");
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->sides_known);
  for (const char* key : {"TransformMatrix", "Rotation", "Orientation"}) {
    const auto image = with(std::string(key) + " = 1 0 0 0 1 0 0 0 1\n");
    ASSERT_TRUE(image) << key;
    EXPECT_TRUE(image->sides_known) << key;
    EXPECT_EQ(image->value, plain->value) << key << ": the same place, stated";
  }
}

TEST(MetaImage, LengthsAreInTheUnitThatTheFileNames) {
  const auto with = [](const std::string& lengths) {
    std::string text = kMha;
    for (const std::string from : {"Offset = 1 2 3\n", "ElementSpacing = 0.1 0.2 0.4\n"}) text.erase(text.find(from), from.size());
    return mha(text + lengths + "ElementDataFile = LOCAL\n" + ramp());
  };
  const auto um = with("DistanceUnits = um\nOffset = 1000 2000 3000\nElementSpacing = 100 200 400\n");
  ASSERT_TRUE(um) << um.error().where;
  EXPECT_TRUE(um->spacing_known);
  EXPECT_LT(glm::length(um->layout.spacing_mm - Vec3(0.1, 0.2, 0.4)), 1e-12);
  EXPECT_LT(glm::length(um->layout.origin_mm - Vec3(-1.1, -2.4, 3.0)), 1e-12);
  EXPECT_LT(glm::length(with("DistanceUnits = cm\nElementSpacing = 0.01 0.02 0.04\n")->layout.spacing_mm - Vec3(0.1, 0.2, 0.4)), 1e-12);
  const auto unknown = with("DistanceUnits = ?\nElementSpacing = 0.1 0.2 0.4\n");
  ASSERT_TRUE(unknown);
  EXPECT_FALSE(unknown->spacing_known);
  EXPECT_LT(glm::length(unknown->layout.spacing_mm - Vec3(0.1, 0.2, 0.4)), 1e-12);
}

TEST(MetaImage, DetachedListedAndNumberedDataAreReadWithoutZerosInFront) {
  const TempFolder folder;
  const std::string all = ramp(), slice(12, '\0');
  write_text(folder / "v.raw", all);
  for (int k = 0; k < 4; ++k) write_text(folder / ("s" + std::to_string(8 + k) + ".raw"), all.substr(static_cast<std::size_t>(12 * k), 12));
  const std::string whole = kMha + "ElementDataFile = ";
  write_text(folder / "one.mhd", whole + "v.raw\n");
  write_text(folder / "list.mhd", whole + "LIST\ns8.raw\ns9.raw\ns10.raw\ns11.raw\n");
  write_text(folder / "numbered.mhd", whole + "s%d.raw 8 11 1\n");
  const auto expected = mha(whole + "LOCAL\n" + all);
  ASSERT_TRUE(expected);
  for (const char* name : {"one.mhd", "list.mhd", "numbered.mhd"}) {
    const auto image = read_metaimage(folder / name);
    ASSERT_TRUE(image) << name << key_of(image.error().code) << image.error().where;
    EXPECT_EQ(image->value, expected->value) << name;
  }
  write_text(folder / "two.mhd", whole + "LIST\ns8.raw\ns9.raw\n");
  EXPECT_EQ(read_metaimage(folder / "two.mhd").error().code, ImportError::bad_sizes);  // of four slices
  std::filesystem::remove(folder / "s10.raw");
  EXPECT_EQ(read_metaimage(folder / "numbered.mhd").error().code, ImportError::missing_file);
  EXPECT_EQ(read_metaimage(folder / "numbered.mhd").error().where, "s10.raw");
}

TEST(MetaImage, ARefusedPlaceIsNamedByTheKeyThatMadeIt) {
  const struct {
    std::string from, to, code, where;
  } cases[] = {
      {"Offset = 1 2 3", "Offset = 1 nan 3", "bad_header", "v.mha Offset"},
      {"Offset = 1 2 3", "Offset = 1 2 1e30", "bad_header", "v.mha Offset"},
      {"0.1 0.2 0.4", "0.1 0.2 1e-10", "bad_spacing", "v.mha ElementSpacing"},
      {"0.1 0.2 0.4", "0.1 0.2 1e30", "bad_spacing", "v.mha ElementSpacing"},
      {"0.1 0.2 0.4", "0.1 0.2 0.4\nTransformMatrix = 1 0 0 0 1 0 0 0 0", "bad_spacing", "v.mha TransformMatrix"},
      {"0.1 0.2 0.4", "0.1 0.2 0.4\nTransformMatrix = 1 0 0 0 nan 0 0 0 1", "bad_spacing", "v.mha TransformMatrix"},
      {"0.1 0.2 0.4", "0.1 0.2 0.4\nTransformMatrix = 1 0 0 0.5 1 0 0 0 1", "bad_orientation", "v.mha TransformMatrix"},
  };
  for (const auto& c : cases) {
    std::string text = kMha + "ElementDataFile = LOCAL\n" + ramp();
    text.replace(text.find(c.from), c.from.size(), c.to);
    const auto r = mha(text);
    ASSERT_FALSE(r) << c.to;
    EXPECT_EQ(key_of(r.error().code), c.code) << c.to;
    EXPECT_EQ(r.error().where, c.where) << c.to;
  }
}

TEST(MetaImage, BrokenHeadersAndFilesElsewhereAreRefused) {
  using enum ImportError;
  const struct {
    std::string from, to;
    ImportError code;
  } cases[] = {
      {"NDims = 3", "NDims = 2", bad_sizes},
      {"DimSize = 2 3 4", "DimSize = 2 3", bad_header},
      {"DimSize = 2 3 4", "DimSize = 2 0 4", bad_sizes},
      {"DimSize = 2 3 4", "DimSize = 2 3 4000", too_large},
      {"DimSize = 2 3 4", "DimSize = 500 500 500", truncated},
      {"MET_SHORT", "MET_STRING", unsupported},
      {"BinaryData = True", "BinaryData = False", unsupported},
      {"LOCAL", "../../etc/passwd", unsupported},
      {"LOCAL", "/etc/passwd", unsupported},
      {"LOCAL", "gone.raw", missing_file},
      {"LOCAL", "s%s.raw 1 4 1", unsupported},
      {"LOCAL", "s%d.raw 1 9999999 1", bad_header},
      {"ObjectType = Image", "ObjectType = Tube", unsupported},
      {"Offset", "NDims = 3\nOffset", bad_header},
      {"ElementSpacing = 0.1 0.2 0.4", "TransformMatrix = 1 0 0 1 1 0 0 0 1", bad_orientation},
  };
  for (const auto& c : cases) {
    std::string text = kMha + "ElementDataFile = LOCAL\n" + ramp();
    text.replace(text.find(c.from), c.from.size(), c.to);
    const auto r = mha(text);
    ASSERT_FALSE(r) << c.to;
    EXPECT_EQ(key_of(r.error().code), key_of(c.code)) << c.to << " " << r.error().where;
  }
  EXPECT_EQ(key_of(mha(kMha + "ElementDataFile = LOCAL\n" + ramp() + "x").error().code), "corrupt");
  EXPECT_EQ(key_of(mha("\x7f" "ELF").error().code), "unknown_format");
}

}  // namespace
}  // namespace cusp::test
