#include "tests/bench/tasks.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>

#include "tests/bench/lanes.h"
#include "tests/bench/motions.h"
#include "tests/bench/pin.h"
#include "tests/bench/rate.h"
#include "tests/bench/scale.h"

namespace cusp::bench {

namespace {

constexpr Method kShown[] = {Method::surface, Method::occupancy};
constexpr int kPaceBatch = 250;  // ticks between clock readings, which cost as much as a tick
constexpr std::size_t kPaceTrackTicks = 4096;

/// An endless sequence of ticks of one task.
class TaskRunner {
 public:
  TaskRunner(Method method, const Shape& face, std::string_view task) : method_(method), face_(face) {
    if (task == "perforation") return;
    const auto inputs = task == "displacement" ? clear_inputs(face, kRateSpeedMmS, 1, kPaceTrackTicks)
                                               : slide_inputs(face, kRateSpeedMmS, 1, kPaceTrackTicks);
    lane_ = std::make_unique<Lane>(Lane{StepState(scene_of(face, method, kRateVoxelMm)), Track(inputs), {}});
    bring(lane_->state, step, face, face.before(inputs.front().position_mm()));
    lead(lane_->state, step, inputs.front().position_mm(), kRateSpeedMmS * 1e-3);
    run(1000);
  }

  /// Seconds of the core's time that the steps took.
  double run(int ticks) {
    double spent = 0.0;
    if (lane_) {
      const double start = core_time_s();
      for (int k = 0; k < ticks; ++k) step(lane_->state, lane_->track.next());
      return core_time_s() - start;
    }
    for (int done = 0; done < ticks;) {
      if (!drill_ || left_ == 0) {
        drill_ = std::make_unique<Perforation>(method_, face_, kRateVoxelMm, ++pass_);
        left_ = Perforation::kTicks;
      }
      std::array<StepInput, kPaceBatch> inputs;
      const int n = std::min({left_, ticks - done, kPaceBatch});
      for (int k = 0; k < n; ++k) inputs[static_cast<std::size_t>(k)] = drill_->next();
      const double start = core_time_s();
      for (int k = 0; k < n; ++k) step(drill_->state(), inputs[static_cast<std::size_t>(k)]);
      spent += core_time_s() - start;
      left_ -= n;
      done += n;
    }
    return spent;
  }

 private:
  Method method_;
  const Shape& face_;
  std::unique_ptr<Lane> lane_;          // displacement, exploration
  std::unique_ptr<Perforation> drill_;  // perforation
  std::uint64_t pass_ = 0;
  int left_ = 0;
};

constexpr double kTouchMm = 0.4;  // mm of the device point below the surface while exploring

std::string_view task_at(double t) {
  return t < kFreeS ? "displacement" : t < kFreeS + kExploreS ? "exploration" : "perforation";
}

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", v);
  return text;
}

constexpr std::string_view kPaceNames = "method,task,time_s,updates_per_s";
constexpr std::string_view kMotionNames = "method,task,time_s,x_mm,y_mm,z_mm,fx_n,fy_n,fz_n";

/// Calls take(method, task, numbers) for each line after the names.
template <class Take>
Result<void, RowsFailure> read_lines(const std::string& text, std::string_view names, std::size_t numbers,
                                     Source& source, Take&& take) {
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line)) return fail(RowsError::wrong_type, "first line");
  const auto found = source_from_line(line);
  if (!found) return fail(RowsError::wrong_type, "first line");
  source = *found;
  if (!std::getline(in, line) || line != names) return fail(RowsError::wrong_type, "second line");
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string method, task, cell;
    std::getline(cells, method, ',');
    std::getline(cells, task, ',');
    std::vector<double> values;
    while (std::getline(cells, cell, ',')) {
      char* end = nullptr;
      values.push_back(std::strtod(cell.c_str(), &end));
      if (end == cell.c_str() || *end != '\0' || !std::isfinite(values.back()))
        return fail(RowsError::wrong_type, line);
    }
    if (values.size() != numbers) return fail(RowsError::wrong_type, line);
    take(method, task, values);
  }
  return {};
}

}  // namespace

Vec3 scripted_device_mm(double t, const TaskBlock& block) {
  constexpr double kTurn = 6.283185307179586;
  const double rest = block.top_mm + block.bur_radius_mm;
  if (t < kFreeS) {
    const double u = t / kFreeS;
    return {3.0 * std::sin(kTurn * u), 2.0 * std::sin(2.0 * kTurn * u), rest + 0.2 + 1.8 * std::sin(0.5 * kTurn * u)};
  }
  if (t < kFreeS + kExploreS) {
    const double u = (t - kFreeS) / kExploreS;
    const double deep = kTouchMm * std::sin(0.5 * kTurn * u);
    return {1.5 * std::sin(kTurn * u), 1.0 * std::sin(2.0 * kTurn * u),
            rest + 0.2 - (0.2 + deep) * std::min(1.0, 8.0 * u)};
  }
  const double u = (t - kFreeS - kExploreS) / kDrillS;
  // Slightly faster than the wear, with sideways motion.
  return {0.25 * std::sin(2.0 * kTurn * u), 0.15 * std::sin(3.0 * kTurn * u),
          rest - 0.3 * std::min(1.0, 8.0 * u) - kDrillS * u};
}

std::shared_ptr<Scene> task_scene(Method method) {
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = solid_block(128, kRateVoxelMm, reading_of(method));
  const double r = kPaperBurMm;
  scene->burs = {Bur{"bench", r, 0.4 * r, 4.0 + r, 0.4 * r, 4.0}};
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 1.0};
  scene->full_force_n = 0.25;
  return scene;
}

PaceReport record_pace() {
  PaceReport out{this_source(), {}};
  const std::unique_ptr<Shape> face = make_shape("face", kPaperBurMm);
  for (const std::string_view task : {"displacement", "exploration", "perforation"}) {
    std::vector<TaskRunner> runs;
    for (const Method method : kShown) runs.emplace_back(method, *face, task);
    for (int sample = 1; sample <= kSamplesATask; ++sample)
      for (std::size_t i = 0; i < runs.size(); ++i) {
        double spent = 0.0;
        std::int64_t ticks = 0;
        while (spent < kSampleS) {
          spent += runs[i].run(kPaceBatch);
          ticks += kPaceBatch;
        }
        out.samples.push_back(
            {std::string(key_of(kShown[i])), std::string(task), sample * kSampleS, static_cast<double>(ticks) / spent});
      }
  }
  return out;
}

MotionReport record_motion() {
  MotionReport out{this_source(), {}};
  const double top = solid_block_half_mm(128, kRateVoxelMm);
  for (const Method method : kShown) {
    StepState state(task_scene(method));
    const double r = kPaperBurMm;
    const Vec3 begin = scripted_device_mm(0.0, {top, r});
    lead(state, step, begin, 0.05);
    const int ticks = static_cast<int>((kFreeS + kExploreS + kDrillS) * 1000.0);
    for (int k = 1; k <= ticks; ++k) {
      const double t = k * 1e-3;
      const Vec3 device = scripted_device_mm(t, {top, r});
      const std::string_view task = task_at(t);
      const StepOutput now = step(state, input_at(device, task == "perforation" ? Button::down : Button::up));
      if (k % static_cast<int>(kSampleS * 1000.0) == 0)
        out.samples.push_back({std::string(key_of(method)), std::string(task), t, device - begin, now.force_raw_n});
    }
  }
  return out;
}

std::string to_csv(const PaceReport& report) {
  std::string out = source_line(report.source) + std::string(kPaceNames) + '\n';
  for (const PaceSample& s : report.samples)
    out += s.method + ',' + s.task + ',' + number(s.time_s) + ',' + number(s.updates_per_s) + '\n';
  return out;
}

std::string to_csv(const MotionReport& report) {
  std::string out = source_line(report.source) + std::string(kMotionNames) + '\n';
  for (const MotionSample& s : report.samples) {
    out += s.method + ',' + s.task + ',' + number(s.time_s);
    for (int i = 0; i < 3; ++i) out += ',' + number(s.displacement_mm[i]);
    for (int i = 0; i < 3; ++i) out += ',' + number(s.force_n[i]);
    out += '\n';
  }
  return out;
}

Result<PaceReport, RowsFailure> pace_from_csv(const std::string& text) {
  PaceReport out;
  const auto read =
      read_lines(text, kPaceNames, 2, out.source,
                 [&out](const std::string& method, const std::string& task, const std::vector<double>& v) {
                   out.samples.push_back({method, task, v[0], v[1]});
                 });
  if (!read) return std::unexpected(read.error());
  return out;
}

Result<MotionReport, RowsFailure> motion_from_csv(const std::string& text) {
  MotionReport out;
  const auto read =
      read_lines(text, kMotionNames, 7, out.source,
                 [&out](const std::string& method, const std::string& task, const std::vector<double>& v) {
                   out.samples.push_back({method, task, v[0], {v[1], v[2], v[3]}, {v[4], v[5], v[6]}});
                 });
  if (!read) return std::unexpected(read.error());
  return out;
}

}  // namespace cusp::bench
