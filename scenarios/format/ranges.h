/// The range of every number of a scenario.json, in one table: validate() and scenario.schema.json hold the same, and a test
/// walks both. The reader takes more (whatever was ever published stays readable); what it reads beyond is a finding.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace cusp::scenarios {

/// Most characters (not bytes) of a title, briefing or name of a target in one language. tests/scenarios/format/refusal_test.cpp
/// holds reader and schema to it.
inline constexpr std::size_t kMostTextCharacters = 4000;

struct NumberRange {
  std::string_view path;  // JSON pointer, "*" for any index: "/tissues/*/speed_mm_s"
  std::string_view unit;
  double least, most;
  bool or_zero;             // 0 too, though it is below `least`: none, or cannot
  std::string_view reason;  // why these ends; [M]: general knowledge, unverified
  bool holds(double value) const noexcept { return (value >= least && value <= most) || (or_zero && value == 0.0); }
  /// "[0.05, 20]", "0 or [10, 86400]".
  std::string text() const;
};

std::span<const NumberRange> number_ranges() noexcept;
/// Of a place in a document ("/tissues/3/speed_mm_s"); nullptr where no number stands.
const NumberRange* range_of(std::string_view pointer) noexcept;

}  // namespace cusp::scenarios
