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
/// What a chosen measure is about: stripes of this and of white (mark.frag.glsl).
inline constexpr Colour kEvidence = colour_of(0x0B5C63, 0.75f);
inline constexpr Colour kEvidenceLine = colour_of(0x0B5C63);
inline constexpr Colour kEvidenceCasing = colour_of(0xFFFFFF, 0.85f);

/// Body of a tooth: linear light (red, green, blue), measured against photographs by eye. vertex_look mixes them.
struct LinearLight {
  float r = 0, g = 0, b = 0;
};
inline constexpr LinearLight kEnamelScatter{0.22f, 0.25f, 0.305f};    // 1/mm: blue comes back first
inline constexpr LinearLight kEnamelAbsorb{0.010f, 0.022f, 0.050f};   // 1/mm
inline constexpr LinearLight kUnderEnamel{0.64f, 0.505f, 0.27f};      // dentine behind it
inline constexpr LinearLight kThinEnamel{0.70f, 0.755f, 0.81f};       // a ridge without dentine behind it
inline constexpr LinearLight kCutEnamel{0.80f, 0.775f, 0.70f};       // dry and rough: chalky
inline constexpr LinearLight kFissureStain{0.42f, 0.31f, 0.20f};      // takes this share of what comes back
inline constexpr LinearLight kGumPale{0.70f, 0.29f, 0.26f};           // tight over bone
inline constexpr LinearLight kGumDeep{0.52f, 0.125f, 0.125f};         // rich in blood

/// Difference map at -0.5, -0.3, 0, +0.3 and +0.5 mm: uncut remainder, on target, over-cut. tooth.frag.glsl blends them.
inline constexpr std::array<Colour, 5> kDifference = {colour_of(0x4B2E91), colour_of(0x9A86D0), colour_of(0xEFEDE6),
                                                      colour_of(0xF2A65A), colour_of(0xB54708)};

}  // namespace cusp::ui
