#include "storage/repositories/possible_doubles.h"

#include <utility>

namespace cusp::storage {

Stored<std::vector<PossibleDouble>> possible_doubles(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return std::unexpected(allowed.error());
  // Eight signs of the id after a blank.
  const auto pairs = context.db.all(
      "SELECT p.id, d.id FROM people d JOIN people p ON p.number = substr(d.number, 1, length(d.number) - 9) "
      "WHERE substr(d.number, -9) = ' ' || substr(hex(d.id), 25) AND p.guest = 0 AND d.guest = 0 ORDER BY p.name, p.number, d.number",
      [](Row row) { return std::pair{row.id<UserId>(0), row.id<UserId>(1)}; });
  if (!pairs) return std::unexpected(pairs.error());
  Accounts accounts(context);
  std::vector<PossibleDouble> out;
  for (const auto& [with_number, with_end] : *pairs) {
    auto account = accounts.find(with_number);
    if (!account) return std::unexpected(account.error());
    auto other = accounts.find(with_end);
    if (!other) return std::unexpected(other.error());
    auto stations = context.db.all(
        "SELECT DISTINCT s.station FROM session_summaries m INDEXED BY summaries_of_student JOIN sessions s ON s.id = m.session "
        "WHERE m.student = ?1 ORDER BY s.station",
        [](Row row) { return row.uuid(0); }, with_end);
    if (!stations) return std::unexpected(stations.error());
    out.push_back({std::move(*account), std::move(*other), std::move(*stations)});
  }
  return out;
}

}  // namespace cusp::storage
