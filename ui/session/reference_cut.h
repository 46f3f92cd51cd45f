/// The reference operator's path, played in a set time: its cuts step by step, forth and back. Without hand, device and force, as
/// operator_cut.h. No Qt. Thread: any but the haptic; one at a time.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/volume/volume.h"
#include "scenarios/operators/plan.h"
#include "ui/session/operator_cut.h"

namespace cusp::ui {

/// Where the bur is at a moment of a path.
struct PathMoment {
  Vec3 pivot_mm{0.0};
  bool cut = false;  // the bur turns and cuts
};

/// A plan laid over a time: cutting strokes at one speed, moves in air kAirFaster times as fast. Immutable.
class PathTimeline {
 public:
  static constexpr double kAirFaster = 3.0;  // the watcher learns from the cuts; tests/ui/session/reference_cut_test.cpp

  /// Pre: the plan has strokes and moves.
  PathTimeline(Plan plan, double seconds);
  double seconds() const noexcept { return seconds_; }
  std::uint16_t bur() const noexcept { return plan_.bur; }
  Vec3 axis() const noexcept { return plan_.axis; }
  PathMoment at(double s) const;
  /// What the plan does from one moment to another. Pre: from_s <= to_s.
  Plan between(double from_s, double to_s) const;

 private:
  Vec3 place(std::size_t stroke, double s) const;
  double begin_s(std::size_t stroke) const { return stroke == 0 ? 0.0 : ends_s_[stroke - 1]; }

  Plan plan_;
  double seconds_;
  std::vector<double> ends_s_;  // [stroke], rising
};

class ReferenceCut {
 public:
  static constexpr int kStepsPerSecond = 20;

  /// Pre: the timeline is of this scenario and specimen, and has strokes.
  ReferenceCut(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, PathTimeline timeline);

  const PathTimeline& timeline() const noexcept { return timeline_; }
  const Volume& volume() const noexcept { return *volume_; }
  int step() const noexcept { return step_; }
  int last_step() const noexcept;
  /// Cuts on to this step, or takes back what came after it. A step has the same volume however it is reached. Returns the bricks
  /// that may have changed.
  Result<std::vector<std::int32_t>, OperatorCutError> go_to(int step);

 private:
  bool cut_next();

  Scenario scenario_;
  PathTimeline timeline_;
  std::unique_ptr<Volume> volume_;
  int step_ = 0;
  std::map<int, std::vector<std::byte>> keys_;  // [step]: its cuts, every kKeySteps; the uncut tooth first
};

}  // namespace cusp::ui
