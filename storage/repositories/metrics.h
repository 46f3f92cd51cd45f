/// Removed tissue and force over time: one row per chunk, and one per tissue that changed in the chunk.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/tissue.h"
#include "storage/records/context.h"
#include "storage/modules.h"

namespace cusp::storage {

/// Running total since the session's start.
struct RemovedTissue {
  Tissue tissue = Tissue::empty;
  std::uint64_t voxels = 0;  // occupied at the start, empty now
  double mm3 = 0;
};

/// Of one second.
struct SecondMetrics {
  std::vector<RemovedTissue> removed{};  // totals so far; may omit tissues without removal
  double force_peak_n = 0;               // before the guard
  double force_mean_n = 0;               // over the ticks in contact whose force is known; 0 without one
  std::uint64_t contact_ticks = 0;
  std::uint64_t cutting_ticks = 0;
};

struct MetricsRow {
  std::uint64_t chunk = 0;
  std::uint64_t elapsed_us = 0;  // at the chunk's end
  SecondMetrics metrics{};       // removed holds every tissue's total so far
};

class Metrics {
 public:
  explicit Metrics(StorageContext& context) : c_{context} {}
  Stored<std::vector<MetricsRow>> over_time(SessionId session);
  /// Totals at the end of the stored trace.
  Stored<std::vector<RemovedTissue>> removed(SessionId session);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
