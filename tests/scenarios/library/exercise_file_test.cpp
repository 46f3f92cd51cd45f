// An exercise as one file: what was written comes back, and anything else is refused by its code.

#include "scenarios/library/exercise_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <thread>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "scenarios/library/tar.h"
#include "tests/modules.h"
#include "tests/random.h"
#include "tests/refused_calls.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {

constexpr std::size_t kBlock = 512;  // of a tar archive

/// channel-1 on a block of 0.4 mm voxels, from a volume file.
ExerciseFile on_a_volume(const VoxelVolume& block = dexterity_block(0.4)) {
  const TempFolder folder;
  ExerciseFile file{*load_builtin("channel-1"), {}};
  file.scenario.specimen = {};
  file.scenario.specimen.volume = "block.nrrd";
  file.scenario.specimen.voxel_mm = 0.4;
  EXPECT_TRUE(write_nrrd(block, folder / "block.nrrd"));
  const std::string bytes = read_text(folder / "block.nrrd");
  file.volume.resize(bytes.size());
  std::ranges::transform(bytes, file.volume.begin(), [](char c) { return static_cast<std::byte>(c); });
  return file;
}

/// Entries of a good file, changed, as an archive again.
std::string rearranged(const std::string& good, const std::function<void(std::vector<TarEntry>&)>& change) {
  std::vector<TarEntry> entries = *read_tar(good, 3);
  change(entries);
  return write_tar(entries);
}

/// Code of the refusal: a key of FormatError, a finding's code, or "volume".
std::string code_of(const std::string& bytes) {
  const auto file = parse_exercise_file(bytes);
  if (file) return "accepted";
  if (const auto* format = std::get_if<FormatFailure>(&file.error())) return std::string(key_of(format->code));
  if (const auto* finding = std::get_if<Finding>(&file.error())) return finding->code;
  return "volume";
}

/// With the sum of its first header set anew.
std::string with_header(std::string bytes, std::size_t at, std::string_view text) {
  bytes.replace(at, text.size(), text);
  std::fill_n(bytes.begin() + 148, 8, ' ');
  unsigned sum = 0;
  for (std::size_t i = 0; i < kBlock; ++i) sum += static_cast<unsigned char>(bytes[i]);
  char digits[8];
  std::snprintf(digits, sizeof digits, "%06o", sum);
  bytes.replace(148, 7, std::string_view(digits, 7));
  return bytes;
}

class ExerciseFiles : public testing::Test {
 protected:
  const std::string plain = *exercise_file_bytes({*load_builtin("class-1-36"), {}});
  const ExerciseFile volume = on_a_volume();
  const std::string packed = *exercise_file_bytes(volume);
};

TEST_F(ExerciseFiles, GiveBackEveryExerciseOfTheProgram) {
  for (const std::string_view key : builtin_scenarios()) {
    const Scenario scenario = *load_builtin(key);
    const auto bytes = exercise_file_bytes({scenario, {}});
    ASSERT_TRUE(bytes) << key;
    const auto back = parse_exercise_file(*bytes);
    ASSERT_TRUE(back) << key << ": " << code_of(*bytes);
    EXPECT_EQ(back->scenario, scenario) << key;
    EXPECT_TRUE(back->volume.empty());
    EXPECT_EQ(*exercise_file_bytes(*back), *bytes) << key;
  }
}

TEST_F(ExerciseFiles, CarryTheVolumeThatTheExerciseNames) {
  const auto back = parse_exercise_file(packed);
  ASSERT_TRUE(back) << code_of(packed);
  EXPECT_EQ(back->scenario, volume.scenario);
  EXPECT_EQ(back->volume, volume.volume);
  const auto voxels = voxels_of(*back);
  ASSERT_TRUE(voxels);
  EXPECT_EQ(voxels->s, dexterity_block(0.4).s);
}

TEST_F(ExerciseFiles, AreReadFromADiskAndNameTheFileInAFailure) {
  const TempFolder folder;
  const auto path = folder / "mine.cusp";
  ASSERT_TRUE(write_exercise_file(volume, path));
  EXPECT_EQ(read_exercise_file(path)->scenario, volume.scenario);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
  const auto missing = read_exercise_file(folder / "none.cusp");
  EXPECT_EQ(std::get<FormatFailure>(missing.error()).code, FormatError::unreadable);
  write_text(path, packed.substr(0, 5000));
  const FormatFailure cut = std::get<FormatFailure>(read_exercise_file(path).error());
  EXPECT_EQ(cut.code, FormatError::truncated);
  EXPECT_TRUE(cut.where.starts_with("mine.cusp#")) << cut.where;
  const auto nowhere = write_exercise_file(volume, folder / "no/such/x.cusp");
  EXPECT_EQ(std::get<FormatFailure>(nowhere.error()).code, FormatError::unwritable);
  // A file that states 600 MB on the disk and holds nothing is refused by its length.
  std::filesystem::resize_file(path, std::uintmax_t{600} << 20);
  EXPECT_EQ(std::get<FormatFailure>(read_exercise_file(path).error()).code, FormatError::too_large);
}

TEST_F(ExerciseFiles, AreWrittenBesideWhatBearsTheNameOfAPart) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "a.cusp.part");
  EXPECT_TRUE(write_exercise_file({*load_builtin("channel-1"), {}}, folder / "a.cusp"));
  EXPECT_TRUE(read_exercise_file(folder / "a.cusp"));
}

TEST_F(ExerciseFiles, TakeNoNameUntilTheDiskHoldsThem) {
  const TempFolder folder;
  write_text(folder / "a.cusp", "old");
  bool refused = false;
  std::string reason;
  std::thread([&] {
    refused = refuse_calls({{SYS_fsync, EIO}});
    if (const auto written = write_exercise_file(volume, folder / "a.cusp"); !written) reason = std::get<FormatFailure>(written.error()).detail;
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  EXPECT_EQ(reason, std::strerror(EIO));
  EXPECT_EQ(read_text(folder / "a.cusp"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "a part is left";
}

TEST_F(ExerciseFiles, AreNamedInLettersOfEitherCase) {
  for (const char* name : {"molar.cusp", "/media/stick/MOLAR.CUSP", "molar.Cusp"}) EXPECT_TRUE(names_exercise_file(name)) << name;
  for (const char* name : {"cusp", "molar.cusp.txt", "molar.cusppack", ""}) EXPECT_FALSE(names_exercise_file(name)) << name;
}

TEST_F(ExerciseFiles, OfAnotherKindAreRefused) {
  EXPECT_EQ(code_of(""), "foreign_file");
  EXPECT_EQ(code_of("PK\x03\x04"), "foreign_file");
  EXPECT_EQ(code_of(std::string(4096, '\0')), "foreign_file");
  EXPECT_EQ(code_of(std::string(4096, 'x')), "foreign_file");
  EXPECT_EQ(code_of(canonical_json(volume.scenario)), "foreign_file");
  EXPECT_EQ(code_of(write_tar({{"notes.txt", "format 1\n"}})), "foreign_file");
  const auto marked = [&](std::string_view text) { return rearranged(plain, [&](auto& e) { e[0].data = text; }); };
  EXPECT_EQ(code_of(marked("something")), "foreign_file");
  EXPECT_EQ(code_of(marked("format 2\n")), "newer_format");
  EXPECT_EQ(code_of(marked("format 1\ncontent 00\n")), "damaged");
}

TEST_F(ExerciseFiles, ThatBreakOffAreRefusedWhereverTheyDo) {
  for (const std::string* whole : {&plain, &packed})
    for (std::size_t length = 0; length < whole->size(); length += length < 4096 ? 37 : 1009) {
      const std::string code = code_of(whole->substr(0, length));
      EXPECT_TRUE(code == "truncated" || (length < kBlock && code == "foreign_file")) << length << ": " << code;
    }
}

TEST_F(ExerciseFiles, WithAChangedByteAreRefusedOrHoldTheSame) {
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    std::string bytes = packed;
    const std::size_t at = random.bits() % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.bits() % 8));
    // What fills up a block belongs to no file: the only place where a change changes nothing.
    if (const auto file = parse_exercise_file(bytes)) {
      EXPECT_EQ(file->scenario, volume.scenario) << at;
      EXPECT_EQ(file->volume, volume.volume) << at;
    }
  }
}

TEST_F(ExerciseFiles, HoldNoOtherFilesThanTheExerciseNames) {
  using Entries = std::vector<TarEntry>;
  EXPECT_EQ(code_of(rearranged(plain, [](Entries& e) { e.push_back({"extra.nrrd", "x"}); })), "unnamed_file");
  EXPECT_EQ(code_of(rearranged(packed, [](Entries& e) { e[2].name = "other.nrrd"; })), "unnamed_file");
  EXPECT_EQ(code_of(rearranged(packed, [](Entries& e) { e.push_back({"fourth", "x"}); })), "unnamed_file");
  EXPECT_EQ(code_of(rearranged(packed, [](Entries& e) { e.pop_back(); })), "missing_file");
  EXPECT_EQ(code_of(rearranged(plain, [](Entries& e) { e.pop_back(); })), "missing_file");
  EXPECT_EQ(code_of(rearranged(plain, [](Entries& e) { e.push_back(e[1]); })), "duplicate_value");
  EXPECT_EQ(code_of(rearranged(packed, [](Entries& e) { e[2].data = "NRRD0005"; })), "damaged");
}

TEST_F(ExerciseFiles, WithNamesThatLeadAwayAreRefused) {
  for (const char* name : {"../scenario.json", "/etc/passwd", "a/b", "..", "C:\\x", ".hidden", "a\nb"})
    EXPECT_EQ(code_of(rearranged(packed, [&](std::vector<TarEntry>& e) { e[2].name = name; })), "bad_file_name") << name;
  EXPECT_EQ(code_of(with_header(plain, 345, "/etc")), "bad_file_name") << "a folder in the header's prefix";
  for (const char* type : {"1", "2", "5", "L", "x"}) EXPECT_EQ(code_of(with_header(plain, 156, type)), "unnamed_file") << type;
  Scenario away = volume.scenario;
  away.specimen.volume = "../../away.nrrd";
  const std::string json = canonical_json(away);
  EXPECT_EQ(code_of(rearranged(packed, [&](std::vector<TarEntry>& e) { e[1].data = json; })), "bad_file_name");
}

TEST_F(ExerciseFiles, ThatStateMoreThanTheyHoldTakeNoMemory) {
  EXPECT_EQ(code_of(with_header(plain, 124, "77777777777")), "truncated");
  EXPECT_EQ(code_of(with_header(plain, 124, "999")), "damaged");
  const std::string large(kMaxExerciseFileBytes / 400, ' ');  // beyond a page or two of text
  EXPECT_EQ(code_of(rearranged(plain, [&](std::vector<TarEntry>& e) { e[1].data = large; })), "too_large");
}

TEST_F(ExerciseFiles, WithAnExerciseThatTheChecksRefuseAreWrittenAsItStandsAndNotRead) {
  EXPECT_TRUE(check_exercise_file(volume));
  ExerciseFile ungraded = volume;
  ungraded.scenario.rubric.criteria.clear();
  const auto refused = check_exercise_file(ungraded);
  ASSERT_FALSE(refused);
  EXPECT_EQ(std::get<Finding>(refused.error()).code, "no_criteria");
  const auto bytes = exercise_file_bytes(ungraded);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(read_tar(*bytes, 3)->at(1).data, canonical_json(ungraded.scenario));
  EXPECT_EQ(code_of(*bytes), "no_criteria");
  ExerciseFile outside = volume;
  outside.scenario.target.outline.top_mm = 5;
  EXPECT_EQ(std::get<Finding>(check_exercise_file(outside).error()).code, "target_outside") << "as its volume shows";
  ExerciseFile broken = volume;
  broken.volume.resize(200);
  EXPECT_TRUE(std::holds_alternative<ImportFailure>(check_exercise_file(broken).error()));
  EXPECT_EQ(code_of(*exercise_file_bytes(broken)), "volume");
}

TEST_F(ExerciseFiles, WithATissueThatHasAGrownToothsCodeAreRefusedAsAnImportIs) {
  VoxelVolume block = dexterity_block(0.4);
  std::ranges::replace(block.tissue, Tissue::plastic, Tissue{31});
  block.names[31] = "pulp stone";
  const auto bytes = exercise_file_bytes(on_a_volume(block));
  ASSERT_TRUE(bytes);
  const auto refused = parse_exercise_file(*bytes);
  ASSERT_FALSE(refused);
  const auto* of_volume = std::get_if<ImportFailure>(&refused.error());
  ASSERT_NE(of_volume, nullptr) << code_of(*bytes);
  EXPECT_EQ(key_of(of_volume->code), "code_taken");
  EXPECT_EQ(of_volume->where, "block.nrrd");
  EXPECT_EQ(of_volume->detail, "pulp stone");
  block.names[31] = "firm carious dentine";
  EXPECT_NE(code_of(*exercise_file_bytes(on_a_volume(block))), "volume") << "as Cusp writes it";
}

TEST_F(ExerciseFiles, HoldAVolumeWhoseNameNoArchiveCanHoldUnderAShorterOne) {
  ExerciseFile named = volume;
  named.scenario.specimen.volume = std::string(kMostTarName, 'v') + ".nrrd";
  const auto bytes = exercise_file_bytes(named);
  ASSERT_TRUE(bytes);
  const auto again = parse_exercise_file(*bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->scenario.specimen.volume, std::string(kMostTarName - 5, 'v') + ".nrrd");
  EXPECT_EQ(again->volume, named.volume);
  named.scenario.specimen.volume = again->scenario.specimen.volume;
  EXPECT_EQ(again->scenario, named.scenario) << "all but the name is the same";
}

TEST(TarName, IsCutBetweenCharactersAndKeepsItsSuffix) {
  EXPECT_EQ(tar_name("molar.nrrd"), "molar.nrrd");
  const std::string whole(kMostTarName, 'm');
  EXPECT_EQ(tar_name(whole), whole);
  std::string umlauts;
  for (int i = 0; i < 60; ++i) umlauts += "ä";  // two bytes each: 60 characters, 120 bytes
  EXPECT_EQ(tar_name(umlauts + ".nrrd"), umlauts.substr(0, 94) + ".nrrd") << "95 bytes would end within a character";
  EXPECT_EQ(tar_name(std::string(110, 'm')), whole);
  const std::string sentence = std::string(90, 'm') + ". a name with a full stop in it";
  EXPECT_EQ(tar_name(sentence), sentence.substr(0, kMostTarName));
}

}  // namespace
}  // namespace cusp::test
