// EditorModel's edits of the specimen and of its tissues.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/templates/scope.h"
#include "scenarios/tissues/tissue_facts.h"
#include "ui/editor/commands.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/specimen_grower.h"
#include "ui/editor/tooth_side.h"
#include "ui/modules.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

/// Keeps the fields that the shape uses; the others take their defaults.
void clean(SpecimenSource& source) {
  if (!source.generator.empty()) {
    source.volume.clear();
    source.landmarks = {};
  }
  if (source.generator != "tooth") {
    source.fdi = 0;
    source.seed = 0;
    source.typodont = false;
    source.around.clear();
    source.lesions.clear();
  }
}

bool has(const std::vector<ScenarioTissue>& tissues, Tissue tissue) {
  return std::ranges::find(tissues, tissue, &ScenarioTissue::tissue) != tissues.end();
}

bool has_rule(const Scenario& s, std::string_view event) {
  return std::ranges::find(s.rubric.critical, event) != s.rubric.critical.end();
}

/// Some leaf of the region is of a tissue of which `asked` is true.
bool holds_tissue(const Region& region, const std::function<bool(Tissue)>& asked) {
  return (region.kind == RegionKind::tissue && asked(region.tissue)) ||
         std::ranges::any_of(region.parts, [&](const Region& part) { return holds_tissue(part, asked); });
}

bool guards(const Protected& part, Tissue tissue) {
  return part.tissue == tissue || (part.region && holds_tissue(*part.region, [tissue](Tissue t) { return t == tissue; }));
}

bool lacks_tissue(const Protected& part, const std::vector<ScenarioTissue>& tissues) {
  const auto gone = [&](Tissue t) { return !has(tissues, t); };
  return (part.tissue && gone(*part.tissue)) || (part.region && holds_tissue(*part.region, gone));
}

/// What a new exercise protects of its neighbours, as its template does (scenarios/templates): 0.2 mm of enamel polish away [M].
std::vector<Protected> usual_protection(Tissue tissue) {
  if (tissue == kNeighbourDentine) return {tissue};
  if (tissue != kNeighbourEnamel) return {};
  Region enamel;
  enamel.kind = RegionKind::tissue;
  enamel.tissue = tissue;
  Protected out(std::move(enamel), Damage::depth);
  out.depth_mm = 0.2;
  return {std::move(out)};
}

/// The newest exercise that undo can reach with the tissue in a grown tooth: a code from 16 on means another tissue in a file. nullptr
/// without one.
const Scenario* last_with(const QUndoStack& stack, Tissue tissue) {
  for (int i = stack.index() - 1; i >= 0; --i) {
    const auto* step = dynamic_cast<const ScenarioEdit*>(stack.command(i));
    if (step == nullptr) continue;  // several edits as one step
    const Scenario& then = step->before();
    if (then.specimen.grown_fdi() != 0 && has(then.tissues, tissue)) return &then;
  }
  return nullptr;
}

/// A tissue that a grown tooth did not have: protected as it was in `then`, else as in a new exercise.
void protect_new(Scenario& s, Tissue tissue, const Scenario* then) {
  std::vector<Protected> parts = then == nullptr ? usual_protection(tissue) : then->protected_parts;
  std::erase_if(parts, [&](const Protected& part) { return !guards(part, tissue) || lacks_tissue(part, s.tissues); });
  for (Protected& part : parts) {
    if (then != nullptr && part.region && is_other_side(then->specimen.grown_fdi(), s.specimen.grown_fdi())) mirror_x(*part.region);
    if (std::ranges::find(s.protected_parts, part) == s.protected_parts.end()) s.protected_parts.push_back(std::move(part));
  }
  const bool ruled = !parts.empty() && (then == nullptr || has_rule(*then, "protected_damage"));
  if (ruled && !has_rule(s, "protected_damage")) s.rubric.critical.emplace_back("protected_damage");
}

/// Protects the critical tissues of the specimen and the neighbours of a grown tooth, and no tissue that it lacks. `before`: the
/// tissues until now. New pulp brings its rule, and new neighbours that about damage; a rule that was switched off while they were
/// there stays off. The rule about damage goes with the last protected part.
void guard(Scenario& s, const std::vector<ScenarioTissue>& before, const QUndoStack& stack) {
  std::erase_if(s.protected_parts, [&](const Protected& part) { return lacks_tissue(part, s.tissues); });
  const bool new_pulp = has(s.tissues, Tissue::pulp) && !has(before, Tissue::pulp);
  const Scenario* with_pulp = new_pulp && s.specimen.grown_fdi() != 0 ? last_with(stack, Tissue::pulp) : nullptr;
  auto& critical = s.rubric.critical;
  if (!has(s.tissues, Tissue::pulp)) std::erase(critical, "pulp_exposure");
  if (s.protected_parts.empty()) std::erase(critical, "protected_damage");
  if (new_pulp && !has_rule(s, "pulp_exposure") && (with_pulp == nullptr || has_rule(*with_pulp, "pulp_exposure")))
    critical.emplace_back("pulp_exposure");
  for (const ScenarioTissue& t : s.tissues) {
    if (s.specimen.grown_fdi() != 0 && !has(before, t.tissue)) protect_new(s, t.tissue, last_with(stack, t.tissue));
    if (tissue_facts(t.tissue).critical.value && !is_protected(s, t.tissue)) s.protected_parts.emplace_back(t.tissue);
  }
}

}  // namespace

bool EditorModel::set_specimen(const SpecimenSource& source, const std::vector<ScenarioTissue>& tissues) {
  end_gesture();
  return edit(tr("Tooth"), u"specimen"_qs, [&](Scenario& s) {
    s.specimen = source;
    clean(s.specimen);
    keep_sides(s, drawn_on(scenario_, stack_));
    const std::vector<ScenarioTissue> before = std::exchange(s.tissues, tissues);
    guard(s, before, stack_);
  });
}

bool EditorModel::set_tooth(const SpecimenSource& source, const QString& field) {
  return edit(tr("Tooth"), u"tooth/"_qs + field, [&](Scenario& s) {
    s.specimen = source;
    clean(s.specimen);
    keep_sides(s, drawn_on(scenario_, stack_));
    std::vector<ScenarioTissue> tissues = usual_tissues(tissues_of(s.specimen));
    for (ScenarioTissue& t : tissues) {
      const auto kept = std::ranges::find(s.tissues, t.tissue, &ScenarioTissue::tissue);
      if (kept != s.tissues.end()) t = *kept;
    }
    const std::vector<ScenarioTissue> before = std::exchange(s.tissues, std::move(tissues));
    guard(s, before, stack_);
  });
}

}  // namespace cusp::ui
