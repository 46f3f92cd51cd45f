#include "scenarios/specimens/taken_codes.h"

#include <algorithm>

#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

std::optional<ImportFailure> refuse_taken_codes(const VoxelVolume& volume, const std::string& name) {
  for (const auto& [code, grown] : own_tissue_names()) {
    const auto named = volume.names.find(code);
    const bool unnamed = named == volume.names.end();
    if (unnamed ? std::ranges::find(volume.tissue, Tissue{code}) == volume.tissue.end() : named->second == grown) continue;
    return ImportFailure{ImportError::code_taken, name, unnamed || named->second.empty() ? std::to_string(code) : named->second};
  }
  return std::nullopt;
}

}  // namespace cusp::scenarios
