/// What the paper's figures 13 and 14 show, recorded on Cusp's methods: the pace of the loop in each task, and a hand's
/// way and force through them.
#pragma once

#include <string>
#include <vector>

#include "engine/step/step.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/modules.h"

namespace cusp::bench {

inline constexpr double kSampleS = 0.025;  // the paper samples every 25 ms
inline constexpr int kSamplesATask = 16;

/// Updates a second over 25 ms of nothing but stepping.
struct PaceSample {
  std::string method, task;
  double time_s = 0.0;  // of stepping since the task began, at the sample's end
  double updates_per_s = 0.0;
};
struct PaceReport {
  std::string commit, machine;
  std::vector<PaceSample> samples;
};

/// One moment of a hand's way, 1 kHz sampled every 25 ms.
struct MotionSample {
  std::string method, task;
  double time_s = 0.0;
  Vec3 displacement_mm{0.0};  // of the device point from where it began
  Vec3 force_n{0.0};
};
struct MotionReport {
  std::string commit, machine;
  std::vector<MotionSample> samples;
};

/// The paper's "0.5 mm spherical drill bit", read as the larger of the two that it can mean.
inline constexpr double kPaperBurMm = 0.5;

/// The device point of a hand that moves freely, strokes the top of a block and drills into it, by the time in s.
/// Smooth sines; a task has its seconds.
inline constexpr double kFreeS = 2.0, kExploreS = 2.0, kDrillS = 2.5;
struct TaskBlock {
  double top_mm = 0.0;
  double bur_radius_mm = 0.5;
};
Vec3 scripted_device_mm(double time_s, const TaskBlock& block);
/// The block's scene: K = 1 N/mm, full wear at 0.25 N.
std::shared_ptr<Scene> task_scene(Method method);

/// Surface and occupancy proxy on the face, 128^3 voxels in 10 mm; the two take turns sample by sample.
PaceReport record_pace();
/// In a block of K = 1 N/mm that a bur goes through at 1 mm/s. No clock: the same on every machine.
MotionReport record_motion();

std::string to_csv(const PaceReport& report);
std::string to_csv(const MotionReport& report);
Result<PaceReport, RowsFailure> pace_from_csv(const std::string& text);
Result<MotionReport, RowsFailure> motion_from_csv(const std::string& text);

}  // namespace cusp::bench
