#include "tests/architecture/arrows.h"

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

/// Each folder includes only folders before it: an order of all folders is a proof that they form a DAG.
const std::map<std::string, std::vector<std::string>> kOrders = {
    {"engine", {"base", "volume", "tool", "scene", "contact", "removal", "step", "loop", "mirror", "lab"}},
    {"device", {"pointer", "scripted", "falcon", "hid", "inverse", "."}},
    {"scenarios",
     {"tissues", "burs", "teeth", "format", "shapes", "grading", "metrics", "operators", "import", "blocks", "specimens", "library",
      "checks", "audit"}},
    {"storage", {"base", "sqlite", "records", "repositories", "cache", "summary", "export", "."}},
    {"ui",
     {"widgets", "render", "sound", "session", "settings", "text", "view", "device", "drill", "student", "report", "editor",
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

}  // namespace

std::vector<SourceText> sources_of(const std::string& module) {
  std::vector<SourceText> out;
  const std::filesystem::path root = CUSP_SOURCE_DIR;
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
  const std::string include = "#include \"" + std::string(module) + "/";
  for (const SourceText& file : files) {
    if (file.path.ends_with("/modules.h")) continue;
    const std::string from = folder_of(module, file.path);
    std::set<std::string>& to = out[from];
    for (std::size_t at = file.text.find(include); at != std::string::npos; at = file.text.find(include, at + 1)) {
      const std::size_t start = at + include.size() - module.size() - 1, end = file.text.find('"', start);
      if (end == std::string::npos) break;
      const std::string header = file.text.substr(start, end - start);
      if (header.ends_with("/modules.h")) continue;
      const std::string folder = folder_of(module, header);
      if (folder != from) to.insert(folder);
    }
  }
  return out;
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
