#include "ui/editor/try_outs.h"

#include <algorithm>

namespace cusp::ui {

bool measures_alike(const Scenario& played, const Scenario& present) {
  Scenario same = played;
  same.version = present.version;
  same.title = present.title;
  same.briefing = present.briefing;
  same.level = present.level;
  same.expected_time_s = present.expected_time_s;
  same.self_assessment = present.self_assessment;
  same.time_limit_s = present.time_limit_s;
  same.rubric = present.rubric;
  return same == present;
}

std::string_view key_of(TriedBy by) noexcept {
  switch (by) {
    case TriedBy::author: return "author";
    case TriedBy::reference: return "reference";
    case TriedBy::competent: return "competent";
    case TriedBy::novice: return "novice";
  }
  return {};
}

TriedBy tried_by(const std::string& operator_name) {
  const auto found = std::ranges::find_if(kTriedBy, [&](TriedBy by) { return key_of(by) == operator_name; });
  return found == kTriedBy.end() ? TriedBy::author : *found;
}

void TryOuts::keep(TryOut fresh) {
  std::erase_if(kept_, [&](const TryOut& one) { return one.by == fresh.by; });
  kept_.push_back(std::move(fresh));
}

std::optional<Measure> TryOuts::value(TriedBy by, const std::string& metric, const Scenario& present) const {
  const auto kept = std::ranges::find(kept_, by, &TryOut::by);
  if (kept == kept_.end() || !measures_alike(kept->played, present)) return std::nullopt;
  const auto found = std::ranges::find(kept->measures, metric, &Measure::metric);
  if (found == kept->measures.end() || !found->measured) return std::nullopt;
  return *found;
}

}  // namespace cusp::ui
