#include "storage/repositories/possible_doubles.h"

#include <string_view>
#include <utility>

namespace cusp::storage {
namespace {

/// By number: eight signs of the id after a blank end one that was taken. By name: an account that is known by reference alone, and any
/// other; of two such the pair comes once.
constexpr std::string_view kSelectPairs =
    "SELECT p.id, d.id FROM ("
    "SELECT p.id AS one, d.id AS other FROM people d JOIN people p ON p.number = substr(d.number, 1, length(d.number) - 9) "
    "WHERE substr(d.number, -9) = ' ' || substr(hex(d.id), 25) UNION "
    "SELECT p.id, d.id FROM referred r JOIN people d ON d.id = r.id JOIN people p ON p.name = d.name COLLATE NOCASE "
    "WHERE r.here = 0 AND p.id <> d.id AND p.role = 'student' AND d.role = 'student' AND substr(d.number, 1, 7) <> 'erased ' "
    "AND (p.id < d.id OR p.id NOT IN (SELECT id FROM referred WHERE here = 0))) "
    "JOIN people p ON p.id = one JOIN people d ON d.id = other WHERE p.guest = 0 AND d.guest = 0 ORDER BY p.name, p.number, d.number";

}  // namespace

Stored<std::vector<PossibleDouble>> possible_doubles(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return std::unexpected(allowed.error());
  const auto pairs = context.db.all(kSelectPairs, [](Row row) { return std::pair{row.id<UserId>(0), row.id<UserId>(1)}; });
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
