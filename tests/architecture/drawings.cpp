#include "tests/architecture/drawings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>

#include "tests/architecture/file_text.h"
#include "tests/source_dir.h"

namespace cusp::test {

namespace {

constexpr std::string_view kRight = "►", kLeft = "◄", kDown = "▼", kUp = "▲", kFence = "```";

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::vector<std::string_view> rows_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// Where a name stands as a word of its own: "text", not "texts" or "ui/text".
std::size_t word_at(std::string_view row, std::string_view name) {
  const auto part_of_word = [row](std::size_t at) {
    return at < row.size() && (std::isalnum(static_cast<unsigned char>(row[at])) != 0 || row[at] == '_' || row[at] == '/');
  };
  std::size_t at = row.find(name);
  while (at != std::string_view::npos && ((at > 0 && part_of_word(at - 1)) || part_of_word(at + name.size()))) at = row.find(name, at + 1);
  return at;
}

struct Place {
  int level = 0;  // grows downwards
  std::size_t row = 0, begin = 0, end = 0;
};

std::optional<Place> place_of(const std::vector<std::string_view>& rows, std::string_view name) {
  int level = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t at = word_at(rows[row], name);
    if (at != std::string_view::npos) return Place{level, row, at, at + name.size()};
    level += (holds(rows[row], kDown) ? 1 : 0) - (holds(rows[row], kUp) ? 1 : 0);
  }
  return std::nullopt;
}

/// Whether an arrow between two names of one row leads from `to` to `from`.
bool is_against_row(std::string_view row, const Place& from, const Place& to) {
  return from.end <= to.begin ? holds(row.substr(from.end, to.begin - from.end), kLeft) : holds(row.substr(to.end, from.begin - to.end), kRight);
}

struct Drawn {
  std::string module, own;
};
const std::vector<Drawn> kDrawn = {{"engine", ""}, {"device", "catalogue"}, {"scenarios", ""}, {"storage", "store"}, {"ui", ""}, {"tests", "random.h"}};
const std::vector<std::string> kModules = {"engine", "device", "scenarios", "storage", "ui"};

std::string readme_of(const std::string& module) { return text_of(source_dir() / module / "README.md"); }

/// The modules themselves; engine/base counts as one.
Arrows arrows_of_modules() {
  Arrows out;
  const auto module_of = [](std::string_view path) { return std::string(path.starts_with("engine/base/") ? "engine/base" : path.substr(0, path.find('/'))); };
  for (const std::string& module : kModules) {
    for (const SourceText& file : sources_of(module)) {
      std::set<std::string>& to = out[module_of(file.path)];
      for (const std::string& other : kModules) {
        const std::string include = "#include \"" + other + "/";
        for (std::size_t at = file.text.find(include); at != std::string::npos; at = file.text.find(include, at + 1)) {
          to.insert(module_of(std::string_view(file.text).substr(at + 10)));
        }
      }
    }
  }
  for (auto& [module, to] : out) to.erase(module);
  return out;
}

TEST(Drawings, OfEachModuleAgreeWithItsIncludes) {
  for (const Drawn& of : kDrawn) {
    const std::string drawing = drawing_of(readme_of(of.module));
    for (const std::string& wrong : against_drawing(arrows_of(of.module, sources_of(of.module)), drawing, of.own)) {
      ADD_FAILURE() << of.module << "/README.md: " << wrong << "\n" << drawing;
    }
  }
}

TEST(Drawings, OfTheModulesAgreesWithTheirIncludes) {
  const std::string drawing = drawing_of(text_of(source_dir() / "README.md"));
  for (const std::string& wrong : against_drawing(arrows_of_modules(), drawing, "")) ADD_FAILURE() << "README.md: " << wrong << "\n" << drawing;
}

TEST(Drawings, ThatAreUpsideDownAreFound) {
  for (const Drawn& of : kDrawn) {
    std::string drawing = drawing_of(readme_of(of.module));
    for (const auto& [mark, other] : {std::pair{kDown, kUp}, {kRight, kLeft}}) {
      const std::string planted = "\x01";
      const auto replace = [&drawing](std::string_view from, std::string_view to) {
        for (std::size_t at = drawing.find(from); at != std::string::npos; at = drawing.find(from, at + to.size())) drawing.replace(at, from.size(), to);
      };
      replace(mark, planted);
      replace(other, mark);
      replace(planted, other);
    }
    EXPECT_FALSE(against_drawing(arrows_of(of.module, sources_of(of.module)), drawing, of.own).empty()) << of.module << "\n" << drawing;
  }
}

using Sentences = std::vector<std::string>;

TEST(Drawings, APlantedReadmeIsFound) {
  const Arrows arrows = {{".", {"a"}}, {"a", {"b"}}, {"b", {"c"}}, {"c", {}}};
  const auto against = [&arrows](std::string_view drawing) { return against_drawing(arrows, drawing, "own"); };
  EXPECT_EQ(against("own\n ▼\n a ──► b\n │ ▼\n c\n"), Sentences{});
  EXPECT_EQ(against("c ◄── b ◄── a\n ▲\nown\n"), Sentences{});
  EXPECT_EQ(against("own\n ▼\n b\n ▼\n a\n ▼\n c\n"), Sentences{"a includes b, which is drawn above it"});
  EXPECT_EQ(against("own\n ▼\n a ◄── b\n │ ▼\n c\n"), Sentences{"a includes b, from which an arrow leads to it"});
  EXPECT_EQ(against("own\n ▼\n b ──► a\n │ ▼\n c\n"), Sentences{"a includes b, from which an arrow leads to it"});
  EXPECT_EQ(against("own\n ▼\n a ──► b\n ▼\n cc, c/d\n"), Sentences{"c is not drawn"});
  EXPECT_EQ(against("a ──► b ──► c\n"), Sentences{"own is not drawn"});
}

TEST(Drawings, AreTheFirstFencedBlockWithAnArrow) {
  EXPECT_EQ(drawing_of("text ► text\n```\n./run\n```\nmore\n```\n a\n ▼\n b\n```\n```\n c ► d\n```\n"), " a\n ▼\n b\n");
  EXPECT_EQ(drawing_of("a ► b\n"), "");
}

}  // namespace

std::string drawing_of(std::string_view readme) {
  std::string block;
  bool open = false;
  for (const std::string_view row : rows_of(readme)) {
    if (row.starts_with(kFence)) {
      for (const std::string_view arrow : {kRight, kLeft, kDown, kUp}) {
        if (holds(block, arrow)) return block;
      }
      open = !open;
      block.clear();
    } else if (open) {
      block += std::string(row) + '\n';
    }
  }
  return {};
}

std::vector<std::string> against_drawing(const Arrows& arrows, std::string_view drawing, std::string_view own) {
  const std::vector<std::string_view> rows = rows_of(drawing);
  const auto name_of = [own](const std::string& folder) { return folder == "." ? std::string(own) : folder; };
  std::map<std::string, Place> places;
  std::vector<std::string> out;
  for (const auto& [folder, to] : arrows) {
    if (const auto place = place_of(rows, name_of(folder))) {
      places[folder] = *place;
    } else {
      out.push_back(name_of(folder) + " is not drawn");
    }
  }
  for (const auto& [folder, targets] : arrows) {
    for (const std::string& target : targets) {
      if (!places.contains(folder) || !places.contains(target)) continue;
      const Place &from = places[folder], &to = places[target];
      const std::string what = name_of(folder) + " includes " + name_of(target);
      if (to.level < from.level) {
        out.push_back(what + ", which is drawn above it");
      } else if (to.row == from.row && is_against_row(rows[from.row], from, to)) {
        out.push_back(what + ", from which an arrow leads to it");
      }
    }
  }
  return out;
}

}  // namespace cusp::test
