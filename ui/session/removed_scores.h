/// What an attempt has removed so far: live scores, and voxels by tissue. Thread: one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "scenarios/metrics/live.h"
#include "storage/repositories/metrics.h"
#include "ui/modules.h"

namespace cusp::ui {

class RemovedScores {
 public:
  explicit RemovedScores(std::shared_ptr<const Reference> reference) : live_(std::move(reference)) {}
  /// `changed`: bricks whose cut field changed since the last call.
  void update(const Volume& volume, std::span<const std::int32_t> changed);
  const LiveReading& reading() const noexcept { return live_.reading(); }
  /// Totals of each tissue that lost something.
  std::vector<RemovedTissue> removed() const;

 private:
  LiveMetrics live_;
  std::map<std::int32_t, std::array<std::uint32_t, kTissueCodes>> gone_voxels_;  // [brick][tissue]
  std::array<std::uint64_t, kTissueCodes> gone_total_{};
};

}  // namespace cusp::ui
