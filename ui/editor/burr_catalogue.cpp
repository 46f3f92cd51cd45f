#include "ui/editor/burr_catalogue.h"

#include <array>

namespace cusp {

std::span<const Burr> round_burrs() {
  // ISO 005, 006, 008, 010, 014, 018, 023 in tenths of a millimetre. Necks as the exercises that come with
  // the program have them, between them in proportion; the FG shank is 1.6 mm thick.
  static const std::array<Burr, 7> burrs = {{
      {"1/4", 0.25, 0.16, 4, 0.8, 12},
      {"1/2", 0.3, 0.19, 4, 0.8, 12},
      {"1", 0.4, 0.25, 4, 0.8, 12},
      {"2", 0.5, 0.3, 4, 0.8, 12},
      {"4", 0.7, 0.4, 4, 0.8, 12},
      {"6", 0.9, 0.5, 4, 0.8, 12},
      {"8", 1.15, 0.6, 4, 0.8, 12},
  }};
  return burrs;
}

}  // namespace cusp
