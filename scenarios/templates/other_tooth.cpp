#include "scenarios/templates/other_tooth.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/templates/templates.h"

namespace cusp::scenarios {
namespace {

using Made = Result<Scenario, OtherToothFailure>;

/// What was chosen, without parameters that the template no longer has.
std::map<std::string, double> values_of(const TemplateUse& use) {
  std::map<std::string, double> out = use.values;
  const auto of = std::ranges::find(exercise_templates(), use.key, &ExerciseTemplate::key);
  if (of == exercise_templates().end()) return out;
  std::erase_if(out, [&](const auto& one) {
    return std::ranges::find(of->parameters, one.first, &TemplateParameter::key) == of->parameters.end();
  });
  return out;
}

/// What the exercise's template makes of the tooth that `seed` grows.
Made fitted(const Scenario& exercise, std::uint64_t seed) {
  const FitRequest request{.key = exercise.made_with->key, .fdi = exercise.specimen.fdi, .seed = seed,
                           .values = values_of(*exercise.made_with), .id = exercise.id};
  auto made = fit_template(request);
  if (!made) return fail(OtherToothError::does_not_fit, std::string(key_of(made.error().code)));
  return std::move(*made);
}

/// The template's exercise on the exercise's own tooth. Fails where the exercise has another geometry.
Made as_made(const Scenario& exercise) {
  if (!exercise.made_with || exercise.specimen.generator != "tooth") return fail(OtherToothError::by_hand, "/template");
  auto made = fitted(exercise, exercise.specimen.seed);
  if (!made) return made;
  if (made->target != exercise.target) return fail(OtherToothError::edited, "/target");
  if (made->protected_parts != exercise.protected_parts) return fail(OtherToothError::edited, "/protected");
  if (made->specimen.lesions != exercise.specimen.lesions) return fail(OtherToothError::edited, "/specimen/lesions");
  return made;
}

/// Names of the parts of a target, and metrics of a rubric: what another tooth must have too.
std::vector<std::string> asked_of(const Scenario& exercise) {
  std::vector<std::string> out;
  for (const Region& part : exercise.target.parts) out.push_back(part.name);
  for (const Criterion& one : exercise.rubric.criteria) out.push_back(one.metric);
  return out;
}

void take_bands(const Scenario& made, const Scenario& fresh, Rubric& rubric) {
  for (Criterion& one : rubric.criteria) {
    const auto was = std::ranges::find(made.rubric.criteria, one.metric, &Criterion::metric);
    const auto is = std::ranges::find(fresh.rubric.criteria, one.metric, &Criterion::metric);
    if (was != made.rubric.criteria.end() && is != fresh.rubric.criteria.end() && was->bands == one.bands) one.bands = is->bands;
  }
}

void take_texts(const LocalText& made, const LocalText& fresh, LocalText& texts) {
  for (auto& [language, text] : texts) {
    const auto was = made.find(language), is = fresh.find(language);
    if (was != made.end() && is != fresh.end() && was->second == text) text = is->second;
  }
}

}  // namespace

std::optional<OtherToothFailure> bound_to_its_tooth(const Scenario& exercise) {
  const auto made = as_made(exercise);
  return made ? std::nullopt : std::optional(made.error());
}

bool keeps_its_texts(const Scenario& exercise) {
  const auto made = as_made(exercise);
  return made && (made->title != exercise.title || made->briefing != exercise.briefing);
}

Result<Scenario, OtherToothFailure> on_other_tooth(const Scenario& exercise, std::uint64_t seed) {
  const auto made = as_made(exercise);
  if (!made) return std::unexpected(made.error());
  const auto fresh = fitted(exercise, seed);
  if (!fresh) return std::unexpected(fresh.error());
  if (asked_of(*made) != asked_of(*fresh)) return fail(OtherToothError::does_not_fit, "/target");
  Scenario out = exercise;
  out.specimen.seed = seed;
  out.specimen.lesions = fresh->specimen.lesions;
  out.target = fresh->target;
  out.protected_parts = fresh->protected_parts;
  take_bands(*made, *fresh, out.rubric);
  take_texts(made->title, fresh->title, out.title);
  take_texts(made->briefing, fresh->briefing, out.briefing);
  return out;
}

}  // namespace cusp::scenarios
