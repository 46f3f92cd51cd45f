/// Colours on the tooth: the same in both themes, apart for normal, protan, deutan and tritan sight (ui/README.md).
/// What stands round the tooth comes from the theme instead.
#pragma once

#include <array>
#include <cstdint>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"
#include "ui/modules.h"

namespace cusp::ui {

/// sRGB, 0 to 1.
struct Colour {
  float r = 0, g = 0, b = 0, a = 1;
  friend bool operator==(const Colour&, const Colour&) = default;
};

constexpr Colour colour_of(std::uint32_t rgb, float alpha = 1.0f) noexcept {
  return {static_cast<float>(rgb >> 16 & 255) / 255.0f, static_cast<float>(rgb >> 8 & 255) / 255.0f,
          static_cast<float>(rgb & 255) / 255.0f, alpha};
}

/// By tissue code: scenarios/tissues.
std::array<Colour, kTissueCodes> tissue_colours() noexcept;

inline constexpr Colour kTargetLine = colour_of(0x12B39A);
inline constexpr Colour kTargetCasing = colour_of(0x16191E);
inline constexpr Colour kLeewayLine = colour_of(0x2F68C4);
inline constexpr Colour kLeewayCasing = colour_of(0xFFFFFF, 0.75f);
inline constexpr Colour kOverCut = colour_of(0xE0700F);

/// Difference map at -0.5, -0.3, 0, +0.3 and +0.5 mm: uncut remainder, on target, over-cut. tooth.frag.glsl blends them.
inline constexpr std::array<Colour, 5> kDifference = {colour_of(0x4B2E91), colour_of(0x9A86D0), colour_of(0xEFEDE6),
                                                      colour_of(0xF2A65A), colour_of(0xB54708)};

}  // namespace cusp::ui
