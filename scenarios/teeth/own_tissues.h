/// Tissues that only some grown teeth have, in the last of the codes that a volume may name for itself (16 to 31): what an
/// import numbers begins at the first. scenarios/tissues has their feel and look.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/volume/tissue.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// A neighbour's tissues have codes of their own, because a cut into a neighbour is damage.
inline constexpr Tissue kNeighbourEnamel{29};
inline constexpr Tissue kNeighbourDentine{30};  // with its cementum; its pulp is left out
inline constexpr Tissue kFirmCariousDentine{31};

/// Of a tooth beside the exercise's own. Pre: a grown tooth's specimen. An import and an exercise's file may not give these codes to
/// tissues of their own (scenarios/specimens/taken_codes.h); the volume of an older exercise may hold them.
constexpr bool is_neighbour(Tissue tissue) noexcept { return tissue == kNeighbourEnamel || tissue == kNeighbourDentine; }

/// Hard and the exercise's own tooth: no gums, bone or ligament, and no neighbour. Pre: as is_neighbour().
constexpr bool is_own_hard(Tissue tissue) noexcept {
  return tissue != Tissue::empty && tissue != Tissue::bone && tissue != Tissue::gingiva && tissue != Tissue::ligament &&
         !is_neighbour(tissue);
}

inline const std::map<std::uint8_t, std::string>& own_tissue_names() {
  static const std::map<std::uint8_t, std::string> names = {
      {29, "neighbour enamel"}, {30, "neighbour dentine"}, {31, "firm carious dentine"}};
  return names;
}

}  // namespace cusp::scenarios
