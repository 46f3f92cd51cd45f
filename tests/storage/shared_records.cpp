#include "tests/storage/shared_records.h"

namespace cusp::test {

std::map<std::string, std::string> shared_records(Store& store) {
  const std::string ended = " WHERE session IN (SELECT session FROM session_summaries WHERE state <> 'running' AND listed = 1)";
  const std::map<std::string, std::string> texts = {
      {"people", "SELECT id, number, name, role, created_at FROM people WHERE (number NOT LIKE 'own-%' AND number NOT LIKE 'local-%') "
                 "OR id IN (SELECT student FROM sessions) ORDER BY id"},
      {"cohorts", "SELECT * FROM cohorts ORDER BY id"},
      {"cohort_students", "SELECT * FROM cohort_students ORDER BY cohort, student"},
      {"scenario_versions", "SELECT id, scenario, key, title, json, content_hash FROM scenario_versions ORDER BY id"},
      {"version_files", "SELECT * FROM version_files ORDER BY version, name"},
      {"version_withdrawals", "SELECT * FROM version_withdrawals ORDER BY version"},
      {"assignments", "SELECT * FROM assignments ORDER BY id"},
      {"assignment_withdrawals", "SELECT * FROM assignment_withdrawals ORDER BY assignment"},
      {"assessments", "SELECT * FROM assessments ORDER BY assignment"},
      {"adjustments", "SELECT * FROM adjustments ORDER BY id"},
      {"sessions", "SELECT * FROM sessions WHERE id IN (SELECT session FROM session_summaries WHERE state <> 'running' AND listed = 1) ORDER BY id"},
      {"session_events", "SELECT * FROM session_events" + ended + " ORDER BY session, row"},
      {"trace_chunks", "SELECT * FROM trace_chunks" + ended + " ORDER BY session, row"},
      {"key_states", "SELECT * FROM key_states" + ended + " ORDER BY session, row"},
      {"metrics", "SELECT * FROM metrics" + ended + " ORDER BY session, row"},
      {"removed_tissues", "SELECT * FROM removed_tissues" + ended + " ORDER BY session, row"},
      {"final_volumes", "SELECT * FROM final_volumes" + ended + " ORDER BY session, row"},
      {"grades", "SELECT * FROM grades" + ended + " ORDER BY session, row"},
      {"criteria", "SELECT * FROM criteria" + ended + " ORDER BY session, row"},
      {"graded_criteria", "SELECT * FROM graded_criteria" + ended + " ORDER BY session, row"},
      {"session_chain", "SELECT * FROM session_chain" + ended + " ORDER BY session, position"},
      {"session_heads", "SELECT * FROM session_heads" + ended + " ORDER BY session"},
      {"thinned_traces", "SELECT * FROM thinned_traces ORDER BY session"},
      {"statements", "SELECT * FROM statements ORDER BY id"},
      {"statement_texts", "SELECT * FROM statement_texts ORDER BY statement"},
      {"results", "SELECT session, student, scenario, version, state, elapsed_us, score, passed, critical, released, attempt "
                  "FROM session_summaries WHERE state <> 'running' AND listed = 1 ORDER BY session"},
  };
  std::map<std::string, std::string> out;
  for (const auto& [table, sql] : texts) {
    Blake2b hash;
    const auto rows = must(store.database().all(sql, [&](Row row) {
      hash.add_hash(row.content_hash());
      return true;
    }));
    out[table] = std::to_string(rows.size()) + ' ' + hex(hash.finish()).substr(0, 16);
  }
  return out;
}

}  // namespace cusp::test
