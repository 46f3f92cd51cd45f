/// What a session leaves each second: inputs, hash of the state, metrics; and its final volume. Key states are a cache
/// (storage/key_state_cache.h); sessions of older programs have rows of them.
/// Thread: the recorder's, with a Store of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/step/input.h"
#include "storage/context.h"
#include "storage/modules.h"
#include "storage/repositories/metrics.h"
#include "storage/repositories/sessions.h"

namespace cusp::storage {

/// StepState::save() after `tick`, and Process::save() of all ticks up to it; empty where not all of them are known.
struct KeyState {
  std::uint64_t tick = 0;
  std::vector<std::byte> state{};
  std::vector<std::byte> process{};
};

/// One second (or the rest of one, at the end) as the recorder hands it over.
struct RecordedSecond {
  std::uint64_t first_tick = 1;               // tick that inputs[0] makes; 1 is a session's first
  std::vector<StepInput> inputs{};            // 1 to kMostInputsPerChunk
  std::optional<std::uint64_t> state_hash{};  // StepState::hash() after the last of them
  SecondMetrics metrics{};
};

struct ChunkInfo {
  std::uint64_t number = 0;  // 0, 1, 2 ...
  std::uint64_t first_tick = 1;
  std::uint64_t count = 0;       // inputs
  std::uint64_t elapsed_us = 0;  // of the whole session up to the chunk's end
  std::optional<std::uint64_t> state_hash{};
};

class Traces {
 public:
  explicit Traces(StorageContext& context) : c_{context} {}

  /// One transaction: chunk, metrics, links, signed head. wrong_state when the session is not running or
  /// first_tick does not follow the last stored tick.
  Stored<void> append(SessionId session, const RecordedSecond& second);
  /// For a session that was interrupted: the volume that a replay of its trace gives. Once.
  Stored<void> save_final_volume(SessionId session, const FinalVolume& volume);

  Stored<std::vector<ChunkInfo>> chunks(SessionId session);
  Stored<std::vector<StepInput>> inputs(SessionId session);                       // all of them, in order
  Stored<std::vector<StepInput>> inputs(SessionId session, std::uint64_t chunk);  // of one chunk
  /// Ticks at which a session of an older program has a key state, rising.
  Stored<std::vector<std::uint64_t>> key_state_ticks(SessionId session);
  /// The last of these at or before `tick`; nullopt when there is none.
  Stored<std::optional<KeyState>> key_state_before(SessionId session, std::uint64_t tick);
  Stored<std::optional<FinalVolume>> final_volume(SessionId session);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
