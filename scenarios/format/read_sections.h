/// The parts of a scenario.json, each as its values. Inside of the reader.
#pragma once

#include "scenarios/format/json_values.h"

namespace cusp::scenarios::format_reader {

Tissue read_tissue(const Value& value);
SpecimenSource read_specimen(const Value& value);
ScenarioTissue read_scenario_tissue(const Value& value);
Bur read_bur(const Value& value);
/// Whose direct parts of a union may have names.
enum class RegionUse : std::uint8_t { target, spared };
Region read_region(const Value& value, RegionUse use);
FaceName read_face(const Value& value);
Leeway read_leeway(const Value& value);
Protected read_protected(const Value& value);
Rubric read_rubric(const Value& value);

}  // namespace cusp::scenarios::format_reader
