#include "storage/repositories/metrics.h"

#include <map>

namespace cusp::storage {

Stored<std::vector<MetricsRow>> Metrics::over_time(SessionId session) {
  auto rows = c_.db.all(
      "SELECT row, elapsed_us, force_peak_n, force_mean_n, contact_ticks, cutting_ticks FROM metrics "
      "WHERE session = ?1 ORDER BY row",
      [](Row row) {
        return MetricsRow{row.u64(0), row.u64(1), {{}, row.real(2), row.real(3), row.u64(4), row.u64(5)}};
      },
      session);
  if (!rows) return rows;
  struct Change {
    std::uint64_t chunk;
    RemovedTissue removed;
  };
  const auto changes = c_.db.all(
      "SELECT chunk, tissue, voxels, mm3 FROM removed_tissues WHERE session = ?1 ORDER BY row",
      [](Row row) { return Change{row.u64(0), {static_cast<Tissue>(row.integer(1)), row.u64(2), row.real(3)}}; },
      session);
  if (!changes) return std::unexpected(changes.error());
  std::map<Tissue, RemovedTissue> totals;
  auto change = changes->begin();
  for (MetricsRow& row : *rows) {
    for (; change != changes->end() && change->chunk <= row.chunk; ++change) {
      totals[change->removed.tissue] = change->removed;
    }
    for (const auto& [tissue, total] : totals) row.metrics.removed.push_back(total);
  }
  return rows;
}

Stored<std::vector<RemovedTissue>> Metrics::removed(SessionId session) {
  // SQLite takes the bare columns from the row that holds the max().
  return c_.db.all(
      "SELECT tissue, voxels, mm3, max(row) FROM removed_tissues WHERE session = ?1 GROUP BY tissue ORDER BY tissue",
      [](Row row) { return RemovedTissue{static_cast<Tissue>(row.integer(0)), row.u64(1), row.real(2)}; }, session);
}

}  // namespace cusp::storage
