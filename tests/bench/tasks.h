/// The paper's figures 13 and 14 for Cusp's methods: updates a second in each task, and motion and force through them.
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
  double time_s = 0.0;  // stepping time since the task began, at the end of the sample
  double updates_per_s = 0.0;
};
struct PaceReport {
  Source source;
  std::vector<PaceSample> samples;
};

/// One sample of the scripted motion: 1 kHz, every 25 ms.
struct MotionSample {
  std::string method, task;
  double time_s = 0.0;
  Vec3 displacement_mm{0.0};  // of the device point from its start
  Vec3 force_n{0.0};
};
struct MotionReport {
  Source source;
  std::vector<MotionSample> samples;
};

/// The paper's "0.5 mm spherical drill bit", read as the larger of the two that it can mean.
inline constexpr double kPaperBurMm = 0.5;

/// Scripted device point: free motion, strokes over the top of a block, then drilling into it, in smooth sines. The
/// constants give the length of each task in s.
inline constexpr double kFreeS = 2.0, kExploreS = 2.0, kDrillS = 2.5;
struct TaskBlock {
  double top_mm = 0.0;
  double bur_radius_mm = 0.5;
};
Vec3 scripted_device_mm(double time_s, const TaskBlock& block);
/// The block's scene: K = 1 N/mm, full wear at 0.25 N.
std::shared_ptr<Scene> task_scene(Method method);

/// Surface and occupancy proxy on the face, 128^3 voxels in 10 mm, alternating sample by sample.
PaceReport record_pace();
/// In a block of 1 N/mm with wear up to 1 mm/s. Deterministic.
MotionReport record_motion();

std::string to_csv(const PaceReport& report);
std::string to_csv(const MotionReport& report);
Result<PaceReport, RowsFailure> pace_from_csv(const std::string& text);
Result<MotionReport, RowsFailure> motion_from_csv(const std::string& text);

}  // namespace cusp::bench
