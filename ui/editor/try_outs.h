/// What the draft was tried out by, and what was measured then. Plain values; any thread.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/grading/grade.h"
#include "ui/modules.h"

namespace cusp::ui {

enum class TriedBy : std::uint8_t { author, reference, competent, novice };
inline constexpr std::array kTriedBy = {TriedBy::author, TriedBy::reference, TriedBy::competent, TriedBy::novice};

/// The operator's key; "author" of the author.
[[nodiscard]] std::string_view key_of(TriedBy by) noexcept;
/// Of a scripted operator's key (ui/session/operator_cut.h); `author` of any other.
[[nodiscard]] TriedBy tried_by(const std::string& operator_name);

/// The same cuts would measure the same: all but rubric, texts and times is equal.
[[nodiscard]] bool measures_alike(const Scenario& played, const Scenario& present);

struct TryOut {
  TriedBy by = TriedBy::author;
  Scenario played;
  std::vector<Measure> measures;
};

/// The newest of each.
class TryOuts {
 public:
  void keep(TryOut fresh);
  /// As measured with the present tooth, target and burs; a rubric measures nothing and may differ. nullopt: never measured so.
  [[nodiscard]] std::optional<Measure> value(TriedBy by, const std::string& metric, const Scenario& present) const;

 private:
  std::vector<TryOut> kept_;
};

}  // namespace cusp::ui
