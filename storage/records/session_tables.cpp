#include "storage/records/session_tables.h"

namespace cusp::storage {
namespace {

struct Columns {
  std::string_view name, columns;
};

constexpr Columns of(SessionTable table) noexcept {
  switch (table) {
    case SessionTable::sessions:
      return {"sessions",
              "id, station, student, version, version_hash, json_hash, kind, assignment, hand, device, device_class, "
              "engine_version, specimen_blob, header, started_at, sequence"};
    case SessionTable::session_events:
      return {"session_events", "session, row, kind, at, sequence, tick, reason, process"};
    case SessionTable::trace_chunks:
      return {"trace_chunks", "session, row, first_tick, inputs, elapsed_us, state_hash, trace"};
    case SessionTable::key_states:
      return {"key_states", "session, row, tick, state"};
    case SessionTable::metrics:
      return {"metrics", "session, row, elapsed_us, force_peak_n, force_mean_n, contact_ticks, cutting_ticks"};
    case SessionTable::removed_tissues:
      return {"removed_tissues", "session, row, chunk, tissue, voxels, mm3"};
    case SessionTable::final_volumes:
      return {"final_volumes", "session, row, tick, volume_hash, cuts"};
    case SessionTable::grades:
      return {"grades",
              "session, row, at, sequence, grader, score, score_max, pass_mark, passed, critical, rubric_hash, "
              "evaluator, engine_version, device_class, calibration"};
    case SessionTable::criteria:
      return {"criteria",
              "session, row, grade, id, metric, measured, value, uncertainty, unit, where_x_mm, where_y_mm, "
              "where_z_mm, band, points, points_max, reason_code, reason_args"};
    case SessionTable::graded_criteria:
      return {"graded_criteria", "session, row, packed"};
  }
  return {};
}

enum class RowNumber : bool { without, with };

/// "SELECT row, ... FROM ... WHERE session = ?1". A session's own row has the number 0.
std::string select(SessionTable table, RowNumber number) {
  const Columns c = of(table);
  const bool own = table == SessionTable::sessions;
  std::string sql = "SELECT ";
  if (number == RowNumber::with) sql += own ? "0, " : "row, ";
  sql.append(c.columns).append(" FROM ").append(c.name).append(own ? " WHERE id = ?1" : " WHERE session = ?1");
  return sql;
}

}  // namespace

std::string_view name_of(SessionTable table) noexcept { return of(table).name; }
std::string select_row(SessionTable table) {
  return select(table, RowNumber::without) + (table == SessionTable::sessions ? " AND ?2 = 0" : " AND row = ?2");
}
std::string select_rows(SessionTable table) {
  return select(table, RowNumber::with) + (table == SessionTable::sessions ? "" : " ORDER BY row");
}

}  // namespace cusp::storage
