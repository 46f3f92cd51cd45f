#include "ui/render/colours.h"

#include <cmath>

#include "scenarios/tissues/tissue_facts.h"
#include "ui/modules.h"

namespace cusp::ui {

std::array<Colour, kTissueCodes> tissue_colours() noexcept {
  std::array<Colour, kTissueCodes> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = colour_of(tissue_facts(static_cast<Tissue>(i)).colour.value);
  return out;
}

Colour difference_colour(float mm) noexcept {
  const float size = std::abs(mm);
  const std::size_t half = mm < 0 ? 1 : 3, end = mm < 0 ? 0 : 4;
  const auto mix = [](Colour a, Colour b, float t) {
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return Colour{a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, 1.0f};
  };
  if (size <= kDifferenceHalfMm)
    return mix(kDifference[2], kDifference[half], (size - kDifferenceQuietMm) / (kDifferenceHalfMm - kDifferenceQuietMm));
  return mix(kDifference[half], kDifference[end],
             (size - kDifferenceHalfMm) / (kDifferenceEndMm - kDifferenceHalfMm));
}

}  // namespace cusp::ui
