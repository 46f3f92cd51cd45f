/// Which way is up in a file.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/base/vec.h"

namespace cusp::scenarios {

/// The direction of the file that becomes the specimen's +z (occlusal). The turn keeps right hands right.
enum class UpAxis : std::uint8_t { z, y, x, minus_z, minus_y, minus_x };
inline constexpr std::array<std::string_view, 6> kUpAxisKeys = {"z", "y", "x", "-z", "-y", "-x"};  // as typed

/// A turn by right angles.
constexpr Vec3 turned_up(Vec3 p, UpAxis up) noexcept {
  switch (up) {
    case UpAxis::z: return p;
    case UpAxis::minus_z: return {p.x, -p.y, -p.z};
    case UpAxis::y: return {p.x, -p.z, p.y};
    case UpAxis::minus_y: return {p.x, p.z, -p.y};
    case UpAxis::x: return {-p.z, p.y, p.x};
    case UpAxis::minus_x: return {p.z, p.y, -p.x};
  }
  return p;
}

}  // namespace cusp::scenarios
