#include <algorithm>
#include <cmath>

#include "engine/volume/specimen.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/specimen_grower.h"
#include "ui/instructor/import_page.h"
#include "ui/modules.h"

namespace cusp::ui {

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
  s.briefing = {{"en", pattern ? pattern->briefing.at("en") : name}};
  s.specimen = {};
  s.specimen.volume = "specimen.nrrd";
  s.specimen.voxel_mm = stated_voxel_mm(volume.grid.voxel_mm).value_or(volume.grid.voxel_mm);
  s.tissues = usual_tissues(facts.tissues);
  if (std::ranges::find(facts.tissues, Tissue::pulp) != facts.tissues.end()) {
    s.protected_parts = {Tissue::pulp};
    s.rubric.critical = {"pulp_exposure"};
  }
  const auto tidy = [](double mm) { return std::round(mm * 100) / 100; };
  const Vec3 middle = (facts.low_mm + facts.high_mm) / 2.0;
  const auto specimen = Specimen::build(volume, Reading::banded);
  s.target.outline.top_mm = tidy(height_at(*specimen, middle.x, middle.y).value_or(facts.high_mm.z));
  // At most a third of length and height: the first target lies inside the specimen.
  const double reach = std::min(std::abs(s.target.outline.paths[0][0].x), (facts.high_mm.x - facts.low_mm.x) / 6);
  s.target.outline.paths = {{{tidy(middle.x - reach), tidy(middle.y), 0}, {tidy(middle.x + reach), tidy(middle.y), 0}}};
  settle_on_floor(s.target.outline);
  const std::filesystem::path folder = drafts_folder(database, s.id);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ImportError::io, folder.string(), error.message());
  if (auto written = write_nrrd(volume, folder / s.specimen.volume); !written) return std::unexpected(written.error());
  start.folder = folder.string();
  return start;
}

}  // namespace cusp::ui
