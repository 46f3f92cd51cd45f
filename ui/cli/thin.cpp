// cusp thin DB

#include <nlohmann/json.hpp>

#include "storage/retention/thinning.h"
#include "ui/cli/account.h"
#include "ui/cli/interrupt.h"
#include "ui/cli/outputs.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"
#include "ui/text/thinning_text.h"

namespace cusp::ui {
namespace {

struct ThinOptions {
  std::string db;
  int older_than_days = kThinAfterDays;
  bool dry_run = false;
  ClockOption clock;
  AccountOption account;
  JsonOption json;
};

nlohmann::ordered_json json_of(const ThinOptions& o, const ThinningReport& report) {
  nlohmann::ordered_json json;
  json["older_than_days"] = o.older_than_days;
  json["dry_run"] = o.dry_run;
  json["attempts"] = report.attempts;
  json["bytes"] = report.bytes;
  json["kept"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < report.kept.size(); ++i) json["kept"][std::string(key_of(static_cast<KeptBecause>(i)))] = report.kept[i];
  json["broken"] = nlohmann::ordered_json::array();
  for (const ChainFinding& f : report.broken) {
    json["broken"].push_back({{"session", f.owner.text()}, {"code", std::string(key_of(f.code))}, {"table", f.table}, {"row", f.row}, {"second", f.second}});
  }
  json["failed"] = report.failed ? 1 : 0;  // the first failure ends the run
  json["left"] = report.left;
  json["stopped"] = report.stopped;
  return json;
}

int thin(const ThinOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  const ThinningMode mode = o.dry_run ? ThinningMode::dry_run : ThinningMode::carry_out;
  catch_interrupt();
  const auto report = thin_traces((*store)->context(), account->actor(), {o.older_than_days, mode, o.clock.trust()},
                                  [](std::size_t, std::size_t) { return !interrupted(); });
  if (!report) return failed_by_age(report.error());
  if (report->doubt && !o.clock.is_right) return failed_by_age(*report->doubt);
  const bool written = o.json.write(json_of(o, *report));
  // Also if the file cannot be written: nothing else reports what went.
  if (!o.json.on_stdout()) {
    print_line(plain(thinned_text(*report, mode)));
    if (const QString kept = kept_text(report->kept); !kept.isEmpty()) print_line(plain(kept));
  }
  if (report->failed) return failed(describe(*report->failed));
  if (report->stopped) return failed(CliText::tr("Stopped before the last recording. Every recording is whole or thinned."));
  if (report->broken.empty()) return written ? kDone : kFailed;
  const ChainFinding& first = report->broken.front();
  return failed(CliText::tr("%n attempt(s) cannot be verified and stayed as they are, %1 first: %2", nullptr, static_cast<int>(report->broken.size()))
                    .arg(QString::fromStdString(first.owner.text()), finding_text(first)));
}

}  // namespace

void add_thin(CLI::App& program, Job& job) {
  auto o = std::make_shared<ThinOptions>();
  CLI::App* verb = program.add_subcommand(
      "thin", help(CliText::tr("Takes the recordings of old practice attempts out; grades and final teeth stay; for administrators")));
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  verb->add_option("--older-than", o->older_than_days, help(CliText::tr("Days since an attempt ended")))
      ->type_name("DAYS")
      ->transform(decimal)
      ->check(CLI::Range(1, kMostThinAfterDays))
      ->capture_default_str();
  verb->add_flag("--dry-run", o->dry_run, help(CliText::tr("Only say what would go, and what stays and why")));
  o->clock.add_to(*verb);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return thin(*o); }; });
}

}  // namespace cusp::ui
