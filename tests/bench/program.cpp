#include "tests/bench/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/accuracy.h"
#include "tests/bench/cavity.h"
#include "tests/bench/chart.h"
#include "tests/bench/head_courses.h"
#include "tests/bench/heads.h"
#include "tests/bench/latency.h"
#include "tests/bench/names.h"
#include "tests/bench/options.h"
#include "tests/bench/rate.h"
#include "tests/bench/removal.h"
#include "tests/bench/scale.h"
#include "tests/bench/stability.h"

namespace cusp::bench {

namespace {

struct Verb {
  const char* name;
  const char* about;
  int (*run)(const Options&);
  bool writes_folder;  // takes --out
};

constexpr Verb kVerbs[] = {
    {"accuracy", "every contact method against the exact proxy of a ball bur", run_accuracy, false},
    {"heads", "burs that are no balls, with a fixed and a turning axis, against the exact proxy", run_heads, false},
    {"cavity", "balls in a cavity that a trembling hand has milled, against the exact proxy", run_cavity, false},
    {"rate", "updates a second of every method in displacement, exploration and perforation", run_rate, false},
    {"scale", "cost of a tick and memory of a scene from 128^3 to 1024^3 voxels", run_scale, false},
    {"stability", "largest stable stiffness and failures of every method, guard on and off",
     run_stability, false},
    {"removal", "drilling speed, exactness of the cut and cost of a cutting tick", run_removal, false},
    {"latency", "lateness and duration of ticks in real time, with and without drawing", run_latency, false},
    {"chart", "measures every verb, or reads --from, and writes the tables for charts/draw.py", run_chart, true},
};

std::vector<std::string> bur_numbers() {
  std::vector<std::string> out;
  for (const scenarios::CatalogueBur& entry : scenarios::bur_catalogue()) out.push_back(entry.bur.name);
  return out;
}

std::vector<std::string> case_names() {
  std::vector<std::string> out;
  const auto add = [&out](const auto& names) { out.insert(out.end(), names.begin(), names.end()); };
  add(kPressCases);
  add(kMotionCases);
  add(kFaultCases);
  add(kTaskCases);
  return out;
}

void add_options(CLI::App& app, Options& options, const Verb& verb) {
  const std::vector<std::string> methods(kMethodNames.begin(), kMethodNames.end());
  std::vector<std::string> shapes(kShapeNames.begin(), kShapeNames.end());
  shapes.insert(shapes.end(), kHeadShapes.begin(), kHeadShapes.end());
  shapes.emplace_back("cavity");
  app.add_option("--method", options.methods, "only this method (repeatable)")->check(CLI::IsMember(methods));
  app.add_option("--shape", options.shapes, "only this shape (repeatable)")->check(CLI::IsMember(shapes));
  app.add_option("--motion", options.motions, "press or slide; cavity: also cutting (repeatable)")
      ->check(CLI::IsMember(std::vector<std::string>{"press", "slide", "cutting"}));
  app.add_option("--task", options.tasks, "displacement, exploration, perforation or mill (repeatable)")
      ->check(CLI::IsMember(std::vector<std::string>{"displacement", "exploration", "perforation", "mill"}));
  app.add_option("--case", options.cases, "stability: only this case (repeatable)")->check(CLI::IsMember(case_names()));
  app.add_option("--guard", options.guards, "stability: on or off (repeatable)")
      ->check(CLI::IsMember(std::vector<std::string>{"on", "off"}));
  app.add_option("--device", options.devices, "stability: m0.1-b2 is 0.1 kg and 2 N s/m (repeatable)")
      ->check(CLI::IsMember(device_names()));
  app.add_option("--grip", options.grips, "stability: none, soft, firm; or scripted, without a hand (repeatable)")
      ->check(CLI::IsMember(std::vector<std::string>{"none", "soft", "firm", "scripted"}));
  app.add_option("--friction-n", options.frictions_n, "stability: Coulomb friction of the device, 0 or 0.1 (repeatable)")
      ->check(CLI::Range(0.0, 10.0));
  app.add_option("--delay-ms", options.delays_ms, "stability: there and back, 0, 1 or 3 (repeatable)")
      ->check(CLI::Range(0.0, 20.0));
  const std::vector<std::string> measures(kMeasures.begin(), kMeasures.end());
  const std::vector<std::string> tissues(kRemovalTissues.begin(), kRemovalTissues.end());
  app.add_option("--measure", options.measures, "removal: only this (repeatable)")->check(CLI::IsMember(measures));
  app.add_option("--tissue", options.tissues, "removal: only this tissue (repeatable)")->check(CLI::IsMember(tissues));
  app.add_option("--direction", options.directions, "removal: only this feed direction, -z or +x-y (repeatable)")
      ->check(CLI::IsMember(direction_names()));
  app.add_option("--tick-ms", options.ticks_ms, "removal: lengths of a tick (repeatable)")->check(CLI::Range(0.1, 50.0));
  app.add_option("--alpha", options.alphas, "removal: wear coefficients (repeatable)")->check(CLI::Range(0.01, 1.0));
  const std::vector<std::string> axes(kAxisMotions.begin(), kAxisMotions.end());
  app.add_option("--bur", options.burs, "heads, and rate's mill alone: this catalogue number (repeatable)")->check(CLI::IsMember(bur_numbers()));
  app.add_option("--axis", options.axes, "heads: fixed, turning or jitter; mill: fixed or jitter (repeatable)")->check(CLI::IsMember(axes));
  app.add_flag("--full", options.full, "removal: every combination for the 1.0 mm round bur at 0.1 mm, not all pairs; every bur of the "
               "catalogue. stability: k_max on every device, grip, friction and delay, and nothing else. rate: mill with every bur of the "
               "catalogue, and nothing else");
  app.add_option("--speed-mm-s", options.speeds_mm_s, "speeds of slides (repeatable)")->check(CLI::Range(0.01, 2000.0));
  app.add_option("--bur-radius-mm", options.bur_radii_mm, "bur radii (repeatable)")->check(CLI::Range(0.05, 5.0));
  app.add_option("--voxel-mm", options.voxels_mm, "voxel sizes; 0.078 is 10/128 (repeatable)")
      ->check(CLI::Range(0.01, 1.0));
  app.add_option("--budget-s", options.budget_s, "wall clock a row, 1 unless given")->check(CLI::Range(0.001, 3600.0));
  app.add_option("--samples", options.samples, "accuracy and heads: presses or ticks of a slide, not by the budget")->check(CLI::Range(1, 400000));
  app.add_option("--minutes", options.minutes, "cavity and mill: of milling (repeatable)")->check(CLI::Range(0.01, 120.0));
  app.add_option("--tremor-mm", options.tremors_mm, "cavity and mill: rms of the tremor (repeatable)")->check(CLI::Range(0.0, 1.0));
  app.add_option("--seconds", options.seconds, "latency: of each row, 10 unless given")->check(CLI::Range(0.1, 3600.0));
  app.add_option("--load", options.loads, "latency: off or on (repeatable)")
      ->check(CLI::IsMember(std::vector<std::string>{"off", "on"}));
  app.add_option("--seed", options.seed, "of every random choice, 1 unless given");
  app.add_option("--json", options.json, "write rows as JSON to a file, or to stdout for -");
  if (!verb.writes_folder) return;
  app.add_option("--out", options.out, "folder for the files")->required();
  app.add_option("--from", options.from,
                 "draw these instead of measuring: a report of --json, a table, or their folder");
}

}  // namespace

int run_program(std::vector<std::string> args) {
  CLI::App app{"Measures speed, accuracy, stability and removal of each contact method", "cusp-bench"};
  app.require_subcommand(1);
  Options options;
  const Verb* chosen_verb = nullptr;
  for (const Verb& verb : kVerbs) {
    CLI::App* sub = app.add_subcommand(verb.name, verb.about);
    add_options(*sub, options, verb);
    sub->callback([&chosen_verb, &verb] { chosen_verb = &verb; });
  }
  try {
    std::reverse(args.begin(), args.end());  // CLI11 takes them from the back
    app.parse(args);
  } catch (const CLI::ParseError& e) {
    return app.exit(e, std::cout, std::cerr) == 0 ? kDone : kUsage;  // --help is a ParseError that is none
  }
  try {
    return chosen_verb->run(options);
  } catch (const std::exception& e) {
    std::cerr << "cusp-bench: " << e.what() << '\n';
    return kFailed;
  }
}

}  // namespace cusp::bench
