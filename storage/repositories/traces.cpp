#include "storage/repositories/traces.h"

#include <utility>

#include "storage/records/chain_writer.h"
#include "storage/records/session_summary.h"
#include "storage/records/thinned_traces.h"
#include "storage/repositories/session_state.h"
#include "storage/records/trace_codec.h"

namespace cusp::storage {

Stored<void> Traces::append(SessionId session, const RecordedSecond& second) {
  const auto& inputs = second.inputs;
  if (inputs.empty() || inputs.size() > kMostInputsPerChunk) return fail(StorageError::bad_value, "inputs");
  // Before the transaction: encoding needs no lock.
  const auto trace = encode_trace(inputs);

  Transaction transaction(c_.db);
  require_state(transaction, session, Need::running);
  const TraceEnd end = trace_end(transaction, session);
  if (second.first_tick != end.tick + 1) {
    transaction.refuse({StorageError::wrong_state, "trace_chunks", std::to_string(end.tick)});
  }
  std::uint64_t elapsed = end.elapsed_us;
  for (const StepInput& input : inputs) elapsed += input.elapsed_us;
  const std::uint64_t chunk = end.chunks;
  const std::int64_t at = end.second();

  ChainWriter chain(c_, transaction, session);
  transaction.run(
      "INSERT INTO trace_chunks (session, row, first_tick, inputs, elapsed_us, state_hash, trace) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)",
      session, chunk, second.first_tick, std::uint64_t{inputs.size()}, elapsed, second.state_hash, trace);
  chain.add(SessionTable::trace_chunks, chunk, at);

  const SecondMetrics& m = second.metrics;
  transaction.run(
      "INSERT INTO metrics (session, row, elapsed_us, force_peak_n, force_mean_n, contact_ticks, cutting_ticks) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)",
      session, chunk, elapsed, m.force_peak_n, m.force_mean_n, m.contact_ticks, m.cutting_ticks);
  chain.add(SessionTable::metrics, chunk, at);

  std::uint64_t row = next_row(transaction, SessionTable::removed_tissues, session);
  for (const RemovedTissue& removed : m.removed) {
    const auto before = transaction.first(
        "SELECT voxels, mm3 FROM removed_tissues WHERE session = ?1 AND tissue = ?2 ORDER BY row DESC LIMIT 1",
        [](Row r) { return std::pair{r.u64(0), r.real(1)}; }, session, std::uint64_t{index_of(removed.tissue)});
    if (before.value_or(std::pair{std::uint64_t{0}, 0.0}) == std::pair{removed.voxels, removed.mm3}) continue;
    transaction.run(
        "INSERT INTO removed_tissues (session, row, chunk, tissue, voxels, mm3) VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
        session, row, chunk, std::uint64_t{index_of(removed.tissue)}, removed.voxels, removed.mm3);
    chain.add(SessionTable::removed_tissues, row++, at);
  }
  chain.finish();
  follow_second(transaction, session, elapsed);
  return transaction.commit();
}

Stored<std::vector<ChunkInfo>> Traces::chunks(SessionId session) {
  auto chunks = c_.db.all(
      "SELECT row, first_tick, inputs, elapsed_us, state_hash FROM trace_chunks WHERE session = ?1 ORDER BY row",
      [](Row row) {
        ChunkInfo info{row.u64(0), row.u64(1), row.u64(2), row.u64(3), std::nullopt};
        if (!row.is_null(4)) info.state_hash = row.u64(4);
        return info;
      },
      session);
  if (!chunks || !chunks->empty()) return chunks;
  return c_.db.all(
      kSelectThinnedEnd, [](Row row) { return ChunkInfo{0, 1, row.u64(1), row.u64(2), std::nullopt}; }, session);
}

namespace {
/// Fails if the session's recording was thinned.
Stored<void> require_recording(Database& db, SessionId session) {
  const auto at = thinned_at(db, session);
  if (!at) return std::unexpected(at.error());
  if (*at) return std::unexpected(thinned_failure(**at));
  return {};
}

/// bad_trace names the chunk.
Stored<std::vector<StepInput>> decoded(std::span<const std::byte> bytes, std::uint64_t chunk) {
  auto inputs = decode_trace(bytes);
  if (!inputs) return fail(StorageError::bad_trace, "trace_chunks " + std::to_string(chunk), inputs.error().detail);
  return inputs;
}
}  // namespace

Stored<std::vector<StepInput>> Traces::inputs(SessionId session) {
  auto parts = c_.db.all(
      "SELECT row, trace FROM trace_chunks WHERE session = ?1 ORDER BY row",
      [](Row row) { return decoded(row.bytes(1), row.u64(0)); }, session);
  if (!parts) return std::unexpected(parts.error());
  if (parts->empty()) {
    if (auto recorded = require_recording(c_.db, session); !recorded) return std::unexpected(recorded.error());
  }
  std::vector<StepInput> out;
  for (auto& part : *parts) {
    if (!part) return std::unexpected(part.error());
    out.insert(out.end(), part->begin(), part->end());
  }
  return out;
}

Stored<std::vector<StepInput>> Traces::inputs(SessionId session, std::uint64_t chunk) {
  const auto part = c_.db.first(
      "SELECT trace FROM trace_chunks WHERE session = ?1 AND row = ?2",
      [chunk](Row row) { return decoded(row.bytes(0), chunk); }, session, chunk);
  if (!part) return std::unexpected(part.error());
  if (!*part) {
    if (auto recorded = require_recording(c_.db, session); !recorded) return std::unexpected(recorded.error());
    return fail(StorageError::not_found, "trace_chunks", std::to_string(chunk));
  }
  return **part;
}

Stored<std::vector<std::uint64_t>> Traces::key_state_ticks(SessionId session) {
  return c_.db.all(
      "SELECT tick FROM key_states WHERE session = ?1 ORDER BY row", [](Row row) { return row.u64(0); }, session);
}

Stored<std::optional<KeyState>> Traces::key_state_before(SessionId session, std::uint64_t tick) {
  const auto found = c_.db.first(
      "SELECT tick, state FROM key_states WHERE session = ?1 AND tick <= ?2 ORDER BY tick DESC LIMIT 1",
      [](Row row) { return std::pair{row.u64(0), unpack(row.bytes(1))}; }, session, tick);
  if (!found) return std::unexpected(found.error());
  if (!*found) return std::optional<KeyState>{};
  if (!(*found)->second) return fail(StorageError::bad_trace, "key_states", std::to_string((*found)->first));
  return KeyState{(*found)->first, std::move(*(*found)->second), {}};
}

Stored<std::optional<FinalVolume>> Traces::final_volume(SessionId session) {
  const auto found = c_.db.first(
      "SELECT tick, volume_hash, cuts FROM final_volumes v WHERE session = ?1 AND NOT EXISTS (SELECT 1 FROM trace_chunks c "
      "WHERE c.session = ?1 AND c.row = (SELECT max(row) FROM trace_chunks WHERE session = ?1) AND c.first_tick + c.inputs - 1 > v.tick)",
      [](Row row) { return std::pair{FinalVolume{{}, row.u64(1), row.u64(0)}, unpack(row.bytes(2))}; }, session);
  if (!found) return std::unexpected(found.error());
  if (!*found) return std::optional<FinalVolume>{};
  if (!(*found)->second) return fail(StorageError::bad_trace, "final_volumes", session.text());
  FinalVolume volume = (*found)->first;
  volume.cuts = std::move(*(*found)->second);
  return volume;
}

Stored<bool> Traces::keeps_volume(SessionId session) {
  const auto found = c_.db.first("SELECT 1 FROM final_volumes WHERE session = ?1", [](Row) { return true; }, session);
  if (!found) return std::unexpected(found.error());
  return found->has_value();
}

}  // namespace cusp::storage
