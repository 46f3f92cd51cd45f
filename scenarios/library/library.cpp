#include "scenarios/library/library.h"

#include <array>

#include "scenarios/format/read.h"

namespace cusp {
namespace embedded {
extern const std::string_view paper_block;
extern const std::string_view channel_1;
extern const std::string_view class_1_36;
}  // namespace embedded
namespace {

constexpr std::array<std::string_view, 3> kKeys = {"channel-1", "class-1-36", "paper-block"};

}  // namespace

std::span<const std::string_view> builtin_scenarios() noexcept { return kKeys; }

std::string_view builtin_scenario_text(std::string_view key) noexcept {
  if (key == "channel-1") return embedded::channel_1;
  if (key == "class-1-36") return embedded::class_1_36;
  if (key == "paper-block") return embedded::paper_block;
  return {};
}

Result<Scenario, FormatFailure> load_builtin(std::string_view key) {
  const std::string_view text = builtin_scenario_text(key);
  if (text.empty()) return fail(FormatError::unknown_builtin, std::string(key));
  return read_scenario(text);
}

}  // namespace cusp
