/// One session of an exercise, live: joins a device, the loop, its mirror, the live scores and the recorder.
/// Thread: every function is called from one thread (the window's); loop, mirror and recorder have their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/base/ids.h"
#include "engine/base/pedal_source.h"
#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/grading/changes.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/reference.h"
#include "storage/repositories/sessions.h"
#include "ui/modules.h"
#include "ui/session/observer.h"
#include "ui/session/session_error.h"

namespace cusp::ui {

/// What the screen tells while somebody drills. The record and the grade are the same.
enum class Guidance : std::uint8_t {
  full,
  silent,  // an assessment: no target but a block's printed one, no depth, no section, no scores, no coach
};

/// Who and what.
struct SessionPlan {
  Scenario scenario;
  std::filesystem::path scenario_folder;     // where a volume named by the scenario lies; empty for generators
  std::filesystem::path database;            // empty: nothing is kept (an editor's try-out, a trial without an account)
  Actor student;                             // who drills; not read if nothing is kept
  VersionId version;                         // published version; nil: the scenario's own, published at need
  SessionKind kind = SessionKind::practice;  // try_it and try_out stay out of histories and figures
  std::optional<AssignmentId> assignment;    // the session is then of its kind
  std::string start_code;                    // of an assessment, as the student typed it
  bool drawn_tooth = false;                  // `scenario` is the assignment's version, fitted to a tooth of the student's own (drawn_tooth.h)
  Guidance guidance = Guidance::full;
  std::string operator_name{kUserOperator};  // else the name of a scripted operator or of a file
  SessionId resumes;                         // an interrupted session to resume; nil: a new one
  std::shared_ptr<const Specimen> specimen;  // build_specimen()'s, to save the time; may be null
  std::shared_ptr<const Reference> reference;  // of that specimen, to save the time; may be null
  std::vector<Observer*> observers;          // outlive the session
  std::shared_ptr<const PedalSource> pedal;  // a foot pedal beside the device; may be null
};

/// What an attempt came to; also what an old session opens as (replay.h).
struct SessionResult {
  SessionId session;                         // nil when nothing was kept
  SessionState state = SessionState::graded;
  bool interrupted = false;                  // it never came to its finish: graded as it stands
  Scenario scenario;
  Grade grade;
  std::optional<GradeChanges> changes;       // of a grade that was made anew, against the stored one
  std::vector<Measure> measures;             // all that was measured, also without a criterion; empty for an old session
  std::shared_ptr<const Volume> volume;      // specimen and cuts, for the picture
  std::uint64_t volume_hash = 0;
  double seconds = 0;
  DeviceLimits device;
  double stiffness_share = 1.0;              // of the scenario's, that the device could hold
  std::string operator_name;
  int engine_version = kEngineVersion;
};

class ExerciseSession {
 public:
  /// Builds the scene, opens the port, makes the session's rows and starts loop, mirror and recorder.
  /// `port` outlives the session. Up to seconds for a large specimen: then not on the window's thread.
  static Outcome<std::unique_ptr<ExerciseSession>> start(SessionPlan plan, HapticPort& port);
  /// If its driver stands still, finish(), abandon() and the destructor wait 3 s for it. Then the haptic thread keeps the port until
  /// the driver comes back, or the program ends. `called_off` is asked on the calling thread while the port opens, and after that by
  /// set_up(). Once it says true, a driver is waited for 3 s more; then start() fails (device, kStandsStill), and a thread closes the port
  /// when the driver comes back.
  static Outcome<std::unique_ptr<ExerciseSession>> start(SessionPlan plan, std::shared_ptr<HapticPort> port,
                                                         const std::function<bool()>& called_off = {});
  /// Abandons when neither finish() nor abandon() was called.
  ~ExerciseSession();
  ExerciseSession(const ExerciseSession&) = delete;
  ExerciseSession& operator=(const ExerciseSession&) = delete;

  void pause();
  /// Takes cut and force off the device while the clock runs on; false gives them back as after a pause. For an attempt by hand.
  void set_idle(bool on);
  /// Also after a fault, or when the device or the disk has come back: re-arms the guard, the force ramps in, and a cut that is held
  /// counts once it was released. Without effect once LiveView::time_is_up: the session itself holds the loop at its time limit, and
  /// only finish() is left.
  void resume();
  /// Index into the scenario's instruments.
  void change_bur(std::size_t index);
  /// For exercises that reckon heat; off at the start. It is part of the record.
  void set_coolant(bool on);

  /// Stops, works through every input, writes the final volume, grades, and stores the grade. recording_failed leaves the
  /// session as it was (stopped): finish() may be tried again when the disk is well. An attempt that ended by itself because inputs
  /// were not taken off in time is graded as it stands, with SessionResult::interrupted set. driver_silent (device, where nothing is kept): the
  /// session is abandoned. `progress`: of the measuring, on the calling thread.
  Outcome<SessionResult> finish(const MeasureProgress& progress = {});
  /// Stops; the session stays as interrupted in the database and can be graded as it stands. False if that could not be written: the session
  /// counts as running until Sessions::interrupt() succeeds, or this process has ended.
  bool abandon();

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
  double time_limit_s() const;  // with the student's extra time; 0: none

 private:
  struct Inner;
  explicit ExerciseSession(std::unique_ptr<Inner> inner);
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
