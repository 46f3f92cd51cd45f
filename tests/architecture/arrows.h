/// The arrows between the folders of a module, read from its includes.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::test {

/// Folder of a module -> the folders of the same module that its files include. "." is the module's own folder.
using Arrows = std::map<std::string, std::set<std::string>>;

struct SourceText {
  std::string path;  // from the root: "engine/step/step.h"
  std::string text;
};

/// Headers and sources of a module of this tree.
std::vector<SourceText> sources_of(const std::string& module);

/// The arrows of `module` ("engine") in `files`; `modules.h` is left out, for it includes nothing.
Arrows arrows_of(std::string_view module, const std::vector<SourceText>& files);

/// The arrows between all folders below `module`, each by its path from the root: "tests/engine/step".
Arrows arrows_of_all_folders(std::string_view module, const std::vector<SourceText>& files);

/// What is left of `arrows` without the folders from which no cycle is reached. Pre: each target is a folder of `arrows`.
Arrows cycles_of(Arrows arrows);

/// One sentence for each arrow that leads to a folder not before its own in `order`, or from or to one that is not there.
std::vector<std::string> against_order(const Arrows& arrows, const std::vector<std::string>& order);

/// A line for each folder, in that order: "step -> contact removal".
std::string drawn(const Arrows& arrows, const std::vector<std::string>& order);

}  // namespace cusp::test
