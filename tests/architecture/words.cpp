// Words that only this project's authors would understand: the tree uses the field's word instead. Stored spellings stay,
// at the edges that kAllowed lists.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/source_dir.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct PrivateWord {
  std::string_view word;  // in small letters, words apart by one blank
  std::string_view write;
};
constexpr PrivateWord kPrivate[] = {
    {"told", "report, list, show"},
    {"burr", "bur"},
    {"burrs", "burs"},
    {"astray", "predicted displacement"},
    {"errand", "background task"},
    {"errands", "background tasks"},
    {"map2", "height field"},
    {"place sink", "region classifier"},
    {"shelf", "thumbnail cache"},
    {"decay", "carious lesion"},
    {"decays", "carious lesions"},
    {"cut too far", "over-cut"},
    {"left standing", "uncut remainder"},
    {"owed", "pending"},
    {"lift out", "depenetrate, retract"},
    {"lifts out", "depenetrates, retracts"},
    {"lifted out", "depenetrated, retracted"},
    {"lifts it out", "depenetrates it, retracts it"},
    {"let go", "release, fragment"},
    {"lets go", "releases"},
    {"letting go", "releasing"},
    {"teacher", "instructor"},
    {"teachers", "instructors"},
    {"fair hand", "competent operator"},
    {"scripted hand", "scripted operator"},
    {"scripted hands", "scripted operators"},
    {"house", "module"},
    {"houses", "modules"},
};

/// Where a word may stand. `file` ends in '/' for a folder; an empty `word` allows all.
struct Allowed {
  std::string_view file, word, reason;
};
constexpr Allowed kAllowed[] = {
    {"device/scripted/csv_trace.cpp", "burr", "header of older traces"},
    {"scenarios/operators/operator_port.cpp", "scripted hand", "device name in stored sessions"},
    {"tests/scenarios/blocks/block_exercises_test.cpp", "burr", "text of published exercises"},
    {"tests/scenarios/blocks/block_exercises_test.cpp", "cut too far", "text of published exercises"},
    {"translations/README.md", "", "its table lists words that are not used"},
    {"engine/removal/heat.cpp", "decay", "of a temperature"},
    {"tests/bench/rows.cpp", "decay", "std::decay_t"},
    {"tests/bench/rows_test.cpp", "decay", "std::decay_t"},
};

std::string read(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

/// Words in small letters with a blank around each, `|` for punctuation, and the line of each character. Names are
/// divided: "told_at", "ToldPort" hold "told". A comment that continues on the next line is one text.
struct PlainText {
  std::string text = " ";
  std::vector<int> line = {1};
};
PlainText plain(std::string_view source) {
  PlainText out;
  int line = 1;
  const auto put = [&](char c) {
    if (c == ' ' && out.text.back() == ' ') return;
    out.text += c;
    out.line.push_back(line);
  };
  char before = ' ';
  for (const char c : source) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isupper(u) != 0 && std::islower(static_cast<unsigned char>(before)) != 0) put(' ');
    if (std::isalnum(u) != 0) {
      put(static_cast<char>(std::tolower(u)));
    } else {
      put(' ');
      if (std::string_view(" \t\r\n_-/*#").find(c) == std::string_view::npos) {
        put('|');
        put(' ');
      }
    }
    if (c == '\n') ++line;
    before = c;
  }
  put(' ');
  return out;
}

/// Indices into kAllowed of the entries that were needed.
using Needed = std::set<std::size_t>;

bool allowed(std::string_view path, std::string_view word, Needed& needed) {
  for (std::size_t i = 0; i < std::size(kAllowed); ++i) {
    const Allowed& a = kAllowed[i];
    const bool there = a.file.ends_with('/') ? path.starts_with(a.file) : path == a.file;
    if (!there || (!a.word.empty() && a.word != word)) continue;
    needed.insert(i);
    return true;
  }
  return false;
}

/// One line for each private word in the text: "file:line: word; write ...".
std::vector<std::string> private_words(std::string_view path, std::string_view source, Needed& needed) {
  std::map<int, std::vector<std::string>> by_line;
  const PlainText words = plain(source);
  for (const PrivateWord& p : kPrivate) {
    const std::string wanted = " " + std::string(p.word) + " ";
    for (std::size_t at = words.text.find(wanted); at != std::string::npos; at = words.text.find(wanted, at + 1)) {
      if (allowed(path, p.word, needed)) continue;
      const int line = words.line[at + 1];
      by_line[line].push_back(std::string(path) + ":" + std::to_string(line) + ": \"" + std::string(p.word) + "\"; write " +
                              std::string(p.write));
    }
  }
  std::vector<std::string> out;
  for (const auto& [line, found] : by_line) out.insert(out.end(), found.begin(), found.end());
  return out;
}

bool is_prose(const fs::path& path) {
  static const std::set<std::string> kKinds = {".h", ".cpp", ".md", ".py", ".cmake"};
  return kKinds.contains(path.extension().string()) || path.filename() == "CMakeLists.txt";
}

TEST(Words, AreThoseOfTheField) {
  const fs::path root = source_dir();
  std::vector<fs::path> files = {root / "README.md", root / "CMakeLists.txt"};
  for (const char* folder : {"engine", "device", "scenarios", "storage", "ui", "tests", "translations", "package"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file() && is_prose(entry.path())) files.push_back(entry.path());
    }
  }
  EXPECT_GT(files.size(), 900u);
  Needed needed;
  for (const fs::path& file : files) {
    const std::string path = fs::relative(file, root).string();
    if (path == "tests/architecture/words.cpp") continue;
    for (const std::string& found : private_words(path, read(file), needed)) ADD_FAILURE() << found;
  }
  for (std::size_t i = 0; i < std::size(kAllowed); ++i) {
    const bool folder = kAllowed[i].file.ends_with('/');
    EXPECT_TRUE(folder || needed.contains(i)) << kAllowed[i].file << ": \"" << kAllowed[i].word << "\" is no longer there";
  }
}

TEST(Words, APlantedOneIsFoundInProseAndInNames) {
  Needed needed;
  const auto found = [&needed](std::string_view text) { return private_words("ui/a.cpp", text, needed); };
  for (const PrivateWord& p : kPrivate) EXPECT_EQ(found("// A " + std::string(p.word) + ".\n").size(), 1u) << p.word;
  const std::vector<std::string> at_line_2 = {"ui/a.cpp:2: \"told\"; write report, list, show"};
  for (const char* planted : {"\nint told_at_ = 0;", "\nclass ToldPort;", "\nTEST(A, it_is_told);", "\nTold, at last."}) {
    EXPECT_EQ(found(planted), at_line_2) << planted;
  }
  EXPECT_EQ(found("/// what was cut too\n/// far here\n").size(), 1u);
  for (const char* fine : {"untold", "toldo", "burrow", "Let A. Go on.", "cut(too); far", "household"}) {
    EXPECT_TRUE(found(fine).empty()) << fine;
  }
}

TEST(Words, AnAllowedOneIsAllowedInItsFileAlone) {
  Needed needed;
  EXPECT_TRUE(private_words("device/scripted/csv_trace.cpp", "\"pedal,burr\"", needed).empty());
  EXPECT_EQ(private_words("device/scripted/csv_trace.cpp", "told", needed).size(), 1u);
  EXPECT_EQ(private_words("device/scripted/csv_trace.h", "burr", needed).size(), 1u);
}

}  // namespace
}  // namespace cusp::test
