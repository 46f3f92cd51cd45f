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
#include "engine/base/result.h"
#include "scenarios/format/scenario.h"
#include "scenarios/grading/grade.h"
#include "ui/session/observer.h"

namespace cusp {

enum class RunError : std::uint8_t {
  specimen,         // the scenario's volume cannot be made or read
  scene,            // no tissue, no instrument, or a value the engine refuses
  device,           // the port did not open, or it has fewer axes than the scenario needs
  device_class,     // the scenario does not admit this class of device
  storage,          // the database refused; detail says what
  recording_failed, // the record could not be written: what stands in the database is complete up to the last second
  not_deterministic,// loop and mirror came to different states
  not_running,      // finish() of a go that is over
  grading,          // the volume could not be measured
};
using RunFailure = Failure<RunError>;

/// Who and what. A guest or a try-out keeps nothing: `database` is empty.
struct RunPlan {
  Scenario scenario;
  std::filesystem::path scenario_folder;   // where a volume named by the scenario lies; empty for generators
  std::filesystem::path database;          // empty: nothing is kept
  UserId student;
  VersionId version;                       // published version; nil when there is none yet
  AssignmentId assignment;                 // nil: practice
  std::string hand;                        // "" = a person; "expert", "novice" or a file's name
  std::shared_ptr<const VoxelVolume> specimen;  // already built, to save the time; may be null
  std::vector<Observer*> observers;        // outlive the run
};

/// What a go came to.
struct RunResult {
  SessionId session;                       // nil when nothing was kept
  Grade grade;
  std::uint64_t volume_hash = 0;
  double seconds = 0;
  std::vector<Measure> process;            // time, forces
  std::shared_ptr<const VoxelVolume> original, final;  // for the report's picture
};

class ExerciseRun {
 public:
  /// Builds the scene, opens the port, makes the session's rows and starts loop, mirror and recorder.
  /// `port` outlives the run. Takes up to seconds for a large specimen: not on the window's thread then.
  static Result<std::unique_ptr<ExerciseRun>, RunFailure> start(RunPlan plan, HapticPort& port);
  /// Abandons when neither finish() nor abandon() was called.
  ~ExerciseRun();

  void pause();
  /// Also after a fault or when the device has come back: re-arms the guard, the force ramps in.
  void resume();
  /// Index into the scenario's instruments.
  void change_burr(std::size_t index);

  /// Stops, works through every input, writes the final volume, grades, and stores the grade.
  Result<RunResult, RunFailure> finish();
  /// Stops; the session stays as interrupted in the database and can be graded as it stands.
  void abandon();

  /// The newest values; cheap, no lock that the loop ever takes.
  LiveView view() const;
  SessionId session() const;
  const Scenario& scenario() const;
  const std::shared_ptr<const Scene>& scene() const;
  /// The specimen as it was at the start, dense (target overlays, section views).
  std::shared_ptr<const VoxelVolume> original() const;
  DeviceLimits device() const;

 private:
  struct Inner;
  explicit ExerciseRun(std::unique_ptr<Inner> inner);
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp
