// cusp replay [--verify | --at SECONDS] DB SESSION

#include "ui/cli/interrupt.h"
#include "ui/modules.h"
#include "ui/session/replay.h"

#include <nlohmann/json.hpp>

#include "scenarios/import/nrrd.h"
#include "ui/cli/account.h"
#include "ui/cli/outputs.h"
#include "ui/cli/terminal.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"

namespace cusp::ui {

namespace {

struct ReplayOptions {
  std::string db, session, volume;
  bool verify = false;
  std::optional<double> at_s;
  AccountOption account;
  JsonOption json;
};

std::string hex16(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

int verify(const ReplayOptions& o, Store& store, SessionId id) {
  auto proof = prove_session(store, id);
  if (!proof) return failed(describe(proof.error()));
  nlohmann::ordered_json json;
  json["session"] = id.text();
  json["holds"] = proof->holds();
  json["chain_intact"] = proof->chain.intact();
  json["links"] = proof->chain.links;
  json["findings"] = nlohmann::ordered_json::array();
  for (const ChainFinding& f : proof->chain.findings) {
    json["findings"].push_back(
        {{"code", std::string(key_of(f.code))}, {"table", f.table}, {"row", f.row}, {"second", f.second}});
  }
  json["engine"] = proof->engine_version;
  json["same_engine"] = proof->same_engine;
  json["ticks"] = proof->ticks;
  json["seconds_compared"] = proof->seconds_compared;
  json["differs_at_tick"] = proof->differs_at_tick ? nlohmann::ordered_json(*proof->differs_at_tick) : nullptr;
  json["volume_equal"] = proof->has_final_volume ? nlohmann::ordered_json(proof->volume_equal) : nullptr;
  json["grade_equal"] = proof->has_grade ? nlohmann::ordered_json(proof->grade_equal) : nullptr;
  json["grade_differs"] = proof->grade_differs;
  json["volume_hash"] = hex16(proof->volume_hash);
  if (!o.json.write(json)) return kFailed;
  if (!proof->holds()) return failed(proof_text(*proof));
  if (o.json.on_stdout()) return kDone;
  if (!proof->same_engine) {
    print_line(plain(not_computed_text(*proof)));
  } else {
    print_line(plain(CliText::tr("The record is whole; %n tick(s) come to the same tooth and grade, bit for bit.", nullptr,
                           static_cast<int>(proof->ticks))));
  }
  return kDone;
}

/// The last tick that had begun and ended by then.
std::uint64_t tick_at(const std::vector<StepInput>& inputs, double seconds) {
  const double wanted_us = seconds * 1e6;
  double elapsed_us = 0;
  std::uint64_t tick = 0;
  for (const StepInput& input : inputs) {
    elapsed_us += input.elapsed_us;
    if (elapsed_us > wanted_us) break;
    ++tick;
  }
  return tick;
}

int rebuild(const ReplayOptions& o, Store& store, SessionId id) {
  auto opened = open_session(store, id);
  if (!opened) return failed(describe(opened.error()));
  auto replayed = Replay::open(store, std::move(*opened));
  if (!replayed) return failed(describe(replayed.error()));
  catch_interrupt();
  ReplayJump jump;
  jump.from = o.at_s ? ReplayFrom::nearest : ReplayFrom::first_tick;
  jump.keep = true;
  jump.watch = [](double share) {
    show_progress(share);
    return !interrupted();
  };
  auto arrived = replayed->to(o.at_s ? tick_at(replayed->inputs(), *o.at_s) : UINT64_MAX, jump);
  end_progress();
  if (!arrived) return failed(describe(arrived.error()));
  if (!*arrived) return failed(CliText::tr("Stopped. Nothing was changed."));
  const StepState& state = replayed->state();
  if (!o.volume.empty()) {
    if (auto written = write_nrrd(state.volume().dense(), o.volume); !written) return failed(describe(written.error()));
  }
  nlohmann::ordered_json json;
  json["session"] = id.text();
  json["engine"] = kEngineVersion;
  json["ticks"] = state.last().tick;
  json["ticks_run"] = replayed->ticks_computed();
  json["duration_s"] = static_cast<double>(state.last().elapsed_us) / 1e6;
  json["volume_hash"] = hex16(state.volume().hash());
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) print_line(hex16(state.volume().hash()));
  return kDone;
}

int replay(const ReplayOptions& o) {
  if (const auto no = refuse_outputs({o.volume, o.json.file}, o.db)) return failed(*no);
  const auto id = SessionId::parse(o.session);
  if (!id) return wrong_usage(CliText::tr("%1 is not a session’s id.").arg(QString::fromStdString(o.session)));
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  // A record so damaged that its session cannot be found is still to be proved.
  const auto may = (*store)->history.may_read_result(account->actor(), *id);
  if (!may && may.error().code != StorageError::not_found) return failed(describe(may.error()));
  return o.verify ? verify(o, **store, *id) : rebuild(o, **store, *id);
}

}  // namespace

void add_replay(CLI::App& program, Job& job) {
  auto o = std::make_shared<ReplayOptions>();
  CLI::App* verb = program.add_subcommand(
      "replay", help(CliText::tr("Run a stored session again and print the hash of its tooth")));
  auto* verify = verb->add_flag("--verify", o->verify,
                                help(CliText::tr("Prove it: the record's chain, then tooth and grade bit for bit")));
  verb->add_option("--at", o->at_s, help(CliText::tr("Only up to this moment of the session, in seconds")))
      ->type_name("SECONDS")
      ->check(check_not_negative)
      ->excludes(verify);
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  verb->add_option("SESSION", o->session, help(CliText::tr("The session's id")))->required();
  verb->add_option("--volume", o->volume, help(CliText::tr("Write the tooth as it is then (NRRD)")))
      ->type_name("FILE")
      ->check(check_file_name)
      ->excludes(verify);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return replay(*o); }; });
}

}  // namespace cusp::ui
