// What a call may leave unnamed: a bool is a function's only parameter (set_muted(true)), beside others it is an enum.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/file_text.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Blanks in place of comments and of what stands in quotes.
std::string code_of(const std::string& text) {
  static const std::regex kNoCode(R"(//[^\n]*|/\*[\s\S]*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')", std::regex::optimize);
  return std::regex_replace(text, kNoCode, " ");
}

/// The list's opening bracket before a place; npos where it stands in none.
std::size_t opening(const std::string& code, std::size_t at) {
  int depth = 0;
  while (at-- > 0) {
    const char c = code[at];
    if (c == ';' || c == '{' || c == '}') return std::string::npos;
    if (c == ')') ++depth;
    if (c == '(' && depth-- == 0) return at;
  }
  return std::string::npos;
}

/// How many parameters the list has that opens there.
int parameters(const std::string& code, std::size_t open) {
  int depth = 0, count = 1;
  for (std::size_t at = open; at < code.size(); ++at) {
    const char c = code[at];
    if (c == '(' || c == '<' || c == '{') ++depth;
    if ((c == ')' || c == '>' || c == '}') && --depth == 0) break;
    if (c == ',' && depth == 1) ++count;
  }
  return count;
}

/// Lists with a bool and another parameter. A lambda's list is whoever calls it that chooses.
std::vector<std::string> bools_beside_others(const std::string& text) {
  static const std::regex kBool(R"(\bbool\s+\w+\s*(?:=[^,()]*)?(?=[,)]))", std::regex::optimize);
  const std::string code = code_of(text);
  std::vector<std::string> out;
  for (std::sregex_iterator it(code.begin(), code.end(), kBool); it != std::sregex_iterator(); ++it) {
    const std::size_t open = opening(code, static_cast<std::size_t>(it->position()));
    if (open == std::string::npos) continue;
    std::size_t before = open;
    while (before > 0 && std::isspace(static_cast<unsigned char>(code[before - 1])) != 0) --before;
    const bool lambda = before > 0 && code[before - 1] == ']';
    if (!lambda && parameters(code, open) > 1) out.push_back(it->str());
  }
  return out;
}

TEST(Parameters, AreNoBoolBesideOthers) {
  const fs::path root = source_dir();
  int files = 0;
  for (const char* module : {"engine", "device", "scenarios", "storage", "ui"})
    for (const auto& entry : fs::recursive_directory_iterator(root / module)) {
      const std::string kind = entry.path().extension().string();
      if (!entry.is_regular_file() || (kind != ".h" && kind != ".cpp")) continue;
      ++files;
      if (fs::relative(entry.path(), root) == "storage/sqlite/statement.h") continue;  // put(): the bool is what is stored
      for (const std::string& found : bools_beside_others(text_of(entry.path())))
        ADD_FAILURE() << fs::relative(entry.path(), root).string() << ": " << found << " beside other parameters";
    }
  EXPECT_GT(files, 500);
}

TEST(Parameters, APlantedBoolBesideOthersIsFound) {
  EXPECT_EQ(bools_beside_others("void show(int page, bool whole);").size(), 1u);
  EXPECT_EQ(bools_beside_others("void show(bool whole = true, int page = 0) {}").size(), 1u);
  EXPECT_EQ(bools_beside_others("using At = std::function<double(Vec3 mm, bool cut)>;").size(), 1u);
}

TEST(Parameters, ABoolAloneASlotALambdaAndAMemberAreNone) {
  EXPECT_TRUE(bools_beside_others("void set_muted(bool muted);").empty());
  EXPECT_TRUE(bools_beside_others("connect(a, &A::toggled, this, [this](int id, bool on) { go(id, on); });").empty());
  EXPECT_TRUE(bools_beside_others("struct A { bool a, b; }; // f(int a, bool b)").empty());
  EXPECT_TRUE(bools_beside_others("if (bool ok = go(a, b); ok) return;").empty());
}

}  // namespace
}  // namespace cusp::test
