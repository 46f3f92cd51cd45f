#include "ui/render/colours.h"

#include <cmath>

namespace cusp {

std::array<Colour, kTissueCodes> tissue_colours() noexcept {
  std::array<Colour, kTissueCodes> out{};
  // Enamel, dentine, decay and pulp are the ones told apart for every kind of sight; the others stand beside them.
  constexpr std::array<std::uint32_t, 13> kNamed = {0xF1EBDD, 0xF1EBDD, 0xE6BE7C, 0x6A3D1E, 0xDCC9A0, 0xC2255C, 0xE9DFC9,
                                                    0xD98C8C, 0xC9A9A0, 0x8E959E, 0xEDE6D3, 0xD5DADF, 0xA98A62};
  constexpr std::array<std::uint32_t, 4> kOwn = {0xD5DADF, 0xB9C4CE, 0xE3D7C0, 0xC8BBAF};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = colour_of(i < kNamed.size() ? kNamed[i] : kOwn[i % kOwn.size()]);
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

}  // namespace cusp
