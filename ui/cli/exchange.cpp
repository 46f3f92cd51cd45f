// cusp exchange key|trust|keys|out|in

#include "storage/exchange/exchange.h"

#include <nlohmann/json.hpp>

#include "storage/base/clock.h"
#include "storage/exchange/trust.h"
#include "ui/cli/account.h"
#include "ui/cli/interrupt.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"
#include "ui/text/exchange_text.h"

namespace cusp::ui {
namespace {

using nlohmann::ordered_json;

struct ExchangeOptions {
  std::string db, file;
  bool office = false, results = false, revoke = false;
  AccountOption account;
  JsonOption json;
};

/// The records, and who acts on them.
struct Signed {
  std::unique_ptr<Store> store;
  Actor actor;
};

Result<Signed, Message> sign_in_to(const ExchangeOptions& o) {
  auto store = open_records(o.db);
  if (!store) return std::unexpected(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return std::unexpected(account.error());
  return Signed{std::move(*store), account->actor()};
}

QString named(const std::string& file) { return QString::fromStdString(file); }

/// The text that another station trusts: two lines.
int write_key(const ExchangeOptions& o) {
  if (const auto no = refuse_outputs({o.file, o.json.file}, o.db)) return failed(*no);
  const auto in = sign_in_to(o);
  if (!in) return failed(in.error());
  const auto key = own_key(in->store->context(), in->actor);
  if (!key) return failed(describe(key.error()));
  if (const auto written = write_whole(o.file, key_file_of(*key)); !written) return failed(cannot_write(o.file, written.error().detail));
  const Hash256 id = in->store->context().key->id();
  if (!o.json.write({{"station", in->store->context().station.text()}, {"key", storage::hex(id)}, {"file", o.file}})) return kFailed;
  if (!o.json.on_stdout()) print_line(plain(CliText::tr("Key %1. The other station’s administrator compares it before trusting %2.").arg(fingerprint(id), named(o.file))));
  return kDone;
}

Result<PublicKey, Message> key_in(const std::string& file) {
  auto key = public_key_in(file);
  if (key) return *key;
  if (auto refused = unreadable(key.error(), file)) return std::unexpected(std::move(*refused));
  return std::unexpected(describe_key_failure(key.error(), named(file)));
}

Message unknown_key(const Hash256& id) { return {CliText::tr("Key %1 is not known here.").arg(fingerprint(id)), CliText::tr("Nothing was changed.")}; }

int trust_key(const ExchangeOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db, {o.file})) return failed(*no);
  const auto in = sign_in_to(o);
  if (!in) return failed(in.error());
  const auto key = key_in(o.file);
  if (!key) return failed(key.error());
  const Hash256 id = key_id(key->bytes);
  StorageContext& context = in->store->context();
  const auto done = o.revoke ? revoke(context, in->actor, id) : trust(context, in->actor, *key, o.office ? KeyRole::office : KeyRole::station);
  if (!done && done.error().code == StorageError::not_found) return failed(unknown_key(id));
  if (!done) return failed(describe(done.error()));
  const KeyRole role = o.revoke ? KeyRole::revoked : o.office ? KeyRole::office : KeyRole::station;
  if (!o.json.write({{"station", key->station.text()}, {"key", storage::hex(id)}, {"role", std::string(key_of(role))}})) return kFailed;
  if (o.json.on_stdout()) return kDone;
  print_line(plain((o.revoke ? CliText::tr("Files under key %1 are no longer read.") : CliText::tr("Files under key %1 are read from now on.")).arg(fingerprint(id))));
  return kDone;
}

int list_keys(const ExchangeOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  const auto in = sign_in_to(o);
  if (!in) return failed(in.error());
  const auto keys = other_keys(in->store->context(), in->actor);
  if (!keys) return failed(describe(keys.error()));
  ordered_json list = ordered_json::array();
  for (const OtherKey& key : *keys) {
    const std::string role(key_of(key.role)), since = iso_utc(key.changed_utc_us);
    list.push_back({{"station", key.station.text()}, {"key", storage::hex(key.key)}, {"role", role}, {"since", since}});
    if (!o.json.on_stdout()) print_line(plain(fingerprint(key.key)) + "  " + role + "  " + since + "  " + key.station.text());
  }
  return o.json.write({{"keys", list}}) ? kDone : kFailed;
}

ordered_json json_of(const ExchangeDescription& d, const Hash256& key, const ExchangeCounts& counts) {
  ordered_json json;
  json["station"] = d.station.text();
  json["key"] = storage::hex(key);
  json["kind"] = std::string(key_of(d.kind));
  json["number"] = d.number();
  json["made"] = iso_utc(d.made_utc_us);
  json["sessions"] = counts.sessions;
  json["statements"] = counts.statements;
  json["accounts"] = counts.accounts;
  json["versions"] = counts.versions;
  json["assignments"] = counts.assignments;
  return json;
}

/// If the folder of the new file is not there, or takes no file: the system's reason.
std::optional<std::string> reason_of_place(const StorageFailure& failure, const std::string& file) {
  const bool concerns_place = failure.code == StorageError::not_found || (failure.code == StorageError::read_only && failure.where == file);
  if (!concerns_place) return std::nullopt;
  const auto begun = can_begin(file);
  return begun ? std::nullopt : std::optional(begun.error().detail);
}

int write_file(const ExchangeOptions& o) {
  if (o.office == o.results) return wrong_usage(CliText::tr("Either --office or --results says what the file carries."));
  if (const auto no = refuse_outputs({o.file, o.json.file}, o.db)) return failed(*no);
  const auto in = sign_in_to(o);
  if (!in) return failed(in.error());
  catch_interrupt();
  const auto made = give_out(in->store->context(), in->actor, o.office ? ExchangeKind::office : ExchangeKind::results, o.file, goes_on_until_interrupt);
  if (!made) {
    const auto reason = reason_of_place(made.error(), o.file);
    return failed(reason ? cannot_write(o.file, *reason) : describe_exchange_failure(made.error(), named(o.file)));
  }
  if (!o.json.write(json_of(made->description, made->key, made->counts))) return kFailed;
  if (!o.json.on_stdout()) print_line(plain(CliText::tr("File %1 under key %2: %3.").arg(made->description.number()).arg(fingerprint(made->key), counts_text(made->counts))));
  return kDone;
}

int read_file(const ExchangeOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db, {o.file})) return failed(*no);
  const auto in = sign_in_to(o);
  if (!in) return failed(in.error());
  catch_interrupt();
  const auto read = read_in(in->store->context(), in->actor, o.file, goes_on_until_interrupt);
  if (!read) {
    if (const auto refused = unreadable(read.error(), o.file)) return failed(*refused);
    return failed(describe_exchange_failure(read.error(), named(o.file)));
  }
  auto json = json_of(read->description, read->key, read->counts);
  json["outcome"] = std::string(key_of(read->outcome));
  json["waiting"] = read->waiting;
  json["conflicts"] = read->conflicts;
  json["gave_way"] = read->gave_way;
  json["apart"] = ordered_json::array();
  for (const SessionId& session : read->apart) json["apart"].push_back(session.text());
  if (!o.json.write(json)) return kFailed;
  if (o.json.on_stdout()) return kDone;
  print_line(plain(outcome_text(read->outcome)));
  for (const QString& line : read_in_text(*read)) print_line(plain(line));
  return kDone;
}

void add_shared(CLI::App& part, ExchangeOptions& o) {
  part.add_option("--db", o.db, help(CliText::tr("Database")))->required()->type_name("DB")->check(check_not_empty);
  o.account.add_to(part);
  o.json.add_to(part);
}

}  // namespace

void add_exchange(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand("exchange", help(CliText::tr("Files from station to station, without a server; for administrators")));
  verb->require_subcommand(1);
  const auto part = [&](const char* name, const QString& does, const QString& file, int (*run)(const ExchangeOptions&)) {
    auto o = std::make_shared<ExchangeOptions>();
    CLI::App* made = verb->add_subcommand(name, help(does));
    add_shared(*made, *o);
    if (!file.isEmpty()) made->add_option("FILE", o->file, help(file))->required()->check(check_not_empty);
    made->callback([&job, o, run] { job = [o, run] { return run(*o); }; });
    return std::pair{made, o};
  };
  part("key", CliText::tr("Writes this station’s public key, for others to trust"), CliText::tr("Where the key is written"), write_key)
      .first->get_option("FILE")
      ->check(check_file_name);
  part("keys", CliText::tr("Lists the other stations’ keys that are known here"), {}, list_keys);
  const auto [trusts, t] = part("trust", CliText::tr("Makes a station’s key known here, after its fingerprint was compared"), CliText::tr("A key that “exchange key” wrote"), trust_key);
  CLI::Option* office = trusts->add_flag("--office", t->office, help(CliText::tr("Its files may also bring accounts, cohorts, assignments and exercises")));
  trusts->add_flag("--revoke", t->revoke, help(CliText::tr("No longer read files under this key")))->excludes(office);
  const auto [out, o] = part("out", CliText::tr("Writes a signed file for other stations"), CliText::tr("A new file"), write_file);
  out->get_option("FILE")->check(check_file_name);
  out->add_flag("--office", o->office, help(CliText::tr("Accounts, cohorts, assignments, exercises and statements of this station")));
  out->add_flag("--results", o->results, help(CliText::tr("Attempts and statements of this station")));
  part("in", CliText::tr("Reads another station’s file whole, or changes nothing"), CliText::tr("A file that “exchange out” wrote"), read_file);
}

}  // namespace cusp::ui
