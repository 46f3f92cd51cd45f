#include <gtest/gtest.h>

#include <random>

#include "scenarios/blocks/blocks.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/nrrd_image.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {

using test::read_text;
using test::TempFolder;
using test::write_text;

/// A good file of 3 x 3 x 3 voxels, to be broken.
std::string good_file(const TempFolder& folder) {
  VoxelVolume volume(Grid{{3, 3, 3}, 0.1, Vec3(0.0)});
  for (std::size_t i = 0; i < 27; ++i) {
    volume.tissue[i] = Tissue::enamel;
    volume.s[i] = static_cast<std::uint16_t>(40000 + 911 * i % 20000);
  }
  volume.names[20] = "stone";
  EXPECT_TRUE(write_nrrd(volume, folder / "good.nrrd"));
  return read_text(folder / "good.nrrd");
}

struct Broken {
  const char* from;  // a part of the good header
  const char* to;
  ImportError code;
  const char* where;
};

using enum ImportError;
const Broken kBroken[] = {
    {"NRRD0005", "NRRX0005", unknown_format, "v.nrrd"},
    {"NRRD0005", "NRRD0009", unsupported, "v.nrrd:1"},
    {"NRRD0005\n", "NRRD0005 \n", unknown_format, "v.nrrd:1"},
    {"type: uint16", "type: float", unsupported, "v.nrrd:3 type"},
    {"type: uint16\n", "", bad_header, "v.nrrd type"},
    {"type: uint16", "type uint16", bad_header, "v.nrrd:3"},
    {"type: uint16", "type: uint16\ntype: uint16", bad_header, "v.nrrd:3 type"},
    {"type: uint16", "colour: red", bad_header, "v.nrrd:3 colour"},
    {"dimension: 4", "dimension: 5", bad_sizes, "v.nrrd:4 dimension"},
    {"dimension: 4", "dimension: 3", bad_sizes, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 3 3", bad_sizes, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 3 0 3", bad_sizes, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 3 -3 3", bad_sizes, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 3 3.5 3", bad_sizes, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 3 3 3 3", unsupported, "v.nrrd:6 sizes"},  // colours
    {"sizes: 2 3 3 3", "sizes: 2 3 3 99999", too_large, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 2000 2000 2000", too_large, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 3 3 99999999999999999999999", too_large, "v.nrrd:6 sizes"},
    {"sizes: 2 3 3 3", "sizes: 2 4294967297 4294967297 4294967297", too_large, "v.nrrd:6 sizes"},
    {"space: right-anterior-superior", "space: left-right", bad_orientation, "v.nrrd:5 space"},
    {"(0.1,0,0) (0,0.1,0)", "(0.1,0.01,0) (0,0.1,0)", bad_orientation, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(0.1,0,0) (0.1,0,0)", bad_orientation, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(0.1,0,0) (0,0.2,0)", bad_spacing, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(nan,0,0) (0,0.1,0)", bad_spacing, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(0,0,0) (0,0.1,0)", bad_spacing, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(inf,0,0) (0,0.1,0)", bad_spacing, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(0.1,0) (0,0.1,0)", bad_header, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(0.1,0,0", bad_header, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "(0.1,0,0)", bad_header, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0) (0,0,0.1)", "(0.1,0,0)", bad_header, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0)", "none (0,0.1,0)", bad_header, "v.nrrd:7 space directions"},
    {"(0.1,0,0) (0,0.1,0) (0,0,0.1)", "(9,0,0) (0,9,0) (0,0,9)", bad_spacing, "v.nrrd:7 space directions"},
    {"space directions: none (0.1,0,0) (0,0.1,0) (0,0,0.1)", "spacings: nan 0.1 nan 0.1", bad_spacing,
       "v.nrrd:7 spacings"},
    {"space directions: none (0.1,0,0) (0,0.1,0) (0,0,0.1)\n", "", bad_spacing, "v.nrrd spacings"},
    {"endian: little", "endian: middle", bad_header, "v.nrrd:10 endian"},
    {"endian: little\n", "", bad_header, "v.nrrd endian"},
    {"encoding: gzip", "encoding: bzip2", unsupported, "v.nrrd:11 encoding"},
    {"encoding: gzip", "encoding: raw", corrupt, "v.nrrd (0,0,0)"},
    {"encoding: gzip\n", "", bad_header, "v.nrrd encoding"},
    {"encoding: gzip", "encoding: gzip\ndata file: ../../secret", unsupported, "v.nrrd:12 data file"},
    {"encoding: gzip", "encoding: gzip\nbyte skip: 12", unsupported, "v.nrrd:12 byte skip"},
    {"space origin: (0,0,0)", "space origin: (0,nan,0)", bad_header, "v.nrrd:12 space origin"},
    {"\"mm\" \"mm\" \"mm\"", "\"um\" \"um\" \"um\"", bad_spacing, "v.nrrd:13 space units"},
    {"tissue 1:=enamel", "tissue 1:=dentine", bad_tissue, "v.nrrd:14"},
    {"tissue 1:=enamel", "tissue 99:=enamel", bad_tissue, "v.nrrd:14"},
    {"tissue 1:=enamel", "tissue 20:=enamel", bad_tissue, "v.nrrd:15"},
};

TEST(NrrdRefusals, EachBrokenHeaderHasItsCodeAndPlace) {
  const TempFolder folder;
  const std::string good = good_file(folder);
  ASSERT_TRUE(read_nrrd(folder / "good.nrrd"));
  for (const Broken& c : kBroken) {
    SCOPED_TRACE(std::string(c.from) + " -> " + c.to);
    std::string text = good;
    const auto at = text.find(c.from);
    ASSERT_NE(at, text.npos);
    text.replace(at, std::string(c.from).size(), c.to);
    write_text(folder / "v.nrrd", text);
    const auto r = read_nrrd(folder / "v.nrrd");
    ASSERT_FALSE(r);
    if (c.code == corrupt) continue;  // packed bytes read raw: some voxel is wrong, whichever
    EXPECT_EQ(key_of(r.error().code), key_of(c.code));
    EXPECT_EQ(r.error().where, c.where);
  }
}

TEST(NrrdRefusals, ASpecimenThatIsOpenedAsAnImageIsRefusedWhereItIsWrong) {
  const TempFolder folder;
  const std::string good = good_file(folder);
  const auto refused = [&](const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string text = good;
    for (const auto& [from, to] : changes) text.replace(text.find(from), from.size(), to);
    write_text(folder / "v.nrrd", text);
    EXPECT_FALSE(nrrd_is_specimen(folder / "v.nrrd"));
    const auto r = read_nrrd_image(folder / "v.nrrd");
    return r ? std::string("read") : std::string(key_of(r.error().code)) + " " + r.error().where;
  };
  const std::pair<std::string, std::string> uneven{"(0,0.1,0)", "(0,0.2,0)"};
  EXPECT_EQ(refused({uneven}), "bad_spacing v.nrrd:7 space directions");
  EXPECT_EQ(refused({{"(0.1,0,0)", "(0.1,0.01,0)"}}), "bad_orientation v.nrrd:7 space directions");
  EXPECT_EQ(refused({{"\"mm\" \"mm\" \"mm\"", "\"um\" \"um\" \"um\""}}), "bad_spacing v.nrrd:13 space units");
  const std::vector<std::pair<std::string, std::string>> unnamed{uneven, {"tissue 1:=enamel\n", ""}, {"tissue 20:=stone\n", ""}};
  EXPECT_EQ(refused(unnamed), "unsupported v.nrrd sizes") << "of another program";
}

TEST(NrrdRefusals, AMissingFileAFolderAndAnEmptyFileAreReported) {
  const TempFolder folder;
  EXPECT_EQ(read_nrrd(folder / "none.nrrd").error().code, ImportError::missing_file);
  EXPECT_EQ(read_nrrd(folder.path()).error().code, ImportError::io);
  write_text(folder / "empty.nrrd", "");
  EXPECT_EQ(read_nrrd(folder / "empty.nrrd").error().code, ImportError::unknown_format);
}

TEST(NrrdRefusals, AFileCutAnywhereIsRefused) {
  const TempFolder folder;
  const std::string good = good_file(folder);
  for (std::size_t n = 0; n < good.size(); n += 3) {
    write_text(folder / "v.nrrd", good.substr(0, n));
    ASSERT_FALSE(read_nrrd(folder / "v.nrrd")) << n << " of " << good.size();
  }
}

TEST(NrrdRefusals, AByteChangedInTheDataIsFoundByTheirCheckSum) {
  const TempFolder folder;
  const std::string good = good_file(folder);
  // The first ten bytes of gzip hold its date and its system, which do not depend on the data.
  const std::size_t first = good.find("\n\n") + 2 + 10;
  const auto intact = read_nrrd(folder / "good.nrrd");
  ASSERT_TRUE(intact);
  std::size_t unseen = 0;
  for (std::size_t i = first; i < good.size(); ++i) {
    std::string text = good;
    text[i] = static_cast<char>(text[i] ^ 0x10);
    write_text(folder / "v.nrrd", text);
    const auto r = read_nrrd(folder / "v.nrrd");
    // The bits that fill up the last packed byte mean nothing: then it must be the same volume.
    unseen += r && !(r->s == intact->s && r->tissue == intact->tissue);
  }
  EXPECT_EQ(unseen, 0u);
}

TEST(NrrdRefusals, ASizeThatTheFileIsTooShortForTakesNoMemory) {
  const TempFolder folder;
  std::string text = good_file(folder);
  const std::string sizes = "sizes: 2 3 3 3";
  text.replace(text.find(sizes), sizes.size(), "sizes: 2 512 512 512");  // within the limits, 400 MB
  write_text(folder / "v.nrrd", text);
  EXPECT_EQ(key_of(read_nrrd(folder / "v.nrrd").error().code), "truncated");
}

TEST(NrrdRefusals, MoreDataThanTheHeaderStatesIsRefusedWithoutMemoryForIt) {
  const TempFolder folder;
  ASSERT_TRUE(write_nrrd(dexterity_block(0.5), folder / "big.nrrd"));
  std::string text = read_text(folder / "big.nrrd");
  const std::string sizes = "sizes: 2 48 48 28";
  const auto at = text.find(sizes);
  ASSERT_NE(at, text.npos);
  text.replace(at, sizes.size(), "sizes: 2 48 48 14");
  write_text(folder / "v.nrrd", text);
  const auto r = read_nrrd(folder / "v.nrrd");
  ASSERT_FALSE(r);
  EXPECT_EQ(key_of(r.error().code), "corrupt");
}

TEST(NrrdRefusals, TheCallersLimitsHold) {
  const TempFolder folder;
  good_file(folder);
  VolumeLimits limits;
  limits.max_voxels = 26;  // the file has 27
  EXPECT_EQ(read_nrrd(folder / "good.nrrd", limits).error().code, ImportError::too_large);
  limits = {};
  limits.max_edge_voxels = 2;
  EXPECT_EQ(read_nrrd(folder / "good.nrrd", limits).error().code, ImportError::too_large);
  limits = {};
  limits.min_voxel_mm = 0.11;
  EXPECT_EQ(read_nrrd(folder / "good.nrrd", limits).error().code, ImportError::bad_spacing);
}

TEST(NrrdRefusals, CodesOfNoTissueAndNegativeOnesAreRefusedWithTheirVoxel) {
  const TempFolder folder;
  for (const auto& [type, value] : {std::pair<std::string, char>{"uint8", 32}, {"uint8", 13}, {"uint8", 15}, {"int8", -1}}) {
    std::string data(27, '\1');
    data[1 + 3 * 2] = value;
    write_text(folder / "v.nrrd",
               "NRRD0005\ntype: " + type + "\ndimension: 3\nsizes: 3 3 3\nspacings: 1 1 1\nencoding: raw\n\n" + data);
    const auto r = read_nrrd(folder / "v.nrrd");
    ASSERT_FALSE(r);
    EXPECT_EQ(key_of(r.error().code), "bad_tissue");
    EXPECT_EQ(r.error().where, "v.nrrd (1,2,0)");
  }
}

TEST(NrrdRefusals, ACodeOfNoTissueIsNotWritten) {
  const TempFolder folder;
  VoxelVolume volume(Grid{{1, 1, 1}, 0.1, Vec3(0.0)});
  volume.tissue[0] = static_cast<Tissue>(13);
  volume.s[0] = kSolid;
  const auto r = write_nrrd(volume, folder / "v.nrrd");
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, ImportError::bad_tissue);
}

TEST(NrrdRefusals, AnEmptyLabelMapIsRefused) {
  const TempFolder folder;
  write_text(folder / "v.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 3 3 3\nspacings: 1 1 1\nencoding: raw\n\n" +
                                    std::string(27, '\0'));
  EXPECT_EQ(read_nrrd(folder / "v.nrrd").error().code, ImportError::nothing_solid);
}

TEST(NrrdRefusals, NamesThatWouldBreakTheHeaderAreNotWritten) {
  const TempFolder folder;
  VoxelVolume volume(Grid{{1, 1, 1}, 0.1, Vec3(0.0)});
  volume.tissue[0] = Tissue::bone;
  volume.s[0] = kSolid;
  for (const auto& [code, name] : {std::pair<std::uint8_t, std::string>{16, "a\n\nb"}, {16, "a\rb"}, {3, "x"}, {32, "x"}}) {
    volume.names = {{code, name}};
    const auto r = write_nrrd(volume, folder / "v.nrrd");
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().code, ImportError::bad_tissue);
    EXPECT_FALSE(std::filesystem::exists(folder / "v.nrrd"));
  }
}

TEST(NrrdRefusals, RandomDamageIsRefusedOrReadButNeverMore) {
  const TempFolder folder;
  const std::string good = good_file(folder);
  std::mt19937 random(20240611);
  std::size_t refused = 0;
  for (int round = 0; round < 500; ++round) {
    std::string text = good;
    for (unsigned n = 1 + random() % 4; n > 0; --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0: text[at] = static_cast<char>(random()); break;
        case 1: text.erase(at, 1 + random() % 8); break;
        case 2: text.insert(at, text.substr(random() % text.size(), random() % 12)); break;
        default: text[at] = "0123456789().,- \n:="[random() % 19]; break;
      }
      if (text.empty()) text = " ";
    }
    write_text(folder / "v.nrrd", text);
    const auto r = read_nrrd(folder / "v.nrrd");
    if (!r) ++refused;
    else ASSERT_EQ(r->s.size(), r->grid.voxels());
  }
  EXPECT_GT(refused, 150u);
}

}  // namespace
}  // namespace cusp::test
