/// Tissues that only some teeth have, in the codes that a volume may name for itself (from 16 on).
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/volume/tissue.h"

namespace cusp {

/// A neighbour's tissues are told apart from the tooth's own: what is cut of a neighbour is damage.
inline constexpr Tissue kNeighbourEnamel{16};
inline constexpr Tissue kNeighbourDentine{17};  // with its cementum; its pulp is left out
inline constexpr Tissue kFirmCariousDentine{18};

inline const std::map<std::uint8_t, std::string>& own_tissue_names() {
  static const std::map<std::uint8_t, std::string> names = {
      {16, "neighbour enamel"}, {17, "neighbour dentine"}, {18, "firm carious dentine"}};
  return names;
}

}  // namespace cusp
