#include "storage/exchange/trust.h"

#include <algorithm>
#include <array>

#include "storage/base/files.h"
#include "storage/exchange/json_read.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/current_rights.h"

namespace cusp::storage {
namespace {

using nlohmann::json;

constexpr std::string_view kTrustLabel = "cusp station key 1";
constexpr int kKeyFormat = 1;
constexpr std::size_t kMostKeyText = 1024;
constexpr std::array<std::string_view, 4> kRoles = {"station", "office", "former", "revoked"};

KeyRole role_from(std::string_view key) noexcept {
  const auto found = std::ranges::find(kRoles, key);
  return found == kRoles.end() ? KeyRole::revoked : static_cast<KeyRole>(found - kRoles.begin());
}

OtherKey other_key_of(Row row) { return {row.uuid(0), row.hash(1), role_from(row.text(2)), row.integer(3), row.hash(4)}; }

/// The entry names the key, then the row's seal.
void log_key(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action, const Hash256& key) {
  const auto id = transaction.first("SELECT id FROM other_keys WHERE key = ?1", [](Row row) { return row.uuid(0); }, key);
  if (!id) return;
  const auto seal = row_seals(context.db, SealedTable::other_keys, *id);
  if (!seal || seal->empty()) return transaction.refuse(seal ? StorageFailure{StorageError::not_found, "other_keys"} : seal.error());
  log_event(context, transaction, {.actor = actor, .action = action, .subject = *id, .detail = hex(key) + ' ' + hex(seal->front().seal)});
}

void insert_key(StorageContext& context, Transaction& transaction, const PublicKey& key, KeyRole role) {
  const Hash256 id = key_id(key.bytes);
  transaction.run("INSERT INTO station_keys (id, public_key, added_at) VALUES (?1, ?2, ?3)", id, key.bytes, context.clock());
  transaction.run("INSERT INTO other_keys (id, station, key, role, changed_at) VALUES (?1, ?2, ?3, ?4, ?5)", Uuid::v7(), key.station, id,
                  key_of(role), context.clock());
}

bool own(Transaction& transaction, const Hash256& key) {
  return transaction.first(kSelectOwnKey, [](Row) { return true; }, key).value_or(false);
}

}  // namespace

std::string_view key_of(KeyRole role) noexcept { return kRoles[static_cast<std::size_t>(role)]; }

Stored<SignedText> own_key(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  if (!context.key) return std::unexpected(context.db.unwritable());
  nlohmann::ordered_json out;
  out["cusp_station_key"] = kKeyFormat;
  out["station"] = context.station.text();
  return sign_text(*context.key, kTrustLabel, out.dump());
}

Stored<PublicKey> public_key_from(const SignedText& text) {
  const json read = text.description.size() > kMostKeyText ? json{} : json::parse(text.description, nullptr, false);
  const auto station = uuid_at(read, "station");
  if (number_at(read, "cusp_station_key") != kKeyFormat || !station) return fail(StorageError::bad_value, "description");
  const auto by = check_text(text, kTrustLabel);
  if (!by || !by->holds) return fail(StorageError::bad_value, "signature");
  return PublicKey{*station, by->public_key};
}

std::string key_file_of(const SignedText& text) { return text.description + '\n' + text.signature; }

Stored<PublicKey> public_key_in(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) return fail(StorageError::bad_value, "description");
  const auto content = read_private_file(file);
  if (!content) return std::unexpected(content.error());
  if (!*content) return fail(StorageError::not_found, file.string());
  const std::string_view text = **content;
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return fail(StorageError::bad_value, "description");
  return public_key_from({std::string(text.substr(0, end)), std::string(text.substr(end + 1))});
}

std::optional<OtherKey> other_key(Transaction& transaction, const Hash256& key) {
  return transaction.first("SELECT o.station, o.key, o.role, o.changed_at, k.public_key FROM other_keys o JOIN station_keys k ON k.id = o.key WHERE o.key = ?1", other_key_of, key);
}

Stored<void> trust(StorageContext& context, const Actor& actor, const PublicKey& key, KeyRole role) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return allowed;
  if (role != KeyRole::station && role != KeyRole::office) return fail(StorageError::bad_value, "role");
  const Hash256 id = key_id(key.bytes);
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_station);
  if (key.station == context.station || own(transaction, id)) transaction.refuse({StorageError::not_allowed, "own_key", hex(id)});
  const auto known = other_key(transaction, id);
  if (known && known->station != key.station) transaction.refuse({StorageError::differs, "other_keys", hex(id)});
  if (!known) {
    insert_key(context, transaction, key, role);
  } else {
    transaction.run("UPDATE other_keys SET role = ?2, changed_at = ?3 WHERE key = ?1", id, key_of(role), context.clock());
  }
  log_key(context, transaction, actor.id, known ? "key_role_changed" : "key_trusted", id);
  return commit_sealed(context, transaction);
}

Stored<void> revoke(StorageContext& context, const Actor& actor, const Hash256& key) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return allowed;
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_station);
  if (!other_key(transaction, key)) transaction.refuse({StorageError::not_found, "other_keys", hex(key)});
  transaction.run("UPDATE other_keys SET role = ?2, changed_at = ?3 WHERE key = ?1", key, key_of(KeyRole::revoked), context.clock());
  log_key(context, transaction, actor.id, "key_revoked", key);
  return commit_sealed(context, transaction);
}

Stored<std::vector<OtherKey>> other_keys(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  return context.db.all("SELECT o.station, o.key, o.role, o.changed_at, k.public_key FROM other_keys o JOIN station_keys k ON k.id = o.key ORDER BY o.id", other_key_of);
}

void keep_former_key(StorageContext& context, Transaction& transaction, UserId actor, const PublicKey& key) {
  const Hash256 id = key_id(key.bytes);
  if (!transaction.ok() || other_key(transaction, id)) return;
  if (own(transaction, id)) return transaction.refuse({StorageError::differs, "station_keys", hex(id)});
  insert_key(context, transaction, key, KeyRole::former);
  log_key(context, transaction, actor, "key_kept", id);
}

}  // namespace cusp::storage
