/// A whole mesh as bytes for the cache of grown teeth.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ui/render/patch_feed.h"

namespace cusp::ui {

std::vector<std::byte> mesh_bytes(const WholeMesh& mesh);
/// nullopt when the bytes are not a whole mesh of that many bricks. Sizes are checked before memory is taken.
std::optional<WholeMesh> mesh_from_bytes(std::span<const std::byte> bytes, std::size_t bricks);

}  // namespace cusp::ui
