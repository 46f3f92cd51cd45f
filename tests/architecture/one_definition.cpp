// A type of one name in two files of the same namespace: the compiler sees neither beside the other, the linker keeps one
// of their constructors for both, and memory is written past its end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/architecture/file_text.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Without comments, preprocessor lines and what stands in quotes.
std::string bare(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '/' && text.compare(i, 2, "//") == 0) {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '/' && text.compare(i, 2, "/*") == 0) {
      i = std::min(text.find("*/", i + 2), text.size() - 2) + 1;
    } else if (c == '#' && line_begins) {
      do i = std::min(text.find('\n', i + 1), text.size());
      while (i < text.size() && text[i - 1] == '\\');
      --i;
    } else if (c == 'R' && text.compare(i, 2, "R\"") == 0) {
      const std::size_t open = text.find('(', i);
      const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
      i = std::min(text.find(close, open), text.size() - close.size()) + close.size() - 1;
    } else if (c == '"' || (c == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1]))))) {
      for (++i; i < text.size() && text[i] != c; ++i) i += text[i] == '\\';
    } else {
      out += c;
    }
    if (c == '\n') {
      line_begins = true;
    } else if (c != ' ' && c != '\t') {
      line_begins = false;
    }
  }
  return out;
}

/// Full names of the structs, classes and enums that `text` defines in namespaces with a name, outside other types.
std::set<std::string> types_of(const std::string& text) {
  static const std::regex kSpace(R"(^\s*(?:inline\s+)?namespace\s*([\w:]*)\s*$)");
  static const std::regex kType(R"(^\s*(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(\w+)\s*(?:final\s*)?(?::[^:][^()=]*)?$)");
  std::set<std::string> out;
  std::vector<std::string> open;  // names of namespaces; "" for one without, and for all other braces
  std::string head;
  for (const char c : bare(text)) {
    if (c == '{') {
      std::smatch found;
      std::string name;
      if (std::regex_match(head, found, kSpace)) {
        name = found[1];
      } else if (std::regex_match(head, found, kType)) {
        std::string whole;
        for (const std::string& space : open) whole += space + "::";
        if (std::ranges::find(open, "") == open.end()) out.insert(whole + found[1].str());
      }
      open.push_back(name);
      head.clear();
    } else if (c == '}') {
      if (!open.empty()) open.pop_back();
      head.clear();
    } else if (c == ';') {
      head.clear();
    } else {
      head += c;
    }
  }
  return out;
}

TEST(OneDefinition, no_two_files_of_the_program_define_a_type_of_the_same_name) {
  std::map<std::string, std::string> where;
  std::size_t types = 0;
  for (const char* module : {"engine", "device", "scenarios", "storage", "ui"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source_dir() / module)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), source_dir()).string();
      // Of these two only one is ever built.
      if (file == "ui/sound/drill_sound_silent.cpp") continue;
      for (const std::string& type : types_of(text_of(entry.path()))) {
        ++types;
        const auto [before, fresh] = where.emplace(type, file);
        EXPECT_TRUE(fresh) << type << " in " << before->second << " and in " << file;
      }
    }
  }
  EXPECT_GT(types, 500u);  // it does read them
}

TEST(OneDefinition, types_are_found_behind_comments_quotes_and_bases_and_not_where_nobody_else_sees_them) {
  EXPECT_EQ(types_of(R"x(
      #define A struct Macro {
      namespace cusp {
      // struct Comment {
      const char* a = "struct Quoted {"; char b = '{'; int c = 1'000;
      struct Plain { struct Inner { int d; }; };
      class Derived final : public Plain { void f() { struct Local {}; } };
      enum class Kind : unsigned char { one };
      struct Declared;
      struct Plain made() { return {}; }
      namespace { struct Hidden {}; }
      namespace deep::er { template <class T> struct Mould {}; struct Deep {}; }
      })x"),
            (std::set<std::string>{"cusp::Derived", "cusp::Kind", "cusp::Plain", "cusp::deep::er::Deep"}));
}

}  // namespace
}  // namespace cusp::test
