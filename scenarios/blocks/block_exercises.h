/// The exercises on practice blocks: five shapes in three levels, each built from shape and level. Pure; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

enum class BlockShape : std::uint8_t {
  channel,  // straight, 6 mm long
  line,     // 0.2 mm wider than its bur
  cross,    // two channels
  circle,   // a disc of 4 mm
  ring,     // a channel about an island
};

/// 1: tolerance zone 0.5 mm; 2: 0.3 mm; 3: 0.2 mm, in a block of two materials.
enum class BlockLevel : std::uint8_t { first, second, third };

struct BlockExercise {
  std::string_view key;  // "channel-1"
  BlockShape shape;
  BlockLevel level;
};

/// In the order in which a newcomer meets them; the levels of a shape stand together.
std::span<const BlockExercise> block_exercises() noexcept;

/// Every call with the same arguments gives the same scenario, bit for bit: its content hash is published.
[[nodiscard]] Scenario block_exercise(BlockShape shape, BlockLevel level);

}  // namespace cusp::scenarios
