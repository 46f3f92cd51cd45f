/// Templates of exercises: a preparation in parameters, fitted to a tooth by its landmarks.
/// A template is a JSON file of this folder (README.md); the program holds them all. Thread: any.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct TemplateParameter {
  std::string key;    // "depth"
  LocalText name;
  std::string unit;   // "mm", "deg"; empty: a share or a choice
  double least = 0, most = 0;
  std::string value;  // default: an expression of the tooth and of the parameters before it
  std::string source; // "dental.md 2.2", or "[M]": general knowledge that nobody verified
  /// 0 or 1 and nothing between: without a unit, from 0 to 1. A share has a narrower range.
  bool is_choice() const noexcept { return unit.empty() && least == 0 && most == 1; }
};

/// What a template's values have to keep together.
struct TemplateNeed {
  std::string key;  // "box"
  LocalText text;   // what to change where they do not keep it
};

struct ExerciseTemplate {
  std::string key;  // "class-2-adhesive"
  LocalText name, about;
  std::vector<TemplateParameter> parameters;
  std::vector<TemplateNeed> needs;
};

/// In the order in which they are offered. The first call reads them.
[[nodiscard]] std::span<const ExerciseTemplate> exercise_templates();

enum class FitError : std::uint8_t {
  unknown_template,   // where: the key
  unsuitable_tooth,   // where: the number; no premolar or molar
  unknown_parameter,  // where: its key
  out_of_range,       // where: the parameter; detail: "0.8..2.5", of a choice "0, 1"
  missing_landmark,   // where: what the tooth has none of: "cej.mesial.z", a fissure's name; detail "no_room": the values leave nothing of it
  missing_tissue,     // a tooth from a file; where: tissue or surroundings that it lacks
  turned_tooth,       // a tooth from a file; where: degrees that it is turned or tilted from its frame
  does_not_fit,       // where: JSON pointer into the exercise; detail: code of the format's refusal
  unmet_need,         // where: its key in ExerciseTemplate::needs
  bad_template,       // a broken build; where: JSON pointer or expression
};
using FitFailure = Failure<FitError>;
inline constexpr std::string_view key_of(FitError error) noexcept {
  constexpr std::string_view kKeys[] = {"unknown_template", "unsuitable_tooth", "unknown_parameter", "out_of_range",
                                        "missing_landmark", "missing_tissue",
                                        "turned_tooth",     "does_not_fit",     "unmet_need",
                                        "bad_template"};
  return kKeys[static_cast<std::size_t>(error)];
}

/// A tooth from a file: what of its specimen an exercise states.
struct ImportedTooth {
  std::string volume;  // plain file name
  double voxel_mm = 0.1;  // of the file; the exercise states stated_voxel_mm() of it
  std::vector<Tissue> tissues;  // that it holds
  SpecimenLandmarks landmarks;
};

struct FitRequest {
  std::string key;
  int fdi = 36;
  std::uint64_t seed = 0;              // of the tooth (scenarios/teeth/tooth.h)
  std::map<std::string, double> values{};  // of parameters; those left out have their defaults
  ScenarioId id{};                     // of the exercise
  std::optional<ImportedTooth> imported{};  // instead of a grown tooth; its number is `fdi`, whatever its landmarks say
};

/// The default of each parameter of a template on a tooth, within its range. Fails as fit_template() does. Some 40 ms.
[[nodiscard]] Result<std::map<std::string, double>, FitFailure> template_defaults(std::string_view key, int fdi, std::uint64_t seed = 0);

/// The exercise of a template on a tooth: target, rubric, burs, texts. It has neither key nor version of its own: 1.
/// Some 50 ms. The result passes validate(); whether it suits its specimen is for scenarios/checks.
[[nodiscard]] Result<Scenario, FitFailure> fit_template(const FitRequest& request);

/// "1.2", "1.25": hundredths as texts of exercises have them, without a trailing zero; in German ("de") with a comma.
std::string figure_text(double value, std::string_view language);

}  // namespace cusp::scenarios
