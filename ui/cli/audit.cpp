// cusp audit SCENARIO [--seeds N] [--detail] [--apply [-o FILE]] [--json FILE]

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "scenarios/audit/audit_json.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "storage/base/files.h"
#include "ui/cli/load_scenario.h"
#include "ui/cli/outputs.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/cli/interrupt.h"
#include "ui/modules.h"
#include "ui/session/audit_run.h"
#include "ui/text/audit_text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

namespace {

struct AuditOptions {
  std::string scenario, out;
  int seeds = 2;
  bool apply = false, detail = false, progress = false;
  JsonOption json;
};

void print(const AuditReport& report) {
  const auto line = [](const QString& name, const QString& verdict, const QString& us, const QString& mb, const QString& start,
                       const QString& force, const QString& score) {
    print_line(plain(u"%1 %2 %3 %4 %5 %6 %7"_qs.arg(name, -38).arg(verdict, -14).arg(us, 8).arg(mb, 8).arg(start, 8).arg(force, 13).arg(score, 7)));
  };
  line(CliText::tr("Choice"), {}, CliText::tr("µs"), CliText::tr("MB"), CliText::tr("start, s"), CliText::tr("force, N"),
       CliText::tr("score"));
  const auto number = [](double v, int digits) { return QLocale().toString(v, 'f', digits); };
  const auto megabytes = [&](const ModelResult& r) { return number(static_cast<double>(r.cost.bytes) / 1e6, 1); };
  const ModelResult& as_set = report.as_set;
  line(CliText::tr("as it is set"), {}, number(as_set.cost.us_a_tick, 1), megabytes(as_set), number(as_set.cost.start_s, 2), {}, {});
  for (const AuditRow& row : report.rows) {
    const QString name = choice_name(row.choice), verdict = verdict_name(row.verdict);
    if (!row.result) {
      line(name, verdict, {}, {}, {}, {}, {});
      continue;
    }
    const ModelResult& r = *row.result;
    line(name, verdict, number(r.cost.us_more, 1), megabytes(r), number(r.cost.start_s, 2),
         number(r.force_rms_n, 3) + u" / "_qs + number(r.force_most_n, 2), number(row.change.score, 2));
  }
  print_line(plain(CliText::tr("µs: CPU time of an update; below the first row what it takes more or less. Force: rms and most of its change "
                         "on the same path. Score: the largest change of an operator’s attempt.")));
  if (!report.as_set.cost.instructions_a_tick)
    print_line(plain(CliText::tr("This machine does not count instructions, so only times are shown.")));
  print_line(plain(leanest_sentence(report)));
}

/// Asked before what takes minutes. Leaves nothing. No failure of a pipe or a device, which is not opened.
Stored<void> can_be_written(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status there = std::filesystem::status(file, error);
  const bool exists = std::filesystem::exists(there);
  if (exists && !std::filesystem::is_regular_file(there) && !std::filesystem::is_directory(there)) return {};
  if (auto begun = can_begin(file); !begun) return begun;
  if (auto fits = writable_folder(file.has_parent_path() ? file.parent_path() : "."); !fits) return fits;
  errno = 0;
  // A file that its owner has locked is not to be replaced either.
  if (!exists || std::ofstream(file, std::ios::binary | std::ios::app).good()) return {};
  return fail(error_from_errno(errno), file.string(), std::generic_category().message(errno));
}

/// Whether what is written takes the place of the exercise: without -o, or where -o names the exercise itself.
bool replaces(const AuditOptions& o, const std::filesystem::path& file) {
  std::error_code error;
  return o.out.empty() ||
         std::ranges::any_of(scenario_files(o.scenario), [&](const auto& own) { return std::filesystem::equivalent(own, file, error); });
}

/// Writes the leanest as the next version. Refuses if the exercise was saved after `before` was read: that edit would be lost.
int apply(const AuditOptions& o, const std::filesystem::path& file, const Scenario& before, const AuditReport& report) {
  Scenario leaner = report.leanest;
  if (report.changed()) ++leaner.version;
  if (replaces(o, file)) {
    if (!report.changed()) return kDone;  // nothing to write
    const auto now = load_scenario(o.scenario);
    if (!now || !(now->scenario == before))
      return failed(Message{CliText::tr("%1 was changed while it was audited.").arg(QString::fromStdString(file.string())),
                            CliText::tr("Nothing was written: audit it again.")});
  }
  if (const auto written = write_whole(file, write_scenario(leaner)); !written) return failed(cannot_write(file, written.error().detail));
  if (!o.json.on_stdout())
    print_line(plain(CliText::tr("Written to %1 as version %2.").arg(QString::fromStdString(file.string()), QString::number(leaner.version))));
  return kDone;
}

/// Whether the copy would lack the volume that its exercise names: that lies beside the exercise.
bool leaves_its_volume(const std::filesystem::path& copy, const LoadedScenario& loaded) {
  const auto named = [](const std::filesystem::path& folder) { return folder.empty() ? std::filesystem::path(".") : folder; };
  std::error_code error;
  return loaded.scenario.specimen.generator.empty() &&
         !std::filesystem::equivalent(named(copy.parent_path()), named(loaded.folder), error);
}

int audit_verb(const AuditOptions& o) {
  if (const auto no = refuse_outputs({o.out, o.json.file})) return failed(*no);
  if (const auto no = refuse_outputs({o.json.file}, {}, scenario_files(o.scenario))) return failed(*no);
  const bool builtin = !builtin_scenario_text(o.scenario).empty();
  if (o.apply && builtin && o.out.empty())
    return wrong_usage(CliText::tr("%1 is built in: --apply needs -o FILE for the copy.").arg(QString::fromStdString(o.scenario)));
  if (!o.apply && !o.out.empty()) return wrong_usage(CliText::tr("-o FILE belongs to --apply."));
  auto loaded = load_scenario(o.scenario);
  if (!loaded) return failed(loaded.error());
  std::filesystem::path file(o.out.empty() ? o.scenario : o.out);
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) file /= "scenario.json";
  if (o.apply) {
    if (const auto may = can_be_written(file); !may) return failed(cannot_write(file, may.error().detail));
  }
  if (o.apply && leaves_its_volume(file, *loaded))
    return failed(Message{CliText::tr("The copy needs %1 beside it.").arg(QString::fromStdString(loaded->scenario.specimen.volume)),
                          CliText::tr("Write it into the exercise’s folder.")});
  if (o.json.wanted() && !o.json.on_stdout()) {
    if (const auto may = can_be_written(o.json.file); !may) return failed(cannot_write(o.json.file, may.error().detail));
  }

  AuditSettings settings;
  settings.operators.clear();
  settings.detail_alone = o.detail;
  for (const char* name : {"expert", "competent", "novice"}) {
    for (int seed = 1; seed <= o.seeds; ++seed) settings.operators.push_back({name, static_cast<std::uint64_t>(seed)});
  }
  catch_interrupt();
  int printed = -1;
  const AuditWatch watch = [&](double share) {
    const int percent = static_cast<int>(100 * share);
    if (o.progress && percent > printed) std::fprintf(stderr, "%d %%\n", printed = percent);
    return !interrupted();
  };
  auto report = audit(loaded->scenario, settings, audit_runner(loaded->folder), watch);
  if (!report) return failed(describe(report.error()));
  if (!o.json.write(nlohmann::ordered_json::parse(audit_json(*report)))) return kFailed;
  if (!o.json.on_stdout()) print(*report);
  return o.apply ? apply(o, file, loaded->scenario, *report) : kDone;
}

}  // namespace

void add_audit(CLI::App& program, Job& job) {
  auto o = std::make_shared<AuditOptions>();
  CLI::App* verb = program.add_subcommand(
      "audit", help(CliText::tr("What each part of an exercise’s model costs and changes, and the leanest model that grades the "
                                 "same; scripted operators drill it many times, which takes minutes")));
  verb->add_option("SCENARIO", o->scenario, help(CliText::tr("A scenario.json, its folder, or a built-in one")))->required()->check(check_not_empty);
  verb->add_option("--seeds", o->seeds, help(CliText::tr("Attempts of each scripted operator: expert, competent and novice")))
      ->transform(decimal)
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  verb->add_flag("--detail", o->detail, help(CliText::tr("Only the size of the voxels: minutes, between neighbouring teeth hours")));
  verb->add_flag("--apply", o->apply, help(CliText::tr("Write the leanest into the scenario, as its next version")));
  verb->add_option("-o,--out", o->out, help(CliText::tr("With --apply: write a copy there")))->type_name("FILE")->check(check_file_name);
  verb->add_flag("--progress", o->progress, help(CliText::tr("Print how far it is to stderr")));
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return audit_verb(*o); }; });
}

}  // namespace cusp::ui
