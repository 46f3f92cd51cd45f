/// One second of inputs as bytes: columns of differences as variable-length integers, then zstd, behind a 16-byte hash.
/// Lossless. Altered, truncated or oversized bytes are refused. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/step/input.h"
#include "storage/base/error.h"
#include "storage/modules.h"

namespace cusp::storage {

/// Most inputs in one chunk: two minutes at 1 kHz. The limit bounds the memory that a damaged count asks for.
inline constexpr std::size_t kMostInputsPerChunk = 120'000;
/// Most bytes that a compressed blob may unpack to.
inline constexpr std::size_t kMostUnpackedBytes = std::size_t{1} << 30;

/// Pre: inputs.size() <= kMostInputsPerChunk.
std::vector<std::byte> encode_trace(std::span<const StepInput> inputs);
Stored<std::vector<StepInput>> decode_trace(std::span<const std::byte> bytes);

/// quick: for what is packed while a session runs, 0.004 s for a key state of 3.3 MB in place of 0.027 s, and as small (the cuts
/// of class II, measured).
enum class Packing : std::uint8_t { small, quick };
/// Any other blob: zstd with its checksum. bad_trace if the bytes are not one whole frame.
std::vector<std::byte> pack(std::span<const std::byte> bytes, Packing packing = Packing::small);
Stored<std::vector<std::byte>> unpack(std::span<const std::byte> bytes);

}  // namespace cusp::storage
