// EditorModel's findings, and the pulp's rule after the specimen has grown.
#include <algorithm>

#include "scenarios/checks/checks.h"
#include "scenarios/shapes/target.h"
#include "ui/editor/commands.h"
#include "ui/editor/editor_model.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

bool pulp_rule(const Scenario& s) {
  return std::ranges::find(s.rubric.critical, "pulp_exposure") != s.rubric.critical.end();
}

}  // namespace

void EditorModel::set_facts(std::optional<SpecimenFacts> facts, std::vector<Vec3> pulp_mm,
                            std::shared_ptr<const Specimen> specimen) {
  facts_ = std::move(facts);
  pulp_mm_ = std::move(pulp_mm);
  specimen_ = std::move(specimen);
  check();
  if (!allow_access()) Q_EMIT changed();
}

const std::map<std::uint8_t, std::string>& EditorModel::tissue_names() const {
  static const std::map<std::uint8_t, std::string> none;
  return specimen_ ? specimen_->names() : none;
}

bool EditorModel::allow_access() {
  if (!specimen_ || stack_.index() == 0 || stack_.index() != stack_.count()) return false;
  const auto* last = dynamic_cast<const ScenarioEdit*>(stack_.command(stack_.count() - 1));
  if (last == nullptr) return false;  // several edits as one step, which no further edit joins
  if (last->before().specimen == scenario_.specimen || pulp_rule(last->before()) || !pulp_rule(scenario_)) return false;
  Scenario without = scenario_;
  std::erase(without.rubric.critical, "pulp_exposure");
  const auto found = check_regions(without, *specimen_);
  if (std::ranges::find(found, "target_holds_pulp", &Finding::code) == found.end()) return false;
  // With the field and gesture of the specimen's step this edit merges into it.
  stack_.push(new ScenarioEdit(scenario_, std::move(without), last->text(), last->field(), last->gesture(),
                               [this] { after_change(); }));
  return true;
}

void EditorModel::check() {
  findings_ = validate(scenario_, facts_ ? &*facts_ : nullptr);
  if (specimen_) add(check_regions(scenario_, *specimen_));
  std::vector<Finding> texts = check_texts(scenario_, library_patterns());
  // A new version of a delivered exercise keeps its own title and briefing; a copy has another id.
  if (std::ranges::find(library_patterns(), scenario_.id, &Scenario::id) != library_patterns().end())
    std::erase_if(texts, [](const Finding& f) { return f.code == "text_of_template"; });
  add(std::move(texts));
  if (!specimen_) check_pulp();
  playable_ = !has_error(findings_);
}

void EditorModel::add(std::vector<Finding> findings) {
  for (Finding& f : findings) {
    const auto first_warning = std::ranges::find(findings_, Severity::warning, &Finding::severity);
    findings_.insert(f.severity == Severity::error ? first_warning : findings_.end(), std::move(f));
  }
}

bool EditorModel::prove(std::vector<Finding> of_attempts) {
  const bool found = !of_attempts.empty();
  check();  // what the check before found goes
  add(std::move(of_attempts));
  if (found) Q_EMIT changed();
  return !has_error(findings_);
}

void EditorModel::check_pulp() {
  const auto& critical = scenario_.rubric.critical;
  if (std::ranges::find(critical, "pulp_exposure") == critical.end() || pulp_mm_.empty()) return;
  const TargetShape shape(scenario_.target);
  if (shape.empty()) return;
  double gap = 1e300;
  bool in_leeway = false;
  for (const Vec3& p : pulp_mm_) {
    const Near near = shape.near(p);
    gap = std::min(gap, near.distance_mm);
    in_leeway = in_leeway || near.distance_mm < scenario_.leeway.of(near.face);
  }
  if (gap < 0) {
    findings_.insert(findings_.begin(), {Severity::error, "/target/depth_mm", "target_opens_pulp", {{"value", -gap}}, {}});
  } else if (in_leeway) {
    findings_.push_back({Severity::warning, "/leeway/floor_mm", "leeway_opens_pulp", {{"value", gap}}, {}});
  }
}

}  // namespace cusp::ui
