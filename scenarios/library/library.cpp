#include "scenarios/library/library.h"

#include <array>

#include "scenarios/format/read.h"

namespace cusp {
namespace embedded {
extern const std::string_view channel_1;
extern const std::string_view channel_2;
extern const std::string_view channel_3;
extern const std::string_view circle_1;
extern const std::string_view circle_2;
extern const std::string_view circle_3;
extern const std::string_view class_1_36;
extern const std::string_view cross_1;
extern const std::string_view cross_2;
extern const std::string_view cross_3;
extern const std::string_view line_1;
extern const std::string_view line_2;
extern const std::string_view line_3;
extern const std::string_view paper_block;
extern const std::string_view ring_1;
extern const std::string_view ring_2;
extern const std::string_view ring_3;
}  // namespace embedded
namespace {

/// In the order in which they are offered: one of each kind first, then the practice on blocks by shape and level.
constexpr std::array<std::string_view, 17> kKeys = {
    "channel-1",
    "class-1-36",
    "paper-block",
    "channel-2",
    "channel-3",
    "circle-1",
    "circle-2",
    "circle-3",
    "cross-1",
    "cross-2",
    "cross-3",
    "line-1",
    "line-2",
    "line-3",
    "ring-1",
    "ring-2",
    "ring-3",
};

struct Entry {
  std::string_view key;
  const std::string_view* text;
};
constexpr Entry kTexts[] = {
    {"channel-1", &embedded::channel_1},
    {"class-1-36", &embedded::class_1_36},
    {"paper-block", &embedded::paper_block},
    {"channel-2", &embedded::channel_2},
    {"channel-3", &embedded::channel_3},
    {"circle-1", &embedded::circle_1},
    {"circle-2", &embedded::circle_2},
    {"circle-3", &embedded::circle_3},
    {"cross-1", &embedded::cross_1},
    {"cross-2", &embedded::cross_2},
    {"cross-3", &embedded::cross_3},
    {"line-1", &embedded::line_1},
    {"line-2", &embedded::line_2},
    {"line-3", &embedded::line_3},
    {"ring-1", &embedded::ring_1},
    {"ring-2", &embedded::ring_2},
    {"ring-3", &embedded::ring_3},
};

}  // namespace

std::span<const std::string_view> builtin_scenarios() noexcept { return kKeys; }

std::string_view builtin_scenario_text(std::string_view key) noexcept {
  for (const Entry& entry : kTexts) {
    if (entry.key == key) return *entry.text;
  }
  return {};
}

Result<Scenario, FormatFailure> load_builtin(std::string_view key) {
  const std::string_view text = builtin_scenario_text(key);
  if (text.empty()) return fail(FormatError::unknown_builtin, std::string(key));
  return read_scenario(text);
}

}  // namespace cusp
