/// One go at an exercise, live: joins a device, the loop, its mirror, the live scores and the recorder.
/// Thread: every function is called from one thread (the window's); loop, mirror and recorder have their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/base/ids.h"
#include "engine/base/pedal_source.h"
#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "storage/repositories/sessions.h"
#include "ui/modules.h"
#include "ui/session/observer.h"
#include "ui/session/run_error.h"

namespace cusp::ui {

/// Who and what.
struct RunPlan {
  Scenario scenario;
  std::filesystem::path scenario_folder;     // where a volume named by the scenario lies; empty for generators
  std::filesystem::path database;            // empty: nothing is kept (an editor's try-out, a trial without an account)
  Actor student;                             // who drills; Accounts::guest() for "Try it"
  VersionId version;                         // published version; nil: the scenario's own, published at need
  SessionKind kind = SessionKind::practice;  // try_it and try_out stay out of histories and figures
  std::optional<AssignmentId> assignment;
  std::string hand = "person";               // or "expert", "novice", a file's name
  SessionId go_on;                           // an interrupted session to go on with; nil: a new one
  std::shared_ptr<const Specimen> specimen;  // build_specimen()'s, to save the time; may be null
  std::vector<Observer*> observers;          // outlive the run
  std::shared_ptr<const PedalSource> pedal;  // a foot pedal beside the device; may be null
};

/// What a go came to; also what an old session opens as (replay.h).
struct RunResult {
  SessionId session;                         // nil when nothing was kept
  SessionState state = SessionState::graded;
  bool interrupted = false;                  // it never came to its finish: graded as it stands
  Scenario scenario;
  Grade grade;
  std::vector<Measure> measures;             // all that was measured, also without a criterion; empty for an old session
  std::shared_ptr<const Volume> volume;      // specimen and cuts, for the picture
  std::uint64_t volume_hash = 0;
  double seconds = 0;
  DeviceLimits device;
  double stiffness_share = 1.0;              // of the scenario's, that the device could hold
  std::string hand;
  int engine_version = kEngineVersion;
};

class ExerciseRun {
 public:
  /// Builds the scene, opens the port, makes the session's rows and starts loop, mirror and recorder.
  /// `port` outlives the run. Up to seconds for a large specimen: then not on the window's thread.
  static Run<std::unique_ptr<ExerciseRun>> start(RunPlan plan, HapticPort& port);
  /// Abandons when neither finish() nor abandon() was called.
  ~ExerciseRun();
  ExerciseRun(const ExerciseRun&) = delete;
  ExerciseRun& operator=(const ExerciseRun&) = delete;

  void pause();
  /// Also after a fault, or when the device or the disk has come back: re-arms the guard, the force ramps in.
  void resume();
  /// Index into the scenario's instruments.
  void change_bur(std::size_t index);
  /// For exercises that reckon heat; off at the start. It is part of the record.
  void set_coolant(bool on);

  /// Stops, works through every input, writes the final volume, grades, and stores the grade. recording_failed leaves the
  /// run as it was (stopped): finish() may be tried again when the disk is well. A go that ended by itself because inputs
  /// were not taken off in time is graded as it stands, RunResult::interrupted says so.
  Run<RunResult> finish();
  /// Stops; the session stays as interrupted in the database and can be graded as it stands.
  void abandon();

  /// The newest values; cheap; takes no lock that the loop ever takes.
  LiveView view() const;
  SessionId session() const;
  const Scenario& scenario() const;
  const std::shared_ptr<const Scene>& scene() const;
  /// Target, leeway and pulp, for overlays.
  const std::shared_ptr<const Reference>& reference() const;
  DeviceLimits device() const;
  /// What the tissues' stiffness was multiplied with, because the device cannot hold more; 1: nothing was cut.
  double stiffness_share() const;

 private:
  struct Inner;
  explicit ExerciseRun(std::unique_ptr<Inner> inner);
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
