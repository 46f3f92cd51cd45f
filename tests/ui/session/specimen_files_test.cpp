#include "ui/session/specimen_files.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"
#include "tests/storage/sample.h"
#include "ui/session/scenery_blob.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

Scenario coarse_tooth(int fdi = 36) {
  Scenario out;
  out.specimen.generator = "tooth";
  out.specimen.fdi = fdi;
  out.specimen.voxel_mm = 0.4;  // grown in some 0.3 s
  return out;
}

/// What came of asking: whether it was grown, and the voxels.
struct Got {
  std::shared_ptr<const Specimen> specimen;
  bool grown = false;
};
Got ask(const SpecimenFiles& files, const Scenario& scenario) {
  Got out;
  out.specimen = *files.specimen(scenario, {}, nullptr, [&out](double) { out.grown = true; });
  return out;
}

class SpecimenFilesTest : public testing::Test {
 protected:
  std::vector<fs::path> kept() const {
    std::vector<fs::path> out;
    if (fs::exists(place)) for (const auto& one : fs::directory_iterator(place)) out.push_back(one.path());
    return out;
  }
  Folder folder;
  fs::path place = folder / "grown";
  SpecimenFiles files{place};
};

TEST_F(SpecimenFilesTest, ReadsTheSecondTimeWhatItGrewTheFirstBitForBit) {
  const Got first = ask(files, coarse_tooth());
  EXPECT_TRUE(first.grown);
  const Got second = ask(files, coarse_tooth());
  EXPECT_FALSE(second.grown);
  const auto generated = Specimen::build(make_specimen(coarse_tooth().specimen, {}).value(), reading_of(coarse_tooth().method));
  EXPECT_EQ(second.specimen->hash(), generated->hash());
  EXPECT_EQ(second.specimen->dense().s, generated->dense().s);
  EXPECT_EQ(second.specimen->dense().tissue, generated->dense().tissue);
  EXPECT_EQ(second.specimen->names(), generated->names());
}

TEST_F(SpecimenFilesTest, GrowsAnewWhatAnyFieldOfTheSourceChanges) {
  ask(files, coarse_tooth());
  Scenario other = coarse_tooth();
  other.specimen.seed = 1;
  EXPECT_TRUE(ask(files, other).grown);
  other = coarse_tooth();
  other.specimen.typodont = true;
  EXPECT_TRUE(ask(files, other).grown);
  other = coarse_tooth();
  other.specimen.lesions.push_back({});
  EXPECT_TRUE(ask(files, other).grown);
  other = coarse_tooth();
  other.specimen.voxel_mm = 0.39;
  EXPECT_TRUE(ask(files, other).grown);
  EXPECT_FALSE(ask(files, coarse_tooth()).grown);
}

TEST_F(SpecimenFilesTest, ReplacesADamagedFileWhereverTheDamageLies) {
  const std::uint64_t hash = ask(files, coarse_tooth()).specimen->hash();
  ASSERT_EQ(kept().size(), 1u);
  const fs::path file = kept().front();
  const auto size = static_cast<std::streamoff>(fs::file_size(file));
  for (const std::streamoff at : {std::streamoff{0}, std::streamoff{40}, size / 2, size - 1}) {
    std::fstream damaged(file, std::ios::in | std::ios::out | std::ios::binary);
    damaged.seekg(at);
    const int byte = damaged.get();
    damaged.seekp(at);
    damaged.put(static_cast<char>(byte ^ 1));
    damaged.close();
    const Got got = ask(files, coarse_tooth());
    EXPECT_TRUE(got.grown) << "byte " << at;
    EXPECT_EQ(got.specimen->hash(), hash);
    EXPECT_FALSE(ask(files, coarse_tooth()).grown) << "the file is whole again";
  }
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_TRUE(ask(files, coarse_tooth()).grown);
  fs::resize_file(file, 0);
  EXPECT_TRUE(ask(files, coarse_tooth()).grown);
}

TEST_F(SpecimenFilesTest, TrustsNoFileThatBearsTheNameOfAnother) {
  ask(files, coarse_tooth(36));
  const fs::path molar = kept().front();
  ask(files, coarse_tooth(14));
  const auto all = kept();
  const fs::path premolar = all[0] == molar ? all[1] : all[0];
  fs::copy_file(molar, premolar, fs::copy_options::overwrite_existing);
  EXPECT_TRUE(ask(files, coarse_tooth(14)).grown);
}

TEST_F(SpecimenFilesTest, RemovesTheLeastRecentlyUsedFilesAboveTheBound) {
  ask(files, coarse_tooth(36));
  const std::uint64_t one = fs::file_size(kept().front());
  const SpecimenFiles bounded(place, 2 * one + one / 2);
  ask(bounded, coarse_tooth(37));
  for (const fs::path& file : kept()) fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_FALSE(ask(bounded, coarse_tooth(36)).grown) << "and it is the newest by that";
  ask(bounded, coarse_tooth(46));
  EXPECT_FALSE(ask(bounded, coarse_tooth(36)).grown);
  EXPECT_TRUE(ask(bounded, coarse_tooth(37)).grown);
}

TEST_F(SpecimenFilesTest, GrowsWithoutAFolderThatCanBeWritten) {
  std::ofstream(folder / "file") << "no folder";
  const SpecimenFiles nowhere(folder / "file" / "grown");
  EXPECT_TRUE(ask(nowhere, coarse_tooth()).grown);
  EXPECT_TRUE(ask(nowhere, coarse_tooth()).grown);
  const SpecimenFiles nothing(fs::path{});
  EXPECT_TRUE(ask(nothing, coarse_tooth()).grown);
}

TEST_F(SpecimenFilesTest, TwoProcessesThatGrowTheSameToothKeepOneWholeFile) {
  const auto grows_it = [&] { return ask(SpecimenFiles(place), coarse_tooth()).specimen->hash(); };
  const pid_t other = fork();
  if (other == 0) _exit(grows_it() != 0 ? 0 : 1);
  const std::uint64_t own = grows_it();
  int status = 0;
  ASSERT_EQ(waitpid(other, &status, 0), other);
  EXPECT_EQ(status, 0);
  ASSERT_EQ(kept().size(), 1u);
  const Got read = ask(files, coarse_tooth());
  EXPECT_FALSE(read.grown);
  EXPECT_EQ(read.specimen->hash(), own);
}

TEST_F(SpecimenFilesTest, KeepsNothingOfAToothThatWasCancelled) {
  const std::atomic<bool> stop{true};
  const auto none = files.specimen(coarse_tooth(), {}, &stop);
  ASSERT_FALSE(none);
  EXPECT_EQ(std::get<ImportError>(none.error().cause), ImportError::cancelled);
  EXPECT_TRUE(kept().empty());
}

TEST_F(SpecimenFilesTest, KeepsNoBlock) {
  Scenario block = coarse_tooth();
  block.specimen.generator = "block";
  ASSERT_TRUE(files.specimen(block, {}));
  EXPECT_TRUE(kept().empty());
}

TEST(SceneryBlob, ReadsBackWhatItWroteAndRefusesAnythingElse) {
  JawSurface one;
  one.fdi = 34;
  one.mesh.points_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}};
  one.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  one.mesh.tissue = {Tissue::enamel, Tissue::dentine, Tissue::enamel};
  one.mesh.ambient = {1, 2, 255};
  one.mesh.triangles = {0, 1, 2, 2, 1, 0};
  one.mesh.seen = 3;
  one.mesh.within = Tissue::gingiva;
  const auto bytes = scenery_bytes({one, one});
  const auto back = scenery_from_bytes(bytes);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), 2u);
  EXPECT_EQ(back->back().fdi, 34);
  EXPECT_EQ(back->back().mesh.points_mm, one.mesh.points_mm);
  EXPECT_EQ(back->back().mesh.normals, one.mesh.normals);
  EXPECT_EQ(back->back().mesh.tissue, one.mesh.tissue);
  EXPECT_EQ(back->back().mesh.ambient, one.mesh.ambient);
  EXPECT_EQ(back->back().mesh.triangles, one.mesh.triangles);
  EXPECT_EQ(back->back().mesh.seen, 3u);
  EXPECT_EQ(back->back().mesh.within, Tissue::gingiva);
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_FALSE(scenery_from_bytes(std::span(bytes).first(n))) << n << " bytes of it";
  one.mesh.triangles[1] = 3;
  EXPECT_FALSE(scenery_from_bytes(scenery_bytes({one}))) << "no fourth point";
}

}  // namespace
}  // namespace cusp::test
