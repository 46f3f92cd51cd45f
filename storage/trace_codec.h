/// One second of inputs as bytes: columns of differences as variable-length integers, then zstd, under a hash of
/// their own. Exact both ways; anything altered, cut short or too large is refused. Any thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/step/input.h"
#include "storage/error.h"
#include "storage/modules.h"

namespace cusp::storage {

/// Most inputs one chunk may hold: two minutes at 1 kHz, so that a damaged count cannot ask for all memory.
inline constexpr std::size_t kMostInputsPerChunk = 120'000;
/// Most bytes a compressed blob may unfold to.
inline constexpr std::size_t kMostUnpackedBytes = std::size_t{1} << 30;

/// Pre: inputs.size() <= kMostInputsPerChunk.
std::vector<std::byte> encode_trace(std::span<const StepInput> inputs);
Stored<std::vector<StepInput>> decode_trace(std::span<const std::byte> bytes);

/// Any other blob: zstd with its checksum. bad_trace when the bytes are not one whole frame.
std::vector<std::byte> pack(std::span<const std::byte> bytes);
Stored<std::vector<std::byte>> unpack(std::span<const std::byte> bytes);

}  // namespace cusp::storage
