/// Names of methods and shapes in files and on command lines.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "engine/scene/scene.h"
#include "tests/modules.h"

namespace cusp::bench {

inline constexpr std::array<Method, 6> kMethods = {Method::occupancy, Method::occupancy_pivot, Method::ray,
                                                   Method::penalty,   Method::gradient,        Method::surface};

inline constexpr std::array<std::string_view, 6> kMethodNames = {key_of(kMethods[0]), key_of(kMethods[1]),
                                                                 key_of(kMethods[2]), key_of(kMethods[3]),
                                                                 key_of(kMethods[4]), key_of(kMethods[5])};

inline constexpr std::array<std::string_view, 11> kShapeNames = {
    "face", "sphere", "pit", "cylinder", "edge", "corner", "groove", "step", "wall", "cut", "channel"};

}  // namespace cusp::bench
