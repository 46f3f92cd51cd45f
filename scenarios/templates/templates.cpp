#include "scenarios/templates/templates.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenarios/format/keys.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/landmarks/landmarks.h"
#include "scenarios/templates/fill.h"
#include "scenarios/templates/scope.h"
#include "scenarios/teeth/tooth.h"

// template_list.inc: CUSP_TEMPLATE(class_1_adhesive) and so on, written by CMakeLists.txt.
namespace cusp::scenarios {
namespace embedded {
extern const std::string_view template_common;
#define CUSP_TEMPLATE(symbol) extern const std::string_view symbol;
#include "template_list.inc"
#undef CUSP_TEMPLATE
}  // namespace embedded
namespace {

using Json = nlohmann::ordered_json;

struct Entry {
  ExerciseTemplate head;
  Json body;
};

LocalText text_of(const Json& node) {
  LocalText out;
  for (const auto& [language, text] : node.items()) out[language] = text.get<std::string>();
  return out;
}

Entry entry_of(std::string_view text) {
  Entry out;
  out.body = Json::parse(text);
  out.head.key = out.body.at("key").get<std::string>();
  out.head.name = text_of(out.body.at("name"));
  out.head.about = text_of(out.body.at("about"));
  for (const Json& one : out.body.at("parameters"))
    out.head.parameters.push_back({one.at("key").get<std::string>(), text_of(one.at("name")), one.at("unit").get<std::string>(),
                                   one.at("range").at(0).get<double>(), one.at("range").at(1).get<double>(),
                                   one.at("default").get<std::string>(), one.at("source").get<std::string>()});
  const Json needs = out.body.value("needs", Json::object());
  for (const auto& [key, one] : needs.items()) out.head.needs.push_back({key, text_of(one.at("text"))});
  return out;
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> out;
#define CUSP_TEMPLATE(symbol) out.push_back(entry_of(embedded::symbol));
#include "template_list.inc"
#undef CUSP_TEMPLATE
    return out;
  }();
  return all;
}

const Entry* entry(std::string_view key) {
  for (const Entry& one : entries())
    if (one.head.key == key) return &one;
  return nullptr;
}

/// A template on a tooth, before its parameters.
struct Ground {
  const Entry& of;
  ToothLandmarks landmarks;  // mesial_forward
  Scope scope;
};

/// What a template needs and a file does not hold: a file's own tissues have no names that an exercise knows neighbours by.
Result<void, FitFailure> check_tissues(const Json& body, const ImportedTooth& tooth) {
  if (!body.at("around").empty()) return fail(FitError::missing_tissue, body.at("around").front().get<std::string>());
  const bool carious = std::ranges::find(tooth.tissues, Tissue::carious_dentine) != tooth.tissues.end();
  if (body.contains("lesions") && !carious) return fail(FitError::missing_tissue, std::string(key_of_scenario_tissue(Tissue::carious_dentine)));
  return {};
}

Result<ToothLandmarks, FitFailure> landmarks_of(const Json& body, const FitRequest& request) {
  if (!request.imported) {
    auto grown = tooth_landmarks({.fdi = request.fdi, .seed = request.seed});
    if (!grown) return fail(FitError::unsuitable_tooth, std::to_string(request.fdi));
    return std::move(*grown);
  }
  SpecimenLandmarks marked = request.imported->landmarks;
  marked.fdi = request.fdi;
  if (!marked.find(MarkKind::mesial_axis)) return fail(FitError::missing_landmark, std::string(key_of(MarkKind::mesial_axis)));
  const double turned = std::fabs(turn_deg(marked).value_or(180.0)), tilted = tilt_deg(marked).value_or(0.0);
  if (turned > kMostTurnedDeg || tilted > kMostTiltedDeg)
    return fail(FitError::turned_tooth, std::to_string(static_cast<int>(std::max(turned, tilted) + 0.5)));
  if (const auto held = check_tissues(body, *request.imported); !held) return std::unexpected(held.error());
  return as_grown(marked);
}

Result<Ground, FitFailure> ground_of(const FitRequest& request) {
  const Entry* const of = entry(request.key);
  if (of == nullptr) return fail(FitError::unknown_template, request.key);
  const int place = request.fdi % 10, quadrant = request.fdi / 10;
  if (quadrant < 1 || quadrant > 4 || place < 4 || place > 8) return fail(FitError::unsuitable_tooth, std::to_string(request.fdi));
  auto found = landmarks_of(of->body, request);
  if (!found) return std::unexpected(found.error());
  ToothLandmarks landmarks = mesial_forward(std::move(*found), request.fdi);
  Scope scope = scope_of(landmarks, request.fdi);
  return Ground{*of, std::move(landmarks), std::move(scope)};
}

/// An expression of a template that gave nothing.
FitFailure failure_of(const Failure<ExpressionError>& why, std::string where) {
  if (why.code == ExpressionError::unknown_name && is_of_tooth(why.where)) return {FitError::missing_landmark, why.where, {}};
  return {FitError::bad_template, std::move(where), why.where};
}

bool takes(const TemplateParameter& parameter, double value) noexcept {
  if (parameter.is_choice()) return value == 0.0 || value == 1.0;
  return value >= parameter.least && value <= parameter.most;
}

/// Adds the parameters to the scope: as asked for, or by default.
Result<void, FitFailure> add_parameters(const ExerciseTemplate& of, const std::map<std::string, double>& values, Scope& scope) {
  for (const auto& [key, value] : values)
    if (std::ranges::find(of.parameters, key, &TemplateParameter::key) == of.parameters.end())
      return fail(FitError::unknown_parameter, key);
  for (const TemplateParameter& one : of.parameters) {
    const auto asked = values.find(one.key);
    double value = 0.0;
    if (asked != values.end()) {
      value = asked->second;
      if (!takes(one, value))
        return fail(FitError::out_of_range, one.key, one.is_choice() ? "0, 1" : Json(one.least).dump() + ".." + Json(one.most).dump());
    } else {
      const auto computed = evaluate(one.value, scope);
      if (!computed) return std::unexpected(failure_of(computed.error(), "/parameters/" + one.key));
      value = std::clamp(*computed, one.least, one.most);
    }
    scope[one.key] = value;
  }
  return {};
}

}  // namespace

std::span<const ExerciseTemplate> exercise_templates() {
  static const std::vector<ExerciseTemplate> heads = [] {
    std::vector<ExerciseTemplate> out;
    for (const Entry& one : entries()) out.push_back(one.head);
    return out;
  }();
  return heads;
}

Result<std::map<std::string, double>, FitFailure> template_defaults(std::string_view key, int fdi, std::uint64_t seed) {
  auto ground = ground_of({.key = std::string(key), .fdi = fdi, .seed = seed});
  if (!ground) return std::unexpected(ground.error());
  if (auto added = add_parameters(ground->of.head, {}, ground->scope); !added) return std::unexpected(added.error());
  std::map<std::string, double> out;
  for (const TemplateParameter& one : ground->of.head.parameters) out[one.key] = ground->scope.at(one.key);
  return out;
}

Result<Scenario, FitFailure> fit_template(const FitRequest& request) {
  auto ground = ground_of(request);
  if (!ground) return std::unexpected(ground.error());
  if (auto added = add_parameters(ground->of.head, request.values, ground->scope); !added) return std::unexpected(added.error());
  auto filled = fill_template(ground->of.body, Json::parse(embedded::template_common), request, ground->landmarks, ground->scope);
  if (!filled) return std::unexpected(filled.error());
  auto scenario = read_scenario(filled->dump());
  if (!scenario) return fail(FitError::does_not_fit, scenario.error().where, std::string(key_of(scenario.error().code)));
  const auto findings = validate(*scenario);
  if (has_error(findings)) return fail(FitError::does_not_fit, findings.front().path, findings.front().code);
  if (mesial_x(request.fdi) < 0) mirror_x(scenario->target);
  if (!request.imported) scenario->made_with = TemplateUse{request.key, request.values};
  if (request.imported) {
    scenario->specimen.landmarks = request.imported->landmarks;
    scenario->specimen.landmarks.fdi = request.fdi;
  }
  return std::move(*scenario);
}

}  // namespace cusp::scenarios
