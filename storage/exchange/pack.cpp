#include "storage/exchange/pack.h"

#include "storage/base/files.h"
#include "storage/exchange/json_read.h"
#include "storage/exchange/logged_files.h"
#include "storage/exchange/unnamed_copies.h"
#include "storage/repositories/audit_log.h"
#include "storage/records/current_rights.h"

namespace cusp::storage {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kPackFormat = 1;
constexpr std::string_view kPackLabel = "cusp pack 1";
/// Names of files and hashes take a few hundred bytes.
constexpr std::size_t kMostPackText = 64 * 1024;

std::string pack_text(const PackDescription& d) {
  ordered_json out;
  out["cusp_pack"] = kPackFormat;
  out["station"] = d.station.text();
  out["session"] = d.session.text();
  out["made_by"] = d.maker.text();
  out["made_at"] = d.made_utc_us;
  out["log"] = json_of(d.log);
  out["files"] = json_of(d.files);
  return out.dump(1) + '\n';
}

std::optional<PackDescription> description_from(std::string_view text) {
  if (text.size() > kMostPackText) return std::nullopt;
  const json read = json::parse(text, nullptr, false);
  const auto station = uuid_at(read, "station"), session = uuid_at(read, "session"), maker = uuid_at(read, "made_by");
  const auto made = number_at(read, "made_at");
  if (number_at(read, "cusp_pack") != kPackFormat || !station || !session || !maker || !made) return std::nullopt;
  const auto log = head_at(read, "log");
  auto files = files_at(read, "files");
  if (!log || !files) return std::nullopt;
  return PackDescription{*station, SessionId{*session}, UserId{*maker}, *made, *log, std::move(*files)};
}

}  // namespace

Stored<SignedPack> sign_pack(StorageContext& context, const Actor& actor, SessionId session, std::vector<PackFile> files) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  if (!context.key) return std::unexpected(context.db.unwritable());
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::export_results);
  const auto log = transaction.first("SELECT entries, link FROM audit_head", [](Row row) { return ChainHead{row.u64(0), row.hash(1)}; });
  if (auto done = transaction.commit(); !done) return std::unexpected(done.error());
  const PackDescription description{context.station, session, actor.id, context.clock(), log.value_or(ChainHead{}), std::move(files)};
  return sign_text(*context.key, kPackLabel, pack_text(description));
}

Stored<void> give_out_pack(StorageContext& context, const Actor& actor, SessionId session, std::string_view bytes, const std::filesystem::path& file) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return allowed;
  if (name_earlier_files(context, file)) return fail(StorageError::duplicate, file.filename().string(), "finished");
  const std::string detail = packed_detail(blake2b_256(bytes));
  return make_named(file, [&](const std::filesystem::path& copy, const NoteName& note) -> Stored<void> {
    if (auto written = write_new_file(copy, bytes); !written) return written;
    if (auto noted = note(); !noted) return noted;
    return AuditLog(context).add_if_allowed({.actor = actor.id, .action = "packed", .subject = session.uuid, .detail = detail}, Action::export_results);
  });
}

Stored<CheckedPack> check_pack(const SignedPack& pack) {
  auto description = description_from(pack.description);
  if (!description) return fail(StorageError::bad_value, "description");
  const auto by = check_text(pack, kPackLabel);
  if (!by) return fail(StorageError::bad_value, "signature");
  return CheckedPack{std::move(*description), key_id(by->public_key), by->holds};
}

Stored<PackSigner> signer_of(StorageContext& context, const CheckedPack& pack) {
  const auto known = context.db.first(kSelectOwnKey, [](Row) { return true; }, pack.key);
  if (!known) return std::unexpected(known.error());
  return *known && pack.description.station == context.station ? PackSigner::this_station : PackSigner::other_station;
}

}  // namespace cusp::storage
