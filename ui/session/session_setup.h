/// The beginning and the end that a live attempt and a scripted one share: scene, rows, recorder; then final volume and grade.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "engine/step/step.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/process.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"

namespace cusp::ui {

struct SessionSetup {
  DeviceLimits device;
  std::shared_ptr<const Scene> scene;
  double stiffness_share = 1.0;          // of the scenario's, that the device leaves
  double time_limit_s = 0;               // of the scenario, with the student's extra time; 0: none
  std::shared_ptr<const Reference> reference;
  std::unique_ptr<Store> store;          // null: nothing is kept
  SessionId session;
  std::optional<StepState> loop_start, mirror_start;
  Process process;                       // of the part before, when a session resumes
};

/// A time limit with a student's extra time. 0: none.
constexpr double extended_limit_s(double limit_s, int extra_percent) noexcept { return limit_s * (100 + extra_percent) / 100; }

/// `plan` gets its specimen. No row is written before everything else has succeeded. `called_off` is asked while the past of an attempt
/// that resumes is computed, which takes long where no key state is kept; once it says true, this fails (specimen, cancelled).
Outcome<SessionSetup> set_up(SessionPlan& plan, const DeviceLimits& device, const std::function<bool()>& called_off = {});

/// Why an attempt is over; the key is the reason stored with the event.
enum class SessionEnd : std::uint8_t {
  student,         // finished by the student
  time_limit,      // finished, the scenario's time was used
  script,          // finished, the scripted operator had nothing more to do
  recorder_full,   // interrupted: inputs were not taken off in time
  stopped,         // interrupted from outside
};
std::string_view key_of(SessionEnd end) noexcept;
constexpr bool interrupts(SessionEnd end) noexcept { return end == SessionEnd::recorder_full || end == SessionEnd::stopped; }

/// Grades the volume and, with a store, writes final volume, event and grade. Measured before anything is written. `progress`: of the
/// measuring.
Outcome<SessionResult> conclude(const SessionPlan& plan, const SessionSetup& setup, Store* store, const StepState& state,
                        const Process& process, SessionEnd end, const MeasureProgress& progress = {});

/// Of the rubric's canonical JSON, as stored beside a grade.
Hash256 rubric_hash(const Rubric& rubric);

}  // namespace cusp::ui
