/// A small block of plastic with its face at z = 0, and a scripted device that drills and slides in it: enough for
/// everything that runs the step without caring what is cut.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "engine/base/haptic_port.h"
#include "engine/step/step.h"
#include "tests/eventually.h"
#include "tests/modules.h"

namespace cusp::test {

/// 3.6 x 3.6 x 2.4 mm of plastic under z = 0, voxels of 0.15 mm, padded by four: coarse, so that it runs under sanitizers.
inline VoxelVolume block_volume() {
  Grid grid;
  grid.size = {32, 32, 24};
  grid.voxel_mm = 0.15;
  grid.origin_mm = {-2.325, -2.325, -2.925};
  VoxelVolume block(grid);
  for (int z = 0; z < grid.size.z; ++z)
    for (int y = 0; y < grid.size.y; ++y)
      for (int x = 0; x < grid.size.x; ++x) {
        const Vec3 at = grid.centre_mm({x, y, z});
        const double d = std::max({std::abs(at.x) - 1.8, std::abs(at.y) - 1.8, at.z, -2.4 - at.z});
        const std::size_t i = grid.index({x, y, z});
        block.s[i] = solid_from_distance(d / grid.voxel_mm);
        if (block.s[i] > 0) block.tissue[i] = Tissue::plastic;
      }
  return block;
}

inline std::vector<Bur> block_burs() {
  Bur large, small;
  large.name = "large";
  large.radius_mm = 0.5;
  small.name = "small";
  small.radius_mm = 0.4;
  small.neck_radius_mm = 0.25;
  return {large, small};
}

inline std::shared_ptr<const Scene> block_scene(Method method = Method::surface) {
  auto scene = std::make_shared<Scene>();
  scene->specimen = Specimen::build(block_volume(), reading_of(method));
  scene->method = method;
  scene->tissues[index_of(Tissue::plastic)] = {1.0, 4.0};
  scene->burs = block_burs();
  scene->guard.ramp_in_ms = 10;
  scene->guard.late_ms = 60000;  // a busy machine is no fault here; tests with their own clock test lateness
  return scene;
}

/// The block with so many burs, all alike: for tests of who chooses one.
inline std::shared_ptr<const Scene> block_scene_with_burs(std::size_t burs) {
  auto scene = std::make_shared<Scene>(*block_scene());
  scene->burs.resize(burs, scene->burs.back());
  return scene;
}

/// The device after `tick` milliseconds: touches at 20 ms, cuts from 40 ms on, circles 0.5 mm deep until 1.2 mm.
inline Sample drilling_sample(std::uint64_t tick) {
  const double t = static_cast<double>(tick) * 1e-3;
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = {0.6 * std::sin(4.0 * t), 0.6 - 0.6 * std::cos(4.0 * t),
                        t < 0.1 ? 0.6 - 5.0 * t : std::max(0.1 - 0.5 * (t - 0.1), -0.7)};
  sample.buttons = t > 0.04 ? StepInput::kCut : 0;
  return sample;
}

/// A port that plays drilling_sample(): one sample a wait(), `gone` after the last.
class DrillingPort : public HapticPort {
 public:
  /// Whether wait() returns at once or sleeps to its deadline.
  enum class Pace : std::uint8_t { at_once, to_deadline };
  explicit DrillingPort(std::uint64_t ticks, Pace pace = Pace::at_once) : ticks_(ticks), pace_(pace) {}
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    if (gone_.load() || at_ >= ticks_) return {};  // at once: a lost device has no pace
    if (pace_ == Pace::to_deadline) std::this_thread::sleep_until(deadline);
    return drilling_sample(at_++);
  }
  void write(const Feedback& feedback) noexcept override {
    last_force_n_.store(glm::length(feedback.force_n));
    peak_force_n_.store(std::max(peak_force_n_.load(), glm::length(feedback.force_n)));
    writes_.fetch_add(1);
  }
  DeviceLimits limits() const override {
    DeviceLimits limits;
    limits.name = "Test device";
    limits.device_class = "scripted";
    return limits;
  }
  void close() noexcept override {}

  void lose() noexcept { gone_.store(true); }
  void find() noexcept { gone_.store(false); }
  double last_force_n() const noexcept { return last_force_n_.load(); }
  double peak_force_n() const noexcept { return peak_force_n_.load(); }
  std::uint64_t writes() const noexcept { return writes_.load(); }

 private:
  std::uint64_t ticks_;
  Pace pace_;
  std::uint64_t at_ = 0;
  std::atomic<bool> gone_{false};
  std::atomic<double> last_force_n_{0}, peak_force_n_{0};
  std::atomic<std::uint64_t> writes_{0};
};

}  // namespace cusp::test
