#include "scenarios/library/library.h"

#include <array>

#include "scenarios/format/read.h"

// builtin_list.inc: CUSP_BUILTIN("channel-1", channel_1) and so on, written by CMakeLists.txt.
namespace cusp::scenarios {
namespace embedded {
#define CUSP_BUILTIN(key, symbol) extern const std::string_view symbol;
#include "builtin_list.inc"
#undef CUSP_BUILTIN
}  // namespace embedded
namespace {

struct Entry {
  std::string_view key;
  const std::string_view* text;
};
constexpr Entry kEntries[] = {
#define CUSP_BUILTIN(key, symbol) {key, &embedded::symbol},
#include "builtin_list.inc"
#undef CUSP_BUILTIN
};

constexpr auto kKeys = [] {
  std::array<std::string_view, std::size(kEntries)> keys;
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = kEntries[i].key;
  return keys;
}();

}  // namespace

std::span<const std::string_view> builtin_scenarios() noexcept { return kKeys; }

std::string_view builtin_scenario_text(std::string_view key) noexcept {
  for (const Entry& entry : kEntries) {
    if (entry.key == key) return *entry.text;
  }
  return {};
}

Result<Scenario, FormatFailure> load_builtin(std::string_view key) {
  const std::string_view text = builtin_scenario_text(key);
  if (text.empty()) return fail(FormatError::unknown_builtin, std::string(key));
  return read_scenario(text);
}

}  // namespace cusp::scenarios
