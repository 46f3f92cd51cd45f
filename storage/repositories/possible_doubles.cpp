#include "storage/repositories/possible_doubles.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "storage/base/small_letters.h"

namespace cusp::storage {
namespace {

struct DoublePair {
  UserId account{}, other{};
  bool by_name_alone = false;
  bool same_as(const DoublePair& pair) const { return account == pair.account && other == pair.other; }
};

/// Eight signs of the id after a blank end a number that was taken.
constexpr std::string_view kSelectByNumber =
    "SELECT p.id, d.id FROM people d JOIN people p ON p.number = substr(d.number, 1, length(d.number) - 9) "
    "WHERE substr(d.number, -9) = ' ' || substr(hex(d.id), 25) AND p.guest = 0 AND d.guest = 0";

struct NamedStudent {
  UserId id{};
  bool referred = false, disabled = false;
};

Stored<std::map<std::string, std::vector<NamedStudent>>> students_by_name(Database& db) {
  std::map<std::string, std::vector<NamedStudent>> out;  // [agreeing_name()]
  const auto all = db.all(
      "SELECT id, name, id IN (SELECT id FROM referred WHERE here = 0), disabled FROM people "
      "WHERE role = 'student' AND guest = 0 AND substr(number, 1, 7) <> 'erased ' ORDER BY id",
      [&out](Row row) {
        out[agreeing_name(row.text(1))].push_back({row.id<UserId>(0), row.flag(2), row.flag(3)});
        return true;
      });
  if (!all) return std::unexpected(all.error());
  return out;
}

/// Of those that share a name: each that is known by reference alone with each other one; of two such the pair comes once.
void add_referred(std::vector<DoublePair>& pairs, const std::vector<NamedStudent>& same) {
  for (const NamedStudent& other : same) {
    if (!other.referred) continue;
    for (const NamedStudent& account : same)
      if (account.id != other.id && (!account.referred || account.id < other.id)) pairs.push_back({account.id, other.id});
  }
}

Stored<void> add_whole(std::vector<DoublePair>& pairs, Database& db, const std::vector<NamedStudent>& same) {
  std::vector<UserId> whole;
  for (const NamedStudent& one : same)
    if (!one.referred && !one.disabled) whole.push_back(one.id);
  if (whole.size() != 2) return {};
  const auto cohort = db.first(
      "SELECT 1 FROM cohort_students a JOIN cohort_students b ON b.cohort = a.cohort WHERE a.student = ?1 AND b.student = ?2", [](Row) { return true; },
      whole[0], whole[1]);
  if (!cohort) return std::unexpected(cohort.error());
  if (!*cohort) pairs.push_back({whole[0], whole[1], true});
  return {};
}

Stored<std::vector<DoublePair>> find_pairs(Database& db) {
  auto pairs = db.all(kSelectByNumber, [](Row row) { return DoublePair{row.id<UserId>(0), row.id<UserId>(1)}; });
  if (!pairs) return std::unexpected(pairs.error());
  const auto named = students_by_name(db);
  if (!named) return std::unexpected(named.error());
  std::vector<DoublePair> by_name;
  for (const auto& [name, same] : *named) {
    if (same.size() < 2) continue;
    add_referred(by_name, same);
    if (auto added = add_whole(by_name, db, same); !added) return std::unexpected(added.error());
  }
  for (const DoublePair& pair : by_name)
    if (std::ranges::none_of(*pairs, [&pair](const DoublePair& one) { return one.same_as(pair) || (one.account == pair.other && one.other == pair.account); })) pairs->push_back(pair);
  return pairs;
}

}  // namespace

std::string agreeing_name(std::string_view name) {
  std::string turned(name);
  if (std::ranges::count(name, ',') == 1) {
    const std::size_t comma = name.find(',');
    turned = std::string(name.substr(comma + 1)) + ' ' + std::string(name.substr(0, comma));
  }
  std::istringstream words(small_letters(turned));
  std::string out, word;
  while (words >> word) out += (out.empty() ? "" : " ") + word;
  return out;
}

Stored<std::vector<PossibleDouble>> possible_doubles(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return std::unexpected(allowed.error());
  const auto pairs = find_pairs(context.db);
  if (!pairs) return std::unexpected(pairs.error());
  Accounts accounts(context);
  std::vector<PossibleDouble> out;
  for (const DoublePair& pair : *pairs) {
    auto account = accounts.find(pair.account);
    if (!account) return std::unexpected(account.error());
    auto other = accounts.find(pair.other);
    if (!other) return std::unexpected(other.error());
    auto stations = context.db.all(
        "SELECT DISTINCT s.station FROM session_summaries m INDEXED BY summaries_of_student JOIN sessions s ON s.id = m.session "
        "WHERE m.student = ?1 ORDER BY s.station",
        [](Row row) { return row.uuid(0); }, pair.other);
    if (!stations) return std::unexpected(stations.error());
    out.push_back({std::move(*account), std::move(*other), std::move(*stations), pair.by_name_alone});
  }
  std::ranges::sort(out, {}, [](const PossibleDouble& one) { return std::tie(one.account.name, one.account.number, one.other.number); });
  return out;
}

}  // namespace cusp::storage
