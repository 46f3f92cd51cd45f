/// The exact proxy on a carved block. A tick costs 0.2 to 3 ms, so CarvedMemory keeps each path: every method follows
/// the same device points.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "tests/bench/carved_block.h"
#include "tests/bench/truth.h"

namespace cusp::bench {

class CarvedMemory;

class CarvedTruth : public Truth {
 public:
  CarvedTruth(std::shared_ptr<CarvedBlock> block, std::shared_ptr<CarvedMemory> memory)
      : block_(std::move(block)), memory_(std::move(memory)) {}
  double clearance_mm(Vec3 centre) const override { return block_->clearance_mm(centre); }
  void start(Vec3 centre) override;
  Exact follow(Vec3 device) override;

 protected:
  Vec3 place(Vec3 centre) override;
  Exact move_to(Vec3 device) override { return move_to(device, kFine); }

 private:
  static constexpr double kFine = 1e-8, kCoarse = 5e-4;  // mm: at the end of a tick, and in its sub-steps
  Exact move_to(Vec3 device, double precision_mm);

  std::shared_ptr<CarvedBlock> block_;
  std::shared_ptr<CarvedMemory> memory_;
  Vec3 y_{0.0}, device_{0.0}, begin_{0.0};
  std::size_t done_ = 0;
};

/// Ticks followed from a start, by the start and the first device point.
class CarvedMemory {
 public:
  struct Tick {
    Vec3 device{0.0};
    Exact exact;
  };
  using Key = std::tuple<double, double, double, double, double, double>;
  std::vector<Tick>& from(Vec3 start, Vec3 first) {
    return runs_[{start.x, start.y, start.z, first.x, first.y, first.z}];
  }
  std::vector<Tick>* running = nullptr;

 private:
  std::map<Key, std::vector<Tick>> runs_;
};

}  // namespace cusp::bench
