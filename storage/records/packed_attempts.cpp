#include "storage/records/packed_attempts.h"

#include <algorithm>
#include <compare>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "storage/sqlite/row_stream.h"

namespace cusp::storage {
namespace {

constexpr std::string_view kPacked =
    "SELECT scenario, device_class, started_at >> 39, "
    "pack_attempts(started_at, student, score, pass_mark, elapsed_us, attempt, passed, operator <> 'person', released, version_number, "
    "kind = 'assessment') "
    "FROM session_summaries ";
constexpr std::string_view kGroups = " AND listed = 1 AND score IS NOT NULL GROUP BY 1, 2, 3";

std::string every_row() { return std::string(kPacked) + "WHERE 1" + std::string(kGroups); }

struct PackedPlace {
  ScenarioId scenario;
  std::string device_class;
  std::int64_t period = 0;
  friend auto operator<=>(const PackedPlace&, const PackedPlace&) = default;
};

/// nullopt unless the session is packed.
std::optional<PackedPlace> place_of(Transaction& transaction, SessionId session) {
  return transaction.first(
      "SELECT scenario, device_class, started_at >> 39 FROM session_summaries WHERE session = ?1 AND listed = 1 AND score IS NOT NULL",
      [](Row row) { return PackedPlace{row.id<ScenarioId>(0), row.text(1), row.integer(2)}; }, session);
}

void pack_place(Transaction& transaction, const PackedPlace& place) {
  transaction.run("DELETE FROM packed_attempts WHERE scenario = ?1 AND device_class = ?2 AND period = ?3", place.scenario, place.device_class,
                  place.period);
  transaction.run("INSERT INTO packed_attempts " + std::string(kPacked) +
                      "INDEXED BY summaries_of_scenario WHERE scenario = ?1 AND device_class = ?2 "
                      "AND started_at >= ?3 << 39 AND started_at < (?3 + 1) << 39" +
                      std::string(kGroups),
                  place.scenario, place.device_class, place.period);
}

/// By scenario, device class and period.
class PackedRows : public RowStream {
 public:
  using RowStream::RowStream;
  std::tuple<Uuid, std::string, std::int64_t> key() const { return {row().uuid(0), row().text(1), row().integer(2)}; }
};

}  // namespace

void follow_graded(Transaction& transaction, SessionId session) {
  if (const auto place = place_of(transaction, session)) pack_place(transaction, *place);
}

void follow_graded(Transaction& transaction, const std::set<SessionId>& sessions) {
  std::set<PackedPlace> places;
  for (const SessionId session : sessions) {
    if (auto place = place_of(transaction, session)) places.insert(std::move(*place));
  }
  for (const PackedPlace& place : places) pack_place(transaction, place);
}

void rebuild_packed(Transaction& transaction) {
  transaction.run("DELETE FROM packed_attempts");
  transaction.run("INSERT INTO packed_attempts " + every_row());
}

Stored<void> compare_packed(Database& db, const std::function<void(const PackedDifference&)>& each) {
  PackedRows summaries(db, every_row() + " ORDER BY 1, 2, 3");
  PackedRows stored(db, "SELECT scenario, device_class, period, attempts FROM packed_attempts ORDER BY 1, 2, 3");
  auto done = summaries.next();
  if (done) done = stored.next();
  while (done && (summaries.there() || stored.there())) {
    const bool only_summaries = !stored.there() || (summaries.there() && summaries.key() < stored.key());
    const bool only_stored = !only_summaries && (!summaries.there() || stored.key() < summaries.key());
    const ScenarioId scenario = (only_stored ? stored : summaries).row().id<ScenarioId>(0);
    if (only_summaries) {
      each({PackedDifference::Kind::missing, scenario});
    } else if (only_stored) {
      each({PackedDifference::Kind::added, scenario});
    } else if (!summaries.row().same_value(3, stored.row())) {
      each({PackedDifference::Kind::changed, scenario});
    }
    if (!only_stored) done = summaries.next();
    if (done && !only_summaries) done = stored.next();
  }
  return done;
}

}  // namespace cusp::storage
