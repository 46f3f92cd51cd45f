#include "scenarios/import/nrrd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scenarios/blocks/blocks.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {

using test::read_text;
using test::TempFolder;
using test::write_text;

void expect_same(const VoxelVolume& a, const VoxelVolume& b) {
  EXPECT_EQ(a.grid, b.grid);
  EXPECT_EQ(a.names, b.names);
  EXPECT_TRUE(a.tissue == b.tissue);
  EXPECT_TRUE(a.s == b.s);
}

/// Every code, every s, a place and an edge that have no short decimal.
VoxelVolume random_volume(std::uint32_t seed) {
  std::mt19937 random(seed);
  Grid grid;
  grid.size = {1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 20)};
  grid.voxel_mm = 0.05 + random() * 1e-11;
  for (int i = 0; i < 3; ++i) grid.origin_mm[i] = (static_cast<double>(random()) - 2e9) * 1e-8;
  VoxelVolume out(grid);
  for (std::size_t i = 0; i < out.s.size(); ++i) {
    const std::size_t code = random() % kTissueCodes;
    out.tissue[i] = static_cast<Tissue>(is_tissue_code(code) ? code : 0);
    out.s[i] = out.tissue[i] == Tissue::empty ? std::uint16_t{0} : static_cast<std::uint16_t>(random());
  }
  out.tissue[0] = Tissue::enamel;
  out.s[0] = kSolid;
  out.names[17] = "Pulpenstein, 50 % \\ \xc3\xa4:=";
  out.names[31] = "";
  return out;
}

TEST(Nrrd, WriteThenReadIsIdentity) {
  const TempFolder folder;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const VoxelVolume volume = random_volume(seed);
    ASSERT_TRUE(write_nrrd(volume, folder / "v.nrrd"));
    const auto back = read_nrrd(folder / "v.nrrd");
    ASSERT_TRUE(back) << key_of(back.error().code) << " " << back.error().where;
    expect_same(volume, *back);
  }
}

TEST(Nrrd, ItsNamesAreReadOfTheHeaderAlone) {
  const TempFolder folder;
  const VoxelVolume volume = random_volume(7);
  ASSERT_TRUE(write_nrrd(volume, folder / "v.nrrd"));
  EXPECT_EQ(nrrd_names(folder / "v.nrrd"), volume.names);
  const std::string text = read_text(folder / "v.nrrd");
  write_text(folder / "cut.nrrd", text.substr(0, text.find("\n\n") + 2));
  EXPECT_FALSE(read_nrrd(folder / "cut.nrrd"));
  EXPECT_EQ(nrrd_names(folder / "cut.nrrd"), volume.names);
  write_text(folder / "other.nrrd", "NRRD0009\n\n");
  EXPECT_TRUE(nrrd_names(folder / "other.nrrd").empty());
  EXPECT_TRUE(nrrd_names(folder / "none.nrrd").empty());
}

TEST(Nrrd, AWholeBlockComesBack) {
  const TempFolder folder;
  const VoxelVolume block = paper_block();
  ASSERT_TRUE(write_nrrd(block, folder / "block.nrrd"));
  const auto back = read_nrrd(folder / "block.nrrd");
  ASSERT_TRUE(back);
  expect_same(block, *back);
}

TEST(Nrrd, TheSameVolumeGivesTheSameBytes) {
  const TempFolder folder;
  const VoxelVolume volume = random_volume(7);
  ASSERT_TRUE(write_nrrd(volume, folder / "a.nrrd"));
  ASSERT_TRUE(write_nrrd(volume, folder / "b.nrrd"));
  EXPECT_EQ(read_text(folder / "a.nrrd"), read_text(folder / "b.nrrd"));
}

TEST(Nrrd, TheHeaderStatesWhatTheFormatPromises) {
  const TempFolder folder;
  VoxelVolume volume(Grid{{3, 2, 1}, 0.1, {-0.25, 1.0, 2.5}});
  volume.tissue[0] = Tissue::dentine;
  volume.s[0] = kSolid;
  volume.names[16] = "stone";
  ASSERT_TRUE(write_nrrd(volume, folder / "v.nrrd"));
  const std::string text = read_text(folder / "v.nrrd");
  EXPECT_EQ(text.substr(0, text.find("\n\n") + 2),
            "NRRD0005\n"
            "# Cusp specimen: per voxel its tissue and its solid fraction in 1/65535\n"
            "type: uint16\n"
            "dimension: 4\n"
            "space: right-anterior-superior\n"
            "sizes: 2 3 2 1\n"
            "space directions: none (0.1,0,0) (0,0.1,0) (0,0,0.1)\n"
            "centerings: none cell cell cell\n"
            "kinds: list space space space\n"
            "endian: little\n"
            "encoding: gzip\n"
            "space origin: (-0.25,1,2.5)\n"
            "space units: \"mm\" \"mm\" \"mm\"\n"
            "tissue 2:=dentine\n"
            "tissue 16:=stone\n\n");
}

TEST(Nrrd, AnOldFileStaysWhenTheNewOneCannotBeWritten) {
  const TempFolder folder;
  ASSERT_TRUE(write_nrrd(random_volume(3), folder / "v.nrrd"));
  const std::string before = read_text(folder / "v.nrrd");
  VoxelVolume wrong = random_volume(4);
  wrong.tissue[0] = Tissue::empty;  // with s > 0: no reader would take it
  const auto r = write_nrrd(wrong, folder / "v.nrrd");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, ImportError::bad_tissue);
  EXPECT_EQ(r.error().where, "v.nrrd (0,0,0)");
  EXPECT_EQ(read_text(folder / "v.nrrd"), before);
}

TEST(Nrrd, AMissingFolderIsReported) {
  const TempFolder folder;
  const auto r = write_nrrd(random_volume(3), folder / "no" / "v.nrrd");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, ImportError::io);
}

TEST(Nrrd, AFolderOfTheNameIsReportedAndNothingLiesBesideIt) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "v.nrrd");
  const auto r = write_nrrd(random_volume(3), folder / "v.nrrd");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, ImportError::io);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& f : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 1u);
}

/// A label map with one voxel set: header lines besides sizes and type, the place in the file, the place expected.
struct Placed {
  const char* axes;
  IVec3 in_file;
  Vec3 expected_mm;
};

TEST(NrrdLabels, EveryAxisOrderAndDirectionLandsInTheSpecimenFrame) {
  const Placed cases[] = {
      // The file's own numbers: origin + index * 0.5, then LPS turned to RAS by minus x and minus y.
      {"space: right-anterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nspace origin: (1,2,3)\n",
       {3, 1, 0}, {2.5, 2.5, 3.0}},
      {"space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nspace origin: (1,2,3)\n",
       {3, 1, 0}, {-2.5, -2.5, 3.0}},
      {"space: LAS\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nspace origin: (1,2,3)\n",
       {3, 1, 0}, {-2.5, 2.5, 3.0}},
      {"space: RAS\nspace directions: (0,0,-0.5) (0.5,0,0) (0,0.5,0)\nspace origin: (1,2,3)\n",
       {3, 1, 0}, {1.5, 2.0, 1.5}},
      {"spacings: 0.5 0.5 0.5\n", {3, 1, 0}, {1.5, 0.5, 0.0}},
  };
  const TempFolder folder;
  for (const Placed& c : cases) {
    SCOPED_TRACE(c.axes);
    std::string data(4 * 3 * 2, '\0');
    data[static_cast<std::size_t>(c.in_file.x + 4 * (c.in_file.y + 3 * c.in_file.z))] = 2;
    write_text(folder / "l.nrrd", std::string("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 3 2\nencoding: raw\n") +
                                      c.axes + "\n" + data);
    const auto volume = read_nrrd(folder / "l.nrrd");
    ASSERT_TRUE(volume) << key_of(volume.error().code) << " " << volume.error().where;
    EXPECT_EQ(volume->grid.size, IVec3(9));  // one voxel and four on each side
    const IVec3 middle(4);
    EXPECT_LT(glm::length(volume->grid.centre_mm(middle) - c.expected_mm), 1e-12);
    EXPECT_EQ(volume->tissue[volume->grid.index(middle)], Tissue::dentine);
  }
}

TEST(NrrdLabels, EveryIntegerTypeReadsAlike) {
  const TempFolder folder;
  const auto make = [&](const std::string& type, const std::string& endian, std::size_t bytes) {
    std::string data;
    for (int i = 0; i < 27; ++i) {
      std::string sample(bytes, '\0');
      sample[endian == "big" ? bytes - 1 : 0] = i == 13 ? 1 : 5;
      data += sample;
    }
    write_text(folder / "l.nrrd", "NRRD0001\r\ntype: " + type + "\r\ndimension: 3\r\nsizes: 3 3 3\r\nendian: " + endian +
                                      "\r\nspacings: 1 1 1\r\nencoding: raw\r\n\r\n" + data);
    return read_nrrd(folder / "l.nrrd");
  };
  const auto reference = make("uint8", "little", 1);
  ASSERT_TRUE(reference);
  for (const auto& [type, bytes] : {std::pair<std::string, std::size_t>{"signed char", 1}, {"short", 2}, {"uint16", 2},
                                    {"int", 4}, {"unsigned int", 4}, {"long long", 8}, {"uint64_t", 8}})
    for (const char* endian : {"little", "big"}) {
      SCOPED_TRACE(type + " " + endian);
      const auto volume = make(type, endian, bytes);
      ASSERT_TRUE(volume) << key_of(volume.error().code);
      expect_same(*reference, *volume);
    }
}

TEST(NrrdLabels, ALeadingAxisOfOneAndItsNanSpacingAreDropped) {
  const TempFolder folder;
  const std::string data(8, '\1');
  write_text(folder / "l.nrrd", "NRRD0005\ntype: uint8\ndimension: 4\nsizes: 1 2 2 2\nspacings: NaN 0.2 0.2 0.2\n"
                                "encoding: raw\n\n" + data);
  const auto volume = read_nrrd(folder / "l.nrrd");
  ASSERT_TRUE(volume) << key_of(volume.error().code) << " " << volume.error().where;
  EXPECT_EQ(volume->grid.size, IVec3(10));
}

TEST(NrrdLabels, FacesAlongTheAxesAreExactAndABallWithinHalfAVoxel) {
  const TempFolder folder;
  const auto read = [&](int n, auto label) {
    std::string data;
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) data += static_cast<char>(label(Vec3(x, y, z)));
    const std::string size = std::to_string(n);
    write_text(folder / "l.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: " + size + " " + size + " " + size +
                                      "\nspacings: 0.1 0.1 0.1\nencoding: raw\n\n" + data);
    return read_nrrd(folder / "l.nrrd");
  };
  const auto cube = read(12, [](Vec3) { return 1; });
  ASSERT_TRUE(cube);
  for (int i = 0; i < 20; ++i) {
    // Across the middle of a face the distance is that of the plane: -(i - 4) - 1/2 voxels from the low side.
    const double expected = std::max(3.5 - i, i - 15.5);
    EXPECT_EQ(cube->s[cube->grid.index({i, 10, 10})], solid_from_distance(expected)) << i;
  }

  const auto ball = read(25, [](Vec3 p) { return glm::length(p - 12.0) <= 10.0 ? 2 : 0; });
  ASSERT_TRUE(ball);
  double worst = 0;
  IVec3 v;
  for (v.z = 0; v.z < ball->grid.size.z; ++v.z)
    for (v.y = 0; v.y < ball->grid.size.y; ++v.y)
      for (v.x = 0; v.x < ball->grid.size.x; ++v.x) {
        const double d = glm::length(ball->grid.centre_mm(v) - 1.2) / 0.1 - 10.0;
        if (std::abs(d) < 2.0)
          worst = std::max(worst, std::abs(d - distance_from_solid(ball->s[ball->grid.index(v)])));
      }
  RecordProperty("worst_voxels", std::to_string(worst));
  EXPECT_LT(worst, 0.6) << "measured 0.50";
  EXPECT_GT(worst, 0.1) << "a label map cannot know better; a smaller error means a broken test";
}

TEST(NrrdLabels, OutsideTheSurfaceStandsTheNearestTissue) {
  const TempFolder folder;
  std::string data;
  for (int i = 0; i < 6 * 6 * 6; ++i) data += i % 6 < 3 ? '\1' : '\2';  // enamel at low x, dentine at high x
  write_text(folder / "l.nrrd",
             "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 6 6 6\nspacings: 0.1 0.1 0.1\nencoding: raw\n\n" + data);
  const auto volume = read_nrrd(folder / "l.nrrd");
  ASSERT_TRUE(volume);
  IVec3 v;
  for (v.z = 0; v.z < 14; ++v.z)
    for (v.y = 0; v.y < 14; ++v.y)
      for (v.x = 0; v.x < 14; ++v.x) {
        const std::size_t i = volume->grid.index(v);
        const Tissue expected = volume->s[i] == 0 ? Tissue::empty : v.x < 7 ? Tissue::enamel : Tissue::dentine;
        ASSERT_EQ(volume->tissue[i], expected) << v.x << " " << v.y << " " << v.z;
      }
}

}  // namespace
}  // namespace cusp::test
