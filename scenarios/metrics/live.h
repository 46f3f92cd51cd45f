/// The scores while drilling: the same figures as measure() gives, kept current by redoing only the bricks that changed.
/// Thread: the mirror's (or whichever owns the volume). About every 100 ms of the session's time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scenarios/metrics/reference.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Plain values; safe to copy between threads.
struct LiveReading {
  static constexpr std::size_t kMostTargets = 8;  // the panel has room for them; no more are shown
  double target_removed = 0;                    // %
  /// % of the first of several targets, in the order of asked_targets(). Within 0.01 of measure(): where one target alone reaches a
  /// brick, what is removed of the whole target counts, which is found already.
  std::array<double, kMostTargets> removed_of{};
  bool target_measured = false;                 // false: the target holds no tissue
  std::array<double, kPlaces> overcut_mm3{};    // by Place; [target] is what was rightly removed
  std::array<double, kTissueCodes> removed_mm3{};
  std::optional<double> remaining_over_pulp_mm; // least so far; none: no pulp, or nothing cut
  bool pulp_exposed = false;                    // pulp_exposure of measure()
};

class LiveMetrics {
 public:
  explicit LiveMetrics(std::shared_ptr<const Reference> reference);
  /// `changed`: bricks whose cut field changed since the last call (StateNews::changed_bricks).
  void update(const Volume& volume, std::span<const std::int32_t> changed);
  const LiveReading& reading() const noexcept { return reading_; }
  /// Forgets everything, for another volume or a jump in a replay; the next update lists every cut brick.
  void reset();

 private:
  void note_dirty(const Volume& volume, std::int32_t brick);

  struct Brick {
    RegionShares shares;
    std::array<double, LiveReading::kMostTargets> of_mm3{};  // removed of each of several targets
  };
  Brick measured(const Volume& volume, int brick) const;
  std::size_t several() const noexcept { return std::min(reference_->targets().asked().size(), LiveReading::kMostTargets); }

  std::shared_ptr<const Reference> reference_;
  std::map<int, Brick> bricks_;  // ascending: the sum has the order of measure()
  std::map<std::int32_t, std::array<std::uint16_t, kBrickVoxels>> cut_;  // [brick]: its cut field at the last update
  std::vector<int> dirty_;
  LiveReading reading_;
};

}  // namespace cusp::scenarios
