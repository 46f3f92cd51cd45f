// cusp appeal DB SESSION FILE, cusp verify FILE [--db DB] [--replay]

#include <nlohmann/json.hpp>

#include "ui/cli/account.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"
#include "ui/report/appeal_pack.h"

namespace cusp::ui {
namespace {

struct AppealOptions {
  std::string db, session, file;
  bool replay = false;
  AccountOption account;
  JsonOption json;
};

int write_pack(const AppealOptions& o) {
  const auto id = SessionId::parse(o.session);
  if (!id) return wrong_usage(CliText::tr("%1 is not a session’s id.").arg(QString::fromStdString(o.session)));
  if (const auto no = refuse_outputs({o.file, o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  if (auto done = write_appeal_pack(**store, account->actor(), *id, o.file); !done) return failed(done.error());
  if (!o.json.write({{"session", id->text()}, {"file", o.file}})) return kFailed;
  if (!o.json.on_stdout()) print_line(o.file);
  return kDone;
}

nlohmann::ordered_json json_of(const OpenedPack& pack) {
  nlohmann::ordered_json json;
  json["session"] = pack.checked.description.session.text();
  json["station"] = pack.checked.description.station.text();
  json["made"] = iso_utc(pack.checked.description.made_utc_us);
  json["key"] = storage::hex(pack.checked.key);
  json["known_key"] = pack.signer == PackSigner::this_station;
  json["whole"] = pack.whole();
  json["signature_holds"] = pack.checked.signature_holds;
  json["differing_files"] = pack.differing;
  json["links"] = pack.links;
  json["findings"] = nlohmann::ordered_json::array();
  for (const ChainFinding& f : pack.findings) json["findings"].push_back({{"code", std::string(key_of(f.code))}, {"table", f.table}, {"row", f.row}, {"second", f.second}});
  const auto& counts = pack.report.counts;
  json["score"] = counts ? nlohmann::ordered_json(counts->grade.score) : nullptr;
  json["passed"] = counts ? nlohmann::ordered_json(counts->grade.passed) : nullptr;
  return json;
}

QString what_is_wrong(const OpenedPack& pack) {
  if (!pack.checked.signature_holds) return CliText::tr("The signature does not belong to this pack.");
  if (!pack.differing.empty()) return CliText::tr("%1 is not as it was signed.").arg(QString::fromStdString(pack.differing.front()));
  return finding_text(pack.findings.front());
}

QString signer_text(PackSigner signer) {
  return signer == PackSigner::this_station ? CliText::tr("The station of this database signed it.")
                                            : CliText::tr("This database does not know the key: compare it with that of the pack’s station.");
}

int verify_pack(const AppealOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db, {o.file})) return failed(*no);
  std::unique_ptr<Store> here;
  if (!o.db.empty()) {
    auto store = open_records(o.db);
    if (!store) return failed(store.error());
    here = std::move(*store);
  }
  const auto pack = open_appeal_pack(o.file, here.get());
  if (!pack) return failed(pack.error());
  auto json = json_of(*pack);
  QString wrong = pack->whole() ? QString() : what_is_wrong(*pack), not_computed;
  if (wrong.isEmpty() && o.replay) {
    const auto proof = prove_pack(*pack);
    if (!proof) return failed(proof.error());
    json["replayed"] = proof->same_engine;
    json["replay_holds"] = proof->holds();
    wrong = proof_text(*proof);
    if (!proof->same_engine) not_computed = not_computed_text(*proof);
  }
  if (!o.json.write(json)) return kFailed;
  if (!wrong.isEmpty()) return failed(wrong);
  if (!o.json.on_stdout()) {
    print_line(plain(CliText::tr("Nothing was changed since this pack was made on %1; key %2.")
                         .arg(QString::fromStdString(iso_utc(pack->checked.description.made_utc_us)), fingerprint(pack->checked.key))));
    if (!not_computed.isEmpty()) print_line(plain(not_computed));
    if (here) print_line(plain(signer_text(pack->signer)));
  }
  return kDone;
}

}  // namespace

void add_appeal(CLI::App& program, Job& job) {
  auto o = std::make_shared<AppealOptions>();
  CLI::App* write = program.add_subcommand("appeal", help(CliText::tr("Saves an attempt as an appeal pack, one file that another station verifies; for staff")));
  write->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  write->add_option("SESSION", o->session, help(CliText::tr("The session's id")))->required();
  write->add_option("FILE", o->file, help(CliText::tr("A new file, NAME.cusppack")))->required()->check(check_file_name);
  o->account.add_to(*write);
  o->json.add_to(*write);
  write->callback([&job, o] { job = [o] { return write_pack(*o); }; });

  auto v = std::make_shared<AppealOptions>();
  CLI::App* verify = program.add_subcommand("verify", help(CliText::tr("Verifies an appeal pack: its signature, its files, and its records")));
  verify->add_option("FILE", v->file, help(CliText::tr("NAME.cusppack")))->required()->check(check_not_empty);
  verify->add_option("--db", v->db, help(CliText::tr("Database that may know the key of the pack")))->type_name("DB")->check(check_not_empty);
  verify->add_flag("--replay", v->replay, help(CliText::tr("Also compute the attempt anew, and compare tooth and grade bit for bit")));
  v->json.add_to(*verify);
  verify->callback([&job, v] { job = [v] { return verify_pack(*v); }; });
}

}  // namespace cusp::ui
