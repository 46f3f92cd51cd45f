#include <algorithm>
#include <sstream>

#include "storage/exchange/exchange.h"

namespace cusp::storage {
namespace {

Stored<std::optional<KeyRole>> role_of(StorageContext& context, const Actor& actor, const Hash256& key) {
  const auto keys = other_keys(context, actor);
  if (!keys) return std::unexpected(keys.error());
  const auto known = std::ranges::find(*keys, key, &OtherKey::key);
  return known == keys->end() ? std::nullopt : std::optional(known->role);
}

/// What the file claims to carry. One that is malformed carries nothing, and is refused later.
std::size_t steps_in(Database& file, ExchangeKind kind) {
  const auto counts = counts_of(file).value_or(ExchangeCounts{});
  return kind == ExchangeKind::office ? counts.accounts : counts.sessions;
}

Stored<ExchangeLook> look_in_steps(StorageContext& context, const Actor& actor, const std::filesystem::path& file, WorkSteps& steps) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  auto opened = open_exchange(file);
  if (!opened) return std::unexpected(opened.error());
  const Snapshot snapshot(*opened);
  const auto checked = read_description(*opened);
  if (!checked) return std::unexpected(failure_in_file(checked.error(), file));
  if (checked->description.station == context.station) return fail(StorageError::not_allowed, "own_file");
  if (auto same = check_schema(context.db, file); !same) return std::unexpected(failure_in_file(same.error(), file));
  steps.begin(steps_in(*opened, checked->description.kind));
  if (auto good = check_content(*opened, checked->description, steps); !good) return std::unexpected(failure_in_file(good.error(), file));
  steps.end();
  if (!steps.go_on()) return fail(StorageError::stopped, file.string());
  const auto counts = counts_of(*opened);
  if (!counts) return std::unexpected(counts.error());
  const Hash256 key = key_id(checked->public_key);
  const auto role = role_of(context, actor, key);
  if (!role) return std::unexpected(role.error());
  const auto read = files_read_in(context, actor);
  if (!read) return std::unexpected(read.error());
  ExchangeLook out{checked->description, {checked->description.station, checked->public_key}, *role, *counts};
  for (const FileReadIn& one : *read) {
    if (one.key == key) out.newest_read = std::max(out.newest_read, one.number);
  }
  return out;
}

}  // namespace

Stored<ExchangeLook> look_into(StorageContext& context, const Actor& actor, const std::filesystem::path& file, const WorkWatch& watch) {
  WorkSteps steps(watch);
  auto out = look_in_steps(context, actor, file, steps);
  if (!out && steps.stopped()) return fail(StorageError::stopped, file.string());
  return out;
}

Stored<std::vector<FileReadIn>> files_read_in(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  const auto entries = context.db.all(
      "SELECT detail, at FROM audit_log INDEXED BY audit_by_subject "
      "WHERE subject IN (SELECT station FROM other_keys) AND action = 'exchange_read_in' AND action <> 'session_sealed' ORDER BY number",
      [](Row row) { return std::pair{row.text(0), row.integer(1)}; });
  if (!entries) return std::unexpected(entries.error());
  std::vector<FileReadIn> out;
  for (const auto& [detail, at] : *entries) {
    std::istringstream in(detail);
    std::string key;
    FileReadIn read{.at_utc_us = at};
    in >> key >> read.number;
    const auto hash = hash_from_hex(key);
    if (!in || !hash) continue;
    read.key = *hash;
    out.push_back(read);
  }
  return out;
}

}  // namespace cusp::storage
