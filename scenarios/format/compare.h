/// What two versions of an exercise differ in, value by value. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

enum class ChangeKind : std::uint8_t { changed, added, removed };

struct Change {
  ChangeKind kind = ChangeKind::changed;
  std::string path;  // JSON pointer with "*" for the item of a list: "/rubric/criteria/*/weight", as number_ranges() writes it
  std::string part;  // the item: a metric, tissue, bur, language, event or phenomenon; empty outside of lists
  std::optional<double> before{}, after{};  // numbers only
  friend bool operator==(const Change&, const Change&) = default;
};

/// In the order of the keys; empty for equal exercises. Items of a list are matched by what names them. Id, version, key and
/// format are of no account. One change stands for a whole: the target if its kind changes or it has parts, the points of an
/// outline, the bands of a criterion, the outline of a bur's head, the protected parts and the lesions.
std::vector<Change> compare(const Scenario& before, const Scenario& after);

}  // namespace cusp::scenarios
