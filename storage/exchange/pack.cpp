#include "storage/exchange/pack.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <span>

#include "storage/records/sealing.h"
#include "storage/records/audit_writer.h"

namespace cusp::storage {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kPackFormat = 1;
constexpr std::string_view kKeyLabel = "key ", kSignatureLabel = "\nsignature ";
/// Names of files and hashes take a few hundred bytes.
constexpr std::size_t kMostDescription = 64 * 1024;

Hash256 message_of(std::string_view description) {
  return Blake2b{}.add_text("cusp pack 1").add_text(description).finish();
}

template <std::size_t N>
std::string hex_of(const std::array<std::uint8_t, N>& bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out;
  for (const std::uint8_t byte : bytes) out += {digits[byte >> 4], digits[byte & 15]};
  return out;
}

template <std::size_t N>
std::optional<std::array<std::uint8_t, N>> bytes_from(std::string_view hex) {
  std::array<std::uint8_t, N> out{};
  if (hex.size() != 2 * N) return std::nullopt;
  for (std::size_t i = 0; i < N; ++i) {
    const char* at = hex.data() + 2 * i;
    if (std::from_chars(at, at + 2, out[i], 16).ptr != at + 2) return std::nullopt;
  }
  return out;
}

std::string text_of(const PackDescription& d) {
  ordered_json files = ordered_json::object();
  for (const PackFile& file : d.files) files[file.name] = hex(file.hash);
  ordered_json log;
  log["entries"] = d.log.links;
  log["link"] = hex(d.log.link);
  ordered_json out;
  out["cusp_pack"] = kPackFormat;
  out["station"] = d.station.text();
  out["session"] = d.session.text();
  out["made_by"] = d.maker.text();
  out["made_at"] = d.made_utc_us;
  out["log"] = log;
  out["files"] = files;
  return out.dump(1) + '\n';
}

/// Of a member that is missing or no text: nullopt.
std::optional<std::string> text_at(const json& from, const char* key) {
  if (!from.is_object()) return std::nullopt;
  const auto it = from.find(key);
  return it != from.end() && it->is_string() ? std::optional(it->get<std::string>()) : std::nullopt;
}
std::optional<std::int64_t> number_at(const json& from, const char* key) {
  if (!from.is_object()) return std::nullopt;
  const auto it = from.find(key);
  return it != from.end() && it->is_number_integer() ? std::optional(it->get<std::int64_t>()) : std::nullopt;
}
std::optional<Hash256> hash_at(const json& from, const char* key) {
  const auto text = text_at(from, key);
  return text ? hash_from_hex(*text) : std::nullopt;
}
std::optional<Uuid> uuid_at(const json& from, const char* key) {
  const auto text = text_at(from, key);
  return text ? Uuid::parse(*text) : std::nullopt;
}

std::optional<std::vector<PackFile>> files_from(const json& from) {
  if (!from.is_object()) return std::nullopt;
  std::vector<PackFile> out;
  for (const auto& [name, value] : from.items()) {
    const auto hash = hash_at(from, name.c_str());
    if (!hash) return std::nullopt;
    out.push_back({name, *hash});
  }
  return out;
}

std::optional<PackDescription> description_from(std::string_view text) {
  if (text.size() > kMostDescription) return std::nullopt;
  const json read = json::parse(text, nullptr, false);
  const auto station = uuid_at(read, "station"), session = uuid_at(read, "session"), maker = uuid_at(read, "made_by");
  const auto made = number_at(read, "made_at");
  if (number_at(read, "cusp_pack") != kPackFormat || !station || !session || !maker || !made) return std::nullopt;
  const json log = read.value("log", json{});
  const auto entries = number_at(log, "entries");
  const auto link = hash_at(log, "link");
  auto files = files_from(read.value("files", json{}));
  if (!entries || *entries < 0 || !link || !files) return std::nullopt;
  return PackDescription{*station, SessionId{*session}, UserId{*maker}, *made, {static_cast<std::uint64_t>(*entries), *link}, std::move(*files)};
}

struct KeyAndSignature {
  std::array<std::uint8_t, 32> key{};
  Signature signature{};
};

std::string text_of(const KeyAndSignature& s) {
  return std::string(kKeyLabel) + hex_of(s.key) + std::string(kSignatureLabel) + hex_of(s.signature) + '\n';
}

std::optional<KeyAndSignature> signature_from(std::string_view text) {
  constexpr std::size_t key_at = kKeyLabel.size(), label_at = key_at + 64, signature_at = label_at + kSignatureLabel.size();
  if (text.size() != signature_at + 128 + 1 || !text.starts_with(kKeyLabel) || text.substr(label_at, kSignatureLabel.size()) != kSignatureLabel)
    return std::nullopt;
  const auto key = bytes_from<32>(text.substr(key_at, 64));
  const auto signature = bytes_from<64>(text.substr(signature_at, 128));
  if (!key || !signature) return std::nullopt;
  return KeyAndSignature{*key, *signature};
}

}  // namespace

Stored<SignedPack> sign_pack(StorageContext& context, const Actor& actor, SessionId session, std::vector<PackFile> files) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  if (!context.key) return fail(StorageError::read_only, context.db.file().string());
  Transaction transaction(context.db);
  log_event(context, transaction, {.actor = actor.id, .action = "packed", .subject = session.uuid, .detail = {}});
  const auto log = transaction.first("SELECT entries, link FROM audit_head", [](Row row) { return ChainHead{row.u64(0), row.hash(1)}; });
  if (auto done = commit_sealed(context, transaction); !done) return std::unexpected(done.error());
  const PackDescription description{context.station, session, actor.id, context.clock(), log.value_or(ChainHead{}), std::move(files)};
  SignedPack out{.description = text_of(description), .signature = {}};
  out.signature = text_of(KeyAndSignature{context.key->public_key, context.key->sign(message_of(out.description))});
  return out;
}

Stored<CheckedPack> check_pack(const SignedPack& pack) {
  auto description = description_from(pack.description);
  if (!description) return fail(StorageError::bad_value, "description");
  const auto by = signature_from(pack.signature);
  if (!by) return fail(StorageError::bad_value, "signature");
  return CheckedPack{std::move(*description), key_id(by->key), signature_holds(by->key, message_of(pack.description), by->signature)};
}

Stored<PackSigner> signer_of(StorageContext& context, const CheckedPack& pack) {
  const auto known = context.db.first("SELECT 1 FROM station_keys WHERE id = ?1", [](Row) { return true; }, pack.key);
  if (!known) return std::unexpected(known.error());
  return *known && pack.description.station == context.station ? PackSigner::this_station : PackSigner::other_station;
}

}  // namespace cusp::storage
