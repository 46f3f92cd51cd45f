// The corpora that coverage-guided fuzzing left, and whatever once broke a reader, read again on every check.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/readers.h"
#include "tests/source_dir.h"

namespace cusp::fuzz {
namespace {

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Corpora, EveryReaderReadsOrRefusesEveryFileOfItsCorpus) {
  for (const Target& target : kTargets) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() / "tests/fuzz/corpora" / target.name)) {
      SCOPED_TRACE(entry.path().string());
      target.read(bytes_of(entry.path()));
      ++files;
    }
    EXPECT_GE(files, 10u) << target.name;
  }
}

TEST(Corpora, EveryReaderMeetsTheFilesOfTheOthersToo) {
  for (const Target& corpus : kTargets)
    for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() / "tests/fuzz/corpora" / corpus.name))
      for (const Target& target : kTargets) target.read(bytes_of(entry.path()));
}

}  // namespace
}  // namespace cusp::fuzz
