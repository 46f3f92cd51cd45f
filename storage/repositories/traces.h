/// The rows of a session's recording: each second's inputs, state hash and metrics, and the final volume. Key states are
/// a cache (storage/cache/key_state_cache.h); sessions of older programs have them as rows. Of a thinned recording
/// inputs() answer wrong_state (where = thinned, detail: UTC µs). Thread: the recorder's, with a Store of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/step/input.h"
#include "storage/records/context.h"
#include "storage/modules.h"
#include "storage/repositories/metrics.h"
#include "storage/repositories/sessions.h"

namespace cusp::storage {

/// StepState::save() after `tick`, and Process::save() of all ticks up to it; `process` is empty if some are unknown.
struct KeyState {
  std::uint64_t tick = 0;
  std::vector<std::byte> state{};
  std::vector<std::byte> process{};
};

/// One second, or less at the end of a session.
struct RecordedSecond {
  std::uint64_t first_tick = 1;               // of inputs[0]; a session begins with 1
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

  /// Chunk, metrics, links and signed head, in one transaction. wrong_state if the session does not run or first_tick
  /// does not follow the last stored tick.
  Stored<void> append(SessionId session, const RecordedSecond& second);

  Stored<std::vector<ChunkInfo>> chunks(SessionId session);  // of a thinned recording one, without state hash
  Stored<std::vector<StepInput>> inputs(SessionId session);                       // all of them, in order
  Stored<std::vector<StepInput>> inputs(SessionId session, std::uint64_t chunk);  // of one chunk
  /// Ticks of the key states in the table (older programs wrote them), rising.
  Stored<std::vector<std::uint64_t>> key_state_ticks(SessionId session);
  /// The last of these at or before `tick`; nullopt if there is none.
  Stored<std::optional<KeyState>> key_state_before(SessionId session, std::uint64_t tick);
  /// nullopt also if the kept one is of an earlier moment: an older program let such an attempt go on. A replay gives the last one.
  Stored<std::optional<FinalVolume>> final_volume(SessionId session);
  /// Whether one is kept, of any moment: the session is then not resumed.
  Stored<bool> keeps_volume(SessionId session);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
