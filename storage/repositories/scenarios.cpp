#include "storage/repositories/scenarios.h"

#include <algorithm>

#include "storage/records/current_rights.h"
#include "storage/repositories/title.h"
#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

constexpr const char* kVersionColumns =
    "SELECT id, scenario, number, key, title, json, content_hash, author, published_at FROM scenario_versions ";

ScenarioVersion version_of(Row row) {
  ScenarioVersion v;
  v.id = row.id<VersionId>(0);
  v.scenario = row.id<ScenarioId>(1);
  v.number = static_cast<int>(row.integer(2));
  v.key = row.text(3);
  v.title = title_from_json(row.text(4));
  v.json = row.text(5);
  v.content_hash = row.hash(6);
  v.author = row.id<UserId>(7);
  v.published_utc_us = row.integer(8);
  return v;
}

Stored<void> add_files(Database& db, ScenarioVersion& version) {
  const auto files = db.all(
      "SELECT name, blob FROM version_files WHERE version = ?1",
      [](Row row) {
        return std::pair{row.text(0), row.hash(1)};
      },
      version.id);
  if (!files) return std::unexpected(files.error());
  version.files.insert(files->begin(), files->end());
  return {};
}

Stored<std::vector<ScenarioVersion>> with_files(Database& db, Stored<std::vector<ScenarioVersion>> versions) {
  if (!versions) return versions;
  for (ScenarioVersion& version : *versions) {
    if (auto done = add_files(db, version); !done) return std::unexpected(done.error());
  }
  return versions;
}

/// The same on every station, so that sessions of several stations name one version. UUIDv8 (RFC 9562, 5.8).
VersionId id_of_kept(ScenarioId scenario, const Hash256& content) {
  const Hash256 hash = Blake2b{}.add_text("cusp version 1").add_uuid(scenario.uuid).add_hash(content).finish();
  VersionId id;
  std::copy_n(hash.begin(), id.uuid.bytes.size(), id.uuid.bytes.begin());
  id.uuid.bytes[6] = static_cast<std::uint8_t>((id.uuid.bytes[6] & 0x0F) | 0x80);
  id.uuid.bytes[8] = static_cast<std::uint8_t>((id.uuid.bytes[8] & 0x3F) | 0x80);
  return id;
}

constexpr const char* kSelectByContent =
    "SELECT id FROM scenario_versions WHERE scenario = ?1 AND content_hash = ?2 ORDER BY number LIMIT 1";

VersionId version_id(Row row) { return row.id<VersionId>(0); }

}  // namespace

Stored<ScenarioVersion> Scenarios::insert(UserId author, const Scenario& scenario, const std::string& json,
                                          const Hash256& content_hash, const std::map<std::string, Hash256>& files,
                                          const std::optional<std::string>& draft) {
  const bool published = !author.is_nil();
  const VersionId id = published ? VersionId::make() : id_of_kept(scenario.id, content_hash);
  Transaction transaction(c_.db);
  if (published) require_now(transaction, author, Action::edit_scenarios);
  if (!published) {
    // Another process may have kept it since ensure() looked.
    const auto kept = transaction.first(kSelectByContent, version_id, scenario.id, content_hash);
    if (kept) return version(*kept);
  }
  const auto newest = transaction.first(
      "SELECT number, content_hash FROM scenario_versions WHERE scenario = ?1 ORDER BY number DESC LIMIT 1",
      [](Row row) {
        return std::pair{static_cast<int>(row.integer(0)), row.hash(1)};
      },
      scenario.id);
  const int last = newest ? newest->first : 0;
  if (published && newest && newest->second == content_hash) {
    transaction.refuse({StorageError::duplicate, "scenario_versions"});
  }
  // An imported version keeps its own number if that is free; a published one takes the next.
  const int number = published ? last + 1 : std::max(scenario.version, last + 1);
  const std::int64_t sequence = c_.next_sequence(transaction);
  transaction.run(
      "INSERT INTO scenario_versions (id, scenario, number, key, title, json, content_hash, author, published_at, "
      "sequence) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10)",
      id, scenario.id, number, scenario.key, title_to_json(scenario.title), json, content_hash, author, c_.clock(),
      sequence);
  for (const auto& [name, blob] : files) {
    transaction.run("INSERT INTO version_files (version, name, blob) VALUES (?1, ?2, ?3)", id, name, blob);
  }
  if (published && draft) {
    transaction.run("DELETE FROM scenario_drafts WHERE scenario = ?1 AND author = ?2 AND json = ?3", scenario.id, author, *draft);
  }
  log_row(c_, transaction, author, published ? "version_published" : "version_kept", SealedTable::scenario_versions,
          id.uuid);
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return version(id);
}

Stored<ScenarioVersion> Scenarios::ensure(const Scenario& scenario, const std::string& json,
                                          const Hash256& content_hash, const std::map<std::string, Hash256>& files) {
  const auto there = c_.db.first(kSelectByContent, version_id, scenario.id, content_hash);
  if (!there) return std::unexpected(there.error());
  if (*there) return version(**there);
  return insert(UserId{}, scenario, json, content_hash, files, std::nullopt);
}

Stored<ScenarioVersion> Scenarios::publish(const Actor& actor, const Scenario& scenario, const std::string& json,
                                           const Hash256& content_hash, const std::map<std::string, Hash256>& files,
                                           const std::optional<std::string>& draft) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  return insert(actor.id, scenario, json, content_hash, files, draft);
}

Stored<ScenarioVersion> Scenarios::version(VersionId id) {
  auto found = c_.db.first(std::string(kVersionColumns) + "WHERE id = ?1", version_of, id);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, "scenario_versions", id.text());
  if (auto done = add_files(c_.db, **found); !done) return std::unexpected(done.error());
  return std::move(**found);
}

Stored<std::vector<ScenarioVersion>> Scenarios::versions(ScenarioId scenario) {
  return with_files(c_.db,
                    c_.db.all(std::string(kVersionColumns) + "WHERE scenario = ?1 ORDER BY number", version_of, scenario));
}

Stored<std::vector<ScenarioVersion>> Scenarios::library() {
  return with_files(c_.db,
                    c_.db.all(std::string(kVersionColumns) + "AS v WHERE number = (SELECT max(number) FROM scenario_versions o "
                                                      "WHERE o.scenario = v.scenario AND NOT EXISTS (SELECT 1 FROM "
                                                      "version_withdrawals w WHERE w.version = o.id) AND NOT EXISTS (SELECT 1 FROM "
                                                      "referred r WHERE r.id = o.id AND r.here = 0)) ORDER BY scenario",
                              version_of));
}

Stored<void> Scenarios::withdraw(const Actor& actor, VersionId version) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::edit_scenarios);
  transaction.run("INSERT INTO version_withdrawals (version, author, at, sequence) VALUES (?1, ?2, ?3, ?4)", version,
                  actor.id, c_.clock(), c_.next_sequence(transaction));
  log_row(c_, transaction, actor.id, "version_withdrawn", SealedTable::version_withdrawals, version.uuid);
  return commit_sealed(c_, transaction);
}

Stored<bool> Scenarios::withdrawn(VersionId version) {
  const auto found = c_.db.first("SELECT 1 FROM version_withdrawals WHERE version = ?1", [](Row) { return true; }, version);
  if (!found) return std::unexpected(found.error());
  return found->value_or(false);
}

namespace {
/// The draft's JSON as the transaction sees it.
std::optional<std::string> draft_json(Transaction& transaction, ScenarioId scenario, UserId author) {
  return transaction.first("SELECT json FROM scenario_drafts WHERE scenario = ?1 AND author = ?2",
                           [](Row row) { return row.text(0); }, scenario, author);
}
}  // namespace

Stored<DraftSave> Scenarios::save_draft(const Actor& actor, ScenarioId scenario, const std::string& json,
                                        const std::optional<std::string>& before) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  Transaction transaction(c_.db);
  const auto there = draft_json(transaction, scenario, actor.id);
  // If two windows wrote the same text, neither loses anything.
  const bool mine = there == before || there == json;
  if (mine) {
    transaction.run(
        "INSERT INTO scenario_drafts (scenario, author, json, saved_at) VALUES (?1, ?2, ?3, ?4) "
        "ON CONFLICT (scenario, author) DO UPDATE SET json = excluded.json, saved_at = excluded.saved_at",
        scenario, actor.id, json, c_.clock());
  }
  if (auto done = transaction.commit(); !done) return std::unexpected(done.error());
  return mine ? DraftSave::kept : DraftSave::changed_elsewhere;
}

namespace {
ScenarioDraft draft_of(Row row) { return {row.id<ScenarioId>(0), row.id<UserId>(1), row.text(2), row.integer(3)}; }
}  // namespace

Stored<std::optional<ScenarioDraft>> Scenarios::draft(const Actor& actor, ScenarioId scenario) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  return c_.db.first("SELECT scenario, author, json, saved_at FROM scenario_drafts WHERE scenario = ?1 AND author = ?2",
                     draft_of, scenario, actor.id);
}

Stored<std::vector<ScenarioDraft>> Scenarios::drafts(const Actor& actor) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  return c_.db.all(
      "SELECT scenario, author, json, saved_at FROM scenario_drafts WHERE author = ?1 ORDER BY saved_at DESC", draft_of,
      actor.id);
}

Stored<bool> Scenarios::has_draft(ScenarioId scenario) {
  const auto draft = c_.db.first("SELECT 1 FROM scenario_drafts WHERE scenario = ?1 LIMIT 1", [](Row) { return true; }, scenario);
  if (!draft) return std::unexpected(draft.error());
  return draft->has_value();
}

Stored<DraftSave> Scenarios::drop_draft(const Actor& actor, ScenarioId scenario, const std::string& before) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  Transaction transaction(c_.db);
  const auto there = draft_json(transaction, scenario, actor.id);
  const bool mine = !there || there == before;
  if (mine) transaction.run("DELETE FROM scenario_drafts WHERE scenario = ?1 AND author = ?2", scenario, actor.id);
  if (auto done = transaction.commit(); !done) return std::unexpected(done.error());
  return mine ? DraftSave::kept : DraftSave::changed_elsewhere;
}

}  // namespace cusp::storage
