#include "scenarios/specimens.h"

#include "scenarios/blocks/blocks.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/teeth/tooth.h"

namespace cusp {
namespace {

Result<VoxelVolume, ImportFailure> tooth(const SpecimenSource& source) {
  auto grown = make_tooth({source.fdi, source.seed, source.voxel_mm});
  if (grown) return std::move(*grown);
  switch (grown.error().code) {
    case ToothError::unknown_fdi: return fail(ImportError::bad_option, "fdi", grown.error().where);
    case ToothError::bad_voxel_size: return fail(ImportError::bad_option, "voxel_mm", grown.error().where);
    case ToothError::cancelled: return fail(ImportError::cancelled, "tooth");
    case ToothError::bad_tables: break;
  }
  return fail(ImportError::corrupt, grown.error().where, grown.error().detail);
}

Result<VoxelVolume, ImportFailure> from_file(const std::string& volume, const std::filesystem::path& folder) {
  // A plain name: a scenario from elsewhere must not reach out of its own folder.
  if (volume.empty() || volume == "." || volume == ".." || volume.find_first_of("/\\") != volume.npos ||
      volume.find('\0') != volume.npos)
    return fail(ImportError::bad_option, "volume", volume);
  return read_nrrd(folder / volume);
}

}  // namespace

Result<VoxelVolume, ImportFailure> make_specimen(const SpecimenSource& source,
                                                 const std::filesystem::path& scenario_folder) {
  if (source.generator.empty()) return from_file(source.volume, scenario_folder);
  if (source.generator == "paper-block") return paper_block();
  if (source.generator == "block" || source.generator == "layered-block") {
    if (!(source.voxel_mm >= kDexterityLeastVoxelMm && source.voxel_mm <= kDexterityMostVoxelMm))
      return fail(ImportError::bad_option, "voxel_mm");
    return source.generator == "block" ? dexterity_block(source.voxel_mm) : layered_block(source.voxel_mm);
  }
  if (source.generator == "tooth") return tooth(source);
  return fail(ImportError::unknown_generator, source.generator);
}

}  // namespace cusp
