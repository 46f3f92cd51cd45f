// What is tried of an exercise: its choices, and the voxel sizes that the search may take.

#include <algorithm>
#include <array>

#include "scenarios/audit/audit.h"
#include "scenarios/blocks/blocks.h"
#include "scenarios/format/keys.h"
#include "scenarios/teeth/tooth.h"

namespace cusp::scenarios {
namespace {

/// Round edges of a voxel, mm.
constexpr std::array kEdges = {0.04, 0.05, 0.06, 0.08, 0.1, 0.125, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5};
constexpr double kSame = 1e-9;

struct Sizes {
  double least = 0, most = 0;
  bool any() const noexcept { return most > 0; }
  bool holds(double mm) const noexcept { return mm >= least - kSame && mm <= most + kSame; }
};

/// The sizes that an exercise's generator can make; the paper's block and a volume from a file come in one.
Sizes sizes_of(const SpecimenSource& source) {
  if (source.generator == "tooth") return {kMinToothVoxelMm, kMaxToothVoxelMm};
  if (source.generator == "block" || source.generator == "layered-block") return {kDexterityLeastVoxelMm, kDexterityMostVoxelMm};
  return {};
}

}  // namespace

std::vector<Choice> choices_of(const Scenario& scenario) {
  std::vector<Choice> out;
  const double voxel = scenario.specimen.voxel_mm;
  const Sizes sizes = sizes_of(scenario.specimen);
  if (sizes.holds(2 * voxel)) out.push_back({Aspect::voxel, {}, voxel, 2 * voxel});
  if (sizes.holds(voxel / 2)) out.push_back({Aspect::voxel, {}, voxel, voxel / 2});
  if (reading_of(scenario.method) == Reading::banded) out.push_back({Aspect::band, {}, kBandVoxels, kBandVoxels / 2});
  out.push_back({Aspect::region, {}, 1, 0});
  for (const std::string& key : scenario.specimen.around) out.push_back({Aspect::around, key, 1, 0});
  if (scenario.tissues.size() > 1) {
    for (const ScenarioTissue& t : scenario.tissues)
      out.push_back({Aspect::tissue, std::string(key_of_scenario_tissue(t.tissue)), 1, 0});
  }
  for (const std::string& key : scenario.phenomena) {
    if (key == "friction") out.push_back({Aspect::friction, {}, 1, 0});
    if (key.starts_with("spindle-")) out.push_back({Aspect::spindle, key, 1, 0});
    if (key == "vibration") out.push_back({Aspect::vibration, {}, 1, 0});
    if (key == "heat") out.push_back({Aspect::heat, {}, 1, 0});
  }
  if (scenario.tool_turn_deg > 0) out.push_back({Aspect::tilt, {}, scenario.tool_turn_deg, 0});
  return out;
}

std::vector<double> coarser_voxels(const Scenario& scenario) {
  const Sizes sizes = sizes_of(scenario.specimen);
  const double voxel = scenario.specimen.voxel_mm;
  std::vector<double> out;
  for (const double mm : kEdges) {
    if (sizes.holds(mm) && mm > voxel + kSame && mm <= 2 * voxel + kSame) out.push_back(mm);
  }
  std::ranges::reverse(out);
  return out;
}

std::vector<double> finer_voxels(const Scenario& scenario) {
  const Sizes sizes = sizes_of(scenario.specimen);
  const double voxel = scenario.specimen.voxel_mm;
  std::vector<double> out;
  for (const double mm : kEdges) {
    if (sizes.holds(mm) && mm < voxel - kSame && mm >= voxel / 2 - kSame) out.push_back(mm);
  }
  std::ranges::reverse(out);
  return out;
}

}  // namespace cusp::scenarios
