#include "scenarios/specimens/specimens.h"

#include <algorithm>
#include <set>

#include "scenarios/blocks/blocks.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/tooth.h"

namespace cusp::scenarios {
namespace {

ImportFailure refused(const ToothFailure& failure) {
  switch (failure.code) {
    case ToothError::unknown_fdi: return {ImportError::bad_option, "fdi", failure.where};
    case ToothError::bad_voxel_size: return {ImportError::bad_option, "voxel_mm", failure.where};
    case ToothError::unknown_site: return {ImportError::bad_option, "lesions", failure.where};
    case ToothError::cancelled: return {ImportError::cancelled, "tooth", {}};
    case ToothError::bad_tables: break;
  }
  return {ImportError::corrupt, failure.where, failure.detail};
}

bool asks_for(const SpecimenSource& source, std::string_view key) {
  return std::ranges::find(source.around, key) != source.around.end();
}

Result<VoxelVolume, ImportFailure> tooth(const SpecimenSource& source, ToothCancel cancel, const ToothProgress& progress) {
  auto grown = make_tooth(tooth_request(source), cancel, progress);
  if (!grown) return std::unexpected(refused(grown.error()));
  return std::move(*grown);
}

Result<VoxelVolume, ImportFailure> from_file(const std::string& volume, const std::filesystem::path& folder) {
  // A plain name: a scenario from elsewhere must not reach out of its own folder.
  if (volume.empty() || volume == "." || volume == ".." || volume.find_first_of("/\\") != volume.npos ||
      volume.find('\0') != volume.npos)
    return fail(ImportError::bad_option, "volume", volume);
  return read_nrrd(folder / volume);
}

}  // namespace

ToothRequest tooth_request(const SpecimenSource& source) {
  ToothRequest out{source.fdi, source.seed, source.voxel_mm};
  out.typodont = source.typodont;
  out.neighbours = asks_for(source, "neighbours") || asks_for(source, "jaw");
  out.gingiva = asks_for(source, "gingiva");
  out.bone = asks_for(source, "bone");
  for (const LesionSource& lesion : source.lesions) {
    const Lesion::Kind kind = lesion.kind == "proximal" ? Lesion::Kind::proximal
                              : lesion.kind == "root"   ? Lesion::Kind::root
                                                        : Lesion::Kind::fissure;
    out.lesions.push_back({kind, lesion.site, lesion.radius_mm, lesion.depth_mm, lesion.softness});
  }
  return out;
}

std::vector<Tissue> tissues_of(const SpecimenSource& source) {
  if (source.generator != "tooth") return {};
  const ToothRequest request = tooth_request(source);
  std::set<Tissue> out;
  if (request.typodont) {
    out.insert(Tissue::plastic);
  } else {
    out = {Tissue::enamel, Tissue::dentine, Tissue::cementum, Tissue::pulp};
    if (request.neighbours) out.insert({kNeighbourEnamel, kNeighbourDentine});
    for (const Lesion& lesion : request.lesions) {
      const bool root = lesion.kind == Lesion::Kind::root;
      if (!root) out.insert(Tissue::carious_enamel);
      if (!root && lesion.depth_mm <= 0.0) continue;
      if (lesion.softness > 0.0) out.insert(Tissue::carious_dentine);
      if (lesion.softness < 1.0) out.insert(kFirmCariousDentine);
    }
  }
  if (request.gingiva) out.insert(Tissue::gingiva);
  if (request.bone) out.insert({Tissue::bone, Tissue::ligament});
  return {out.begin(), out.end()};
}

Result<std::vector<JawSurface>, ImportFailure> make_scenery(const SpecimenSource& source, ToothCancel cancel) {
  if (source.generator != "tooth" || !asks_for(source, "jaw")) return std::vector<JawSurface>{};
  auto rest = rest_of_jaw(tooth_request(source), kSceneryStepMm, cancel);
  if (!rest) return std::unexpected(refused(rest.error()));
  return std::move(*rest);
}

Result<VoxelVolume, ImportFailure> make_specimen(const SpecimenSource& source,
                                                 const std::filesystem::path& scenario_folder, ToothCancel cancel,
                                                 const ToothProgress& progress) {
  if (source.generator.empty()) return from_file(source.volume, scenario_folder);
  if (source.generator == "paper-block") return paper_block();
  if (source.generator == "block" || source.generator == "layered-block") {
    if (!(source.voxel_mm >= kDexterityLeastVoxelMm && source.voxel_mm <= kDexterityMostVoxelMm))
      return fail(ImportError::bad_option, "voxel_mm");
    return source.generator == "block" ? dexterity_block(source.voxel_mm) : layered_block(source.voxel_mm);
  }
  if (source.generator == "tooth") return tooth(source, cancel, progress);
  return fail(ImportError::unknown_generator, source.generator);
}

}  // namespace cusp::scenarios
