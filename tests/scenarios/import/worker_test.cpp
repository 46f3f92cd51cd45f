// The children here are this test program itself, whose first argument names the misbehaviour.
#include "scenarios/import/worker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <thread>

#include "scenarios/import/child_process.h"
#include "scenarios/import/limit_figures.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {


WorkerSettings bad_child(const std::string& way) {
  WorkerSettings settings;
  settings.program = {own_program(), way};
  return settings;
}

std::string outcome(const Result<VoxelVolume, ImportFailure>& r) {
  return r ? "read" : std::string(key_of(r.error().code));
}

class ImportWorker : public ::testing::Test {
 protected:
  ImportWorker() {
    write_obj(folder / "m.obj", {sphere("tab\tand = x", {0, 0, 0}, 1.0, 3), sphere("inner", {0, 0, 0}, 0.5, 3)});
    what.path = folder / "m.obj";
    const auto list = list_meshes(what.path);
    EXPECT_TRUE(list) << key_of(list.error().code) << list.error().detail;
    what.tissues = {{list->at(0).name, Tissue::dentine}, {list->at(1).name, Tissue::pulp}};
  }
  TempFolder folder;
  MeshImport what;
};

TEST_F(ImportWorker, AChildGivesTheSameVolumeAsACall) {
  std::vector<double> shares;
  const auto there = import_mesh_in_child(what, {}, [&](double s) { shares.push_back(s); });
  const auto here = import_mesh(what);
  ASSERT_TRUE(here);
  ASSERT_TRUE(there) << key_of(there.error().code) << " " << there.error().where << " " << there.error().detail;
  EXPECT_EQ(here->grid, there->grid);
  EXPECT_TRUE(here->s == there->s && here->tissue == there->tissue);
  ASSERT_GE(shares.size(), 30u);  // a hundredth apart, most of them within the two meshes
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}

TEST_F(ImportWorker, AChildListsTheSameMeshesAsACall) {
  const auto here = list_meshes(what.path);
  const auto there = look_in_child({what.path});
  ASSERT_TRUE(here);
  ASSERT_TRUE(there) << key_of(there.error().code) << there.error().detail;
  EXPECT_EQ(*here, there->meshes);
}

TEST_F(ImportWorker, AFailureKeepsItsCodeAndPlaceOnTheWay) {
  what.tissues = {{"no\tsuch\nmesh", Tissue::bone}};
  const auto r = import_mesh_in_child(what);
  ASSERT_FALSE(r);
  EXPECT_EQ(key_of(r.error().code), "mesh_not_found");
  EXPECT_EQ(r.error().where, "no\tsuch\nmesh");
  EXPECT_EQ(look_in_child({folder / "none.obj"}).error().code, ImportError::missing_file);
}

TEST_F(ImportWorker, TheCallersLimitsReachTheChild) {
  what.limits.max_voxels = 1000;
  EXPECT_EQ(outcome(import_mesh_in_child(what)), "too_large");
}

TEST_F(ImportWorker, ACrashIsACode) {
  for (const char* way : {"child-segv", "child-abort", "child-throw"}) {
    SCOPED_TRACE(way);
    EXPECT_EQ(outcome(import_mesh_in_child(what, bad_child(way))), "crashed");
  }
}

TEST_F(ImportWorker, TheLastOutputOfACrashIsKeptForTheLog) {
  const auto r = import_mesh_in_child(what, bad_child("child-abort"));
  ASSERT_FALSE(r);
  EXPECT_NE(r.error().detail.find("something is wrong"), std::string::npos) << r.error().detail;
  EXPECT_LT(r.error().detail.size(), 3000u);
}

TEST_F(ImportWorker, AHangEndsAtTheWallLimit) {
  WorkerSettings settings = bad_child("child-sleep");
  settings.wall = std::chrono::milliseconds(200);
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "time_limit");
}

TEST_F(ImportWorker, AHangWithClosedStreamsEndsToo) {
  WorkerSettings settings = bad_child("child-silent");
  settings.wall = std::chrono::milliseconds(200);
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "time_limit");
}

TEST_F(ImportWorker, AnEndlessLoopEndsAtTheLimitOfItsProcessorTime) {
  WorkerSettings settings = bad_child("child-spin");
  settings.cpu = std::chrono::seconds(1);
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "time_limit");
}

TEST_F(ImportWorker, TheLimitThatEndedAChildIsNamedWithItsFigure) {
  const auto figures = [&](const WorkerSettings& settings) {
    const auto r = import_mesh_in_child(what, settings);
    return r ? std::nullopt : limit_figures(r.error().detail);
  };
  WorkerSettings settings = bad_child("child-sleep");
  settings.wall = std::chrono::milliseconds(200);
  EXPECT_EQ(figures(settings), (LimitFigures{LimitKind::wall, 0.0, 0.2, 0.0}));
  settings = bad_child("child-spin");
  settings.cpu = std::chrono::seconds(1);
  EXPECT_EQ(figures(settings), (LimitFigures{LimitKind::processor, 0.0, 1.0, 0.0}));
  if (!child_memory_limit_works()) return;
  settings = bad_child("child-eat");
  settings.memory_bytes = std::size_t{512} << 20;
  EXPECT_EQ(figures(settings), (LimitFigures{LimitKind::memory, 0.0, 536870912.0, 0.0}));
}

TEST_F(ImportWorker, RemarksComeThroughAsTheyWereMade) {
  std::vector<ImportRemark> here, there;
  ASSERT_TRUE(import_mesh(what, {}, &here));
  ASSERT_TRUE(import_mesh_in_child(what, {}, {}, {}, &there));
  EXPECT_EQ(here, there);
  ASSERT_EQ(here.size(), 4u);  // two places in the order, one inside the other, and a ball of 2 mm is no tooth
  EXPECT_EQ(here[2].code, RemarkCode::part_within);
  EXPECT_EQ(here[2].other, what.tissues[0].first);
  what.precedence = PartPrecedence::given;  // the outer one first: nothing is left of the inner one
  const auto volume = import_mesh_in_child(what, {}, {}, {}, &there);
  ASSERT_TRUE(volume);
  EXPECT_TRUE(std::ranges::none_of(volume->tissue, [](Tissue t) { return t == Tissue::pulp; }));
}

TEST_F(ImportWorker, ReportsWhatAChildUsed) {
  WorkerSettings settings = bad_child("child-spin");
  settings.cpu = std::chrono::seconds(1);
  std::vector<ChildEnd> ends;
  settings.ended = [&](const ChildEnd& end) { ends.push_back(end); };
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "time_limit");
  ASSERT_EQ(ends.size(), 1u);
  // The kernel ends it after one second of its own processor time by sampled ticks; the use reported is exact and differs
  // by some tenths on a loaded machine. One thread uses no more processor time than passes on the clock.
  EXPECT_GE(ends[0].cpu_s, 0.5);
  EXPECT_LE(ends[0].cpu_s, ends[0].wall_s + 0.02);
  EXPECT_GT(ends[0].resident_bytes, std::uint64_t{1} << 20);  // no C++ program fits into less
  EXPECT_LT(ends[0].resident_bytes, std::uint64_t{1} << 30);
}

TEST_F(ImportWorker, TooMuchMemoryIsACode) {
  if (!child_memory_limit_works()) GTEST_SKIP() << "a sanitizer needs the address space";
  WorkerSettings settings = bad_child("child-eat");
  settings.memory_bytes = std::size_t{512} << 20;
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "out_of_memory");
}

TEST_F(ImportWorker, ARealImportThatNeedsTooMuchIsACode) {
  if (!child_memory_limit_works()) GTEST_SKIP() << "a sanitizer needs the address space";
  what.voxel_mm = 0.005;  // 408^3 voxels, 340 MB
  WorkerSettings settings;
  settings.memory_bytes = std::size_t{400} << 20;
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "out_of_memory");
}

TEST_F(ImportWorker, CancelKillsTheChild) {
  std::stop_source stop;
  std::jthread asks([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  EXPECT_EQ(outcome(import_mesh_in_child(what, bad_child("child-sleep"), {}, stop.get_token())), "cancelled");
  // Asked for before the start.
  EXPECT_EQ(outcome(import_mesh_in_child(what, bad_child("child-sleep"), {}, stop.get_token())), "cancelled");
}

TEST_F(ImportWorker, NoiseOnTheOutputIsNoAnswer) {
  EXPECT_EQ(outcome(import_mesh_in_child(what, bad_child("child-chatter"))), "crashed");  // ends well, and left no file
}

TEST_F(ImportWorker, AProgramThatIsNotThereIsNotStarted) {
  WorkerSettings settings;
  settings.program = {"/no/such/program"};
  EXPECT_EQ(outcome(import_mesh_in_child(what, settings)), "not_started");
}

TEST_F(ImportWorker, NothingIsLeftInTheTemporaryFolder) {
  const auto ours = [] {
    std::size_t n = 0;
    for (const auto& f : std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
      n += f.path().filename().string().starts_with("cusp-import-");
    return n;
  };
  const TempFolder own;
  const std::string before = std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp";
  setenv("TMPDIR", own.path().c_str(), 1);
  (void)import_mesh_in_child(what);
  (void)import_mesh_in_child(what, bad_child("child-abort"));
  EXPECT_EQ(ours(), 0u);
  setenv("TMPDIR", before.c_str(), 1);
}

TEST_F(ImportWorker, RemovesWhatAKilledProgramLeftInTheTemporaryFolderADayAgo) {
  namespace fs = std::filesystem;
  const TempFolder own;
  const fs::path old = own.path() / "cusp-import-old", present = own.path() / "cusp-import-present", other = own.path() / "other";
  for (const fs::path& one : {old, present, other}) {
    fs::create_directory(one);
    std::ofstream(one / "volume.nrrd") << "voxels";
  }
  for (const fs::path& one : {old, other}) fs::last_write_time(one, fs::file_time_type::clock::now() - std::chrono::hours(25));
  const std::string before = std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp";
  setenv("TMPDIR", own.path().c_str(), 1);
  (void)import_mesh_in_child(what);
  setenv("TMPDIR", before.c_str(), 1);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(present / "volume.nrrd")) << "its program may still run";
  EXPECT_TRUE(fs::exists(other / "volume.nrrd"));
}

TEST_F(ImportWorker, AFolderForTemporaryFilesThatIsGoneIsNamedWithItsCause) {
  const std::string before = std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp";
  const std::string gone = (folder / "gone").string();
  setenv("TMPDIR", gone.c_str(), 1);
  const auto r = import_mesh_in_child(what);
  setenv("TMPDIR", before.c_str(), 1);
  ASSERT_FALSE(r);
  EXPECT_EQ(key_of(r.error().code), "io");
  EXPECT_EQ(r.error().detail.find("no temporary folder"), std::string::npos) << "no English of our own on a German screen";
}

TEST(ImportChildMain, APreviewThatCannotBeWrittenIsReportedWithItsCause) {
  const TempFolder folder;
  write_text(folder / "v.nrrd", "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspacings: 1 1 1\n\n" + std::string(8, '\1'));
  const std::string preview = (folder / "gone/preview").string(), file = (folder / "v.nrrd").string();
  const char* look[] = {"cusp", "import-child", "look", preview.c_str(), file.c_str()};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(import_child_main(5, look), 1);
  const std::string said = ::testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("io\tpreview\t" + std::generic_category().message(ENOENT)), std::string::npos) << said;
}

TEST(ImportChildMain, OtherVerbsAreNotIts) {
  const char* play[] = {"cusp", "play"};
  EXPECT_FALSE(import_child_main(2, play));
  EXPECT_FALSE(import_child_main(1, play));
  const char* wrong[] = {"cusp", "import-child", "mesh", "file"};
  EXPECT_EQ(import_child_main(4, wrong), 2);
}

int misbehave(const std::string& way) {
  if (way == "child-segv") std::raise(SIGSEGV);
  if (way == "child-abort") {
    for (int i = 0; i < 1000; ++i) std::fputs("talk before the fall\n", stderr);
    std::fputs("something is wrong\n", stderr);
    std::abort();
  }
  if (way == "child-throw") throw 1;
  if (way == "child-silent") {
    std::fclose(stdin);
    std::fclose(stdout);
    std::fclose(stderr);
  }
  if (way == "child-sleep" || way == "child-silent") std::this_thread::sleep_for(std::chrono::hours(1));
  if (way == "child-spin")
    for (volatile unsigned i = 0;;) i = i + 1;
  if (way == "child-chatter") {
    std::printf("cusp-importer says hello\nprogress\t1\n%s\n", std::string(100000, 'x').c_str());
    return 0;
  }
  return 9;
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  if (const auto status = cusp::scenarios::import_child_main(argc, argv)) return *status;
  if (argc > 1 && std::strcmp(argv[1], "child-eat") == 0) {
    // What a reader that asks for more and more does, within the verb that must answer for it.
    const char* verb[] = {argv[0], "import-child", "mesh"};
    std::vector<std::vector<char>> kept;
    try {
      for (;;) kept.emplace_back(std::size_t{16} << 20, '\1');
    } catch (const std::bad_alloc&) {
      kept.clear();
      std::printf("cusp-import\tfail\tout_of_memory\t\t\n");
      return 1;
    }
    return *cusp::scenarios::import_child_main(3, verb);
  }
  if (argc > 1 && std::strncmp(argv[1], "child-", 6) == 0) return cusp::test::misbehave(argv[1]);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
