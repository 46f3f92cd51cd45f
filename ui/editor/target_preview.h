/// The tooth with the ideal preparation: the cavity carved out, and outlines of target and tolerance zone on the whole tooth.
/// No widget. Thread: any.
#pragma once

#include <memory>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/render/overlay_line.h"
#include "ui/render/patch_feed.h"

namespace cusp::ui {

struct PreviewWish {
  std::shared_ptr<const Volume> whole;
  Region target;
  Leeway leeway;
  bool carved = true;  // false: the whole tooth
};

struct TargetPreview {
  std::shared_ptr<PatchFeed> patches;
  std::vector<OverlayLine> lines;
  std::shared_ptr<const Volume> shown;  // that the patches are of
};

/// The outlines alone: fast enough to follow a drag, but for leaves of voxels, which take tens of milliseconds each.
std::vector<OverlayLine> preview_lines(const PreviewWish& wish);
TargetPreview make_preview(const PreviewWish& wish);

}  // namespace cusp::ui
