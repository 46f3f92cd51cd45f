// EditorModel's edits of the specimen and of its tissues.
#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/landmarks.h"
#include "scenarios/templates/scope.h"
#include "scenarios/tissues/tissue_facts.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/specimen_grower.h"
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

bool has_pulp(const std::vector<ScenarioTissue>& tissues) {
  return std::ranges::find(tissues, Tissue::pulp, &ScenarioTissue::tissue) != tissues.end();
}

/// Protects the critical tissues of the specimen, and no tissue that it lacks. `before`: the tissues until now. New pulp brings its
/// rule; a rule that was switched off while there was pulp stays off. The rule about damage goes with the last protected part.
void guard(Scenario& s, const std::vector<ScenarioTissue>& before) {
  const auto there = [&s](Tissue t) {
    return std::ranges::any_of(s.tissues, [t](const ScenarioTissue& have) { return have.tissue == t; });
  };
  std::erase_if(s.protected_parts, [&](const Protected& p) {
    if (p.region) return p.region->kind == RegionKind::tissue && !there(p.region->tissue);
    return p.tissue && !there(*p.tissue);
  });
  for (const ScenarioTissue& t : s.tissues) {
    const bool guarded = is_protected(s, t.tissue);
    if (tissue_facts(t.tissue).critical.value && !guarded) s.protected_parts.push_back(t.tissue);
  }
  auto& critical = s.rubric.critical;
  if (!has_pulp(s.tissues)) std::erase(critical, "pulp_exposure");
  if (s.protected_parts.empty()) std::erase(critical, "protected_damage");
  const bool ruled = std::ranges::find(critical, "pulp_exposure") != critical.end();
  if (has_pulp(s.tissues) && !has_pulp(before) && !ruled) critical.push_back("pulp_exposure");
}

/// The halves of a jaw mirror each other: on the other side a mesial box stays mesial, and its walls keep their names.
void keep_sides(Scenario& s, int fdi_before) {
  if (mesial_x(fdi_before) * mesial_x(s.specimen.grown_fdi()) >= 0) return;
  mirror_x(s.target);
  for (Protected& one : s.protected_parts)
    if (one.region) mirror_x(*one.region);
}

}  // namespace

bool EditorModel::set_specimen(const SpecimenSource& source, const std::vector<ScenarioTissue>& tissues) {
  end_gesture();
  return edit(tr("Tooth"), u"specimen"_qs, [&](Scenario& s) {
    s.specimen = source;
    clean(s.specimen);
    const std::vector<ScenarioTissue> before = std::exchange(s.tissues, tissues);
    guard(s, before);
  });
}

bool EditorModel::set_tooth(const SpecimenSource& source, const QString& field) {
  return edit(tr("Tooth"), u"tooth/"_qs + field, [&](Scenario& s) {
    const int fdi_before = s.specimen.grown_fdi();
    s.specimen = source;
    clean(s.specimen);
    keep_sides(s, fdi_before);
    std::vector<ScenarioTissue> tissues = usual_tissues(tissues_of(s.specimen));
    for (ScenarioTissue& t : tissues) {
      const auto kept = std::ranges::find(s.tissues, t.tissue, &ScenarioTissue::tissue);
      if (kept != s.tissues.end()) t = *kept;
    }
    const std::vector<ScenarioTissue> before = std::exchange(s.tissues, std::move(tissues));
    guard(s, before);
  });
}

}  // namespace cusp::ui
