/// What the picture needs to know of a target, made from the scenario's values: deviation, outlines, region of
/// interest, section. Values and functions that own what they need; any thread.
#pragma once

#include <memory>

#include "scenarios/format/scenario.h"
#include "scenarios/shapes/target.h"
#include "ui/modules.h"
#include "ui/render/baked_patch.h"
#include "ui/render/overlay_line.h"
#include "ui/render/patch_feed.h"
#include "ui/render/section.h"

namespace cusp::ui {

class TargetLook {
 public:
  /// `specimen`: uncut, for leaves of its voxels, which take tens of milliseconds each. Without one such a target is empty.
  TargetLook(const Region& target, const Leeway& leeway, std::shared_ptr<const Specimen> specimen);

  bool empty() const noexcept { return shape_->empty(); }
  const TargetShape& shape() const noexcept { return *shape_; }

  /// How far a place of the surface stands from the target.
  DeviationAt deviation() const;
  /// Settings of a feed: deviation, and fine patches about the target.
  FeedSettings feed() const;
  /// About the target and the leeway, from the floor to `highest_mm`, for the camera and the region of interest.
  Box box(double highest_mm) const;
  /// Outlines of target and leeway on the specimen's own surface.
  std::vector<OverlayLine> lines(const Volume& uncut) const;
  /// Target and leeway of a section.
  void put_into(SectionSettings& section) const;

 private:
  std::shared_ptr<const TargetShape> shape_;
  Leeway leeway_;
};

}  // namespace cusp::ui
