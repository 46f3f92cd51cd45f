// cusp play SCENARIO --script expert|competent|novice|FILE [--db DB] [--as NAME] --out DIR

#include <cstdio>
#include <nlohmann/json.hpp>

#include "device/scripted/csv_port.h"
#include "scenarios/library/library.h"
#include "scenarios/operators/faults.h"
#include "scenarios/operators/operator_port.h"
#include "ui/cli/account.h"
#include "ui/cli/load_scenario.h"
#include "ui/cli/outputs.h"
#include "ui/cli/play_live.h"
#include "ui/cli/report_files.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/cli/interrupt.h"
#include "ui/modules.h"
#include "ui/session/play_through.h"
#include "ui/session/scene_builder.h"
#include "ui/settings/device_settings.h"
#include "ui/text/device_text.h"

namespace cusp::ui {

namespace {

struct PlayOptions {
  std::string scenario, script = "expert", out, db;
  std::uint64_t seed = 1;
  bool progress = false, script_typed = false, seed_typed = false;
  std::string device;
  double seconds = 0, silence_every_s = 0;
  AccountOption account;
  JsonOption json;
};

/// "channel-1, channel-2, …": all that the program comes with.
QString builtins() {
  QStringList keys;
  for (const std::string_view key : builtin_scenarios()) keys.push_back(QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size())));
  return keys.join(u", "_qs);
}

/// "falcon:FT000001": the kind, and which of several; with what this station knows of it.
DeviceChoice device_of(const std::string& text) {
  const auto colon = text.find(':');
  return DeviceSettings().choice_of(text.substr(0, colon), colon == std::string::npos ? std::string() : text.substr(colon + 1));
}

/// What stands against playing live; nullopt: nothing.
std::optional<int> check_device(const PlayOptions& o, const DeviceChoice& device, const SessionPlan& plan) {
  if (!can_play_live(device)) return wrong_usage(CliText::tr("--device has to be falcon, falcon:NAME or emulated-falcon."));
  if (device.kind != "emulated-falcon") {
    if (o.silence_every_s > 0) return wrong_usage(CliText::tr("--silence-every belongs to --device emulated-falcon."));
    if (o.script_typed || o.seed_typed) return wrong_usage(CliText::tr("--script and --seed belong to a scripted operator: a person holds this device."));
    return std::nullopt;
  }
  const auto scripted = operator_by_name(o.script, plan.scenario, *plan.specimen, o.seed);
  if (!scripted) return wrong_usage(CliText::tr("An emulated Falcon needs a scripted operator by name: expert, novice and so on."));
  if (scripted->plan().strokes.empty()) return failed(no_plan_text(plan.scenario));
  return std::nullopt;
}

/// Bytes of a recording: five hours of a row a millisecond, of 50 bytes. It is read into memory.
constexpr std::uintmax_t kMostScript = std::uintmax_t{1} << 30;

/// The port that --script names, a scripted operator or a file; a status where it is neither.
std::optional<int> take_script(const PlayOptions& o, SessionPlan& plan, PlaySettings& settings, std::unique_ptr<HapticPort>& port) {
  if (auto scripted = operator_by_name(o.script, plan.scenario, *plan.specimen, o.seed)) {
    if (scripted->plan().strokes.empty()) return failed(no_plan_text(plan.scenario));
    port = std::make_unique<OperatorPort>(std::move(*scripted));
    plan.operator_name = o.script;
    return std::nullopt;
  }
  if (o.seed_typed) return wrong_usage(CliText::tr("--seed belongs to a scripted operator, and %1 is none.").arg(QString::fromStdString(o.script)));
  const std::filesystem::path file(o.script);
  std::error_code error;
  if (const auto bytes = std::filesystem::file_size(file, error); !error && bytes > kMostScript)
    return failed(describe(ImportFailure{ImportError::too_large, o.script, {}}));
  auto trace = std::make_unique<CsvPort>(file, Pacing::at_once);
  // Each row brings its own length; the loop asks once a sample, in order.
  settings.elapsed_us = [rows = trace.get(), next = std::size_t{0}]() mutable { return rows->rows()[next++].elapsed_us; };
  // Known to be good before a session begins.
  if (auto opened = trace->open(); !opened) {
    if (opened.error().code == PortError::not_found) return failed(describe(ImportFailure{ImportError::missing_file, o.script, {}}));
    if (opened.error().code == PortError::bad_file) return failed(describe(opened.error()));
    // describe(PortFailure) speaks of a device.
    return failed(describe(ImportFailure{ImportError::io, o.script, {}}));
  }
  trace->close();
  port = std::move(trace);
  plan.operator_name = file.filename().string();
  return std::nullopt;
}

int play(const PlayOptions& o) {
  if (o.device.empty() && (o.seconds > 0 || o.silence_every_s > 0))
    return wrong_usage(CliText::tr("--seconds and --silence-every belong to --device."));
  const std::filesystem::path folder(o.out), database = o.db.empty() ? folder / "cusp.db" : std::filesystem::path(o.db);
  std::vector<std::filesystem::path> outputs = report_files_in(folder);
  outputs.emplace_back(o.json.file);
  std::vector<std::filesystem::path> inputs = scenario_files(o.scenario);
  inputs.emplace_back(o.script);
  if (const auto no = refuse_outputs(outputs, database, inputs)) return failed(*no);
  auto loaded = load_scenario(o.scenario);
  if (!loaded) return failed(loaded.error());
  if (const auto fits = writable_folder(folder); !fits) return failed(nothing_written_to(o.out, fits.error().detail));

  SessionPlan plan;
  plan.scenario = std::move(loaded->scenario);
  plan.scenario_folder = loaded->folder;
  plan.database = database;
  auto specimen = build_specimen(plan.scenario, plan.scenario_folder);
  if (!specimen) return failed(describe(specimen.error()));
  plan.specimen = std::move(*specimen);

  PlaySettings settings;
  std::unique_ptr<HapticPort> port;
  const bool live = !o.device.empty();
  const DeviceChoice device = device_of(o.device);
  if (const auto status = live ? check_device(o, device, plan) : take_script(o, plan, settings, port)) return *status;

  auto store = Store::open(plan.database);
  if (!store) return failed(describe(store.error()));
  auto account = sign_in(**store, o.account, WithoutAccounts::make_demo);
  if (!account) return failed(account.error());
  plan.student = account->actor();

  catch_interrupt();
  settings.go_on = [&o](std::uint64_t elapsed_us) {
    if (o.progress) std::fprintf(stderr, "%.3f\n", static_cast<double>(elapsed_us) * 1e-6);
    return !interrupted();
  };
  LiveFigures figures;
  const LiveOptions options{.script = o.script, .seed = o.seed, .seconds = o.seconds, .silence_every_s = o.silence_every_s,
                            .progress = o.progress};
  auto result = live ? play_live(std::move(plan), device, options, [] { return interrupted(); }, figures)
                     : play_through(std::move(plan), *port, settings);
  if (!result) return failed(describe_on_device(result.error(), device.kind));

  const ReportOrder order{.student = *account, .reader = account->actor()};
  if (auto written = write_report_files(folder, *result, **store, order); !written) return failed(written.error());
  auto json = nlohmann::ordered_json::parse(report_text(*result, **store, *account));
  if (live) json["live"] = to_json(figures);
  if (!o.json.write(json)) return kFailed;
  if (!o.json.on_stdout()) print_line(result->session.text());
  return kDone;
}

}  // namespace

void add_play(CLI::App& program, Job& job) {
  auto o = std::make_shared<PlayOptions>();
  CLI::App* verb = program.add_subcommand(
      "play", help(CliText::tr("Let a scripted operator do an exercise: keeps the session and writes report.json, report.pdf "
                                "and tooth.png; prints the session's id")));
  verb->add_option("SCENARIO", o->scenario, help(CliText::tr("A scenario.json, its folder, or a built-in one: %1").arg(builtins())))
      ->required()
      ->check(check_not_empty);
  const CLI::Option* script = verb->add_option("--script", o->script,
                   help(CliText::tr("expert, competent, novice, too_deep, too_shallow, shaky, off_outline, pulp, dry, or a CSV file of inputs")))
      ->type_name("HAND")
      ->capture_default_str();
  const CLI::Option* seed = verb->add_option("--seed", o->seed, help(CliText::tr("Of the scripted operator's tremor")))->transform(decimal)->check(check_whole)->capture_default_str();
  verb->add_flag("--progress", o->progress, help(CliText::tr("Print each second of the session to stderr as it is played")));
  verb->add_option("--device", o->device,
                   help(CliText::tr("Play in real time on a device: falcon, falcon:NAME (held by a person) or emulated-falcon "
                                     "(led by the scripted operator)")))
      ->type_name("DEVICE")
      ->check(check_not_empty);
  verb->add_option("--seconds", o->seconds, help(CliText::tr("With --device: end after so many seconds of the session; the "
                                                              "scripted operator begins anew meanwhile")))
      ->check(check_positive);
  verb->add_option("--silence-every", o->silence_every_s,
                   help(CliText::tr("With the emulated Falcon: it answers nothing for 50 ms every so many seconds")))
      ->check(check_positive);
  verb->add_option("--db", o->db, help(CliText::tr("Database; made when it is not there. Without it: cusp.db in DIR")))
      ->type_name("DB")
      ->check(check_not_empty);
  verb->add_option("--out", o->out, help(CliText::tr("Folder for the report")))->type_name("DIR")->required()->check(check_not_empty);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o, script, seed] {
    o->script_typed = script->count() > 0;
    o->seed_typed = seed->count() > 0;
    job = [o] { return play(*o); };
  });
}

}  // namespace cusp::ui
