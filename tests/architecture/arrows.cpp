#include "tests/architecture/arrows.h"
#include "tests/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace cusp::test {

namespace {

/// The folder below `module` that `path` ("engine/step/step.h") lies in; "." for the module's own.
std::string folder_of(std::string_view module, std::string_view path) {
  const std::string_view rest = path.substr(module.size() + 1);
  const std::size_t slash = rest.find('/');
  return slash == std::string_view::npos ? "." : std::string(rest.substr(0, slash));
}

/// The folder that a file lies in: "tests/engine/step" of "tests/engine/step/scenes.h".
std::string parent_of(std::string_view path) { return std::string(path.substr(0, path.rfind('/'))); }

/// The headers of `module` that a file includes, by their path from the root, `modules.h` left out.
std::vector<std::string_view> headers_in(std::string_view text, std::string_view module) {
  std::vector<std::string_view> out;
  const std::string include = "#include \"" + std::string(module) + "/";
  for (std::size_t at = text.find(include); at != std::string_view::npos; at = text.find(include, at + 1)) {
    const std::size_t start = text.find('"', at) + 1, end = text.find('"', start);
    if (end == std::string_view::npos) break;
    const std::string_view header = text.substr(start, end - start);
    if (!header.ends_with("/modules.h")) out.push_back(header);
  }
  return out;
}

/// Each folder includes only folders before it: an order of all folders is a proof that they form a DAG.
const std::map<std::string, std::vector<std::string>> kOrders = {
    {"engine", {"base", "volume", "tool", "scene", "contact", "removal", "step", "loop", "mirror", "lab"}},
    {"engine/contact", {"methods", "solver", "cavity", "features", "."}},
    {"device", {"pointer", "scripted", "falcon", "hid", "inverse", "."}},
    {"scenarios",
     {"tissues", "burs", "teeth", "format", "landmarks", "shapes", "grading", "metrics", "operators", "import", "blocks", "specimens", "library",
      "checks", "templates", "audit"}},
    {"storage", {"base", "sqlite", "records", "repositories", "backup", "cache", "summary", "export", "exchange", "retention", "."}},
    {"ui",
     {"widgets", "render", "sound", "session", "settings", "text", "view", "device", "drill", "replay", "student", "report", "editor",
      "instructor", "admin", "signin", "cli", "app"}},
};

TEST(Arrows, OfEachModuleFollowItsOrder) {
  for (const auto& [module, order] : kOrders) {
    const Arrows arrows = arrows_of(module, sources_of(module));
    std::cout << module << "\n" << drawn(arrows, order);
    for (const std::string& wrong : against_order(arrows, order)) ADD_FAILURE() << module << ": " << wrong;
    for (const std::string& folder : order) EXPECT_TRUE(arrows.contains(folder)) << module << ": no folder " << folder;
  }
}

TEST(Arrows, APlantedCycleIsFound) {
  for (const auto& [module, order] : kOrders) {
    std::vector<SourceText> files = sources_of(module);
    const std::string top = order.back() == "." ? module : module + "/" + order.back();
    const std::string bottom = order.front() == "." ? module : module + "/" + order.front();
    files.push_back({bottom + "/planted.h", "#include \"" + top + "/planted.h\"\n"});
    EXPECT_EQ(against_order(arrows_of(module, files), order), std::vector<std::string>{order.front() + " includes " + order.back()});
  }
}

TEST(Arrows, AFolderThatNoOrderNamesIsFound) {
  const Arrows arrows = arrows_of("engine", {{"engine/helpers/a.h", "#include \"engine/base/vec.h\"\n"}});
  EXPECT_EQ(against_order(arrows, {"base", "volume"}).size(), 1u);
}

std::string lines_of(const Arrows& arrows) {
  std::string out;
  for (const auto& [from, targets] : arrows) {
    for (const std::string& to : targets) out += from + " includes " + to + "\n";
  }
  return out;
}

TEST(Arrows, OfTheTestsFoldersFormNoCycle) {
  const Arrows arrows = arrows_of_all_folders("tests", sources_of("tests"));
  EXPECT_GT(arrows.size(), 40u);
  EXPECT_EQ(lines_of(cycles_of(arrows)), "");
}

TEST(Arrows, APlantedCycleOfTestsFoldersIsFound) {
  std::vector<SourceText> files = sources_of("tests");
  files.push_back({"tests/engine/volume/planted.h", "#include \"tests/bench/planted.h\"\n"});
  const std::string found = lines_of(cycles_of(arrows_of_all_folders("tests", files)));
  for (const char* arrow : {"tests/engine/volume includes tests/bench\n", "tests/bench includes tests/engine/volume\n"}) {
    EXPECT_NE(found.find(arrow), std::string::npos) << found;
  }
}

TEST(Arrows, AChainOfFoldersIsNoCycle) {
  EXPECT_TRUE(cycles_of({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {"d"}}, {"d", {}}}).empty());
  EXPECT_EQ(cycles_of({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b", "d"}}, {"d", {}}}).size(), 3u);
}

}  // namespace

std::vector<SourceText> sources_of(const std::string& module) {
  std::vector<SourceText> out;
  const std::filesystem::path root = source_dir();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / module)) {
    const std::string kind = entry.path().extension().string();
    if (!entry.is_regular_file() || (kind != ".h" && kind != ".cpp")) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    out.push_back({std::filesystem::relative(entry.path(), root).string(), text.str()});
  }
  return out;
}

Arrows arrows_of(std::string_view module, const std::vector<SourceText>& files) {
  Arrows out;
  for (const SourceText& file : files) {
    if (file.path.ends_with("/modules.h")) continue;
    const std::string from = folder_of(module, file.path);
    std::set<std::string>& to = out[from];
    for (const std::string_view header : headers_in(file.text, module)) to.insert(folder_of(module, header));
    to.erase(from);
  }
  return out;
}

Arrows arrows_of_all_folders(std::string_view module, const std::vector<SourceText>& files) {
  Arrows out;
  for (const SourceText& file : files) {
    const std::string from = parent_of(file.path);
    std::set<std::string>& to = out[from];
    for (const std::string_view header : headers_in(file.text, module)) to.insert(parent_of(header));
    to.erase(from);
  }
  return out;
}

Arrows cycles_of(Arrows arrows) {
  const auto leads_nowhere = [](const auto& folder) { return folder.second.empty(); };
  for (auto at = std::ranges::find_if(arrows, leads_nowhere); at != arrows.end(); at = std::ranges::find_if(arrows, leads_nowhere)) {
    const std::string name = at->first;
    arrows.erase(at);
    for (auto& [from, to] : arrows) to.erase(name);
  }
  return arrows;
}

std::vector<std::string> against_order(const Arrows& arrows, const std::vector<std::string>& order) {
  std::vector<std::string> out;
  const auto rank = [&order](const std::string& folder) { return std::find(order.begin(), order.end(), folder) - order.begin(); };
  for (const auto& [from, targets] : arrows) {
    if (rank(from) == std::ssize(order)) {
      out.push_back("no order names the folder " + from);
      continue;
    }
    for (const std::string& to : targets)
      if (rank(to) >= rank(from)) out.push_back(from + " includes " + to);
  }
  return out;
}

std::string drawn(const Arrows& arrows, const std::vector<std::string>& order) {
  std::string out;
  for (const std::string& folder : order) {
    out += "  " + folder;
    const auto at = arrows.find(folder);
    if (at != arrows.end() && !at->second.empty()) {
      out += " ->";
      for (const std::string& to : order)
        if (at->second.contains(to)) out += " " + to;
    }
    out += "\n";
  }
  return out;
}

}  // namespace cusp::test
