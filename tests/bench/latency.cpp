#include "tests/bench/latency.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "device/falcon/emulated_falcon_port.h"
#include "engine/loop/haptic_loop.h"
#include "engine/mirror/mirror.h"
#include "engine/step/step.h"
#include "tests/bench/latency_load.h"
#include "tests/bench/tick_times.h"
#include "tests/bench/machine.h"
#include "tests/bench/program.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kWarmUpS = 0.5;  // not counted: caches, first pages, homing's ramp
constexpr double kLatencyVoxelMm = 0.1;
constexpr double kBlockHalfMm = 4.0, kBlockDepthMm = 4.0;

/// A block of plastic, 8 x 8 x 4 mm with its face at z = 0, padded by four voxels, and a bur of 1 mm.
std::shared_ptr<const Scene> latency_scene() {
  Grid grid;
  grid.size = {88, 88, 48};
  grid.voxel_mm = kLatencyVoxelMm;
  grid.origin_mm = {-4.35, -4.35, -4.35};
  VoxelVolume volume(grid);
  for (int z = 0; z < grid.size.z; ++z) {
    for (int y = 0; y < grid.size.y; ++y) {
      for (int x = 0; x < grid.size.x; ++x) {
        const Vec3 at = grid.centre_mm({x, y, z});
        const double d = std::max({std::abs(at.x) - kBlockHalfMm, std::abs(at.y) - kBlockHalfMm, at.z, -kBlockDepthMm - at.z});
        const std::size_t i = grid.index({x, y, z});
        volume.s[i] = solid_from_distance(d / grid.voxel_mm);
        if (volume.s[i] > 0) volume.tissue[i] = Tissue::plastic;
      }
    }
  }
  auto scene = std::make_shared<Scene>();
  scene->specimen = Specimen::build(volume, reading_of(Method::surface));
  scene->method = Method::surface;
  scene->tissues[index_of(Tissue::plastic)] = {1.0, 4.0};
  Bur bur;
  bur.radius_mm = 0.5;
  scene->burs = {bur};
  scene->guard.late_ms = 60'000;  // the guard must not end a late run
  return scene;
}

/// Device point after t seconds: deepening circles of 1 mm at 10 mm/s, in the next quarter of the block every 10 s.
Vec3 circle_device_mm(double t) {
  const double round = std::fmod(t, 10.0);
  const int quarter = static_cast<int>(t / 10.0) % 4;
  const double x = quarter % 2 == 0 ? -1.8 : 1.8, y = quarter / 2 == 0 ? -1.8 : 1.8;
  const double angle = 10.0 * round;
  return {x + std::cos(angle), y + std::sin(angle), 0.4 - 0.25 * round};
}

class ClockPort final : public HapticPort {
 public:
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(Clock::time_point deadline) noexcept override {
    std::this_thread::sleep_until(deadline);
    Sample sample;
    sample.status = Sample::Status::fresh;
    t_ += 0.001;
    sample.position_mm = circle_device_mm(t_);
    sample.buttons = StepInput::kCut;
    sample.pedal = 65535;
    return sample;
  }
  void write(const Feedback&) noexcept override {}
  DeviceLimits limits() const override {
    DeviceLimits limits;
    limits.device_class = "scripted";
    limits.closed_loop = false;
    return limits;
  }
  void close() noexcept override {}

 private:
  double t_ = 0;
};

/// Wraps a port and times, on the loop's thread, the lateness of its samples and the duration of write().
class TimedPort final : public HapticPort {
 public:
  explicit TimedPort(HapticPort& port) : port_(port), own_clock_(port.limits().has_own_clock) {}
  Result<void, PortFailure> open() override { return port_.open(); }
  Sample wait(Clock::time_point deadline) noexcept override {
    const Sample sample = port_.wait(deadline);
    const Clock::time_point now = Clock::now();
    if (counting_.load(std::memory_order_relaxed)) {
      if (sample.status == Sample::Status::fresh) {
        // A device's next sample belongs a millisecond after its last.
        const auto due = own_clock_ ? last_ + std::chrono::milliseconds(1) : deadline;
        if (!own_clock_ || last_ != Clock::time_point{}) late.add_ns(ns(now - due));
      } else {
        late_samples.fetch_add(1, std::memory_order_relaxed);
      }
    }
    if (sample.status == Sample::Status::fresh) last_ = now;
    return sample;
  }
  void write(const Feedback& feedback) noexcept override {
    const Clock::time_point before = Clock::now();
    port_.write(feedback);
    if (counting_.load(std::memory_order_relaxed)) exchange.add_ns(ns(Clock::now() - before));
  }
  DeviceLimits limits() const override { return port_.limits(); }
  void close() noexcept override { port_.close(); }

  void count() noexcept { counting_.store(true, std::memory_order_relaxed); }
  TimeHistogram late, exchange;
  std::atomic<std::uint64_t> late_samples{0};

 private:
  static std::uint64_t ns(Clock::duration time) noexcept {
    return time.count() > 0 ? static_cast<std::uint64_t>(time.count()) : 0;
  }
  HapticPort& port_;
  bool own_clock_;
  Clock::time_point last_{};
  std::atomic<bool> counting_{false};
};

std::unique_ptr<HapticPort> make_port(const std::string& name) {
  if (name == "clock") return std::make_unique<ClockPort>();
  auto t = std::make_shared<double>(0.0);
  EmulatedFalconSettings settings;
  settings.scale = 0.5;
  return std::make_unique<EmulatedFalconPort>(
      [t](const Feedback&, double dt_s) noexcept {
        *t += std::min(dt_s, 0.01);
        return EmulatedHandPose{.position_mm = circle_device_mm(*t), .cut = true};
      },
      settings);
}

std::string_view realtime_name(RealtimeLevel level) {
  switch (level) {
    case RealtimeLevel::normal: return "normal";
    case RealtimeLevel::rtkit: return "rtkit";
    case RealtimeLevel::fifo: return "fifo";
  }
  return "normal";
}

std::string_view key_of(Load load) { return load == Load::on ? "on" : "off"; }

nlohmann::json json_of(const Spread& s) { return {{"p50", s.p50}, {"p99", s.p99}, {"p999", s.p999}, {"max", s.max}}; }

void print_latency(const std::vector<LatencyRow>& rows) {
  fmt::print("{:<16} {:<5} {:<8} {:>8} {:>7}   {:>30}   {:>30}   {:>22}   {:>6}\n", "port", "load", "class", "ticks", "missed",
             "late, us: p50 p99 p99.9 max", "tick, us: p50 p99 p99.9 max", "exchange: p50 p99 max", "fps");
  for (const LatencyRow& r : rows) {
    fmt::print("{:<16} {:<5} {:<8} {:>8} {:>7}   {:>6.0f} {:>6.0f} {:>7.0f} {:>8.0f}   {:>6.1f} {:>6.1f} {:>7.1f} {:>8.1f}   {:>6.1f} "
               "{:>6.1f} {:>8.1f}   {:>6.1f}\n",
               r.port, key_of(r.load), realtime_name(r.grant.level), r.ticks, r.missed, r.late_us.p50, r.late_us.p99,
               r.late_us.p999, r.late_us.max, r.tick_us.p50, r.tick_us.p99, r.tick_us.p999, r.tick_us.max, r.exchange_us.p50,
               r.exchange_us.p99, r.exchange_us.max, r.frames_per_s);
  }
}

}  // namespace

Spread spread_of(const TimeHistogram& times) noexcept {
  return {times.percentile_us(0.5), times.percentile_us(0.99), times.percentile_us(0.999), times.max_us()};
}

LatencyRow measure_latency(const std::string& name, Load load, double seconds) {
  LatencyRow row;
  row.port = name;
  row.load = load;
  std::unique_ptr<DrawingLoad> drawing;
  if (load == Load::on && !(drawing = DrawingLoad::start())) return row;
  const std::unique_ptr<HapticPort> port = make_port(name);
  TimedPort timed(*port);
  if (!timed.open()) return row;
  const auto scene = latency_scene();
  HapticLoop loop(timed, StepState(scene));
  Mirror mirror(StepState(scene), loop.hand_over(), {});
  mirror.start();
  loop.start();
  std::this_thread::sleep_for(std::chrono::duration<double>(kWarmUpS));
  timed.count();
  const LoopTimes before = loop.times();
  const Clock::time_point begun = Clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  row.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  const LoopTimes times = loop.times();
  row.grant = loop.grant();
  if (drawing) row.frames_per_s = drawing->frames_per_s();
  drawing.reset();
  loop.stop();
  mirror.stop();
  timed.close();
  row.ticks = times.ticks - before.ticks;
  row.missed = times.missed - before.missed;
  row.late_samples = timed.late_samples.load();
  row.late_us = spread_of(timed.late);
  row.exchange_us = spread_of(timed.exchange);
  // Of the whole run: the warm-up's ticks are the same work.
  row.tick_us = {times.tick_p50_us, times.tick_p99_us, times.tick_p999_us, times.tick_max_us};
  row.mirror_equal = !mirror.mismatch() && mirror.state().hash() == loop.state().hash();
  return row;
}

std::string latency_json(const std::vector<LatencyRow>& rows) {
  nlohmann::ordered_json out;
  out["commit"] = commit_of_build();
  out["engine"] = kEngineVersion;
  out["machine"] = cpu_name();
  out["cores"] = std::thread::hardware_concurrency();
  out["rows"] = nlohmann::ordered_json::array();
  for (const LatencyRow& r : rows) {
    nlohmann::ordered_json row;
    row["port"] = r.port;
    row["load"] = key_of(r.load);
    row["seconds"] = r.seconds;
    row["realtime"] = std::string(realtime_name(r.grant.level));
    row["priority"] = r.grant.priority;
    row["memory_locked"] = r.grant.memory_locked;
    row["ticks"] = r.ticks;
    row["missed"] = r.missed;
    row["late_samples"] = r.late_samples;
    row["late_us"] = json_of(r.late_us);
    row["tick_us"] = json_of(r.tick_us);
    row["exchange_us"] = json_of(r.exchange_us);
    row["mirror_equal"] = r.mirror_equal;
    if (r.load == Load::on) row["frames_per_s"] = r.frames_per_s;
    out["rows"].push_back(std::move(row));
  }
  return out.dump(2) + "\n";
}

int run_latency(const Options& options) {
  std::vector<LatencyRow> rows;
  for (const char* port : {"clock", "emulated-falcon"}) {
    for (const Load load : {Load::off, Load::on}) {
      if (!asked(options.loads, key_of(load))) continue;
      LatencyRow row = measure_latency(port, load, options.seconds);
      if (row.ticks == 0) {
        std::cerr << "cusp-bench: " << port << ", load " << key_of(load) << ": nothing ran"
                  << (load == Load::on ? " (no OpenGL without a window here?)" : "") << '\n';
        return kFailed;
      }
      if (!row.mirror_equal) {
        std::cerr << "cusp-bench: " << port << ": loop and mirror differ\n";
        return kFailed;
      }
      rows.push_back(std::move(row));
    }
  }
  if (options.json.empty()) {
    print_latency(rows);
    return kDone;
  }
  const std::string text = latency_json(rows);
  if (options.json == "-") {
    std::cout << text;
    return kDone;
  }
  std::ofstream file(options.json, std::ios::binary);
  if (!(file << text)) {
    std::cerr << "cusp-bench: " << options.json << " cannot be written\n";
    return kFailed;
  }
  return kDone;
}

}  // namespace cusp::bench
