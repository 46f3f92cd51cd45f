#include "scenarios/library/library.h"

#include <vector>

#include "scenarios/blocks/block_exercises.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"

// builtin_list.inc: CUSP_BUILTIN("class-1-36", class_1_36) and so on, written by CMakeLists.txt.
namespace cusp::scenarios {
namespace embedded {
#define CUSP_BUILTIN(key, symbol) extern const std::string_view symbol;
#include "builtin_list.inc"
#undef CUSP_BUILTIN
}  // namespace embedded
namespace {

struct Entry {
  std::string_view key;
  std::string text;
};

/// The generated exercises first, then the embedded files. Built once, at the first call.
const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> out;
    for (const BlockExercise& e : block_exercises()) out.push_back({e.key, write_scenario(block_exercise(e.shape, e.level))});
#define CUSP_BUILTIN(key, symbol) out.push_back({key, std::string(embedded::symbol)});
#include "builtin_list.inc"
#undef CUSP_BUILTIN
    return out;
  }();
  return all;
}

}  // namespace

std::span<const std::string_view> builtin_scenarios() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> out;
    for (const Entry& entry : entries()) out.push_back(entry.key);
    return out;
  }();
  return keys;
}

std::string_view builtin_scenario_text(std::string_view key) {
  for (const Entry& entry : entries()) {
    if (entry.key == key) return entry.text;
  }
  return {};
}

Result<Scenario, FormatFailure> load_builtin(std::string_view key) {
  const std::string_view text = builtin_scenario_text(key);
  if (text.empty()) return fail(FormatError::unknown_builtin, std::string(key));
  return read_scenario(text);
}

}  // namespace cusp::scenarios
