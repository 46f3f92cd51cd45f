/// One attempt of a scripted operator through the real step, in virtual time, measured and graded.
#pragma once

#include <memory>

#include "engine/step/step.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/tool_axis.h"
#include "scenarios/grading/grader.h"
#include "scenarios/operators/operator_port.h"
#include "scenarios/metrics/measure.h"
#include "tests/modules.h"

namespace cusp::test::attempt {

inline std::shared_ptr<const Scene> scene_of(const Scenario& scenario, std::shared_ptr<const Specimen> specimen) {
  auto scene = std::make_shared<Scene>();
  scene->specimen = std::move(specimen);
  scene->method = scenario.method;
  for (const ScenarioTissue& t : scenario.tissues)
    scene->tissues[index_of(t.tissue)] = {t.stiffness_n_per_mm, t.speed_mm_s};
  scene->burs = scenario.instruments;
  scene->tool_axis = resting_axis(scenario.tool_tilt_deg);
  scene->full_force_n = scenario.device.full_force_n;
  scene->phenomena = phenomena_from_keys(scenario.phenomena);
  return scene;
}

struct Result {
  Process process;
  std::vector<Measure> measures;
  Grade grade;
  std::size_t skipped = 0;  // strokes that the operator gave up
  std::uint64_t ticks = 0, infeasible = 0, overflow = 0;
  bool faulted = false;
  const Measure& get(std::string_view key) const {
    for (const Measure& m : measures)
      if (m.metric == key) return m;
    static const Measure none{"none", false, 0, 0, "", {}};
    return none;
  }
};

inline Result run(const Scenario& scenario, const Reference& reference, std::shared_ptr<const Specimen> specimen,
                  ScriptedOperator scripted, std::uint32_t tick_us = 1000) {
  Result out;
  StepState state(scene_of(scenario, std::move(specimen)));
  OperatorPort port(std::move(scripted), tick_us * 1e-6);
  StepInput last;
  while (true) {
    const Sample sample = port.wait({});
    if (sample.status == Sample::Status::gone) break;
    last = quantise(sample, tick_us, last);
    const StepOutput o = step(state, last);
    out.process.add(o);
    ++out.ticks;
    out.infeasible += o.infeasible;
    out.overflow += o.overflow;
    out.faulted = out.faulted || o.faulted;
    port.write({o.force_n, o.proxy_mm, o.stiffness_n_per_mm, Vec3(0, 0, 1), o.contact, o.faulted});
  }
  out.skipped = port.scripted_operator().strokes_skipped();
  out.measures = measure(reference, state.volume(), out.process);
  out.grade = grade(scenario, out.measures);
  return out;
}

}  // namespace cusp::test::attempt
