#include <algorithm>
#include <cmath>
#include <string>

#include "engine/volume/specimen.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "scenarios/templates/templates.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/first_bands.h"
#include "ui/editor/specimen_grower.h"
#include "ui/instructor/import_page.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

double to_hundredths(double mm) { return std::round(mm * 100) / 100; }

/// The pattern's briefing with this depth in place of the pattern's.
LocalText briefing_with_depth(const Scenario& pattern, double depth_mm) {
  LocalText out = pattern.briefing;
  for (auto& [language, text] : out) {
    const std::string before = figure_text(pattern.target.outline.depth_mm, language) + " mm";
    if (const std::size_t at = text.find(before); at != std::string::npos) text.replace(at, before.size(), figure_text(depth_mm, language) + " mm");
  }
  return out;
}

/// Lays the pattern's channel on the middle of the specimen, with a third of its length and height at most, so that it lies inside. The
/// bands follow.
void fit_target(Scenario& s, const VoxelVolume& volume, const SpecimenFacts& facts) {
  const Outline pattern = s.target.outline;
  Outline& target = s.target.outline;
  const Vec3 middle = (facts.low_mm + facts.high_mm) / 2.0, size = facts.high_mm - facts.low_mm;
  const auto specimen = Specimen::build(volume, Reading::banded);
  target.top_mm = to_hundredths(height_at(*specimen, middle.x, middle.y).value_or(facts.high_mm.z));
  target.depth_mm = to_hundredths(std::min(pattern.depth_mm, size.z / 3));
  const double reach = std::min(std::abs(pattern.paths[0][0].x), size.x / 6);
  const double y = to_hundredths(middle.y);
  target.paths = {{{to_hundredths(middle.x - reach), y, 0}, {to_hundredths(middle.x + reach), y, 0}}};
  settle_on_floor(target);
  for (Criterion& c : s.rubric.criteria) c.bands = fitted_bands(c.bands, c.metric, target, pattern);
}

}  // namespace

Result<EditorStart, ImportFailure> exercise_on(const VoxelVolume& volume, const std::string& name,
                                               const std::filesystem::path& database) {
  const auto pattern = load_builtin("channel-1");
  const SpecimenFacts facts = facts_of(volume);
  EditorStart start;
  Scenario& s = start.draft;
  if (pattern) s = *pattern;
  s.id = ScenarioId::make();
  s.key.clear();
  s.version = 1;
  s.title = {{"en", name}};
  s.specimen = {};
  s.specimen.volume = "specimen.nrrd";
  s.specimen.voxel_mm = stated_voxel_mm(volume.grid.voxel_mm).value_or(volume.grid.voxel_mm);
  s.tissues = usual_tissues(facts.tissues);
  if (std::ranges::find(facts.tissues, Tissue::pulp) != facts.tissues.end()) {
    s.protected_parts = {Tissue::pulp};
    s.rubric.critical = {"pulp_exposure"};
  }
  fit_target(s, volume, facts);
  s.briefing = pattern ? briefing_with_depth(*pattern, s.target.outline.depth_mm) : s.title;
  for (const auto& [language, text] : s.briefing) s.title[language] = name;
  const std::filesystem::path folder = drafts_folder(database, s.id);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ImportError::io, folder.string(), error.message());
  if (auto written = write_nrrd(volume, folder / s.specimen.volume); !written) return std::unexpected(written.error());
  start.folder = folder.string();
  return start;
}

}  // namespace cusp::ui
